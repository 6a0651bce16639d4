/**
 * The reference cube [0,1]^3 beside the element: the same colours, marks and probe, in (xi, eta, zeta). It is drawn as the element
 * whose vertices are the cube's own; they cannot be moved, so dragging and arrow keys turn it.
 */
import type { Candidate, JacobianReport, Report } from '../core/report'
import { type Vec3, vertexReference } from '../model/hexahedron'
import { type CameraView, type State, sliceChange, sliceOf } from '../model/state'
import { type PlacePoint, placeMarksOf } from '../views/place-marks'
import { sceneSlice } from '../views/scene-slices'
import type { Frame } from '../views/view'
import { say } from '../words/say'
import type { Viewport } from './paint/picture'
import { Pane, type PaneScene } from './pane'
import { DEFAULT_DIRECTION } from './space/camera'
import { verticesInWorld, worldOf } from './space/world'

const CUBE = vertexReference.flat()
const WORLD = worldOf(CUBE)
/** Points of other cells are not in the cube. */
function inOwnCube(mark: PlacePoint): PlacePoint[] {
  return mark.point ? [{ ...mark, position: mark.point }] : []
}

const CORNERS = verticesInWorld(WORLD, CUBE)
const INSETS = { top: 56, right: 44, bottom: 72, left: 44 }
const IDENTITY = {
  columns: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  axisExponents: [0, 0, 0],
  jacdet: 1,
  exponent: 0,
} as const

const HELP_ID = 'reference-help'

export class ReferenceCube extends Pane {
  readonly root = document.createElement('div')
  readonly movesVertices = false
  readonly world = WORLD
  readonly #link = document.createElement('input')
  /** Top left of the cube in the canvas. */
  #left = 0
  #top = 0
  /** The camera to begin with once there is a size; null by default. */
  #asked: CameraView | null
  #hasSize = false
  /** The report last shown, and the same with candidates at their points of the cube. */
  #report: Report | null = null
  #reportInCube: Report | null = null

  constructor(scene: PaneScene, camera: CameraView | null) {
    super(scene, { letters: ['ξ', 'η', 'ζ'], isFixed: true }, HELP_ID)
    this.#asked = camera
    this.root.className = 'reference'
    this.element.setAttribute('aria-label', say('The reference cube, in xi, eta and zeta'))
    const help = document.createElement('p')
    help.id = HELP_ID
    help.hidden = true
    help.textContent = say(
      'Drag or the arrow keys turn it, plus and minus zoom, F fits. Point at a face, or tap it, and the same point is marked in space. P points at the minimizer, then at one candidate after another.',
    )
    this.root.append(this.element, help, this.#createLink())
  }

  /** Fills the box that the style sheet gives it. */
  resize(unit: number): void {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = this.root
    const view = this.cameraView()
    this.#left = offsetLeft / unit
    this.#top = offsetTop / unit
    this.camera.resize(Math.max(offsetWidth, 1) / unit, Math.max(offsetHeight, 1) / unit, INSETS)
    this.#hasSize = true
    this.look(view)
  }

  cameraView(): CameraView | null {
    return this.#hasSize ? this.orbit.cameraView(CORNERS, 1) : this.#asked
  }

  look(view: CameraView | null): void {
    this.#asked = view
    if (this.#hasSize) this.orbit.look(CORNERS, 1, view)
  }

  vertices(): readonly Vec3[] {
    return CORNERS
  }

  prepare(state: State): Viewport {
    this.inputs.probe.update()
    return this.viewport(CORNERS, state, this.#left, this.#top)
  }

  update(frame: Frame): void {
    const { state, report } = frame
    const place = placeMarksOf(frame)
    this.#link.checked = sliceOf(sceneSlice, state).camerasLinked
    this.overlay.update({
      state: { ...state, vertices: CUBE, gestureStart: null },
      preview: null,
      place: place && { ...place, position: null, points: place.points.flatMap(inOwnCube) },
      report: this.#inCube(report),
      world: WORLD,
      camera: this.camera,
      sight: this.sight,
      handles: this.seen,
      drag: null,
      taken: [],
    })
  }

  /** The columns of the map's derivative are the images of the axes; of the map to the cube itself they are the axes. */
  updateProbe(probe: JacobianReport | null, colour: string): void {
    const { point } = probe ?? {}
    const inCube = point && { ...IDENTITY, point, position: point }
    this.overlay.updateProbe(inCube ?? null, { colour, words: '' })
  }

  fit(toDefault: boolean): void {
    this.orbit.fit(CORNERS, toDefault ? DEFAULT_DIRECTION : undefined)
    this.host.requestFrame()
  }

  #createLink(): HTMLElement {
    const label = document.createElement('label')
    label.className = 'reference-link'
    label.title = say('Turning one turns the other')
    this.#link.type = 'checkbox'
    this.#link.addEventListener('change', () => {
      this.host.dispatch(sliceChange(sceneSlice, { camerasLinked: this.#link.checked }))
    })
    label.append(this.#link, say('Link views'))
    return label
  }

  #inCube(report: Report | null): Report | null {
    if (report === this.#report) return this.#reportInCube
    const inCube = (candidate: Candidate): Candidate => ({ ...candidate, position: candidate.point })
    this.#report = report
    this.#reportInCube = report && {
      ...report,
      minimizer: inCube(report.minimizer),
      volumeMinimum: { ...report.volumeMinimum, position: report.volumeMinimum.point },
      candidates: report.candidates.map(inCube),
    }
    return this.#reportInCube
  }
}
