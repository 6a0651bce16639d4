/**
 * The least jacdet of the whole element without the theorem: the reference cube is cut into boxes. In each jacdet is at least the least
 * of its 27 Bernstein coefficients, and at its corners it is a coefficient. Drawn and read, never a verdict.
 */
import { bernsteinIndex, bernsteinStrides } from '../../model/bernstein'
import type { Axis } from '../../model/hexahedron'

export interface LeastByBoxes {
  /** The least jacdet is between these, but for rounding. */
  readonly lower: number
  readonly upper: number
  /** How many boxes were looked at. */
  readonly boxes: number
}

interface Box {
  readonly bernstein: readonly number[]
  readonly lower: number
  /** The axis to be cut next. */
  readonly axis: Axis
}

const ENDS = [0, 2] as const
const CORNERS = ENDS.flatMap(i => ENDS.flatMap(j => ENDS.map(k => bernsteinIndex(i, j, k))))
/** The bracket's width as a share of the largest coefficient: less than a pixel of any drawing. */
const TOLERANCE = 1 / 2000
/** Boxes that a drag leaves time for. */
const MOST_BOXES = 800

export function leastByBoxes(bernstein: readonly number[]): LeastByBoxes {
  const width = TOLERANCE * Math.max(...bernstein.map(Math.abs))
  const open: Box[] = [{ bernstein, lower: Math.min(...bernstein), axis: 0 }]
  let upper = leastCorner(bernstein)
  let boxes = 1
  for (;;) {
    // The box with the least bound is next: only it can raise the bound of all.
    const next = open.reduce((least, box, i) => (box.lower < (open[least] as Box).lower ? i : least), 0)
    const { bernstein: cut, lower, axis } = open[next] as Box
    if (upper - lower <= width || boxes >= MOST_BOXES) return { lower, upper, boxes }
    const parts = halves(cut, axis).map(half => {
      upper = Math.min(upper, leastCorner(half))
      return { bernstein: half, lower: Math.min(...half), axis: ((axis + 1) % 3) as Axis }
    })
    boxes += parts.length
    open.splice(next, 1, ...parts)
  }
}

function leastCorner(bernstein: readonly number[]): number {
  return Math.min(...CORNERS.map(corner => bernstein[corner] as number))
}

/** De Casteljau's scheme at 1/2 along the axis. */
function halves(bernstein: readonly number[], axis: Axis): readonly [number[], number[]] {
  const [below, above] = [bernstein.slice(), bernstein.slice()]
  const stride = bernsteinStrides[axis]
  for (let at = 0; at < bernstein.length; at++) {
    if (Math.floor(at / stride) % 3 !== 0) continue
    const [q0, q1, q2] = [0, 1, 2].map(k => bernstein[at + k * stride]) as [number, number, number]
    const [left, right] = [(q0 + q1) / 2, (q1 + q2) / 2]
    const middle = (left + right) / 2
    below[at + stride] = left
    below[at + 2 * stride] = middle
    above[at] = middle
    above[at + stride] = right
  }
  return [below, above]
}
