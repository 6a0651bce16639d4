/** Bounds of the volumes of cells, in doubles. */
import type { Mesh } from '../mesh/mesh'

/**
 * Twelve times the volume is the sum of three determinants of sums of at most two differences of vertices: docs/algorithm.md (V0). Each of
 * their 18 products of three carries two roundings a factor, two of the products, one of the minor, and eight of the sums: with the
 * division less than 18u of the sum of the products' magnitudes, which is at most that of the products of the columns' sums of magnitudes.
 * Those are rounded themselves, by less than 20u: 2^-48 is above both.
 */
const ERROR = 2 ** -48
/** Products of three coordinates from there to there lose no bits. */
const LEAST = 2 ** -300
const GREATEST = 2 ** 300

export interface VolumeBounds {
  /** Of |volume|, as far as the last `find` went. */
  least: number
  greatest: number
  /** False where doubles have no room for the products. */
  find(cell: number): boolean
}

export function volumeBoundsOf({ points, cells }: Pick<Mesh, 'points' | 'cells'>): VolumeBounds {
  const v = new Float64Array(24)
  const a = new Float64Array(9)
  let volume = 0
  /** Adds the determinant of the three columns in `a`; returns the product of their sums of magnitudes. */
  function add(): number {
    const [a0, a1, a2] = [a[0] as number, a[1] as number, a[2] as number]
    const [b0, b1, b2] = [a[3] as number, a[4] as number, a[5] as number]
    const [c0, c1, c2] = [a[6] as number, a[7] as number, a[8] as number]
    volume += (a1 * b2 - a2 * b1) * c0 + (a2 * b0 - a0 * b2) * c1 + (a0 * b1 - a1 * b0) * c2
    return (
      (Math.abs(a0) + Math.abs(a1) + Math.abs(a2)) *
      (Math.abs(b0) + Math.abs(b1) + Math.abs(b2)) *
      (Math.abs(c0) + Math.abs(c1) + Math.abs(c2))
    )
  }
  const at = (i: number) => v[i] as number
  const bounds: VolumeBounds = {
    least: 0,
    greatest: 0,
    find(cell) {
      for (let i = 0; i < 8; ++i) {
        const from = 3 * (cells[8 * cell + i] as number)
        v[3 * i] = points[from] as number
        v[3 * i + 1] = points[from + 1] as number
        v[3 * i + 2] = points[from + 2] as number
      }
      volume = 0
      let size = 0
      for (let r = 0; r < 3; ++r) {
        a[r] = at(18 + r) - at(3 + r) + (at(21 + r) - at(r))
        a[3 + r] = at(18 + r) - at(9 + r)
        a[6 + r] = at(6 + r) - at(r)
      }
      size += add()
      for (let r = 0; r < 3; ++r) {
        a[r] = at(21 + r) - at(r)
        a[3 + r] = at(18 + r) - at(9 + r) + (at(15 + r) - at(r))
        a[6 + r] = at(18 + r) - at(12 + r)
      }
      size += add()
      for (let r = 0; r < 3; ++r) {
        a[r] = at(18 + r) - at(3 + r)
        a[3 + r] = at(15 + r) - at(r)
        a[6 + r] = at(18 + r) - at(12 + r) + (at(6 + r) - at(r))
      }
      size += add()
      const error = ERROR * size
      const about = Math.abs(volume)
      bounds.least = Math.max(0, about - error) / 12
      bounds.greatest = (about + error) / 12
      return size > LEAST && size < GREATEST
    },
  }
  return bounds
}
