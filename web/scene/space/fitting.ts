/**
 * The part of space that the element's camera sees. It stays while vertices are moved; another element, or one that was typed
 * out of the picture, is brought into sight.
 */
import type { Vec3, Vertices } from '../../model/hexahedron'
import type { CameraView, State } from '../../model/state'
import { DEFAULT_DIRECTION, type ScreenPoint } from './camera'
import type { OrbitCamera, Pose } from './orbit-camera'
import { toWorld, verticesInWorld, type World, worldOf } from './world'

/** Reasons to look elsewhere since the last frame. */
export interface Change {
  /** Null before the first frame. */
  readonly before: State | null
  /** The camera before the pane was resized; null if it was not. */
  readonly resized: { readonly camera: CameraView | null } | null
  /** True if a pointer in the scene moved the element: the picture stays as it is while it can. */
  readonly isDragged: boolean
}

/** Shares of the pane that an element must span to be in sight after a jump, and within an animation. */
const LEAST_SHARE = { jump: 0.2, animation: 0.4 }

export class Fitting {
  world: World = { centre: [0, 0, 0], size: 1 }
  readonly #orbit: OrbitCamera
  #fitted: { readonly preset: string | null; readonly start: Vertices } | null = null
  #onScreen: { readonly pose: Pose; readonly world: World } | null = null

  constructor(orbit: OrbitCamera) {
    this.#orbit = orbit
  }

  /** Returns true if another element is now seen from the default direction. */
  choose(state: State, { before, resized, isDragged }: Change): boolean {
    const fitted = this.#fitted
    const another = fitted === null || fitted.preset !== state.preset || fitted.start !== state.start
    // A program that sets one element after another, none of them a preset, animates: the reader's camera stays.
    const animated = another && fitted !== null && fitted.preset === null && state.preset === null
    const jumped = before && before.vertices !== state.vertices && !before.gestureStart && !state.gestureStart
    const ended = before?.gestureStart && !state.gestureStart
    // Out of a view that shows a part alone, only the vertex itself is brought back.
    const moved = isDragged ? state.selectedVertex : null
    const share = animated ? LEAST_SHARE.animation : LEAST_SHARE.jump
    this.#fitted = { preset: state.preset, start: state.start }
    const isNew = another && !animated
    if (isNew) this.fit(state.vertices, DEFAULT_DIRECTION)
    else if ((jumped && !this.#isInSight(state, share)) || (ended && !this.#isInSight(state, 0, moved)))
      this.fit(state.vertices)
    else if (resized) this.#look(state.vertices, resized.camera)
    return isNew
  }

  /** The whole element on paper. */
  putOnPaper(vertices: Vertices): void {
    this.#onScreen ??= { pose: this.#orbit.pose, world: this.world }
    this.fit(vertices)
  }

  /** Restores the camera that the reader had on the screen. */
  leavePaper(): void {
    if (this.#onScreen === null) return
    this.world = this.#onScreen.world
    this.#orbit.pose = this.#onScreen.pose
    this.#onScreen = null
  }

  /** The whole element, along the same line of sight or from the given direction. */
  fit(vertices: Vertices, from?: Vec3): void {
    this.world = worldOf(vertices)
    this.#orbit.fit(verticesInWorld(this.world, vertices), from)
  }

  /** Brings places beside the element into sight, along the same line; if they are so far off that the element would be lost they stay out. */
  reach(vertices: Vertices, places: readonly Vec3[]): void {
    const points = places.map(place => toWorld(this.world, place))
    if (points.every(point => this.#isOnScreen(point, 0))) return
    const { pose } = this.#orbit
    this.#orbit.fit([...verticesInWorld(this.world, vertices), ...points])
    if (!this.#isInSight({ vertices }, LEAST_SHARE.jump)) this.#orbit.pose = pose
  }

  look(vertices: Vertices, view: CameraView | null): void {
    this.world = worldOf(vertices)
    this.#look(vertices, view)
  }

  cameraView(vertices: Vertices): CameraView | null {
    return this.#orbit.cameraView(verticesInWorld(this.world, vertices), this.#halfExtent(vertices))
  }

  #look(vertices: Vertices, view: CameraView | null): void {
    this.#orbit.look(verticesInWorld(this.world, vertices), this.#halfExtent(vertices), view)
  }

  /** Half of the longest side of these vertices, in world space. */
  #halfExtent(vertices: Vertices): number {
    return worldOf(vertices).size / this.world.size
  }

  /** True if the element, or one vertex of it, is all there, but for little, and it spans more than a share of the pane. */
  #isInSight({ vertices }: Pick<State, 'vertices'>, share: number, only: number | null = null): boolean {
    const { camera } = this.#orbit
    camera.three.updateMatrixWorld()
    const inWorld = verticesInWorld(this.world, vertices)
    const points = inWorld.map(point => camera.project(point))
    const { width, height } = camera
    const slack = only === null ? 0.05 : 0
    const inside = inWorld.every((point, v) => (only !== null && only !== v) || this.#isOnScreen(point, slack))
    const spread = (of: (p: ScreenPoint) => number) => Math.max(...points.map(of)) - Math.min(...points.map(of))
    return inside && Math.max(spread(p => p.x) / width, spread(p => p.y) / height) > share
  }

  #isOnScreen(point: Vec3, slack: number): boolean {
    const { camera } = this.#orbit
    camera.three.updateMatrixWorld()
    const { x, y, depth } = camera.project(point)
    const isWithin = (value: number, size: number) => Math.abs(value / size - 0.5) < 0.5 + slack
    return depth > 0 && isWithin(x, camera.width) && isWithin(y, camera.height)
  }
}
