/**
 * The reference cube [0,1]^3 beside the element: the same colours, marks and point, in (xi, eta, zeta). It is drawn as the element
 * whose vertices are the cube's own; they cannot be moved, so dragging and arrow keys turn it.
 */
import type { Candidate, JacobianReport, Report } from '../core/report'
import { type Vec3, vertexReference } from '../model/hexahedron'
import type { CameraView } from '../model/state'
import type { Frame, ViewHost } from '../views/view'
import { pointUnder } from './input/face-hit'
import type { Stage } from './input/input-target'
import { KeyboardInput } from './input/keyboard-input'
import { PointerInput } from './input/pointer-input'
import { ProbeInput } from './input/probe-input'
import { Overlay } from './overlay/overlay'
import type { Region } from './paint/face-renderer'
import type { ScreenPoint } from './space/camera'
import { Viewpoint } from './space/orbit-camera'
import { placeIn } from './space/unit'
import { frameOf, verticesInView } from './space/world'

const CUBE = vertexReference.flat()
const FRAME = frameOf(CUBE)
const CORNERS = verticesInView(FRAME, CUBE)
const INSETS = { top: 56, right: 44, bottom: 72, left: 44 }
const AXES: readonly [Vec3, Vec3, Vec3] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]

const HELP =
  'Drag or the arrow keys turn it, plus and minus zoom, F fits. Point at a face, or tap it, and the same point is marked in space. P points at the minimizer, then at one candidate after another.'

/** What it has in common with the element's own scene. */
type Shared = Pick<Stage, 'probeNext' | 'toggleReference'> & { readonly host: ViewHost }

export class ReferenceCube implements Stage {
  readonly root = document.createElement('div')
  readonly element = document.createElement('div')
  readonly viewpoint: Viewpoint
  readonly host: ViewHost
  readonly movesVertices = false
  readonly #shared: Shared
  readonly #overlay = new Overlay({ letters: ['ξ', 'η', 'ζ'], isFixed: true })
  readonly #pointer: PointerInput
  readonly #keyboard: KeyboardInput
  readonly #probe: ProbeInput
  readonly #link = document.createElement('input')
  readonly #listening = new AbortController()
  #corners: readonly ScreenPoint[] = []
  #unit = 1
  #left = 0
  #top = 0
  /** To be looked at so once it has a size; null is the default view. */
  #asked: CameraView | null = null
  #hasSize = false
  /** The report last shown, and the same with candidates where they are in the cube. */
  #report: Report | null = null
  #reportHere: Report | null = null

  /** `onTurn` is told of every move of its camera. */
  constructor(shared: Shared, onTurn: () => void) {
    this.#shared = shared
    this.host = shared.host
    this.#build()
    this.viewpoint = new Viewpoint(this.element, onTurn)
    this.#keyboard = new KeyboardInput(this)
    this.#pointer = new PointerInput(this, () => this.#keyboard.commit())
    this.#probe = new ProbeInput(this)
  }

  get camera() {
    return this.viewpoint.camera
  }

  /** Where it is in the canvas. */
  get region(): Region {
    return { left: this.#left, top: this.#top, vertices: CORNERS, camera: this.camera }
  }

  /** To the box that it is laid out in. */
  resize(unit: number): void {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = this.root
    const view = this.view()
    this.#unit = unit
    this.#left = offsetLeft / unit
    this.#top = offsetTop / unit
    this.camera.resize(Math.max(offsetWidth, 1) / unit, Math.max(offsetHeight, 1) / unit, INSETS)
    this.#hasSize = true
    this.look(view)
  }

  /** How it is looked at; null in the default view. */
  view(): CameraView | null {
    return this.#hasSize ? this.viewpoint.seen(CORNERS, 1) : this.#asked
  }

  look(view: CameraView | null): void {
    this.#asked = view
    if (this.#hasSize) this.viewpoint.look(CORNERS, 1, view)
  }

  /** Before the picture is painted. */
  prepare(): void {
    this.#probe.update()
    this.camera.enclose(CORNERS)
    this.#corners = CORNERS.map(corner => this.camera.project(corner))
  }

  update({ state, report }: Frame): void {
    this.#link.checked = state.camerasLinked
    this.#overlay.update({
      state: { ...state, vertices: CUBE, gestureStart: null, previewedOrder: null, previewedMove: null },
      report: this.#inCube(report),
      frame: FRAME,
      camera: this.camera,
      handles: this.#corners,
      drag: null,
      taken: [],
    })
  }

  /** The columns of the map's derivative are the images of the axes. */
  updateProbe(probe: JacobianReport | null): void {
    const here = probe && { ...probe, position: probe.point, columns: AXES, axisExponents: [0, 0, 0] as const }
    this.#overlay.updateProbe(here, FRAME, this.camera)
  }

  /** What is marked now is not this pointer's. */
  letGo(): void {
    this.#probe.letGo()
  }

  dispose(): void {
    this.#listening.abort()
    this.#pointer.dispose()
    this.#probe.dispose()
    this.viewpoint.dispose()
  }

  frame() {
    return FRAME
  }

  placeOf(event: MouseEvent) {
    return placeIn(this.element, this.#unit, event)
  }

  handles(): readonly ScreenPoint[] {
    return []
  }

  pointAt(x: number, y: number): Vec3 | null {
    const { camera, host } = this
    return pointUnder({ camera, vertices: CORNERS, handles: this.#corners, state: host.state() }, x, y)
  }

  showHover(): void {}

  showDrag(): void {}

  fit(toDefault: boolean): void {
    this.viewpoint.aim(CORNERS, toDefault)
    this.host.requestFrame()
  }

  orbit(right: number, up: number): void {
    this.viewpoint.turn(right, up)
  }

  zoom(factor: number): void {
    this.viewpoint.zoom(factor)
  }

  probeNext(): void {
    this.#shared.probeNext()
  }

  toggleReference(): void {
    this.#shared.toggleReference()
  }

  #build(): void {
    this.root.className = 'reference'
    this.element.className = 'scene-stage'
    this.element.tabIndex = 0
    this.element.setAttribute('role', 'application')
    this.element.setAttribute('aria-label', 'The reference cube, in xi, eta and zeta')
    this.element.setAttribute('aria-describedby', 'reference-help')
    const help = document.createElement('p')
    help.id = 'reference-help'
    help.hidden = true
    help.textContent = HELP
    this.element.append(this.#overlay.root)
    this.root.append(this.element, help, this.#createLink())
    this.#listen()
  }

  #createLink(): HTMLElement {
    const label = document.createElement('label')
    label.className = 'reference-link'
    label.title = 'Turning one turns the other'
    this.#link.type = 'checkbox'
    this.#link.addEventListener('change', () => {
      this.host.dispatch({ type: 'link-cameras', camerasLinked: this.#link.checked })
    })
    label.append(this.#link, 'Link views')
    return label
  }

  #listen(): void {
    const { signal } = this.#listening
    const clear = () => {
      delete this.element.dataset.pointed
    }
    this.element.addEventListener(
      'keydown',
      event => {
        clear()
        this.#keyboard.onKeyDown(event)
      },
      { signal },
    )
    this.element.addEventListener('blur', clear, { signal })
  }

  #inCube(report: Report | null): Report | null {
    if (report === this.#report) return this.#reportHere
    const here = (candidate: Candidate): Candidate => ({ ...candidate, position: candidate.point })
    this.#report = report
    this.#reportHere = report && {
      ...report,
      minimizer: here(report.minimizer),
      volumeMinimum: { ...report.volumeMinimum, position: report.volumeMinimum.point },
      candidates: report.candidates.map(here),
    }
    return this.#reportHere
  }
}
