/** Everything that an overlay is drawn from, but for the probe. */
import type { Report } from '../../core/report'
import type { Axis } from '../../model/hexahedron'
import type { State } from '../../model/state'
import type { PlaceMarks } from '../../views/place-marks'
import type { Preview } from '../../views/scene-slices'
import type { SceneCamera, ScreenPoint } from '../space/camera'
import type { Box } from '../space/layout'
import type { Sight } from '../space/sight'
import type { World } from '../space/world'

/** The running drag of the selected vertex, the axis that it is held to, and true if it goes along the grid. */
export interface HandleDrag {
  readonly axis: Axis | null
  readonly snaps: boolean
  readonly byTouch: boolean
}

/** How a pane sees the element. */
export interface Seen {
  readonly world: World
  readonly camera: SceneCamera
  /** Marks that it hides are drawn dashed. */
  readonly sight: Sight
}

export interface OverlayPicture extends Seen {
  readonly state: State
  readonly preview: Preview | null
  readonly place: PlaceMarks | null
  readonly report: Report | null
  /** The vertices on the screen. */
  readonly handles: readonly ScreenPoint[]
  readonly drag: HandleDrag | null
  /** Boxes of words that the overlay's must not cover. */
  readonly taken: readonly Box[]
}

/** Width and height, in the mean, of a picture in which marks have their full size; and the least share of it, still a mark to aim at. */
const FULL_SIZE = 500
const LEAST_SCALE = 0.6

/** The size of handles and rings: in a small picture they would cover what they are about. */
export function markScale({ width, height }: SceneCamera): number {
  return Math.max(LEAST_SCALE, Math.min(Math.sqrt(width * height) / FULL_SIZE, 1))
}
