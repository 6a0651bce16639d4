/** Where a point of the plane is on the screen: x to the right, y upwards, the same scale for both. */
import type { Quadrilateral, Vec2 } from './quadrilateral'

export interface Size {
  readonly width: number
  readonly height: number
}

/** The part of the plane that is shown, before it has a size on the screen. */
export interface Frame {
  readonly centre: Vec2
  /** Half of its width and height. */
  readonly half: Vec2
}

export interface PlaneView {
  readonly toScreen: (point: Vec2) => Vec2
  readonly toPlane: (point: Vec2) => Vec2
  /** Pixels to a unit of the plane. */
  readonly scale: number
}

/** Room around for dragging outwards, as a fraction of the extent. */
const ROOM = 0.15
/** Pixels at the rim for numbers of corners. */
const RIM = 26

export function frameOf(quadrilateral: Quadrilateral, room = ROOM): Frame {
  const range = (i: 0 | 1) => {
    const values = quadrilateral.map(corner => corner[i])
    return [Math.min(...values), Math.max(...values)] as const
  }
  const [[left, right], [low, high]] = [range(0), range(1)]
  const extent = Math.max(right - left, high - low) || 1
  const margin = room * extent
  return {
    centre: [left / 2 + right / 2, low / 2 + high / 2],
    half: [(right - left) / 2 + margin, (high - low) / 2 + margin],
  }
}

export function viewOf({ centre, half }: Frame, { width, height }: Size): PlaneView {
  const rim = Math.min(RIM, width / 6, height / 6)
  const scale = Math.max(1e-300, Math.min((width / 2 - rim) / half[0], (height / 2 - rim) / half[1]))
  return {
    scale,
    toScreen: ([x, y]) => [width / 2 + (x - centre[0]) * scale, height / 2 - (y - centre[1]) * scale],
    toPlane: ([x, y]) => [centre[0] + (x - width / 2) / scale, centre[1] - (y - height / 2) / scale],
  }
}

/** True if every corner is on the screen. */
export function shows({ toScreen }: PlaneView, { width, height }: Size, quadrilateral: Quadrilateral): boolean {
  return quadrilateral.map(toScreen).every(([x, y]) => x >= 8 && y >= 8 && x <= width - 8 && y <= height - 8)
}
