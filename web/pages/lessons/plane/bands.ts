/**
 * Lines of equal jacdet on the square, and their images. jacdet is affine on the square, so they are straight there, and what lies below a
 * value is a convex polygon; on a straight line F is quadratic, so the image of a side is exactly one quadratic Bézier curve.
 */
import { cornerJacdets, cornerReference, jacdetAt, pointAt, type Quadrilateral, type Vec2 } from './quadrilateral'

/** Corners of a polygon of the square, counter-clockwise. */
export type Region = readonly Vec2[]

/** The part of the square where jacdet is at most `greatest`; empty if there is none. */
export function below(quadrilateral: Quadrilateral, greatest: number): Region {
  return clipped(cornerReference, point => greatest - jacdetAt(quadrilateral, point))
}

/** The two ends of the line jacdet = 0 on the square; null if there is no such line. */
export function zeroLine(quadrilateral: Quadrilateral): readonly [Vec2, Vec2] | null {
  const jacdets = cornerJacdets(quadrilateral)
  const ends = cornerReference.flatMap((corner, i): Vec2[] => {
    const next = (i + 1) % 4
    const [from, to] = [jacdets[i] as number, jacdets[next] as number]
    if (from === 0) return [corner]
    return from * to < 0 ? [between(corner, cornerReference[next] as Vec2, from / (from - to))] : []
  })
  return ends.length === 2 ? (ends as unknown as readonly [Vec2, Vec2]) : null
}

/** SVG path data of the region's image, a closed curve; of two points, the image of the line between them. */
export function imagePath(quadrilateral: Quadrilateral, region: Region, toScreen: (point: Vec2) => Vec2): string {
  const [first] = region
  if (!first) return ''
  const sides = region.length === 2 ? 1 : region.length
  const curves = region.slice(0, sides).map((from, i) => {
    const to = region[(i + 1) % region.length] as Vec2
    const [start, middle, end] = [from, between(from, to, 1 / 2), to].map(point => pointAt(quadrilateral, point)) as [
      Vec2,
      Vec2,
      Vec2,
    ]
    const control = [0, 1].map(k => 2 * at(middle, k) - (at(start, k) + at(end, k)) / 2) as unknown as Vec2
    return `Q${written(toScreen(control))} ${written(toScreen(end))}`
  })
  return `M${written(toScreen(pointAt(quadrilateral, first)))}${curves.join('')}${sides === 1 ? '' : 'Z'}`
}

/** The part of a convex polygon where an affine function is not negative. */
function clipped(region: Region, value: (point: Vec2) => number): Region {
  return region.flatMap((point, i): Vec2[] => {
    const next = region[(i + 1) % region.length] as Vec2
    const [here, there] = [value(point), value(next)]
    const crossing = here * there < 0 ? [between(point, next, here / (here - there))] : []
    return here >= 0 ? [point, ...crossing] : crossing
  })
}

const at = (point: Vec2, k: number): number => point[k] as number
const between = (from: Vec2, to: Vec2, way: number): Vec2 => [
  from[0] + way * (to[0] - from[0]),
  from[1] + way * (to[1] - from[1]),
]
export const written = ([x, y]: Vec2): string => `${Number(x.toFixed(2))} ${Number(y.toFixed(2))}`
