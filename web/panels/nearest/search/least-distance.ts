/**
 * The shortest vector d with rows . d >= sides, by Lawson and Hanson, *Solving Least Squares
 * Problems*, chapter 23: their LDP by NNLS. What it returns besides bounds the length of every such
 * d from below: docs/algorithm.md (N9).
 */

export interface HalfSpaces {
  readonly dimension: number
  /** Unit vectors. */
  readonly rows: readonly (readonly number[])[]
  readonly sides: readonly number[]
}

export interface LeastVector {
  /** Null if there is no common point nearer than 10^5 times the farthest half-space. */
  readonly vector: readonly number[] | null
  /** Weights of the half-spaces, none negative: the vector is a multiple of their sum of rows. */
  readonly multipliers: readonly number[]
}

/**
 * 1/(1 + |d|^2) of the farthest vector that counts, |d| = 10^5 in units of the farthest half-space:
 * the number itself is right to ROUNDING only, so of what is farther away fewer than four digits
 * would be known.
 */
const NOTHING = 1e-10

/** The most numbers in a column, and the most independent columns: eight vertices and one. */
const MOST = 25
/** The most that rounding changes a double by, relative to it. */
const UNIT_ROUNDOFF = 2 ** -53
/**
 * A bound for the rounded product of two unit vectors that is zero: MOST products and MOST columns
 * in the residual, twice over. No claim rests on it: (N9) holds for whatever multipliers come out.
 */
const ROUNDING = 4 * MOST * UNIT_ROUNDOFF
/** A dependent unit vector leaves at most this: MOST projections of MOST numbers, twice over. */
const DEPENDENT = 2 * MOST * MOST * UNIT_ROUNDOFF

export function leastVector({ dimension: size, rows, sides }: HalfSpaces): LeastVector {
  const unit = Math.max(...sides)
  if (!(unit > 0)) return { vector: Array<number>(size).fill(0), multipliers: rows.map(() => 0) }
  const columns = rows.map((row, i) => [...row, (sides[i] as number) / unit])
  const target = Array<number>(size + 1)
    .fill(0)
    .with(size, 1)
  const multipliers = nonNegativeLeastSquares(columns, target)
  const residual = residualOf(columns, target, multipliers)
  const last = residual[size] as number
  if (last <= NOTHING) return { vector: null, multipliers }
  return { vector: residual.slice(0, size).map(value => (-value / last) * unit), multipliers }
}

function residualOf(
  columns: readonly (readonly number[])[],
  target: readonly number[],
  x: readonly number[],
): number[] {
  return target.map(
    (value, i) => value - columns.reduce((sum, column, j) => sum + (column[i] as number) * (x[j] as number), 0),
  )
}

/** The x >= 0 with the least |columns x - target|: Lawson and Hanson's active sets. */
function nonNegativeLeastSquares(columns: readonly (readonly number[])[], target: readonly number[]): number[] {
  let x = columns.map(() => 0)
  let free: number[] = []
  let barred: number[] = []
  for (let round = 0; round < 3 * columns.length + 10; round++) {
    const residual = residualOf(columns, target, x)
    const gains = columns.map((column, j) =>
      free.includes(j) || barred.includes(j) ? -1 : product(column, residual) / length(column),
    )
    const best = gains.indexOf(Math.max(...gains))
    if (best < 0 || (gains[best] as number) <= ROUNDING) break
    const before = free
    free = [...free, best]
    for (;;) {
      const solved = leastSquares(
        free.map(j => columns[j] as readonly number[]),
        target,
      )
      if (solved === null) {
        free = before // the new column depends on the others
        barred = [...barred, best]
        break
      }
      if (solved.every(value => value > 0)) {
        x = scattered(solved, free, columns.length)
        barred = []
        break
      }
      // The step goes as far as none becomes negative.
      const steps = free.map((j, i) => {
        const [from, to] = [x[j] as number, solved[i] as number]
        return to > 0 ? 1 : from / (from - to)
      })
      const step = Math.min(...steps)
      x = scattered(
        free.map((j, i) => (x[j] as number) + step * ((solved[i] as number) - (x[j] as number))),
        free,
        columns.length,
      )
      free = free.filter((_, i) => (steps[i] as number) > step)
      x = x.map((value, j) => (free.includes(j) ? value : 0))
    }
  }
  return x
}

function scattered(values: readonly number[], places: readonly number[], count: number): number[] {
  const all = Array<number>(count).fill(0)
  for (const [i, j] of places.entries()) all[j] = Math.max(values[i] as number, 0)
  return all
}

/** Gram and Schmidt, twice over; null if the columns depend on each other in doubles. */
function leastSquares(columns: readonly (readonly number[])[], target: readonly number[]): number[] | null {
  const q: number[][] = []
  const r: number[][] = []
  for (const column of columns) {
    let rest = [...column]
    const entries = q.map(() => 0)
    for (let pass = 0; pass < 2; pass++)
      for (const [i, basis] of q.entries()) {
        const along = product(basis, rest)
        entries[i] = (entries[i] as number) + along
        rest = rest.map((value, k) => value - along * (basis[k] as number))
      }
    const norm = length(rest)
    if (norm <= DEPENDENT * length(column)) return null
    q.push(rest.map(value => value / norm))
    r.push([...entries, norm])
  }
  const x = q.map(basis => product(basis, target))
  for (let i = x.length - 1; i >= 0; i--) {
    for (let j = i + 1; j < x.length; j++) x[i] = (x[i] as number) - (r[j]?.[i] as number) * (x[j] as number)
    x[i] = (x[i] as number) / (r[i]?.[i] as number)
  }
  return x
}

function product(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * (b[i] as number), 0)
}

function length(a: readonly number[]): number {
  return Math.hypot(...a)
}
