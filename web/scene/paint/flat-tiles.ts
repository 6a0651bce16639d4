/** The six faces as flat tiles, the farthest first, for the scene without WebGL. */
import type { Report } from '../../core/report'
import { faces, type Vec3 } from '../../model/hexahedron'
import { faceCorners, facePoint, patchNormal } from '../space/patches'
import { px } from './svg'

/** A point as it is seen: y downwards, depth away from the eye. */
export interface FlatPoint {
  readonly x: number
  readonly y: number
  readonly depth: number
}

export interface FlatTile {
  readonly depth: number
  /** Corners in turn, from (s, t) = (0, 0) by (1, 0). */
  readonly corners: readonly [FlatPoint, FlatPoint, FlatPoint, FlatPoint]
  /** jacdet at its middle: for a colour only, never for a verdict. */
  readonly value: number
  readonly face: number
  /** Where its middle is on the face. */
  readonly s: number
  readonly t: number
  /** Its middle where the vertices are, and a normal there of any length. */
  readonly middle: Vec3
  readonly normal: Vec3
}

/** The faces asked for, `side` times `side` tiles each, of vertices that lie wherever `project` expects them. */
export function flatTiles(
  { faces: reports }: Report,
  vertices: readonly Vec3[],
  side: number,
  project: (point: Vec3) => FlatPoint,
  isShown: (face: number) => boolean = () => true,
): FlatTile[] {
  const tiles: FlatTile[] = []
  for (const face of faces.keys()) {
    if (!isShown(face)) continue
    const bernstein = reports[face]?.bernstein ?? []
    const corner = (i: number, j: number) => project(facePoint(vertices, face, i / side, j / side))
    const points = range(side + 1).map(i => range(side + 1).map(j => corner(i, j)))
    for (const i of range(side))
      for (const j of range(side)) {
        const corners = [points[i]?.[j], points[i + 1]?.[j], points[i + 1]?.[j + 1], points[i]?.[j + 1]]
        const own = corners as unknown as FlatTile['corners']
        const [s, t] = [(i + 0.5) / side, (j + 0.5) / side]
        tiles.push({
          depth: own.reduce((sum, { depth }) => sum + depth, 0),
          corners: own,
          value: jacdetOn(bernstein, s, t),
          face,
          s,
          t,
          middle: facePoint(vertices, face, s, t),
          normal: patchNormal(faceCorners(vertices, face), s, t),
        })
      }
  }
  return tiles.sort((a, b) => b.depth - a.depth)
}

export function pathOf(points: readonly FlatPoint[]): string {
  return `M${points.map(({ x, y }) => `${px(x)} ${px(y)}`).join('L')}`
}

function range(count: number): number[] {
  return Array.from({ length: count }, (_, i) => i)
}

/** The biquadratic with the face's Bernstein coefficients. */
function jacdetOn(bernstein: readonly number[], s: number, t: number): number {
  const [bs, bt] = [s, t].map(x => [(1 - x) * (1 - x), 2 * x * (1 - x), x * x]) as [number[], number[]]
  return bernstein.reduce((sum, b, k) => sum + b * (bs[Math.floor(k / 3)] as number) * (bt[k % 3] as number), 0)
}
