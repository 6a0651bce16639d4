/**
 * The boundary minimum along the straight way from one element to another, and the tau where the
 * verdict changes: two neighbouring doubles each, found by bisection with the certain verdict.
 */

import { changeBetween, verdictOf } from '../../core/crossing'
import type { Core } from '../../core/report'
import type { Vertices } from '../../model/hexahedron'
import { elementAt } from '../../model/way'

export interface MorphSample {
  readonly tau: number
  /** Boundary minimum at tau, in doubles, times 2^exponent. */
  readonly minimum: number
  readonly exponent: number
  /** The certain verdict. */
  readonly valid: boolean
}

/** Neighbouring doubles with different verdicts. */
export interface Crossing {
  readonly validTau: number
  readonly invalidTau: number
}

export interface Morph {
  readonly a: Vertices
  readonly b: Vertices
  /** Samples by tau, from 0 to 1. */
  readonly samples: readonly MorphSample[]
  /** Crossings by tau. More may lie between two samples, closer than the graph shows. */
  readonly crossings: readonly Crossing[]
}

const INTERVALS = 64
/** Samples around each crossing, so that the graph meets zero where it says it does. */
const NEAR_CROSSING = [-1 / 256, 1 / 256]
/** Golden sections about a turning point: its tau to about 2^-27 of them, its value in full. */
const SECTIONS = 38
const GOLDEN = (Math.sqrt(5) - 1) / 2

export function morphOf(core: Core, a: Vertices, b: Vertices): Morph {
  const even = Array.from({ length: INTERVALS + 1 }, (_, i) => sampleAt(core, a, b, i / INTERVALS))
  const turning = even.slice(1, -1).flatMap((sample, i) => {
    const [before, after] = [even[i] as MorphSample, even[i + 2] as MorphSample]
    return mayTouchZero(before, sample, after) ? [turningPoint(core, a, b, before, sample, after)] : []
  })
  const found = byTau([...even, ...turning])
  const crossings = found.slice(1).flatMap((after, i) => {
    const before = found[i] as MorphSample
    return before.valid === after.valid ? [] : [crossingBetween(core, a, b, before, after)]
  })
  const near = crossings
    .flatMap(({ validTau }) => NEAR_CROSSING.map(step => validTau + step))
    .concat(crossings.flatMap(({ validTau, invalidTau }) => [validTau, invalidTau]))
    .filter(tau => tau > 0 && tau < 1)
  return { a, b, samples: byTau([...found, ...near.map(tau => sampleAt(core, a, b, tau))]), crossings }
}

function sampleAt(core: Core, a: Vertices, b: Vertices, tau: number): MorphSample {
  const vertices = elementAt(a, b, tau)
  const minimum = core.boundaryMinimum(vertices, 'roots-b')
  if (!minimum.ok) throw new Error(minimum.error.message)
  const { minimizer, exponent } = minimum.value
  return { tau, minimum: minimizer.value, exponent, valid: verdictOf(core, vertices) }
}

/**
 * A dip between valid neighbours, or a rise between invalid ones, may reach the other side between
 * the samples; hardly if it is farther from zero than the neighbours are from it.
 */
function mayTouchZero(before: MorphSample, middle: MorphSample, after: MorphSample): boolean {
  if (before.valid !== middle.valid || after.valid !== middle.valid) return false
  const side = middle.valid ? 1 : -1
  const lifts = [before, after].map(other => difference(other, middle) * side)
  const [one, two] = lifts as [number, number]
  return one >= 0 && two >= 0 && one + two > 0 && Math.abs(middle.minimum) <= one + two
}

/** The difference of two minima, in the units of the second one. */
function difference(one: MorphSample, other: MorphSample): number {
  return one.minimum * 2 ** (one.exponent - other.exponent) - other.minimum
}

/** The least minimum between valid samples, the greatest between invalid ones, or a crossing. */
function turningPoint(
  core: Core,
  a: Vertices,
  b: Vertices,
  before: MorphSample,
  middle: MorphSample,
  after: MorphSample,
): MorphSample {
  const wanted = middle.valid ? 1 : -1
  let [low, high] = [before.tau, after.tau]
  let best = middle
  for (let i = 0; i < SECTIONS && best.valid === middle.valid; i++) {
    const left = sampleAt(core, a, b, high - GOLDEN * (high - low))
    const right = sampleAt(core, a, b, low + GOLDEN * (high - low))
    for (const sample of [left, right]) if (difference(best, sample) * wanted > 0) best = sample
    if (difference(left, right) * wanted < 0) high = right.tau
    else low = left.tau
  }
  return best
}

function crossingBetween(core: Core, a: Vertices, b: Vertices, before: MorphSample, after: MorphSample): Crossing {
  const { near, far } = changeBetween(core, a, b, { near: before.tau, far: after.tau })
  return before.valid ? { validTau: near, invalidTau: far } : { validTau: far, invalidTau: near }
}

/** Samples in order, each tau once. */
function byTau(samples: readonly MorphSample[]): MorphSample[] {
  const sorted = samples.toSorted((one, other) => one.tau - other.tau)
  return sorted.filter(({ tau }, i) => tau !== sorted[i - 1]?.tau)
}
