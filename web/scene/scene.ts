/**
 * The element in physical space: faces coloured by jacdet in WebGL, and over them, in SVG, edges, handles, marks and words.
 * Draws what a frame says and emits actions; one picture per update and none in between.
 *
 * Dragged coordinates are rounded to the power of ten at or below one pixel's length. Keys: see help.ts; the digit on a
 * handle chooses that handle.
 */
import { pointOfValue } from '../core/point-of-value'
import type { Candidate, Report } from '../core/report'
import type { Vec3 } from '../model/hexahedron'
import type { Cameras, CameraView, State } from '../model/state'
import type { CreateView, Figure, FigureName, Frame, Turn, View, ViewHost } from '../views/view'
import { Controls } from './input/controls'
import { pointUnder } from './input/face-hit'
import type { Stage } from './input/input-target'
import { KeyboardInput } from './input/keyboard-input'
import { PointerInput } from './input/pointer-input'
import { nextCandidate, samePoint } from './input/probe-candidates'
import { ProbeInput } from './input/probe-input'
import type { DragKeys } from './input/vertex-drag'
import { ColourBar } from './overlay/colour-bar'
import { Help } from './overlay/help'
import { Overlay, type OverlayPicture } from './overlay/overlay'
import { Readout, spokenProbe } from './overlay/readout'
import { type ColourScale, colourScaleInside, colourScaleOf, type Ramp, rampOf, type Theme } from './paint/colour-map'
import { faceContext } from './paint/face-context'
import { createFacePainter, type FacePainter } from './paint/face-painter'
import type { Picture, Region } from './paint/face-renderer'
import { figureOf } from './paint/figure'
import { FlatPainter } from './paint/flat-painter'
import { PaperCopy } from './paint/paper-copy'
import { pixelRatio, watchPixelRatio } from './paint/pixel-ratio'
import { ThemeReader } from './paint/theme'
import { ReferenceCube } from './reference-cube'
import css from './scene.css?inline'
import type { ScreenPoint } from './space/camera'
import { Framing } from './space/framing'
import { LinkedViews } from './space/linked-views'
import { Viewpoint } from './space/orbit-camera'
import { Room } from './space/room'
import { placeIn } from './space/unit'
import { type ViewFrame, verticesInView } from './space/world'

export const sceneStyles = css

/** What belongs in a figure: not the controls, nor what is there for the pointer. */
const FIGURE_PARTS = 'canvas, .scene-flat, .scene-overlay, .scene-scale > *'

const NO_WEBGL =
  'This browser gives no WebGL2, so the faces are coloured in coarse tiles. Everything else is as it should be, and the verdict holds.'
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
  readonly turns: readonly Turn[] = [frame => this.#drawColourBar(frame)]
  readonly host: ViewHost
  framesDrawn = 0
  isLoading = false

  readonly #painter: FacePainter
  readonly #paperCopy: PaperCopy | null
  readonly #pane = document.createElement('div')
  readonly #room = new Room(this.root, this.#pane)
  readonly #overlay = new Overlay({ letters: ['x', 'y', 'z'], isFixed: false })
  readonly #readout = new Readout()
  readonly #said = document.createElement('p')
  readonly #colourBar: ColourBar
  readonly #controls: Controls
  readonly #help = new Help('scene-help')
  readonly #viewpoint: Viewpoint
  readonly #framing: Framing
  readonly #links: LinkedViews
  readonly #probe: ProbeInput
  readonly #pointer: PointerInput
  readonly #keyboard: KeyboardInput
  readonly #themeReader: ThemeReader
  readonly #listening = new AbortController()
  readonly #resizes = new ResizeObserver(() => this.#onResize())
  #theme: Theme | null = null
  #ramp: Ramp | null = null
  #contextLost = false
  #isForFigure = false
  /** Whether the browser has laid it out once: what asks for that in the frame that adds it to the page makes it a long one. */
  #isPlaced = false
  /** Made when it is first shown. */
  #reference: ReferenceCube | null = null
  #sizeMayDiffer = true
  #handles: readonly ScreenPoint[] = []
  #shown: Frame | null = null
  /** What was last asked for, and done. */
  #asked: Cameras | null = null
  /** Whether the gesture last shown is of the pointer here, under which the picture must not move. */
  #dragged = false
  #drag: OverlayPicture['drag'] = null
  #drawnDrag: OverlayPicture['drag'] = null
  /** The candidate that a key pointed at, to be said in the next frame. */
  #toSay: Candidate | null = null

  constructor(host: ViewHost) {
    this.host = host
    const context = { lost: () => this.#onContext(true), restored: () => this.#onContext(false) }
    const painter = createFacePainter(context)
    this.#painter = painter ?? new FlatPainter()
    this.#colourBar = new ColourBar(
      referenceCube => host.dispatch({ type: 'show-reference-cube', referenceCube }),
      value => this.#lookAtValue(value),
    )
    this.#controls = new Controls({
      fit: () => this.fit(false),
      toggleHelp: () => host.dispatch({ type: 'show-help', helpShown: !host.state().helpShown }),
      toggleReference: () => this.toggleReference(),
      orbit: (right, up) => this.orbit(right, up),
      zoom: factor => this.zoom(factor),
      showFaces: faceDisplay => host.dispatch({ type: 'show-faces', faceDisplay }),
    })
    this.#viewpoint = new Viewpoint(this.element, () => this.#onTurn(this.#viewpoint))
    this.#framing = new Framing(this.#viewpoint)
    this.#links = new LinkedViews(this.#viewpoint, () => host.state())
    this.#build()
    this.#themeReader = new ThemeReader(this.root, () => host.requestFrame())
    this.#keyboard = new KeyboardInput(this)
    this.#pointer = new PointerInput(this, () => this.#keyboard.commit())
    this.#probe = new ProbeInput(this)
    this.#listen()
    const { root } = this.#painter
    this.#paperCopy = root instanceof HTMLCanvasElement ? new PaperCopy(root) : null
    if (painter === null) host.raise({ code: 'no-webgl', message: NO_WEBGL })
    else host.clear('no-webgl')
    if (this.#painter.isLost) this.#onContext(true)
  }

  get camera() {
    return this.#viewpoint.camera
  }

  get movesVertices(): boolean {
    return !this.host.state().isReadonly
  }

  get drawCalls(): number {
    return this.#painter.drawCalls
  }

  update(frame: Frame): void {
    const { state, isForPaper } = frame
    if (!this.#isPlaced && !isForPaper) {
      this.#place()
      return
    }
    this.root.style.visibility = ''
    this.#name(state)
    const before = this.#shown?.state ?? null
    const isOtherMedium = isForPaper !== (this.#shown?.isForPaper ?? false)
    this.#sizeMayDiffer ||= isOtherMedium
    const resized = this.#resize(state)
    if (this.#room.isEmpty) return
    this.#readTheme()
    if (isForPaper) this.#framing.putOnPaper(state.vertices)
    else if (isOtherMedium) this.#framing.leavePaper()
    else this.#framing.choose(state, { before, resized, isDragged: this.#dragged })
    this.#look(frame)
    this.#links.join(state, before)
    this.#probe.update()
    this.#draw(frame)
    this.#paperCopy?.update(isForPaper, this.framesDrawn)
    this.#sayProbe(frame)
    this.#shown = frame
    this.#dragged = this.#pointer.isDragging
  }

  dispose(): void {
    this.#listening.abort()
    this.#resizes.disconnect()
    this.#keyboard.commit()
    this.#pointer.dispose()
    this.#probe.dispose()
    this.#viewpoint.dispose()
    this.#reference?.dispose()
    this.#themeReader.dispose()
    this.#painter.dispose()
  }

  figure(name: FigureName): Figure | null {
    if (name !== 'scene' || this.#shown === null) return null
    this.#isForFigure = true
    this.#draw(this.#shown)
    this.#isForFigure = false
    this.host.requestFrame()
    return figureOf(this.root, this.root.querySelectorAll(FIGURE_PARTS))
  }

  cameras(): Cameras | null {
    if (this.#shown === null) return null
    return {
      camera: this.#framing.seen(this.#shown.state.vertices),
      referenceCamera: this.#reference ? this.#reference.view() : (this.#asked?.referenceCamera ?? null),
    }
  }

  frame(): ViewFrame {
    return this.#framing.frame
  }

  placeOf(event: MouseEvent) {
    return placeIn(this.element, this.#room.unit, event)
  }

  handles(): readonly ScreenPoint[] {
    return this.movesVertices ? this.#handles : []
  }

  showHover(vertex: number | null): void {
    this.#overlay.showHover(vertex)
  }

  pointAt(x: number, y: number): Vec3 | null {
    const { camera } = this
    const state = this.host.state()
    const vertices = verticesInView(this.#framing.frame, state.vertices)
    return pointUnder({ camera, vertices, handles: this.#handles, state }, x, y)
  }

  probeNext(): void {
    const report = this.#shown?.report
    if (!report) return
    const next = nextCandidate(report, this.host.state().probe)
    this.#probe.letGo()
    this.#reference?.letGo()
    this.#toSay = next
    this.host.dispatch({ type: 'probe', point: next.point })
  }

  #lookAtValue(value: number | null): void {
    const report = this.#shown?.report
    if (!report) return
    this.#probe.letGo()
    this.#reference?.letGo()
    this.host.dispatch({ type: 'probe', point: value === null ? null : pointOfValue(report, value) })
  }

  toggleReference(): void {
    const referenceShown = !this.host.state().referenceShown
    if (!referenceShown && this.#reference?.element.matches(':focus')) this.element.focus()
    this.host.dispatch({ type: 'show-reference', referenceShown })
  }

  showDrag(keys: DragKeys | null, byTouch: boolean): void {
    this.#drag = keys && { keys, byTouch }
    this.#probe.clear()
    this.host.requestFrame()
  }

  fit(toDefault: boolean): void {
    if (this.#pointer.isDragging) return
    this.#framing.fit(this.host.state().vertices, toDefault)
    this.host.requestFrame()
  }

  orbit(right: number, up: number): void {
    this.#viewpoint.turn(right, up)
  }

  zoom(factor: number): void {
    this.#viewpoint.zoom(factor)
  }

  #build(): void {
    this.root.className = 'scene'
    this.element.className = 'scene-stage'
    this.element.tabIndex = 0
    this.element.dataset.cursor = 'orbit'
    this.element.setAttribute('role', 'application')
    this.element.setAttribute('aria-describedby', this.#help.root.id)
    this.#overlay.root.append(this.#readout.root)
    this.element.append(this.#overlay.root)
    this.#said.className = 'scene-said said'
    this.#said.setAttribute('aria-live', 'polite')
    this.#pane.className = 'scene-pane'
    this.#pane.append(this.element, this.#colourBar.root, this.#help.root, this.#controls.root, this.#said)
    this.root.append(this.#painter.root, this.#pane)
  }

  #place(): void {
    this.#isPlaced = true
    this.isLoading = true
    this.root.style.visibility = 'hidden'
    this.host.requestFrame()
  }

  #onTurn(from: Viewpoint): void {
    this.#links.follow(from)
    this.host.requestFrame()
  }

  #name({ isReadonly }: State): void {
    if (isReadonly === this.#shown?.state.isReadonly) return
    const name = isReadonly ? 'The hexahedron in space' : 'The hexahedron in space, eight vertices to move'
    this.element.setAttribute('aria-label', name)
  }

  #createReference(): ReferenceCube {
    const reference = new ReferenceCube(this, () => this.#onTurn(reference.viewpoint))
    reference.look(this.#asked?.referenceCamera ?? null)
    this.#links.other = reference.viewpoint
    this.root.append(reference.root)
    return reference
  }

  #listen(): void {
    const { signal } = this.#listening
    this.element.addEventListener('keydown', event => this.#onKey(event), { signal })
    this.element.addEventListener('keyup', event => this.#onKey(event), { signal })
    this.element.addEventListener('blur', () => this.#onBlur(), { signal })
    this.#resizes.observe(this.root)
    watchPixelRatio(() => this.host.requestFrame(), signal)
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

  #onResize(): void {
    this.#sizeMayDiffer = true
    this.host.requestFrame()
  }

  /** Lays out the parts. Where the element's own part has another size than before: how it was looked at; else null. */
  #resize({ referenceShown }: State): { readonly camera: CameraView | null } | null {
    const shownBefore = this.#shown?.state.referenceShown ?? false
    if (!this.#sizeMayDiffer && referenceShown === shownBefore) return null
    this.#sizeMayDiffer = false
    if (referenceShown) this.#reference ??= this.#createReference()
    if (this.#reference) this.#reference.root.hidden = !referenceShown
    const before = this.#shown && this.#framing.seen(this.#shown.state.vertices)
    const isResized = this.#room.measure(referenceShown)
    if (referenceShown) this.#reference?.resize(this.#room.unit)
    const { own, layout } = this.#room
    if (isResized && !this.#room.isEmpty) this.camera.resize(own.width, own.height, layout.insets)
    return isResized ? { camera: before } : null
  }

  #readTheme(): void {
    const theme = this.#themeReader.read()
    if (theme === this.#theme) return
    this.#theme = theme
    this.#ramp = rampOf(theme)
  }

  /** As a program asked for it, once. */
  #look({ state, cameras }: Frame): void {
    if (cameras === null || cameras === this.#asked) return
    this.#asked = cameras
    this.#framing.look(state.vertices, cameras.camera)
    this.#reference?.look(cameras.referenceCamera)
  }

  /** Where only the probe has changed, nothing else is touched. */
  #draw(frame: Frame): void {
    const { camera } = this
    const { state, report, probe } = frame
    const vertices = verticesInView(this.#framing.frame, state.vertices)
    camera.enclose(vertices)
    this.#handles = vertices.map(point => camera.project(point))
    const reference = state.referenceShown ? this.#reference : null
    reference?.prepare()
    const own = { left: 0, top: 0, vertices, camera }
    if (this.#paint(frame, reference ? [own, reference.region] : [own]) || this.#differs(frame)) {
      this.#drawnDrag = this.#drag
      const picture = { state, report, frame: this.#framing.frame, camera, handles: this.#handles, drag: this.#drag }
      this.#overlay.update({ ...picture, taken: this.#room.layout.taken })
      this.#controls.update(state, report)
      this.#help.show(state.helpShown)
      reference?.update(frame)
    }
    this.#overlay.updateProbe(probe, this.#framing.frame, camera, this.#room.layout.readout)
    this.#readout.update(probe, state.referenceCube, this.#room.layout.isNarrow)
    reference?.updateProbe(probe)
  }

  /** Whether there is another picture now; true where nobody can tell. */
  #paint({ state, report, zeroSurface, isForPaper }: Frame, regions: readonly Region[]): boolean {
    if (this.#contextLost) return true
    const picture: Picture = {
      ...this.#room.whole,
      report,
      scale: scaleOf(state, report),
      ramp: this.#ramp as Ramp,
      theme: this.#theme as Theme,
      display: state.faceDisplay,
      section: state.section,
      zeroSurface,
      regions,
      pixelRatio: this.#room.unit * pixelRatio(this.#isForFigure || isForPaper),
    }
    const isDueNow = isForPaper || this.#isForFigure
    this.isLoading = !isDueNow && !this.#painter.isReady(picture)
    if (this.isLoading) {
      this.host.requestFrame()
      return true
    }
    const painted = this.#painter.paint(picture)
    if (painted) this.framesDrawn++
    this.root.dataset.frames = String(this.framesDrawn)
    return painted
  }

  #drawColourBar({ state, report, probe }: Frame): void {
    const ramp = this.#ramp
    if (ramp === null || this.#room.isEmpty) return
    const { isNarrow, barLength: length } = this.#room.layout
    const scale = scaleOf(state, report)
    this.#colourBar.update({ state, report, probe, scale, ramp, upright: !isNarrow, length })
  }

  /** Whether a frame says more than that something else is pointed at. */
  #differs({ state, report }: Frame): boolean {
    const before = this.#shown
    if (before === null || before.report !== report || this.#drag !== this.#drawnDrag) return true
    const keys = Object.keys(state) as (keyof State)[]
    return keys.some(key => key !== 'probe' && !Object.is(state[key], before.state[key]))
  }

  #sayProbe({ state, probe, report }: Frame): void {
    const at = this.#toSay
    this.#toSay = null
    if (probe === null) this.#said.textContent = ''
    else if (at !== null && report) {
      this.#said.textContent = spokenProbe(probe, at, samePoint(at.point, report.minimizer.point), state.referenceCube)
    }
  }
}

function scaleOf({ faceDisplay }: State, report: Report | null): ColourScale | null {
  if (report === null) return null
  return faceDisplay === 'inside'
    ? colourScaleInside(report)
    : colourScaleOf(report.boundaryMinimum, report.boundaryMaximum)
}

/** Asks for what takes the browser longest. */
export const prepareScene = (): void => void faceContext()

export const createScene = (host: ViewHost): SceneView => new Scene(host)
createScene satisfies CreateView
