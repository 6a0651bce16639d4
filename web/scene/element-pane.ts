/** The element in physical space, with vertices to move. */
import type { JacobianReport } from '../core/report'
import { formatJacdet } from '../model/decimal'
import type { Vec3 } from '../model/hexahedron'
import { type CameraView, type State, sliceOf } from '../model/state'
import { type PlaceMarks, placeMarksOf } from '../views/place-marks'
import { previewSlice } from '../views/scene-slices'
import type { Frame } from '../views/view'
import { say } from '../words/say'
import type { HandleDrag } from './overlay/overlay-picture'
import { Readout } from './overlay/readout'
import type { Viewport } from './paint/picture'
import { Pane, type PaneScene } from './pane'
import { DEFAULT_DIRECTION } from './space/camera'
import { type Change, Fitting } from './space/fitting'
import type { Layout, PaneLayout } from './space/layout'
import { directionBetween, directionTo } from './space/showing'
import { samePoint } from './space/vec3'
import { verticesInWorld, type World, worldOf } from './space/world'

/** Long enough to follow, short enough not to wait for. */
const TURN_MS = 400

export class ElementPane extends Pane {
  readonly root = document.createElement('div')
  readonly fitting = new Fitting(this.orbit)
  readonly #readout = new Readout()
  #isReadonly: boolean | null = null
  #drag: HandleDrag | null = null
  /** The places that were last brought into sight. */
  #places: readonly Vec3[] = []
  #drawnDrag: HandleDrag | null = null
  /** True if the gesture last drawn is of the pointer here, under which the picture must not move. */
  #wasDragging = false
  /** The turn that the camera is in. */
  #turn: { readonly from: Vec3; readonly to: Vec3; readonly start: number } | null = null

  constructor(scene: PaneScene, description: string) {
    super(scene, { letters: ['x', 'y', 'z'], isFixed: false }, description)
    this.root.className = 'scene-pane'
    this.element.dataset.cursor = 'orbit'
    this.element.addEventListener('pointerdown', () => {
      this.#turn = null
    })
    this.overlay.root.append(this.#readout.root)
    this.root.append(this.element)
  }

  get movesVertices(): boolean {
    return !this.host.state().isReadonly
  }

  get world(): World {
    return this.fitting.world
  }

  /** True if the drag has changed since the overlay was drawn. */
  get hasNewDrag(): boolean {
    return this.#drag !== this.#drawnDrag
  }

  vertices(): readonly Vec3[] {
    return verticesInWorld(this.world, this.host.state().vertices)
  }

  name({ isReadonly }: State): void {
    if (isReadonly === this.#isReadonly) return
    this.#isReadonly = isReadonly
    const name = isReadonly ? say('The hexahedron in space') : say('The hexahedron in space, eight vertices to move')
    this.element.setAttribute('aria-label', name)
  }

  resize({ pane, isEmpty }: Layout): void {
    if (!isEmpty) this.camera.resize(pane.width, pane.height, pane.insets)
  }

  /** Looks elsewhere if the frame asks for it. `changesMedium` says whether it is the first on paper or again on the screen. */
  aim(frame: Frame, changesMedium: boolean, change: Omit<Change, 'isDragged'>): void {
    const { state, report, isForPaper } = frame
    if (isForPaper) this.fitting.putOnPaper(state.vertices)
    else if (changesMedium) this.fitting.leavePaper()
    else if (this.fitting.choose(state, { ...change, isDragged: this.#wasDragging })) {
      // A preset that is negative somewhere shows that at first.
      if (state.preset !== null && report && report.boundaryMinimum < 0) {
        const direction = this.#directionTo(report.minimizer.point, DEFAULT_DIRECTION, true)
        if (direction) this.fitting.fit(state.vertices, direction)
      }
    } else this.#goOnTurning(state)
    if (!isForPaper && state.gestureStart === null) this.#reachPlaces(state, placesOf(placeMarksOf(frame)))
    this.#wasDragging = this.inputs.isDragging
  }

  /** Places outside the element that were not there before are brought into sight. */
  #reachPlaces({ vertices }: State, places: readonly Vec3[]): void {
    const isKnown =
      places.length === this.#places.length && places.every((p, i) => samePoint(p, this.#places[i] as Vec3))
    if (!isKnown) this.fitting.reach(vertices, places)
    this.#places = places
  }

  /** Turns to where a point of the boundary is seen; returns false if faces hide it from everywhere. */
  turnTo(point: Vec3): boolean {
    const from = this.orbit.direction
    const to = this.#directionTo(point, from, false)
    this.#turn = to && { from, to, start: performance.now() }
    this.host.requestFrame()
    return to !== null
  }

  #directionTo(point: Vec3, from: Vec3, isLazy: boolean): Vec3 | null {
    const { pose } = this.orbit
    const { vertices } = this.host.state()
    const direction = directionTo(point, verticesInWorld(worldOf(vertices), vertices), this.camera, from, isLazy)
    this.orbit.pose = pose
    return direction
  }

  #goOnTurning({ vertices }: State): void {
    if (this.#turn === null) return
    const { from, to, start } = this.#turn
    const isAtOnce = matchMedia('(prefers-reduced-motion: reduce)').matches
    const share = isAtOnce ? 1 : Math.min((performance.now() - start) / TURN_MS, 1)
    this.fitting.fit(vertices, directionBetween(from, to, share * share * (3 - 2 * share)))
    if (share === 1) this.#turn = null
    else this.host.requestFrame()
  }

  /** Looks as a program wants it, in place of a turn that still runs. */
  look({ vertices }: State, camera: CameraView | null): void {
    this.#turn = null
    this.fitting.look(vertices, camera)
  }

  prepare(state: State): Viewport {
    return this.viewport(verticesInWorld(this.world, state.vertices), state)
  }

  update(frame: Frame, { taken }: PaneLayout): void {
    const { state, report } = frame
    this.#drawnDrag = this.#drag
    const { world, camera, sight, seen: handles } = this
    const { preview } = sliceOf(previewSlice, state)
    const place = placeMarksOf(frame)
    this.overlay.update({ state, preview, place, report, world, camera, sight, handles, drag: this.#drag, taken })
  }

  /** `colour` is that of jacdet at the probe. */
  updateProbe(probe: JacobianReport | null, colour: string, { referenceCube }: State, layout: PaneLayout): void {
    const words = probe
      ? say('volume × {factor}', { factor: formatJacdet(probe.jacdet, probe.exponent, referenceCube) })
      : ''
    this.overlay.updateProbe(probe, { colour, words }, layout.readout)
    this.#readout.update(probe, referenceCube, layout)
  }

  override showHover(vertex: number | null): void {
    this.overlay.showHover(vertex)
  }

  override showDrag(drag: HandleDrag | null): void {
    this.#drag = drag
    this.inputs.probe.clear()
    this.host.requestFrame()
  }

  fit(toDefault: boolean): void {
    if (this.inputs.isDragging) return
    this.fitting.fit(this.host.state().vertices, toDefault ? DEFAULT_DIRECTION : undefined)
    this.host.requestFrame()
  }
}

/** A better place of a vertex, and points of other cells. */
function placesOf(marks: PlaceMarks | null): readonly Vec3[] {
  const own = marks?.position ? [marks.position] : []
  return [...own, ...(marks?.points ?? []).flatMap(({ point, position }) => (point ? [] : [position]))]
}
