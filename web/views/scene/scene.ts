/**
 * The element in physical space: faces coloured by jacdet in WebGL, and over them, in SVG, edges, handles, marks and words.
 * Draws what a frame says and emits actions; one picture per update and none in between.
 *
 * Dragged coordinates are rounded to the power of ten at or below one pixel's length. Keys: see help.ts; the digit on a
 * handle chooses that handle.
 */
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import type { Vertices } from '../../model/hexahedron'
import type { State } from '../../model/state'
import { colourScaleOf, type Ramp, rampOf, type Theme } from '../colour-map'
import { ThemeReader } from '../theme'
import type { CreateView, Frame, View, ViewHost } from '../view'
import { DEFAULT_DIRECTION, type Insets, SceneCamera, type ScreenPoint } from './camera'
import { ColourBar } from './colour-bar'
import { Controls } from './controls'
import { createFacePainter, type FacePainter } from './face-painter'
import { Help } from './help'
import { KeyboardInput } from './keyboard-input'
import type { Box } from './label-place'
import { Overlay } from './overlay'
import { PointerInput } from './pointer-input'
import css from './scene.css?inline'
import type { Stage } from './stage'
import type { DragKeys } from './vertex-drag'
import { frameOf, type ViewFrame, verticesInView } from './view-frame'

export const sceneStyles = css

/** More device pixels than this are not worth their time. */
const MOST_PIXEL_RATIO = 2
/** Below this width, in CSS pixels, the scene is laid out for a phone. */
const NARROW = 560
const ORBIT_STEP = Math.PI / 12

const NO_WEBGL =
  'This browser gives no WebGL2, so the faces are not coloured. Vertices can be moved all the same, and the verdict holds.'
const CONTEXT_LOST =
  'The graphics context was lost, so the faces are not coloured until the browser gives it back. Everything else goes on.'

export interface SceneView extends View {
  /** Pictures drawn so far, and draw calls of the last one: nothing is drawn while nothing changes. */
  readonly framesDrawn: number
  readonly drawCalls: number
}

class Scene implements SceneView, Stage {
  readonly root = document.createElement('div')
  readonly element = document.createElement('div')
  readonly camera = new SceneCamera()
  readonly host: ViewHost
  framesDrawn = 0

  readonly #painter: FacePainter | null
  readonly #overlay = new Overlay()
  readonly #colourBar: ColourBar
  readonly #controls: Controls
  readonly #help = new Help('scene-help')
  readonly #orbit: OrbitControls
  readonly #pointer: PointerInput
  readonly #keyboard: KeyboardInput
  readonly #themeReader: ThemeReader
  readonly #listening = new AbortController()
  readonly #resizes = new ResizeObserver(entries => this.#onResize(entries))
  #theme: Theme | null = null
  #ramp: Ramp | null = null
  #contextLost = false
  /** As last observed, and as the camera knows it. */
  #box = { width: 0, height: 0 }
  #width = 0
  #height = 0
  #frame: ViewFrame = { centre: [0, 0, 0], size: 1 }
  #handles: readonly ScreenPoint[] = []
  #shown: Frame | null = null
  /** Whether the gesture last shown is of the pointer here, under which the picture must not move. */
  #dragged = false
  #framed: { readonly preset: string | null; readonly start: Vertices } | null = null
  #drag: { readonly keys: DragKeys; readonly byTouch: boolean } | null = null

  constructor(host: ViewHost) {
    this.host = host
    this.#painter = createFacePainter({ lost: () => this.#onContext(true), restored: () => this.#onContext(false) })
    this.#colourBar = new ColourBar(referenceCube => host.dispatch({ type: 'show-reference-cube', referenceCube }))
    this.#controls = new Controls({
      fit: () => this.fit(false),
      toggleHelp: () => this.toggleHelp(),
      showFaces: faceDisplay => host.dispatch({ type: 'show-faces', faceDisplay }),
    })
    this.#build()
    this.#themeReader = new ThemeReader(this.root, () => host.requestFrame())
    this.#keyboard = new KeyboardInput(this)
    this.#pointer = new PointerInput(this, () => this.#keyboard.commit())
    this.#orbit = this.#createOrbit()
    this.#listen()
    if (this.#painter === null) host.raise({ code: 'no-webgl', message: NO_WEBGL })
    else host.clear('no-webgl')
  }

  get drawCalls(): number {
    return this.#painter?.drawCalls ?? 0
  }

  update(frame: Frame): void {
    const resized = this.#resize()
    if (this.#width === 0 || this.#height === 0) return
    this.#readTheme()
    this.#chooseFrame(frame, resized)
    this.#shown = frame
    this.#dragged = this.#pointer.isDragging
    this.#draw(frame)
  }

  dispose(): void {
    this.#listening.abort()
    this.#resizes.disconnect()
    this.#keyboard.commit()
    this.#pointer.dispose()
    this.#orbit.dispose()
    this.#themeReader.dispose()
    this.#painter?.dispose()
  }

  frame(): ViewFrame {
    return this.#frame
  }

  handles(): readonly ScreenPoint[] {
    return this.#handles
  }

  showHover(vertex: number | null): void {
    this.#overlay.showHover(vertex)
  }

  showDrag(keys: DragKeys | null, byTouch: boolean): void {
    this.#drag = keys && { keys, byTouch }
    this.host.requestFrame()
  }

  fit(toDefault: boolean): void {
    if (this.#pointer.isDragging) return
    const { vertices } = this.host.state()
    this.#frame = frameOf(vertices)
    this.#aim(vertices, toDefault)
    this.host.requestFrame()
  }

  orbit(right: number, up: number): void {
    const { three } = this.camera
    const eye = three.position.clone().sub(this.#orbit.target)
    const distance = eye.length()
    const azimuth = Math.atan2(eye.y, eye.x) + right * ORBIT_STEP
    const most = Math.PI / 2 - 0.01
    const elevation = Math.max(-most, Math.min(most, Math.asin(eye.z / distance) + up * ORBIT_STEP))
    eye.set(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation))
    three.position.copy(this.#orbit.target).addScaledVector(eye, distance)
    this.#orbit.update()
  }

  zoom(factor: number): void {
    const { three } = this.camera
    three.position.sub(this.#orbit.target).divideScalar(factor).add(this.#orbit.target)
    this.#orbit.update()
  }

  toggleHelp(): void {
    this.#help.toggle()
    this.#controls.showHelp(this.#help.isShown)
  }

  #build(): void {
    this.root.className = 'scene'
    this.element.className = 'scene-stage'
    this.element.tabIndex = 0
    this.element.dataset.cursor = 'orbit'
    this.element.setAttribute('role', 'application')
    this.element.setAttribute('aria-label', 'The hexahedron in space, eight vertices to move')
    this.element.setAttribute('aria-describedby', this.#help.root.id)
    if (this.#painter) this.element.append(this.#painter.canvas)
    this.element.append(this.#overlay.root)
    this.root.append(this.element, this.#colourBar.root, this.#help.root, this.#controls.root)
    this.root.classList.toggle('unpainted', this.#painter === null)
  }

  #createOrbit(): OrbitControls {
    const orbit = new OrbitControls(this.camera.three, this.element)
    this.element.style.touchAction = '' // the style sheet decides; the controls would take the page's scroll
    orbit.zoomToCursor = true
    orbit.zoomSpeed = 1.6
    orbit.minDistance = 0.05
    orbit.maxDistance = 1000
    orbit.addEventListener('change', () => this.host.requestFrame())
    return orbit
  }

  #listen(): void {
    const { signal } = this.#listening
    this.element.addEventListener('keydown', event => this.#onKey(event), { signal })
    this.element.addEventListener('keyup', event => this.#onKey(event), { signal })
    this.element.addEventListener('blur', () => this.#onBlur(), { signal })
    this.#resizes.observe(this.root)
    this.#watchPixelRatio()
  }

  /** A media query for the present ratio, since there is no event for another one. */
  #watchPixelRatio(): void {
    const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`)
    const onChange = () => {
      this.#watchPixelRatio()
      this.host.requestFrame()
    }
    query.addEventListener('change', onChange, { once: true, signal: this.#listening.signal })
  }

  #onKey(event: KeyboardEvent): void {
    if (this.#pointer.isDragging) this.#pointer.onKey(event)
    else if (event.type === 'keydown') {
      delete this.element.dataset.pointed
      this.#keyboard.onKeyDown(event)
    } else this.#keyboard.onKeyUp(event)
  }

  #onBlur(): void {
    delete this.element.dataset.pointed
    this.#keyboard.commit()
  }

  #onContext(lost: boolean): void {
    this.#contextLost = lost
    this.root.classList.toggle('unpainted', lost)
    if (lost) this.host.raise({ code: 'context-lost', message: CONTEXT_LOST })
    else this.host.clear('context-lost')
    this.host.requestFrame()
  }

  #onResize(entries: readonly ResizeObserverEntry[]): void {
    const { width, height } = (entries.at(-1) as ResizeObserverEntry).contentRect
    this.#box = { width: Math.round(width), height: Math.round(height) }
    this.host.requestFrame()
  }

  #resize(): boolean {
    const { width, height } = this.#box
    if (width === this.#width && height === this.#height) return false
    this.#width = width
    this.#height = height
    this.root.classList.toggle('narrow', this.#isNarrow)
    if (width > 0 && height > 0) this.camera.resize(width, height, this.#insets())
    return true
  }

  #insets(): Insets {
    return this.#isNarrow ? { top: 92, right: 36, bottom: 72, left: 36 } : { top: 56, right: 132, bottom: 72, left: 92 }
  }

  get #isNarrow(): boolean {
    return this.#width < NARROW
  }

  get #barLength(): number {
    const length = this.#isNarrow ? Math.min(200, this.#width - 210) : Math.min(220, this.#height * 0.3)
    return Math.round(Math.max(90, length))
  }

  /** What words other than the overlay's stand on. */
  #taken(): Box[] {
    const { width, height } = this.camera
    const bar = this.#isNarrow ? { width, height: 56 } : { width: 140, height: this.#barLength + 64 }
    return [
      { ...bar, x: width - bar.width, y: 0 },
      { x: 0, y: height - 48, width, height: 48 },
      { x: 0, y: 0, width: 84, height: 84 },
    ]
  }

  #readTheme(): void {
    const theme = this.#themeReader.read()
    if (theme === this.#theme) return
    this.#theme = theme
    this.#ramp = rampOf(theme)
  }

  /** The view frame stays while vertices are moved; another element, or what was typed out of the picture, is brought into view. */
  #chooseFrame({ state }: Frame, resized: boolean): void {
    const framed = this.#framed
    const before = this.#shown?.state
    const another = framed === null || framed.preset !== state.preset || framed.start !== state.start
    // A program that sets one element after another, none of them a preset, animates: the reader's view stays.
    const animated = another && framed !== null && framed.preset === null && state.preset === null
    const jumped = before && before.vertices !== state.vertices && !before.gestureStart && !state.gestureStart
    const typed = before?.gestureStart && !state.gestureStart && !this.#dragged
    this.#framed = { preset: state.preset, start: state.start }
    if ((another && !animated) || (jumped && !this.#isInView(state, animated ? 0.4 : 0.2))) {
      this.#frame = frameOf(state.vertices)
      this.#aim(state.vertices, another && !animated)
    } else if (typed && !this.#isInView(state, 0)) {
      this.#frame = frameOf(state.vertices)
      this.#aim(state.vertices, false)
    } else if (resized) {
      this.#aim(state.vertices, false)
    }
  }

  /** Whether the element is all there, and spans at least a share of the scene. */
  #isInView({ vertices }: State, share: number): boolean {
    this.camera.three.updateMatrixWorld()
    const points = verticesInView(this.#frame, vertices).map(point => this.camera.project(point))
    const { width, height } = this.camera
    const inside = points.every(
      ({ x, y, depth }) =>
        depth > 0 && x > -0.05 * width && x < 1.05 * width && y > -0.05 * height && y < 1.05 * height,
    )
    const spread = (of: (p: ScreenPoint) => number) => Math.max(...points.map(of)) - Math.min(...points.map(of))
    return inside && Math.max(spread(p => p.x) / width, spread(p => p.y) / height) > share
  }

  #aim(vertices: Vertices, toDefault: boolean): void {
    const points = verticesInView(this.#frame, vertices)
    const target = this.camera.fit(points, toDefault ? DEFAULT_DIRECTION : undefined)
    this.#orbit.target.set(...target)
    this.#orbit.update()
  }

  #draw({ state, report }: Frame): void {
    const { camera } = this
    const vertices = verticesInView(this.#frame, state.vertices)
    camera.enclose(vertices)
    this.#handles = vertices.map(point => camera.project(point))
    const theme = this.#theme as Theme
    const ramp = this.#ramp as Ramp
    const scale = report && colourScaleOf(report.boundaryMinimum, report.boundaryMaximum)
    if (this.#painter && !this.#contextLost) {
      this.#painter.paint({
        vertices,
        report,
        scale,
        ramp,
        theme,
        display: state.faceDisplay,
        camera,
        width: this.#width,
        height: this.#height,
        pixelRatio: Math.min(devicePixelRatio, MOST_PIXEL_RATIO),
      })
      this.framesDrawn++
      this.root.dataset.frames = String(this.framesDrawn)
    }
    const picture = { state, report, frame: this.#frame, camera, handles: this.#handles, drag: this.#drag }
    this.#overlay.update({ ...picture, taken: this.#taken() })
    this.#colourBar.update({ state, report, scale, ramp, upright: !this.#isNarrow, length: this.#barLength })
    this.#controls.update(state.faceDisplay, report)
  }
}

export const createScene = (host: ViewHost): SceneView => new Scene(host)
createScene satisfies CreateView
