/**
 * A condition, decided by numbers that are cheap: an element that the filter holds back does not
 * meet it, and need not be analysed. Numbers are enclosed in intervals of doubles, first by the
 * verdict alone, then by the corner values, then by the Bernstein coefficients. The condition's own
 * arithmetic is in doubles as they round: held back wrongly is at most an element for which two
 * sides agree to fifteen digits, and none is let through for good by such arithmetic.
 */

import { BERNSTEIN_COUNT, bernsteinMiddles, vertexBernstein } from '../../model/bernstein'
import type { Condition } from '../../model/condition'
import { NUMBERS, type NumberName, type QuantityName } from '../../model/condition/names'
import type { ClaimNode, Comparison, NumberNode } from '../../model/condition/parse'
import { COORDINATE_COUNT, VERTEX_COUNT, type Vertices } from '../../model/hexahedron'
import type { Core } from '../report'
import { CENTRE, EDGES, FINE, setCorners, setFine, setOthers } from './coefficients'

export interface Filter {
  /**
   * True if a valid element may meet the condition, an invalid one, one with a corner value <= 0.
   */
  readonly mayBe: { readonly valid: boolean; readonly invalid: boolean; readonly withoutPositiveCorners: boolean }
  /** The truth for the element whose coordinates begin at `at`; `valid` is the certain verdict. */
  judge(elements: Float64Array, at: number, valid: boolean): Truth
  /** An upper bound of the measure of the element judged last. */
  measureAtMost(): number
}

export const FALSE = 0
export const TRUE = 1
/** Not decided by these numbers. */
export const OPEN = 2
export type Truth = typeof FALSE | typeof TRUE | typeof OPEN

/** Enclosures of the numbers of one element, by the index of their name; and its verdict. */
class Enclosures {
  readonly lower = new Float64Array(NUMBERS.length)
  readonly upper = new Float64Array(NUMBERS.length)
  valid = false

  mayBeZero(name: NumberName): boolean {
    return (this.upper[INDEX[name]] as number) >= 0
  }

  /** Intersects with the interval that is known already. */
  narrow(name: NumberName, lower: number, upper: number): void {
    const i = INDEX[name]
    if (lower > (this.lower[i] as number)) this.lower[i] = lower
    if (upper < (this.upper[i] as number)) this.upper[i] = upper
  }
}

const INDEX = Object.fromEntries(NUMBERS.map((name, i) => [name, i])) as Readonly<Record<NumberName, number>>

/** Names for which the Bernstein coefficients are not needed. */
const OF_THE_VERDICT: readonly QuantityName[] = ['valid', 'moved']

export function filterOf({ claim, names }: Condition, measure: NumberNode, start: Vertices, core: Core): Filter {
  const known = new Enclosures()
  const truth = compiled(claim, known)
  const measured = compiledNumber(measure, known)
  // A condition whose own arithmetic rounds must not say yes.
  const isSharp = comparesWithoutRounding(claim)
  const countsMoved = names.includes('moved')
  const asksBoundary = names.includes('boundary_min')
  const needsCoefficients = names.some(name => !OF_THE_VERDICT.includes(name))
  const bernstein = new Float64Array(BERNSTEIN_COUNT)
  const fine = new Float64Array(FINE ** 3)
  const mayBe = (set: () => void) => {
    set()
    return truth() !== FALSE
  }
  return {
    mayBe: {
      valid: mayBe(() => byVerdict(known, true)),
      invalid: mayBe(() => byVerdict(known, false)),
      withoutPositiveCorners: mayBe(() => {
        byVerdict(known, false)
        byCorner(known, 0)
      }),
    },
    judge(elements, at, valid) {
      byVerdict(known, valid)
      if (countsMoved) byMoved(known, elements, at, start)
      if (needsCoefficients) {
        const error = coefficientError(elements, at)
        setCorners(bernstein, elements, at)
        setOthers(bernstein)
        byCoefficients(known, bernstein, error)
        if (truth() === OPEN) {
          setFine(fine, bernstein)
          byFineCoefficients(known, fine, error)
        }
        if (!valid && asksBoundary && known.mayBeZero('boundary_min') && truth() === OPEN)
          bySign(known, elements.subarray(at, at + COORDINATE_COUNT), core)
      }
      const answer = truth()
      return answer === TRUE && !isSharp ? OPEN : answer
    },
    measureAtMost() {
      const most = measured.upper()
      return Number.isNaN(most) ? Infinity : most + MEASURE_SLACK * Math.abs(most)
    },
  }
}

/** More than what the roundings of a measure come to. */
const MEASURE_SLACK = 1e-9

/** Numbers by their names, and integers, compared as they are. */
function comparesWithoutRounding(node: ClaimNode): boolean {
  if (node.kind === 'claim') return true
  if (node.kind === 'not') return comparesWithoutRounding(node.of)
  if (node.kind === 'chain') return node.terms.every(isExact)
  return node.operands.every(comparesWithoutRounding)
}

function isExact(node: NumberNode): boolean {
  if (node.kind === 'constant') return node.value.lower.denominator === 1n && node.value.lower.numerator < 2n ** 53n
  return node.kind === 'number' || (node.kind === 'minus' && isExact(node.of))
}

/** More than zero: jacdets of elements that are searched are nowhere near the least doubles. */
const POSITIVE = Number.MIN_VALUE

function byVerdict(known: Enclosures, valid: boolean): void {
  known.valid = valid
  known.lower.fill(-Infinity)
  known.upper.fill(Infinity)
  if (valid) for (const name of VALUES) known.narrow(name, POSITIVE, Infinity)
  else for (const name of BOUNDS) known.narrow(name, -Infinity, 0)
  known.narrow('scaled_jacobian', valid ? POSITIVE : -1, 1)
  known.narrow('moved', 0, VERTEX_COUNT)
}

/** Values of jacdet, means of such and the least of all. */
const VALUES: readonly NumberName[] = [
  'boundary_min',
  'boundary_max',
  'volume_min',
  'corner_min',
  'edge_min',
  'centre',
  'volume',
  'gauss2_min',
  'gauss3_min',
]
/** No higher than zero unless the element is valid. */
const BOUNDS: readonly NumberName[] = ['boundary_min', 'volume_min', 'bernstein_min', 'subdivision']

function byMoved(known: Enclosures, elements: Float64Array, at: number, start: Vertices): void {
  let moved = 0
  for (let i = 0; i < COORDINATE_COUNT; i += 3)
    if (elements[at + i] !== start[i] || elements[at + i + 1] !== start[i + 1] || elements[at + i + 2] !== start[i + 2])
      moved += 1
  known.narrow('moved', moved, moved)
}

/**
 * Every coefficient that coefficients.ts computes of the element is off by at most this.
 *
 * With coordinates of magnitude R at most, edge vectors have components of 2R at most, and the permanent of three is at most 48 R^3.
 * A determinant of computed ones is off by less than 12 u times that (docs/algorithm.md (E2)), u = 2^-53; of the other coefficients
 * the cube's centre sums most of them, five times as much with its own roundings: 12 * 5 * 48 R^3 u < 2^-41 R^3. Of quarters
 * up to 1024, 13 bits an edge component, nothing rounds at all: 3 * 13 bits and those of sums and halves are fewer than 53.
 */
const COEFFICIENT_ERROR = 2 ** -41
const MOST_EXACT = 1024

export function coefficientError(elements: Float64Array, at: number): number {
  let greatest = 0
  let isCoarse = true
  for (let i = at; i < at + COORDINATE_COUNT; ++i) {
    const size = Math.abs(elements[i] as number)
    if (size > greatest) greatest = size
    if (isCoarse) isCoarse = Number.isInteger(4 * size)
  }
  return isCoarse && greatest <= MOST_EXACT ? 0 : COEFFICIENT_ERROR * greatest * greatest * greatest
}

/** The least corner value is at most `most`. */
function byCorner(known: Enclosures, most: number): void {
  for (const name of ['corner_min', 'edge_min', 'boundary_min', 'volume_min', 'bernstein_min'] as const)
    known.narrow(name, -Infinity, most)
  // The scaled Jacobian is that of a vertex, or lower.
  if (most <= 0) known.narrow('scaled_jacobian', -1, 0)
}

function byCoefficients(known: Enclosures, bernstein: Float64Array, error: number): void {
  let [least, greatest, leastOutside] = [Infinity, -Infinity, Infinity]
  for (let i = 0; i < bernstein.length; ++i) {
    const value = bernstein[i] as number
    if (value < least) least = value
    if (i === CENTRE) continue
    if (value > greatest) greatest = value
    if (value < leastOutside) leastOutside = value
  }
  let [leastCorner, greatestCorner] = [Infinity, -Infinity]
  for (const corner of vertexBernstein) {
    leastCorner = Math.min(leastCorner, bernstein[corner] as number)
    greatestCorner = Math.max(greatestCorner, bernstein[corner] as number)
  }
  const edge = Math.min(leastCorner, leastOnEdges(bernstein))
  const [centre, mean] = [valueAtCentre(bernstein), meanOf(bernstein)]
  known.narrow('corner_min', leastCorner - error, leastCorner + error)
  known.narrow('edge_min', edge - 8 * error, edge + 8 * error)
  known.narrow('boundary_min', leastOutside - error, edge + 8 * error)
  known.narrow('boundary_max', greatestCorner - error, greatest + error)
  known.narrow('bernstein_min', least - error, least + error)
  known.narrow('volume_min', least - error, Math.min(edge + 8 * error, centre + 2 * error))
  known.narrow('centre', centre - 2 * error, centre + 2 * error)
  known.narrow('volume', mean - 2 * error, mean + 2 * error)
  // Rules of positive weights that integrate jacdet exactly: their least value is at most the mean.
  for (const name of ['gauss2_min', 'gauss3_min'] as const) known.narrow(name, least - error, mean + 2 * error)
  if (leastCorner + error <= 0 || centre + 2 * error <= 0) known.narrow('scaled_jacobian', -1, 0)
  // Subdivision accepts at once what the bound proves.
  if (least - error > 0) known.narrow('subdivision', POSITIVE, Infinity)
}

/**
 * The same bounds once the element is cut into eight, where they are four times as sharp. Means are no further off than what they are
 * made of, and their own roundings, three a coefficient, are far below the error that is doubled here.
 */
function byFineCoefficients(known: Enclosures, fine: Float64Array, error: number): void {
  let [least, leastOutside, greatestOutside] = [Infinity, Infinity, -Infinity]
  let [leastValue, leastValueOutside, greatestValueOutside] = [Infinity, Infinity, -Infinity]
  for (let n = 0; n < fine.length; ++n) {
    const value = fine[n] as number
    const kind = FINE_KIND[n] as number
    if (value < least) least = value
    if (kind & VALUE && value < leastValue) leastValue = value
    if (!(kind & OUTSIDE)) continue
    if (value < leastOutside) leastOutside = value
    if (value > greatestOutside) greatestOutside = value
    if (!(kind & VALUE)) continue
    if (value < leastValueOutside) leastValueOutside = value
    if (value > greatestValueOutside) greatestValueOutside = value
  }
  const off = 2 * error
  known.narrow('boundary_min', leastOutside - off, leastValueOutside + off)
  known.narrow('boundary_max', greatestValueOutside - off, greatestOutside + off)
  known.narrow('volume_min', least - off, leastValue + off)
  for (const name of ['gauss2_min', 'gauss3_min'] as const) known.narrow(name, least - off, Infinity)
  if (least - off > 0) known.narrow('subdivision', POSITIVE, Infinity)
}

/** Zeros are frequent on integer grids, and the exact minimum is the cheapest exact number. */
function bySign(known: Enclosures, element: Float64Array, core: Core): void {
  const result = core.boundaryMinimum(Array.from(element), 'roots-b')
  if (!result.ok) throw new Error(result.error.message)
  const isNegative = result.value.minimizer.value < 0
  known.narrow('boundary_min', isNegative ? -Infinity : 0, isNegative ? -POSITIVE : 0)
}

const VALUE = 1
const OUTSIDE = 2

/** Flags of each of the 125: a value of jacdet, and one of a face. */
const FINE_KIND = Uint8Array.from({ length: FINE ** 3 }, (_, n) => {
  const indices = [Math.floor(n / (FINE * FINE)), Math.floor(n / FINE) % FINE, n % FINE]
  const isValue = indices.every(i => i % 2 === 0)
  return (isValue ? VALUE : 0) | (indices.some(i => i === 0 || i === FINE - 1) ? OUTSIDE : 0)
})

/** The least strictly inside an edge where its parabola dips; the ends are the corners'. */
function leastOnEdges(bernstein: Float64Array): number {
  let least = Infinity
  for (const { middle, stride } of EDGES) {
    const q1 = bernstein[middle] as number
    const q0 = bernstein[middle - stride] as number
    const q2 = bernstein[middle + stride] as number
    if (q1 >= q0 || q1 >= q2) continue
    least = Math.min(least, q0 - ((q0 - q1) * (q0 - q1)) / (q0 - q1 + (q2 - q1)))
  }
  return least
}

function valueAtCentre(bernstein: Float64Array): number {
  let sum = 0
  for (let i = 0; i < BERNSTEIN_COUNT; ++i) sum += (AT_CENTRE[i] as number) * (bernstein[i] as number)
  return sum
}

/** Weights 1/4, 1/2, 1/4 on each axis. */
const AT_CENTRE = Float64Array.from(bernsteinMiddles, middles => 2 ** middles / 64)

function meanOf(bernstein: Float64Array): number {
  let sum = 0
  for (let i = 0; i < BERNSTEIN_COUNT; ++i) sum += bernstein[i] as number
  return sum / BERNSTEIN_COUNT
}

function compiled(node: ClaimNode, known: Enclosures): () => Truth {
  if (node.kind === 'claim') return () => (known.valid ? TRUE : FALSE)
  if (node.kind === 'not') {
    const of = compiled(node.of, known)
    return () => opposite(of())
  }
  if (node.kind === 'chain') {
    const terms = node.terms.map(term => compiledNumber(term, known))
    return allOf(
      node.comparisons.map((sign, i) => compiledComparison(terms[i] as Interval, sign, terms[i + 1] as Interval)),
    )
  }
  const operands = node.operands.map(operand => compiled(operand, known))
  if (node.kind === 'and') return allOf(operands)
  const none = allOf(operands.map(operand => () => opposite(operand())))
  return () => opposite(none())
}

function opposite(truth: Truth): Truth {
  return truth === OPEN ? OPEN : truth === TRUE ? FALSE : TRUE
}

function allOf(operands: readonly (() => Truth)[]): () => Truth {
  return () => {
    let all: Truth = TRUE
    for (const operand of operands) {
      const truth = operand()
      if (truth === FALSE) return FALSE
      if (truth === OPEN) all = OPEN
    }
    return all
  }
}

interface Interval {
  lower(): number
  upper(): number
}

/** NaN, as infinity less infinity, compares with nothing: it leaves everything open. */
function compiledComparison(a: Interval, sign: Comparison, b: Interval): () => Truth {
  const isLess = (x: Interval, y: Interval) => () =>
    x.upper() < y.lower() ? TRUE : y.upper() <= x.lower() ? FALSE : OPEN
  const less = isLess(a, b)
  const more = isLess(b, a)
  switch (sign) {
    case '<':
      return less
    case '>':
      return more
    case '>=':
      return () => opposite(less())
    case '<=':
      return () => opposite(more())
    case '=':
      return () => (less() === TRUE || more() === TRUE ? FALSE : OPEN)
    case '!=':
      return () => (less() === TRUE || more() === TRUE ? TRUE : OPEN)
  }
}

function compiledNumber(node: NumberNode, known: Enclosures): Interval {
  if (node.kind === 'constant') {
    const { lower, upper } = node.value
    return {
      lower: constant(Number(lower.numerator) / Number(lower.denominator)),
      upper: constant(Number(upper.numerator) / Number(upper.denominator)),
    }
  }
  if (node.kind === 'number') {
    const i = INDEX[node.name]
    return { lower: () => known.lower[i] as number, upper: () => known.upper[i] as number }
  }
  if (node.kind === 'minus') {
    const of = compiledNumber(node.of, known)
    return { lower: () => -of.upper(), upper: () => -of.lower() }
  }
  const [left, right] = [compiledNumber(node.left, known), compiledNumber(node.right, known)]
  switch (node.kind) {
    case '+':
      return { lower: () => left.lower() + right.lower(), upper: () => left.upper() + right.upper() }
    case '-':
      return { lower: () => left.lower() - right.upper(), upper: () => left.upper() - right.lower() }
    case '*':
      return product(left, right)
    case '/':
      return product(left, reciprocal(right))
  }
}

function constant(value: number): () => number {
  return () => value
}

function product(a: Interval, b: Interval): Interval {
  const extreme = (pick: (...values: number[]) => number) => () => {
    const [a0, a1, b0, b1] = [a.lower(), a.upper(), b.lower(), b.upper()]
    return pick(a0 * b0, a0 * b1, a1 * b0, a1 * b1)
  }
  return { lower: extreme(Math.min), upper: extreme(Math.max) }
}

function reciprocal(of: Interval): Interval {
  const mayBeZero = () => of.lower() <= 0 && of.upper() >= 0
  return {
    lower: () => (mayBeZero() ? -Infinity : 1 / of.upper()),
    upper: () => (mayBeZero() ? Infinity : 1 / of.lower()),
  }
}
