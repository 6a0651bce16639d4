/** The handle under the pointer: on the screen, so that hidden handles can be taken too. */
import type { ScreenPoint } from '../space/camera'
import type { Point } from '../space/layout'

/** Units from the middle of a handle. */
export function pickRadius(pointerType: string): number {
  return pointerType === 'touch' ? 22 : 12
}

/** Distances this close, in units, are a tie. */
const TIE = 0.5

/**
 * The index of the nearest handle within the radius, the front one of equally near ones, of vertices that coincide the selected
 * one; null if none is in reach.
 */
export function pickHandle(
  handles: readonly ScreenPoint[],
  { x, y }: Point,
  radius: number,
  selected: number | null = null,
): number | null {
  const distances = handles.map(handle => (handle.depth > 0 ? Math.hypot(handle.x - x, handle.y - y) : Infinity))
  const least = Math.min(...distances)
  if (!(least <= radius)) return null
  let picked: number | null = null
  handles.forEach(({ depth }, index) => {
    if ((distances[index] as number) > Math.min(least + TIE, radius)) return
    const ahead = picked === null ? 1 : (handles[picked] as ScreenPoint).depth - depth
    if (ahead > 0 || (ahead === 0 && index === selected)) picked = index
  })
  return picked
}
