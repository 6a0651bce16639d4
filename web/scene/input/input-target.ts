/** The pane that pointer and keys act on: geometry to read, the state, and where to send actions. */
import type { Vec3 } from '../../model/hexahedron'
import type { Dispatch, State } from '../../model/state'
import type { HandleDrag } from '../overlay/overlay-picture'
import type { SceneCamera, ScreenPoint } from '../space/camera'
import type { Point } from '../space/layout'
import type { OrbitCamera } from '../space/orbit-camera'
import type { World } from '../space/world'

export interface InputTarget {
  /** It has the focus, and receives pointers and keys. */
  readonly element: HTMLElement
  readonly camera: SceneCamera
  readonly orbit: Pick<OrbitCamera, 'camera' | 'pose' | 'turnBy' | 'pan' | 'zoom'>
  readonly world: World
  readonly host: { state(): State; readonly dispatch: Dispatch }
  /** True if vertices are moved here; else arrow keys turn the camera. */
  readonly movesVertices: boolean
  /** The pointer in units from the top left, as are all points of the screen. */
  positionOf(event: MouseEvent): Point
  /** Units from the middle of a handle that are on it for this type of pointer. */
  pickRadius(pointerType: string): number
  /** The eight vertices on the screen; none if they cannot be moved. */
  handles(): readonly ScreenPoint[]
  /** (xi, eta, zeta) of the point that is seen there; null beside the element. */
  pointAt(x: number, y: number): Vec3 | null
  /** Marks the minimizer, or the candidate after the one that is marked. */
  probeNext(): void
  /** Turns to the minimum, or shows it through the faces. */
  showMinimum(): void
  /** Marks the handle that a press would take. */
  showHover(vertex: number | null): void
  /** Shows the running drag of the selected vertex; null when none is running. */
  showDrag(drag: HandleDrag | null): void
  /** The whole element, along the same line of sight or in the default direction. */
  fit(toDefault: boolean): void
  /** Turns the camera, in steps to the right and up. */
  turn(right: number, up: number): void
  zoom(factor: number): void
  /** Shows or hides the reference cube. */
  toggleReference(): void
}
