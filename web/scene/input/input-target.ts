/** What the pointer and keyboard inputs see of the scene: geometry to read, the state, and where to send actions. */
import type { Vec3 } from '../../model/hexahedron'
import type { ViewHost } from '../../views/view'
import type { SceneCamera, ScreenPoint } from '../space/camera'
import type { ViewFrame } from '../space/world'
import type { DragKeys } from './vertex-drag'

export interface Stage {
  /** Takes focus, pointer and keys. */
  readonly element: HTMLElement
  readonly camera: SceneCamera
  readonly host: Pick<ViewHost, 'state' | 'dispatch'>
  /** Whether vertices are moved here; else arrow keys turn the view. */
  readonly movesVertices: boolean
  frame(): ViewFrame
  /** Where a pointer is in it, in units (see unit.ts), as are all of its points. */
  placeOf(event: MouseEvent): { readonly x: number; readonly y: number }
  /** Where the handles of the eight vertices are on the screen; none where they are not to be dragged. */
  handles(): readonly ScreenPoint[]
  /** (xi, eta, zeta) of what is seen there; null beside the element. */
  pointAt(x: number, y: number): Vec3 | null
  /** Points at the minimizer, or at the candidate after the one that is pointed at. */
  probeNext(): void
  /** The handle that a press would take, for feedback. */
  showHover(vertex: number | null): void
  /** What the running drag of the selected vertex is held to; null when none is running. */
  showDrag(keys: DragKeys | null, byTouch: boolean): void
  /** Everything in view again: along the same line of sight, or in the default view. */
  fit(toDefault: boolean): void
  /** Turns the view, in steps to the right and up. */
  orbit(right: number, up: number): void
  zoom(factor: number): void
  /** Shows or hides the reference cube. */
  toggleReference(): void
}
