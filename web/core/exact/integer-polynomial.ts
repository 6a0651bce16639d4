/**
 * Polynomials with integer coefficients, `p[i]` that of t^i, without leading zeros (the zero polynomial is empty), and their
 * real roots: counted by Sturm's theorem, isolated and refined in dyadic rationals. Nothing here rounds.
 */
import { magnitude } from '../../model/rational'

export type Polynomial = readonly bigint[]

/** numerator / 2^shift. */
export interface Dyadic {
  readonly numerator: bigint
  readonly shift: number
}

/** The one root in (low, high]; low = high for a root that is this very number. */
export interface IsolatedRoot {
  readonly low: Dyadic
  readonly high: Dyadic
}

export const ZERO: Dyadic = { numerator: 0n, shift: 0 }
export const ONE: Dyadic = { numerator: 1n, shift: 0 }

export function polynomial(...coefficients: bigint[]): Polynomial {
  let length = coefficients.length
  while (length > 0 && coefficients[length - 1] === 0n) length--
  return coefficients.slice(0, length)
}

const degree = (p: Polynomial) => p.length - 1
const coefficient = (p: Polynomial, i: number) => p[i] ?? 0n
const leading = (p: Polynomial) => p[p.length - 1] as bigint

export function sum(p: Polynomial, q: Polynomial, factor = 1n): Polynomial {
  const length = Math.max(p.length, q.length)
  return polynomial(...Array.from({ length }, (_, i) => coefficient(p, i) + factor * coefficient(q, i)))
}

export function product(p: Polynomial, q: Polynomial): Polynomial {
  if (p.length === 0 || q.length === 0) return []
  const coefficients = Array<bigint>(p.length + q.length - 1).fill(0n)
  for (const [i, a] of p.entries())
    for (const [j, b] of q.entries()) coefficients[i + j] = (coefficients[i + j] as bigint) + a * b
  return polynomial(...coefficients)
}

export function derivative(p: Polynomial): Polynomial {
  return p.slice(1).map((a, i) => a * BigInt(i + 1))
}

/** p(t) * 2^(shift * degree): an integer of the value's sign. */
function scaledValue(p: Polynomial, { numerator, shift }: Dyadic): bigint {
  let value = 0n
  for (let i = degree(p), power = 0; i >= 0; i--, power += shift)
    value = value * numerator + (coefficient(p, i) << BigInt(power))
  return value
}

/** p(t) * 2^(shift * over) for a p of degree at most `over`. */
export function valueOver(p: Polynomial, at: Dyadic, over: number): bigint {
  return p.length === 0 ? 0n : scaledValue(p, at) << BigInt(at.shift * (over - degree(p)))
}

export function signOf(value: bigint): -1 | 0 | 1 {
  return value > 0n ? 1 : value < 0n ? -1 : 0
}

export function signAt(p: Polynomial, at: Dyadic): -1 | 0 | 1 {
  return signOf(scaledValue(p, at))
}

export function midpoint(a: Dyadic, b: Dyadic): Dyadic {
  const shift = Math.max(a.shift, b.shift)
  const align = ({ numerator, shift: own }: Dyadic) => numerator << BigInt(shift - own)
  return { numerator: align(a) + align(b), shift: shift + 1 }
}

function isBelow(a: Dyadic, b: Dyadic): boolean {
  return a.numerator << BigInt(b.shift) < b.numerator << BigInt(a.shift)
}

/** p's pseudo-remainder by q: p times |leading(q)|^(degrees' difference + 1), a positive factor, less a multiple of q. */
function pseudoRemainder(p: Polynomial, q: Polynomial): Polynomial {
  const lead = leading(q)
  const size = magnitude(lead)
  let rest = p
  for (let steps = p.length - q.length + 1; steps > 0; steps--) {
    if (rest.length === q.length + steps - 1) {
      const factor = lead < 0n ? -leading(rest) : leading(rest)
      // The leading coefficients cancel.
      const lower = rest.slice(0, -1).map((a, i) => a * size - coefficient(q, i - steps + 1) * factor)
      rest = polynomial(...lower)
    } else {
      rest = rest.map(a => a * size)
    }
  }
  return rest
}

/**
 * p, q, and on with negated remainders, up to positive factors, until one is zero: Sturm's chain if q is p's derivative. Kept
 * small by the divisors of the subresultant algorithm (Knuth, The Art of Computer Programming 2, 4.6.1, algorithm C), which
 * are exact and save the greatest common divisors of huge coefficients.
 */
function remainderChain(p: Polynomial, q: Polynomial): Polynomial[] {
  const chain = [p]
  let [before, last] = [p, q]
  let [g, h] = [1n, 1n]
  while (last.length > 0) {
    chain.push(last)
    const difference = BigInt(before.length - last.length)
    const divisor = g * h ** difference
    const next = pseudoRemainder(before, last).map(a => -a / divisor)
    g = magnitude(leading(last))
    h = difference === 0n ? h : g ** difference / h ** (difference - 1n)
    ;[before, last] = [last, next]
  }
  return chain
}

/** The greatest one, up to a factor, whichever of p and q has the higher degree. */
export function commonDivisor(p: Polynomial, q: Polynomial): Polynomial {
  const [longer, shorter] = p.length >= q.length ? [p, q] : [q, p]
  return longer.length === 0 ? [] : (remainderChain(longer, shorter).at(-1) as Polynomial)
}

/** Quotient of an exact division, up to a positive factor. */
function quotient(p: Polynomial, q: Polynomial): Polynomial {
  const lead = magnitude(leading(q))
  let rest = p
  let result: Polynomial = []
  while (rest.length >= q.length) {
    const factor = leading(q) < 0n ? -leading(rest) : leading(rest)
    const shift = Array<bigint>(rest.length - q.length).fill(0n)
    result = sum(
      result.map(a => a * lead),
      [...shift, factor],
    )
    rest = sum(
      rest.map(a => a * lead),
      [...shift, ...q.map(a => a * factor)],
      -1n,
    )
  }
  return result
}

/** The polynomial with the same roots, each once. */
export function squareFree(p: Polynomial): Polynomial {
  const common = sturmChain(p).at(-1) ?? []
  return common.length > 1 ? quotient(p, common) : p
}

const chains = new WeakMap<Polynomial, Polynomial[]>()

/** Sturm's chain, made once for each polynomial; its last is the greatest common divisor with the derivative. */
function sturmChain(p: Polynomial): Polynomial[] {
  let chain = chains.get(p)
  if (chain === undefined) {
    chain = p.length === 0 ? [] : remainderChain(p, derivative(p))
    chains.set(p, chain)
  }
  return chain
}

function signChanges(chain: readonly Polynomial[], at: Dyadic): number {
  let changes = 0
  let last = 0
  for (const p of chain) {
    const sign = signAt(p, at)
    if (sign === 0) continue
    if (last !== 0 && sign !== last) changes++
    last = sign
  }
  return changes
}

/** The number of roots of a square-free polynomial in (low, high]. */
function countRoots(p: Polynomial, low: Dyadic, high: Dyadic): number {
  if (p.length <= 1) return 0
  const chain = sturmChain(p)
  return signChanges(chain, low) - signChanges(chain, high)
}

/** The roots in (0,1) of a square-free polynomial, ascending, in disjoint intervals whose ends are no roots of it. */
export function rootsInUnitInterval(p: Polynomial): IsolatedRoot[] {
  if (p.length <= 1) return []
  const chain = sturmChain(p)
  const roots: IsolatedRoot[] = []
  // A list, not a recursion: roots can be nearer to each other than a stack is deep. The lowest interval is its last.
  const intervals = [{ low: ZERO, high: ONE, below: signChanges(chain, ZERO), above: signChanges(chain, ONE) }]
  for (let interval = intervals.pop(); interval; interval = intervals.pop()) {
    const { low, high, below, above } = interval
    if (below === above) continue
    if (below - above === 1) {
      const root = separated(p, low, high)
      if (isBelow(root.low, ONE)) roots.push(root)
      continue
    }
    const middle = midpoint(low, high)
    const changes = signChanges(chain, middle)
    intervals.push({ low: middle, high, below: changes, above }, { low, high: middle, below, above: changes })
  }
  return roots
}

/** The one root in (low, high], with both ends moved off roots: off `low`, which may be another root, and off itself. */
function separated(p: Polynomial, low: Dyadic, high: Dyadic): IsolatedRoot {
  if (signAt(p, high) === 0) return { low: high, high }
  let from = low
  let to = high
  while (signAt(p, from) === 0) {
    const middle = midpoint(from, to)
    const sign = signAt(p, middle)
    if (sign === 0) return { low: middle, high: middle }
    // The sign just above the root at `from` is the one opposite to that at `to`, for one root lies between.
    if (sign === signAt(p, to)) to = middle
    else from = middle
  }
  return { low: from, high: to }
}

/** The same root in half the interval. */
export function refined(p: Polynomial, { low, high }: IsolatedRoot): IsolatedRoot {
  if (low === high) return { low, high }
  const middle = midpoint(low, high)
  const sign = signAt(p, middle)
  if (sign === 0) return { low: middle, high: middle }
  return sign === signAt(p, high) ? { low, high: middle } : { low: middle, high }
}

/**
 * The same root in an interval of width 2^-bits or less: quadratic interval refinement (Abbott, Quadratic interval refinement
 * for real roots), bisection where the chord does not tell the part of the interval that has the root.
 */
export function refinedTo(p: Polynomial, root: IsolatedRoot, bits: number): IsolatedRoot {
  let interval = root
  let step = 1
  while (interval.low !== interval.high && isWider(interval, bits)) {
    const narrowed = step > 1 ? narrowedByChord(p, interval, step) : null
    interval = narrowed ?? refined(p, interval)
    step = narrowed || step === 1 ? 2 * step : step >> 1
  }
  return interval
}

function isWider({ low, high }: IsolatedRoot, bits: number): boolean {
  const shift = BigInt(low.shift + high.shift)
  const width = (high.numerator << BigInt(low.shift)) - (low.numerator << BigInt(high.shift))
  return width << BigInt(bits) > 1n << shift
}

/** The 2^step-th part of the interval where the chord of p is zero, if it has the root. */
function narrowedByChord(p: Polynomial, { low, high }: IsolatedRoot, step: number): IsolatedRoot | null {
  const own = Math.max(low.shift, high.shift)
  const [from, to] = [low, high].map(({ numerator, shift }) => numerator << BigInt(own - shift)) as [bigint, bigint]
  const [atFrom, atTo] = [from, to].map(numerator => magnitude(scaledValue(p, { numerator, shift: own }))) as [
    bigint,
    bigint,
  ]
  const first = (from << BigInt(step)) + (to - from) * ((atFrom << BigInt(step)) / (atFrom + atTo))
  const narrowed = {
    low: { numerator: first, shift: own + step },
    high: { numerator: first + to - from, shift: own + step },
  }
  const [below, above] = [signAt(p, narrowed.low), signAt(p, narrowed.high)]
  if (below === 0) return { low: narrowed.low, high: narrowed.low }
  if (above === 0) return { low: narrowed.high, high: narrowed.high }
  return below === above ? null : narrowed
}

/** The sign of q at a root of the square-free p. */
export function signAtRoot(q: Polynomial, p: Polynomial, root: IsolatedRoot): -1 | 0 | 1 {
  if (q.length === 0) return 0
  if (root.low === root.high) return signAt(q, root.low)
  const common = commonDivisor(p, q)
  if (countRoots(squareFree(common), root.low, root.high) > 0) return 0
  const simple = squareFree(q)
  let interval = root
  while (
    interval.low !== interval.high &&
    (countRoots(simple, interval.low, interval.high) > 0 || signAt(q, interval.low) === 0)
  )
    interval = refinedTo(p, interval, 2 * Math.max(interval.low.shift, interval.high.shift) + 2)
  return signAt(q, interval.high)
}

/** Points of (0,1), one between every two neighbours among 0, the roots in it, and 1. */
export function pointsBetween(p: Polynomial, roots: readonly IsolatedRoot[]): Dyadic[] {
  const intervals = roots.map(root => {
    let interval = root
    while (!(isBelow(ZERO, interval.low) && isBelow(interval.high, ONE))) interval = refined(p, interval)
    return interval
  })
  const above = [ZERO, ...intervals.map(({ high }) => high)]
  const below = [...intervals.map(({ low }) => low), ONE]
  return above.map((point, i) => midpoint(point, below[i] as Dyadic))
}

/** True if p is negative on either side of its root, next to it. */
export function isNegativeBeside(p: Polynomial, root: IsolatedRoot): boolean {
  if (root.low !== root.high) return signAt(p, root.low) < 0 || signAt(p, root.high) < 0
  let multiplicity = 0
  let derived = p
  do {
    derived = derivative(derived)
    multiplicity++
  } while (signAt(derived, root.low) === 0)
  return multiplicity % 2 === 1 || signAt(derived, root.low) < 0
}
