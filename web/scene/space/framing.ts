/**
 * What part of space the scene shows. The view frame stays while vertices are moved; another element, or what was typed out of
 * the picture, is brought into view.
 */
import type { Vertices } from '../../model/hexahedron'
import type { CameraView, State } from '../../model/state'
import type { ScreenPoint } from './camera'
import type { Pose, Viewpoint } from './orbit-camera'
import { frameOf, type ViewFrame, verticesInView } from './world'

/** What may ask for another view since the last frame. */
export interface Change {
  /** Null before the first frame. */
  readonly before: State | null
  /** Null unless the picture has another size now: how the element was looked at. */
  readonly resized: { readonly camera: CameraView | null } | null
  /** Whether a pointer in the scene moved the element: under it the picture must not move. */
  readonly isDragged: boolean
}

/** Shares of the scene that an element must span to be in view after a jump, and within an animation. */
const LEAST_SHARE = { jump: 0.2, animation: 0.4 }

export class Framing {
  readonly #viewpoint: Viewpoint
  #frame: ViewFrame = { centre: [0, 0, 0], size: 1 }
  #framed: { readonly preset: string | null; readonly start: Vertices } | null = null

  #onScreen: { readonly pose: Pose; readonly frame: ViewFrame } | null = null

  constructor(viewpoint: Viewpoint) {
    this.#viewpoint = viewpoint
  }

  get frame(): ViewFrame {
    return this.#frame
  }

  choose(state: State, { before, resized, isDragged }: Change): void {
    const framed = this.#framed
    const another = framed === null || framed.preset !== state.preset || framed.start !== state.start
    // A program that sets one element after another, none of them a preset, animates: the reader's view stays.
    const animated = another && framed !== null && framed.preset === null && state.preset === null
    const jumped = before && before.vertices !== state.vertices && !before.gestureStart && !state.gestureStart
    const typed = before?.gestureStart && !state.gestureStart && !isDragged
    const share = animated ? LEAST_SHARE.animation : LEAST_SHARE.jump
    this.#framed = { preset: state.preset, start: state.start }
    if ((another && !animated) || (jumped && !this.#isInView(state, share)))
      this.fit(state.vertices, another && !animated)
    else if (typed && !this.#isInView(state, 0)) this.fit(state.vertices, false)
    else if (resized) this.#lookAt(state.vertices, resized.camera)
  }

  /** Everything in view on paper. */
  putOnPaper(vertices: Vertices): void {
    this.#onScreen ??= { pose: this.#viewpoint.pose, frame: this.#frame }
    this.fit(vertices, false)
  }

  /** What the reader had on the screen before. */
  leavePaper(): void {
    if (this.#onScreen === null) return
    this.#frame = this.#onScreen.frame
    this.#viewpoint.pose = this.#onScreen.pose
    this.#onScreen = null
  }

  /** Everything in view: along the same line of sight, or in the default view. */
  fit(vertices: Vertices, toDefault: boolean): void {
    this.#frame = frameOf(vertices)
    this.#aim(vertices, toDefault)
  }

  /** All of an element, seen so. */
  look(vertices: Vertices, camera: CameraView | null): void {
    this.#frame = frameOf(vertices)
    this.#lookAt(vertices, camera)
  }

  seen(vertices: Vertices): CameraView | null {
    return this.#viewpoint.seen(verticesInView(this.#frame, vertices), this.#unit(vertices))
  }

  #lookAt(vertices: Vertices, camera: CameraView | null): void {
    this.#viewpoint.look(verticesInView(this.#frame, vertices), this.#unit(vertices), camera)
  }

  /** Half of the longest side of these vertices, in the view frame. */
  #unit(vertices: Vertices): number {
    return frameOf(vertices).size / this.#frame.size
  }

  #aim(vertices: Vertices, toDefault: boolean): void {
    this.#viewpoint.aim(verticesInView(this.#frame, vertices), toDefault)
  }

  /** Whether the element is all there, and spans at least a share of the scene. */
  #isInView({ vertices }: State, share: number): boolean {
    const { camera } = this.#viewpoint
    camera.three.updateMatrixWorld()
    const points = verticesInView(this.#frame, vertices).map(point => camera.project(point))
    const { width, height } = camera
    const inside = points.every(
      ({ x, y, depth }) =>
        depth > 0 && x > -0.05 * width && x < 1.05 * width && y > -0.05 * height && y < 1.05 * height,
    )
    const spread = (of: (p: ScreenPoint) => number) => Math.max(...points.map(of)) - Math.min(...points.map(of))
    return inside && Math.max(spread(p => p.x) / width, spread(p => p.y) / height) > share
  }
}
