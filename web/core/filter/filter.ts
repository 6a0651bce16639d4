/**
 * A condition, decided by numbers that are cheap: an element that the filter holds back does not meet it, and need not be analysed.
 * Numbers are enclosed in intervals of doubles, first by the verdict alone, then by the corner values, then by the Bernstein coefficients,
 * and every operation of the condition widens its interval by what it may round (docs/algorithm.md, section 11): both answers are certain.
 */

import { BERNSTEIN_COUNT, bernsteinMiddles, vertexBernstein } from '../../model/bernstein'
import type { Condition } from '../../model/condition'
import type { Enclosure } from '../../model/condition/enclosure'
import { NUMBERS, type NumberName, type QuantityName } from '../../model/condition/names'
import type { ClaimNode, Comparison, NumberNode } from '../../model/condition/parse'
import { COORDINATE_COUNT, VERTEX_COUNT, type Vertices } from '../../model/hexahedron'
import { isAtMost, type Rational, scaledDouble } from '../../model/rational'
import type { Core } from '../report'
import { CENTRE, EDGES, FINE, setCorners, setFine, setOthers } from './coefficients'

export interface Filter {
  /**
   * True if a valid element may meet the condition, an invalid one, one with a corner value <= 0.
   */
  readonly mayBe: { readonly valid: boolean; readonly invalid: boolean; readonly withoutPositiveCorners: boolean }
  /** The truth for the element whose coordinates begin at `at`; `valid` is the certain verdict. */
  judge(elements: Float64Array, at: number, valid: boolean): Truth
  /** An upper bound of the measure of the element judged last, as doubles have it that begin with the report's numbers. */
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
  /** By how much a jacdet of the report may be off. */
  reportError = 0

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
  const measured = compiledNumber(measure, { leaf: name => asReported(known, name), isExact: false })
  const countsMoved = names.includes('moved')
  const asksBoundary = names.includes('boundary_min')
  const needsCoefficients = names.some(name => !OF_THE_VERDICT.includes(name))
  const bernstein = new Float64Array(BERNSTEIN_COUNT)
  const fine = new Float64Array(FINE ** 3)
  let judged: { readonly elements: Float64Array; readonly at: number } = {
    elements: new Float64Array(COORDINATE_COUNT),
    at: 0,
  }
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
      judged = { elements, at }
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
      return truth()
    },
    measureAtMost() {
      known.reportError = REPORT_ERROR * cubeOf(judged.elements, judged.at)
      const most = measured.upper()
      return Number.isNaN(most) ? Infinity : most
    },
  }
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
 * Every coefficient that coefficients.ts computes of the element is off by at most this, in g^3, with g the greatest coordinate's size.
 *
 * Components of edge vectors are 2g at most, and permanents P of three 48 g^3. By (8R) of docs/algorithm.md a coefficient is off by 77uP at
 * most, that of the cube's centre, u = 2^-53: 77 * 48 u < 2^-41. Of quarters up to 1024, 13 bits an edge component, nothing rounds at all:
 * 3 * 13 bits and those of sums and halves are fewer than 53.
 */
const COEFFICIENT_ERROR = 2 ** -41
const MOST_EXACT = 1024

export function coefficientError(elements: Float64Array, at: number): number {
  return isCoarse(elements, at) ? 0 : COEFFICIENT_ERROR * cubeOf(elements, at)
}

function isCoarse(elements: Float64Array, at: number): boolean {
  for (let i = at; i < at + COORDINATE_COUNT; ++i) {
    const size = Math.abs(elements[i] as number)
    if (size > MOST_EXACT || !Number.isInteger(4 * size)) return false
  }
  return true
}

/** g^3. */
function cubeOf(elements: Float64Array, at: number): number {
  let greatest = 0
  for (let i = at; i < at + COORDINATE_COUNT; ++i) greatest = Math.max(greatest, Math.abs(elements[i] as number))
  return greatest * greatest * greatest
}

/**
 * The error of the report's jacdets, in g^3. With P the greatest permanent, 48 g^3 at most, and M the greatest coefficient, 5 P at most:
 * a coefficient by 100uP (8R), what few means make of them by 40uM more (V2), the boundary's minimum and maximum by 36uP + 4000uM (M1),
 * what was decided exactly by a rounding. (36 + 5 * 4000) * 48 u < 2^-33.
 */
const REPORT_ERROR = 2 ** -33

/**
 * A computed scaled Jacobian: where jacdet over the lengths rounds to more than 1, it is a determinant of the columns over them, off by
 * 8u of the permanent, 1.16 products of lengths at most, and by less than 20u for lengths and quotient.
 */
const MOST_SCALED = 1 + 2 ** -48

/**
 * What doubles may have for a number in the report. Of a valid element the volume's minimum is the boundary's there, else a value of the
 * search inside, not above it; subdivision may end elsewhere, and corners of slivers may have any scaled Jacobian.
 */
function asReported(known: Enclosures, name: NumberName): Interval {
  const lower = (of: NumberName) => known.lower[INDEX[of]] as number
  const upper = (of: NumberName) => known.upper[INDEX[of]] as number
  switch (name) {
    case 'moved':
      return { lower: () => lower(name), upper: () => upper(name) }
    case 'scaled_jacobian':
      return { lower: () => -MOST_SCALED, upper: () => MOST_SCALED }
    case 'subdivision':
    case 'twist':
      return { lower: () => -Infinity, upper: () => Infinity }
    case 'volume_min':
      return {
        lower: () => lower('bernstein_min') - known.reportError,
        upper: () => upper('boundary_min') + known.reportError,
      }
    default:
      return { lower: () => lower(name) - known.reportError, upper: () => upper(name) + known.reportError }
  }
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
  const [centre, sum] = [valueAtCentre(bernstein), sumOf(bernstein)]
  const mean = sum / BERNSTEIN_COUNT
  // Values between coefficients that are off by `error` are off by no more. Coefficients that are exact have exact sums.
  const size = Math.max(Math.abs(least), Math.abs(greatest), Math.abs(bernstein[CENTRE] as number))
  const offOnEdge = error + (edge < leastCorner ? EDGE_ROUNDINGS * size : 0)
  const offInSum = error + (error === 0 ? 0 : SUM_ROUNDINGS * size)
  const isExactMean = error === 0 && (COARSE_PARTS * sum) % BERNSTEIN_COUNT === 0
  const offInMean = offInSum + (isExactMean ? 0 : QUOTIENT_ROUNDING * Math.abs(mean))
  known.narrow('corner_min', leastCorner - error, leastCorner + error)
  known.narrow('edge_min', edge - offOnEdge, edge + offOnEdge)
  known.narrow('boundary_min', leastOutside - error, edge + offOnEdge)
  known.narrow('boundary_max', greatestCorner - error, greatest + error)
  known.narrow('bernstein_min', least - error, least + error)
  known.narrow('volume_min', least - error, Math.min(edge + offOnEdge, centre + offInSum))
  known.narrow('centre', centre - offInSum, centre + offInSum)
  known.narrow('volume', mean - offInMean, mean + offInMean)
  // Rules of positive weights that integrate jacdet exactly: their least value is at most the mean.
  for (const name of ['gauss2_min', 'gauss3_min'] as const) known.narrow(name, least - error, mean + offInMean)
  if (leastCorner + error <= 0 || centre + offInSum <= 0) known.narrow('scaled_jacobian', -1, 0)
  // Subdivision accepts at once what the bound proves.
  if (least - error > 0) known.narrow('subdivision', POSITIVE, Infinity)
}

/**
 * In the greatest coefficient M, u = 2^-53. On an edge q0 - d^2/(d + e), with d and e of 2M at most, is off by 6u of the quotient, which is
 * at most d, and by the last difference's rounding: 13u. A sum of 27 whose partial sums are weighted means of M takes 26 roundings. The
 * mean's quotient is one of its own.
 */
const EDGE_ROUNDINGS = 2 ** -49
const SUM_ROUNDINGS = 2 ** -48
const QUOTIENT_ROUNDING = 2 ** -52
/** Coefficients that are exact are integers in units of this part: products of three quarters, halved, and quarters of such sums. */
const COARSE_PARTS = 2 ** 9

/**
 * The same bounds once the element is cut into eight, where they are four times as sharp. Means are no further off than what they are
 * made of, and their own roundings, six a coefficient, 1440u g^3 at most, are below the error that is doubled here.
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

function sumOf(bernstein: Float64Array): number {
  let sum = 0
  for (let i = 0; i < BERNSTEIN_COUNT; ++i) sum += bernstein[i] as number
  return sum
}

function compiled(node: ClaimNode, known: Enclosures): () => Truth {
  if (node.kind === 'claim') return () => (known.valid ? TRUE : FALSE)
  if (node.kind === 'not') {
    const of = compiled(node.of, known)
    return () => opposite(of())
  }
  if (node.kind === 'chain') {
    const exactly = (name: NumberName) => {
      const i = INDEX[name]
      return { lower: () => known.lower[i] as number, upper: () => known.upper[i] as number }
    }
    const terms = node.terms.map(term => compiledNumber(term, { leaf: exactly, isExact: true }))
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

interface Arithmetic {
  /** Where numbers come from. */
  leaf(name: NumberName): Interval
  /** Whether intervals hold what exact arithmetic makes of the numbers in them; else what doubles do. */
  readonly isExact: boolean
}

function compiledNumber(node: NumberNode, arithmetic: Arithmetic): Interval {
  const { leaf, isExact } = arithmetic
  if (node.kind === 'constant') return constant(node.value, isExact)
  if (node.kind === 'number') return leaf(node.name)
  if (node.kind === 'minus') return negated(compiledNumber(node.of, arithmetic))
  const [left, right] = [compiledNumber(node.left, arithmetic), compiledNumber(node.right, arithmetic)]
  switch (node.kind) {
    case '+':
      return sumOfIntervals(left, right, isExact)
    case '-':
      return sumOfIntervals(left, negated(right), isExact)
    case '*':
      return fromEnds(left, right, PRODUCT, isExact)
    case '/':
      return quotient(left, right, isExact)
  }
}

function negated(of: Interval): Interval {
  return { lower: () => -of.upper(), upper: () => -of.lower() }
}

function constant({ lower, upper }: Enclosure, isExact: boolean): Interval {
  const [from, to] = [lower, upper].map(end => {
    const value = Number(end.numerator) / Number(end.denominator)
    const isItself = Number.isFinite(value) && isSame(scaledDouble(value, 0), end)
    return { value, room: isExact && !isItself ? roomAround(value) : 0 }
  }) as [End, End]
  return { lower: () => from.value - from.room, upper: () => to.value + to.room }
}

function isSame(a: Rational, b: Rational): boolean {
  return isAtMost(a, b) && isAtMost(b, a)
}

interface End {
  readonly value: number
  readonly room: number
}

/** An operation that is monotone in either number, and so is its rounding. */
interface Operation {
  of(x: number, y: number): number
  /** What is sure to be exact: false also where that cannot be said. */
  isExact(x: number, y: number, result: number): boolean
}

/** The error of a sum of doubles is a double (Knuth). */
const SUM: Operation = {
  of: (x, y) => x + y,
  isExact: (x, y, sum) => {
    const other = sum - x
    return x - (sum - other) + (y - other) === 0
  },
}
const PRODUCT: Operation = { of: (x, y) => x * y, isExact: isProduct }
const QUOTIENT: Operation = { of: (x, y) => x / y, isExact: (x, y, quotient) => isProduct(quotient, y, x) }

/** In halves of 26 bits nothing rounds (Dekker), if the products of halves are normal. */
function isProduct(x: number, y: number, product: number): boolean {
  if (product === 0) return x === 0 || y === 0
  if (!(Math.abs(product) > LEAST_SPLIT && Math.abs(x) < GREATEST_SPLIT && Math.abs(y) < GREATEST_SPLIT)) return false
  const [a, b] = [upperHalf(x), upperHalf(y)]
  const [c, d] = [x - a, y - b]
  return a * b - product + a * d + c * b + c * d === 0
}

const LEAST_SPLIT = 2 ** -900
const GREATEST_SPLIT = 2 ** 900

function upperHalf(x: number): number {
  const shifted = (2 ** 27 + 1) * x
  return shifted - (shifted - x)
}

/** A result, made less or greater by what it may have rounded if intervals are widened. */
function rounded({ of, isExact }: Operation, isWidened: boolean) {
  const room = (x: number, y: number, value: number) => (isWidened && !isExact(x, y, value) ? roomAround(value) : 0)
  return {
    down(x: number, y: number): number {
      const value = of(x, y)
      return value - room(x, y, value)
    },
    up(x: number, y: number): number {
      const value = of(x, y)
      return value + room(x, y, value)
    },
  }
}

function sumOfIntervals(a: Interval, b: Interval, isWidened: boolean): Interval {
  const { down, up } = rounded(SUM, isWidened)
  return { lower: () => down(a.lower(), b.lower()), upper: () => up(a.upper(), b.upper()) }
}

/** A product or a quotient: the least and the greatest of the ends'. */
function fromEnds(a: Interval, b: Interval, operation: Operation, isWidened: boolean): Interval {
  const { down, up } = rounded(operation, isWidened)
  return {
    lower() {
      const [a0, a1, b0, b1] = [a.lower(), a.upper(), b.lower(), b.upper()]
      return Math.min(down(a0, b0), down(a0, b1), down(a1, b0), down(a1, b1))
    },
    upper() {
      const [a0, a1, b0, b1] = [a.lower(), a.upper(), b.lower(), b.upper()]
      return Math.max(up(a0, b0), up(a0, b1), up(a1, b0), up(a1, b1))
    },
  }
}

/**
 * An operation is off by u of its result, u = 2^-53, a constant, of three roundings, by 3.01 u, and what is added or taken away here by
 * another u: 8u, and the least double where something underflows.
 */
function roomAround(value: number): number {
  return 2 ** -50 * Math.abs(value) + Number.MIN_VALUE
}

/** All numbers if the divisor may be zero. */
function quotient(a: Interval, b: Interval, isWidened: boolean): Interval {
  const mayBeZero = () => b.lower() <= 0 && b.upper() >= 0
  const { lower, upper } = fromEnds(a, b, QUOTIENT, isWidened)
  return { lower: () => (mayBeZero() ? -Infinity : lower()), upper: () => (mayBeZero() ? Infinity : upper()) }
}
