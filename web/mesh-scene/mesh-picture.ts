/**
 * The picture of a mesh: layers of faces on a canvas, the chosen cell's edges in SVG above them. Drawn when something has changed,
 * once a frame. Without WebGL nothing is drawn, and `isDrawn` says so.
 */
import { LinearSRGBColorSpace, Scene, WebGLRenderer } from 'three'
import type { Vec3, Vertices } from '../model/hexahedron'
import type { CameraView } from '../model/state'
import { OrbitInput } from '../scene/input/orbit-input'
import { type Ramp, rampOf, type Theme } from '../scene/paint/colour-map'
import { lightOf } from '../scene/paint/shading'
import { ThemeReader } from '../scene/paint/theme'
import type { Ray, SceneCamera } from '../scene/space/camera'
import type { Point } from '../scene/space/layout'
import { OrbitCamera } from '../scene/space/orbit-camera'
import { mix } from '../scene/space/vec3'
import type { Bounds, Neighbour } from '../survey/survey-jobs'
import { placeIn } from '../views/place-in'
import { type Colouring, coloursOf, oneColour, plainColour, SOFT } from './cell-colour'
import { type Outline, outlinesOf, strokeOutlines } from './chosen-cell'
import { FaceLayer } from './face-layer'
import { type Content, LoadedFaces, NO_CONTENT } from './loaded-faces'
import { type FaceHit, firstHit } from './ray'

/** What was drawn, for those who draw over it. */
export interface PictureSpace {
  readonly camera: SceneCamera
  /** World units a unit of the mesh; the origin of faces is that of the world. */
  readonly scale: number
  /** Of faces, in the mesh. */
  readonly origin: Vec3
  /** Of the bounds, in world space. */
  readonly corners: readonly Vec3[]
  readonly theme: Theme
  readonly ramp: Ramp
  /** Of a positive colour on the surface; the rest is the paper's. */
  readonly share: number
}

/** Half of the longest side of the bounds in world space. */
const HALF_EXTENT = 1
const NO_BOUNDS: Bounds = { least: [0, 0, 0], greatest: [1, 1, 1] }

export class MeshPicture {
  /** Null where there is no WebGL. */
  readonly #renderer: WebGLRenderer | null
  readonly #root: HTMLElement
  readonly #canvas = document.createElement('canvas')
  readonly #overlay = document.createElementNS('http://www.w3.org/2000/svg', 'svg')
  readonly #camera = new OrbitCamera(() => this.draw())
  readonly #listening = new AbortController()
  readonly #theme: ThemeReader
  readonly #scene = new Scene()
  readonly #faces = new LoadedFaces()
  /** The ghost is what the picture is cut from, as a shadow. */
  readonly #layers = { surface: new FaceLayer(), invalid: new FaceLayer(), ghost: new FaceLayer(GHOST) }
  readonly #observer: ResizeObserver
  #corners: readonly Vec3[] = []
  #origin: Vec3 = [0, 0, 0]
  #scale = 1
  #chosen: Vertices | null = null
  #neighbours: readonly Neighbour[] = []
  #painted: { readonly theme: Theme; readonly ramp: Ramp } | null = null
  #frame = 0
  #finding: ReturnType<typeof setTimeout> | undefined
  #isNew = true
  #first: CameraView | null = null
  readonly #takesWheel: (event: WheelEvent) => boolean
  #colouring: Colouring = 'all'
  /** CSS pixels that are kept free above the mesh. */
  top = MARGIN
  /** Called after each frame. */
  onDraw: ((space: PictureSpace) => void) | null = null

  /** A picture among others' content leaves the wheel to the page, but for events that `takesWheel` accepts. */
  constructor(root: HTMLElement, takesWheel: (event: WheelEvent) => boolean = () => true) {
    this.#root = root
    this.#takesWheel = takesWheel
    this.#canvas.className = 'mesh-canvas'
    this.#overlay.classList.add('mesh-overlay')
    this.#overlay.setAttribute('aria-hidden', 'true')
    root.append(this.#canvas, this.#overlay)
    this.#renderer = rendererOn(this.#canvas)
    this.#listen()
    this.#theme = new ThemeReader(root, () => this.draw())
    this.#observer = new ResizeObserver(() => this.draw())
    this.#observer.observe(root)
  }

  get isDrawn(): boolean {
    return this.#renderer !== null
  }

  /** The camera, for `open`; null if nothing has moved it. */
  get view(): CameraView | null {
    return this.#isNew ? this.#first : this.#camera.cameraView(this.#corners, HALF_EXTENT)
  }

  /** The default view for null. */
  look(view: CameraView | null): void {
    this.#first = view
    this.#isNew = true
    this.draw()
  }

  set colouring(colouring: Colouring) {
    if (this.#colouring === colouring) return
    this.#colouring = colouring
    this.#recolour()
    this.draw()
  }

  /** Another mesh, seen whole, or as a picture of it was. */
  open(bounds: Bounds | null, view: CameraView | null = null): void {
    this.#first = view
    const { least, greatest } = bounds ?? NO_BOUNDS
    this.#origin = [0, 1, 2].map(axis => least[axis as 0] / 2 + greatest[axis as 0] / 2) as unknown as Vec3
    const half = [0, 1, 2].map(axis => (greatest[axis as 0] - least[axis as 0]) / 2)
    this.#scale = HALF_EXTENT / (Math.max(...half) || 1)
    this.#bound(bounds)
    this.#chosen = null
    this.#neighbours = []
    this.#isNew = true
    this.#take(NO_CONTENT)
    this.draw()
  }

  /** The same mesh at another time, at the same scale: what has moved is seen to have moved. */
  step(bounds: Bounds | null): void {
    this.#bound(bounds)
    this.draw()
  }

  /** The middle of bounds, less the origin of the picture. */
  middleOf(bounds: Bounds | null): Vec3 {
    const { least, greatest } = bounds ?? NO_BOUNDS
    return this.#origin.map((own, axis) => least[axis as 0] / 2 + greatest[axis as 0] / 2 - own) as unknown as Vec3
  }

  #bound(bounds: Bounds | null): void {
    const { least, greatest } = bounds ?? NO_BOUNDS
    const sides = (axis: 0 | 1 | 2) =>
      [least, greatest].map(corner => (corner[axis] - this.#origin[axis]) * this.#scale)
    this.#corners = sides(0).flatMap(x => sides(1).flatMap(y => sides(2).map((z): Vec3 => [x, y, z])))
  }

  /** What was shown stays until all of it is loaded: most is at once. */
  show(content: Content): void {
    this.#take(content)
    // The painter begins now, and has the time until the next frame.
    if (this.#faces.isLoading) this.draw()
    else this.#drawNow()
  }

  #take(content: Content): void {
    if (!this.#renderer) return
    const gl = this.#gl(this.#renderer)
    this.#faces.put(content, gl)
    this.#load(gl)
  }

  #gl(renderer: WebGLRenderer): WebGL2RenderingContext {
    return renderer.getContext() as WebGL2RenderingContext
  }

  /** The chosen cell stands out, its neighbours are thin lines, invalid ones red. */
  choose(vertices: Vertices | null, neighbours: readonly Neighbour[] = []): void {
    this.#chosen = vertices
    this.#neighbours = neighbours
    this.draw()
  }

  /** The whole mesh. */
  fit(): void {
    this.#camera.fit(this.#corners)
    this.draw()
  }

  /** Looks at a cell, with its surroundings. */
  flyTo(vertices: Vertices): void {
    const points = this.#worldOf(vertices)
    const middle = [0, 1, 2].map(axis => points.reduce((sum, point) => sum + (point[axis as 0] as number), 0) / 8)
    const around = points.map(
      point =>
        point.map(
          (value, axis) => (middle[axis] as number) + SURROUNDINGS * (value - (middle[axis] as number)),
        ) as unknown as Vec3,
    )
    this.#camera.fit(around)
    this.draw()
  }

  /** What keys do with the camera. */
  readonly keys: Readonly<Record<string, () => void>> = {
    ArrowLeft: () => this.#camera.turn(-1, 0),
    ArrowRight: () => this.#camera.turn(1, 0),
    ArrowUp: () => this.#camera.turn(0, 1),
    ArrowDown: () => this.#camera.turn(0, -1),
    '+': () => this.#camera.zoom(1.25),
    '-': () => this.#camera.zoom(0.8),
    f: () => this.fit(),
  }

  /** From the target to the eye, of length 1. */
  get direction(): Vec3 {
    return this.#camera.direction
  }

  /** The line of sight of a pointer, in world space. */
  rayOf(event: MouseEvent): Ray {
    const place = this.#placeOf(event)
    return this.#camera.camera.ray(place.x, place.y)
  }

  /** The cell at a pointer; null beside the mesh. An invalid one is seen through a translucent surface, unless that is not wanted. */
  cellAt(event: PointerEvent, { isThrough = true } = {}): number | null {
    const { origin, direction } = this.rayOf(event)
    const from = origin.map(value => value / this.#scale) as unknown as Vec3
    const { content, lists } = this.#faces
    const hitOf = (name: keyof typeof lists) => {
      const list = lists[name]
      const hidden = name === 'boundary' ? content.hidden : null
      return list && firstHit(list, hidden, { origin: from, direction }, content.size)
    }
    const invalid = hitOf('invalid')
    if (isThrough && this.#layers.surface.isTranslucent && invalid) return invalid.cell
    const hits = [hitOf('boundary'), hitOf('surface'), invalid].filter((hit): hit is FaceHit => hit !== null)
    return hits.reduce((first, hit) => (hit.distance < first.distance ? hit : first), hits[0] ?? NO_HIT).cell
  }

  /** Asks for a frame. */
  draw(): void {
    this.#frame ||= requestAnimationFrame(() => this.#drawNow())
  }

  #drawNow(): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    this.#draw()
  }

  /** The picture as it is, with its background. */
  async toPNG(
    over: (context: OffscreenCanvasRenderingContext2D, space: PictureSpace) => void = () => {},
  ): Promise<Blob> {
    this.#draw()
    const { width, height } = this.#canvas
    const copy = new OffscreenCanvas(width, height)
    const context = copy.getContext('2d') as OffscreenCanvasRenderingContext2D
    const [r, g, b] = this.#paint().theme.paper.map(part => Math.round(255 * part))
    context.fillStyle = `rgb(${r} ${g} ${b})`
    context.fillRect(0, 0, width, height)
    context.drawImage(this.#canvas, 0, 0)
    context.scale(width / this.#root.clientWidth, height / this.#root.clientHeight)
    strokeOutlines(context, this.#outlines, this.#paint().theme)
    over(context, this.#space)
    return copy.convertToBlob({ type: 'image/png' })
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame)
    clearTimeout(this.#finding)
    this.#observer.disconnect()
    this.#theme.dispose()
    this.#listening.abort()
    for (const layer of Object.values(this.#layers)) layer.dispose()
    if (this.#renderer) this.#faces.clear(this.#gl(this.#renderer))
    this.#renderer?.dispose()
    this.#renderer?.getContext().getExtension('WEBGL_lose_context')?.loseContext()
    this.#canvas.remove()
    this.#overlay.remove()
  }

  #placeOf(event: MouseEvent): Point {
    const { x, y } = placeIn(this.#root, event) ?? { x: 0, y: 0 }
    return { x: x * this.#root.clientWidth, y: y * this.#root.clientHeight }
  }

  #listen(): void {
    const { signal } = this.#listening
    const orbit = new OrbitInput(this.#camera, signal)
    const root = this.#root
    root.addEventListener(
      'pointerdown',
      event => {
        root.setPointerCapture(event.pointerId)
        orbit.begin(event, this.#placeOf(event))
      },
      { signal },
    )
    root.addEventListener('pointermove', event => orbit.move(event, this.#placeOf(event)), { signal })
    for (const type of ['pointerup', 'pointercancel'] as const)
      root.addEventListener(type, ({ pointerId }) => orbit.end(pointerId), { signal })
    const onWheel = (event: WheelEvent) => this.#takesWheel(event) && orbit.wheel(event, this.#placeOf(event))
    root.addEventListener('wheel', onWheel, { signal, passive: false })
    root.addEventListener('contextmenu', event => event.preventDefault(), { signal })
    const onRestored = () => {
      if (this.#renderer) this.#faces.renew(this.#gl(this.#renderer))
      this.draw()
    }
    this.#canvas.addEventListener('webglcontextrestored', onRestored, { signal })
  }

  #draw(): void {
    const { clientWidth: width, clientHeight: height } = this.#root
    if (width === 0 || height === 0) return
    if (this.#renderer) this.#load(this.#gl(this.#renderer))
    const { camera } = this.#camera
    // In another size the mesh is seen as it was: what fitted in fits in.
    const isResized = !this.#isNew && (camera.width !== width || camera.height !== height)
    const before = isResized ? this.view : null
    camera.resize(width, height, { top: this.top, right: MARGIN, bottom: MARGIN, left: MARGIN })
    if (isResized) this.#camera.look(this.#corners, HALF_EXTENT, before)
    if (this.#isNew && this.#corners.length > 0) {
      this.#isNew = false
      this.#camera.look(this.#corners, HALF_EXTENT, this.#first)
    }
    camera.enclose(this.#corners)
    const { theme } = this.#paint()
    const { x, y, z } = camera.three.position
    const pixelRatio = Math.min(devicePixelRatio, MOST_PIXEL_RATIO)
    const view = {
      scale: this.#scale,
      size: this.#faces.content.size,
      eye: [x, y, z] as Vec3,
      toLight: lightOf(camera),
      ink: theme.ink,
      pixelRatio,
    }
    for (const layer of Object.values(this.#layers)) layer.write(view)
    if (this.#renderer) {
      this.#resize(this.#renderer, width, height, pixelRatio)
      this.#renderer.clear()
      for (const pass of PASSES) this.#drawPass(this.#renderer, pass)
    }
    this.#drawChosen(width, height)
    this.onDraw?.(this.#space)
  }

  /** A size that is set makes the canvas's memory anew, also if it is the same. */
  #resize(renderer: WebGLRenderer, width: number, height: number, pixelRatio: number): void {
    const [wide, high] = [Math.floor(width * pixelRatio), Math.floor(height * pixelRatio)]
    if (this.#canvas.width === wide && this.#canvas.height === high && renderer.getPixelRatio() === pixelRatio) return
    renderer.setPixelRatio(pixelRatio)
    renderer.setSize(width, height, false)
  }

  #load(gl: WebGL2RenderingContext): void {
    const wasTranslucent = this.#opacity < 1
    if (this.#faces.load(gl)) {
      const { lists, content } = this.#faces
      const { surface, invalid, ghost } = this.#layers
      const some = (...own: readonly (typeof lists.surface)[]) => own.filter(list => list !== null)
      surface.lists = content.hidden ? some(lists.boundary, lists.surface) : some(lists.surface)
      invalid.lists = some(lists.invalid)
      ghost.lists = content.hasGhost ? some(lists.boundary) : []
      surface.opacity = content.opacity
      if (this.#opacity < 1 !== wasTranslucent) this.#recolour()
      this.#findLater(REST)
    }
    if (this.#faces.isLoading) this.draw()
  }

  /** Once faces have come to rest, it is found where they are, before anybody points at them. */
  #findLater(milliseconds: number): void {
    clearTimeout(this.#finding)
    this.#finding = setTimeout(() => this.#faces.find() && this.#findLater(0), milliseconds)
  }

  get #opacity(): number {
    return this.#faces.content.opacity
  }

  get #share(): number {
    return this.#opacity < 1 ? this.#opacity : SOFT
  }

  get #space(): PictureSpace {
    return {
      camera: this.#camera.camera,
      scale: this.#scale,
      origin: this.#origin,
      corners: this.#corners,
      share: this.#share,
      ...this.#paint(),
    }
  }

  /** Of a translucent surface only what is in front is blended with what is behind it: its depth comes first, alone. */
  #drawPass(renderer: WebGLRenderer, pass: (typeof PASSES)[number]): void {
    const { surface } = this.#layers
    const isTranslucent = surface.isTranslucent
    if (pass === 'depth' && !isTranslucent) return
    if (pass === 'depth') renderer.clearDepth()
    surface.beIn(pass)
    const { meshes } = this.#layers[pass === 'depth' ? 'surface' : pass]
    if (meshes.length === 0) return
    this.#scene.clear()
    this.#scene.add(...meshes)
    renderer.render(this.#scene, this.#camera.camera.three)
  }

  /** Colours anew where the theme is another. */
  #paint(): { readonly theme: Theme; readonly ramp: Ramp } {
    const theme = this.#theme.read()
    if (this.#painted?.theme === theme) return this.#painted
    const painted = { theme, ramp: rampOf(theme) }
    this.#painted = painted
    this.#recolour()
    return painted
  }

  #recolour(): void {
    const { ramp, theme } = this.#paint()
    const grey = mix(theme.paper, theme.ink, 0.5)
    const own = { ramp, none: grey, plain: plainColour(theme, this.#colouring) }
    const soft = this.#opacity < 1 ? null : { paper: theme.paper, share: SOFT }
    const { surface, invalid, ghost } = this.#layers
    for (const layer of [surface, invalid]) layer.colours = coloursOf({ ...own, soft })
    ghost.colours = oneColour(grey)
  }

  #drawChosen(width: number, height: number): void {
    this.#overlay.setAttribute('viewBox', `0 0 ${width} ${height}`)
    const paths = this.#outlines.map(({ kind, path }) => {
      const element = document.createElementNS('http://www.w3.org/2000/svg', 'path')
      element.setAttribute('class', kind)
      element.setAttribute('d', path)
      return element
    })
    this.#overlay.replaceChildren(...paths)
  }

  get #outlines(): readonly Outline[] {
    const { camera } = this.#camera
    return outlinesOf(this.#chosen, this.#neighbours, vertices =>
      this.#worldOf(vertices).map(point => camera.project(point)),
    )
  }

  #worldOf(vertices: Vertices): Vec3[] {
    return Array.from({ length: 8 }, (_, v) =>
      [0, 1, 2].map(axis => ((vertices[3 * v + axis] as number) - (this.#origin[axis as 0] as number)) * this.#scale),
    ) as unknown as Vec3[]
  }
}

const PASSES = ['invalid', 'depth', 'surface', 'ghost'] as const
const GHOST = { opacity: 0.1, lineOpacity: 0, writesDepth: false, showsHidden: true }
const NO_HIT = { cell: null, distance: Infinity }
/** Milliseconds without other faces. */
const REST = 200
/** CSS pixels about the mesh. */
const MARGIN = 24
/** A cell is shown with the space of so many of it along each axis. */
const SURROUNDINGS = 5
/** Beyond it nobody sees the difference, and software draws four times as long. */
const MOST_PIXEL_RATIO = 2

function rendererOn(canvas: HTMLCanvasElement): WebGLRenderer | null {
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true, powerPreference: 'high-performance' })
  if (!context) return null
  const renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true })
  renderer.outputColorSpace = LinearSRGBColorSpace
  renderer.setClearColor(0, 0)
  renderer.sortObjects = false
  renderer.autoClear = false
  return renderer
}
