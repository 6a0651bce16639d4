/**
 * The nearest valid element of an invalid one. Where one vertex moves, jacdet is affine in it at
 * every point, so the places that make a valid element are an intersection of half-spaces: cutting
 * planes find the nearest of them, and with it a bound (N8), (N9). If all move, linearizations are
 * followed to a local optimum (N10).
 */

import { timesPowerOfTwo } from '../../../core/power-of-two'
import type { Core, Report } from '../../../core/report'
import { type Vec3, type Vertices, vertexOf } from '../../../model/hexahedron'
import { ofAllVertices } from './distances'
import { analyzed, excessOf, type Goal } from './goal'
import { type HalfSpaces, leastVector } from './least-distance'
import { SLACK, TOLERANCE } from './least-on-boundary'
import { map3, movedEdges, neighbours, responseAt, type ScaledElement } from './scaled-element'

export interface ValidTarget {
  /** Vertices of a valid element; null if none was found. */
  readonly vertices: Vertices | null
  /** No such move that is shorter leads to a valid element; in units of the scaled element. */
  readonly bound: number
  /** True if to first order no small change of the move makes it shorter. */
  readonly isLocallyLeast: boolean
}

/** Jacdet has to exceed this share of the largest: at first, and a factor less once reached. */
const MARGIN = { first: 2 ** -8, factor: 2 ** -7, least: 2 ** -36 }
const MOST_ROUNDS = 80

/** A point at which jacdet, less the share, has to be positive: J + g . d > 0. */
interface Cut {
  readonly jacdet: number
  readonly gradient: readonly number[]
}

/** Yields after each element. */
export function* nearestValidOfVertex(
  core: Core,
  goal: Goal,
  vertices: Vertices,
  scaled: ScaledElement,
  vertex: number,
): Generator<undefined, ValidTarget> {
  const report = analyzed(core, vertices)
  const largest = largestJacdet(report, scaled)
  const excessAt = excessOf(scaled.edges, goal.share)
  const cutAt = (point: Vec3): Cut => {
    const { jacdet, gradients } = excessAt(point)
    return { jacdet, gradient: gradients[vertex] as Vec3 }
  }
  let margin = MARGIN.first * largest
  let cuts: readonly Cut[] = lowPoints(report, goal, scaled, margin).map(cutAt)
  let found: { vertices: Vertices; length: number } | null = null
  let bound = 0
  for (let round = 0; round < MOST_ROUNDS && margin >= MARGIN.least * largest; round++) {
    const fixed = cuts.find(({ jacdet, gradient }) => jacdet <= 0 && !hasLength(gradient))
    if (fixed) return { vertices: null, bound: boundBy([fixed], [1]), isLocallyLeast: false }
    cuts = cuts.filter(({ gradient }) => hasLength(gradient))
    const { vector, multipliers } = leastVector(halfSpaces(3, cuts, margin))
    bound = Math.max(bound, boundBy(cuts, multipliers))
    if (vector === null) {
      margin *= MARGIN.factor
      continue
    }
    const moves = Array.from({ length: 8 }, (_, v): Vec3 => (v === vertex ? (vector as unknown as Vec3) : [0, 0, 0]))
    const target = movedVertices(vertices, moves, scaled)
    const length = Math.hypot(...vector)
    if (!target.every(Number.isFinite)) break
    const there = analyzed(core, target)
    if (goal.isMet(target)) {
      if (found === null || length < found.length) found = { vertices: target, length }
      if (found.length * (1 - TOLERANCE) <= bound) break
      margin *= MARGIN.factor
    } else cuts = [...cuts, ...lowPoints(there, goal, scaled, margin).map(cutAt)]
    yield
  }
  return { vertices: found?.vertices ?? null, bound, isLocallyLeast: false }
}

/** Starts at the element itself, and at other elements that are valid. */
export function* nearestValidOfAll(
  core: Core,
  goal: Goal,
  vertices: Vertices,
  scaled: ScaledElement,
  others: readonly Vertices[],
): Generator<undefined, ValidTarget> {
  const report = analyzed(core, vertices)
  const largest = largestJacdet(report, scaled)
  const places = report.candidates.map(({ point }) => point)
  let bound = boundFrom(scaled, [...GRID, report.volumeMinimum.point, ...places])
  let best: (Descent & { vertices: Vertices }) | null = null
  const starts = [vertices, ...others]
  for (let run = 0; run < starts.length; run++) {
    const start = starts[run] as Vertices
    const descent = yield* descend(core, goal, vertices, scaled, largest, movesBetween(vertices, start, scaled))
    bound = Math.max(bound, boundFrom(scaled, descent.points))
    if (descent.vertices && (best === null || descent.length < best.length))
      best = { ...descent, vertices: descent.vertices }
    // A run that has not settled may do so from where it came to.
    if (run + 1 === starts.length && best?.isSettled === false && starts.length < MOST_RUNS) starts.push(best.vertices)
  }
  return { vertices: best?.vertices ?? null, bound, isLocallyLeast: best?.isSettled ?? false }
}

interface Descent {
  readonly vertices: Vertices | null
  readonly length: number
  readonly points: readonly Vec3[]
  readonly isSettled: boolean
}

const FIRST_STEP = 0.5
const MOST_RUNS = 6
/** A step that goes back on the one before is cut by this. */
const LESS = 0.5
const MORE = 1.25
/** A shorter step, relative to the move, ends the run; so does a longer one at a wide margin. */
const SETTLED = 2 ** -16
const SETTLED_PER_MARGIN = 4

/** The shortest move at which jacdet, linear about the last one, exceeds the margin; then again. */
function* descend(
  core: Core,
  goal: Goal,
  vertices: Vertices,
  scaled: ScaledElement,
  largest: number,
  start: readonly Vec3[],
): Generator<undefined, Descent> {
  let at = start.flat()
  let margin = MARGIN.first * largest
  let share = 1
  let before: number[] | null = null
  let points: readonly Vec3[] = []
  let best: Descent = { vertices: null, length: Number.POSITIVE_INFINITY, points: [], isSettled: false }
  for (let round = 0; round < 2 * MOST_ROUNDS; round++) {
    const moves = triples(at)
    const target = movedVertices(vertices, moves, scaled)
    if (!target.every(Number.isFinite)) break
    const there = analyzed(core, target)
    const length = Math.hypot(...at)
    const isMet = goal.isMet(target)
    const excessAt = excessOf(movedEdges(scaled, moves), goal.share)
    points = distinct([...lowPoints(there, goal, scaled, 4 * margin), ...points]).filter(point =>
      hasLength(excessAt(point).gradients.flat()),
    )
    const cuts = points.map((point): Cut => {
      const { jacdet, gradients } = excessAt(point)
      const gradient = gradients.flat()
      return { jacdet: jacdet - product(gradient, at), gradient }
    })
    const { vector, multipliers } = leastVector(halfSpaces(at.length, cuts, margin))
    yield
    if (vector === null) {
      margin *= MARGIN.factor
      if (margin < MARGIN.least * largest) break
      continue
    }
    const step = vector.map((value, i) => value - (at[i] as number))
    const size = Math.hypot(...step)
    const isSettled = size <= SETTLED * length
    if (isMet && length <= best.length) best = { vertices: target, length, points, isSettled }
    if (isMet && size <= Math.max(SETTLED, (SETTLED_PER_MARGIN * margin) / largest) * length) {
      margin *= MARGIN.factor
      if (margin < MARGIN.least * largest) break
    }
    points = points.filter((_, i) => (multipliers[i] as number) > 0)
    if (before) share = product(before, step) < 0 ? share * LESS : Math.min(1, share * MORE)
    const factor = Math.min(share, FIRST_STEP / (size || 1))
    at = at.map((value, i) => value + factor * (step[i] as number))
    before = step
  }
  return best
}

function hasLength(gradient: readonly number[]): boolean {
  return Math.hypot(...gradient) > SLACK
}

/** Unit rows, and the distance at which jacdet is the margin. */
function halfSpaces(dimension: number, cuts: readonly Cut[], margin: number): HalfSpaces {
  const lengths = cuts.map(({ gradient }) => Math.hypot(...gradient))
  return {
    dimension,
    rows: cuts.map(({ gradient }, i) => gradient.map(value => value / (lengths[i] as number))),
    sides: cuts.map(({ jacdet }, i) => (margin - jacdet) / (lengths[i] as number)),
  }
}

/** |d| >= -sum w J / |sum w g| for every d with J + g . d > 0 at all points, w >= 0: (N9). */
function boundBy(cuts: readonly Cut[], multipliers: readonly number[]): number {
  const weights = cuts.map(({ gradient }, i) => (multipliers[i] as number) / Math.max(Math.hypot(...gradient), SLACK))
  const total = weights.reduce((sum, weight) => sum + weight, 0)
  const jacdet = weights.reduce((sum, weight, i) => sum + weight * (cuts[i] as Cut).jacdet, 0)
  const gradient = [0, 1, 2].map(axis =>
    weights.reduce((sum, weight, i) => sum + weight * (cuts[i]?.gradient[axis] as number), 0),
  )
  if (total === 0) return 0
  return Math.max(0, (-jacdet - SLACK * total) / (Math.hypot(...gradient) + 2 * SLACK * total))
}

/** Jacdet < 0 has to pass zero: (N5), at the best of these points and then uphill. */
function boundFrom(scaled: ScaledElement, points: readonly Vec3[]): number {
  const boundAt = (point: Vec3) =>
    responseAt(scaled.edges, point).jacdet < -SLACK
      ? ofAllVertices.distance(ofAllVertices.entriesAt(scaled.edges, point), SLACK)
      : 0
  let best = points.reduce((most, point) => better(most, { point, bound: boundAt(point) }), NO_BOUND)
  for (let step = 1 / 8; step > 2 ** -24 && best.bound > 0; step /= 2)
    for (let round = 0; round < 8; round++) {
      const before = best
      for (const point of neighbours(best.point, step)) best = better(best, { point, bound: boundAt(point) })
      if (best === before) break
    }
  return best.bound
}

interface BoundAt {
  readonly point: Vec3
  readonly bound: number
}

const NO_BOUND: BoundAt = { point: [0, 0, 0], bound: 0 }

function better(one: BoundAt, other: BoundAt): BoundAt {
  return other.bound > one.bound ? other : one
}

const QUARTERS = [0, 1 / 4, 1 / 2, 3 / 4, 1]
/** Points at which a bound is tried first. */
const GRID = QUARTERS.flatMap(xi => QUARTERS.flatMap(eta => QUARTERS.map((zeta): Vec3 => [xi, eta, zeta])))

function largestJacdet({ bernstein, exponent }: Report, scaled: ScaledElement): number {
  return timesPowerOfTwo(Math.max(...bernstein.map(Math.abs)), exponent - 3 * scaled.exponent) || 1
}

/** The candidates at which jacdet is below the margin, and the share of the volume. */
function lowPoints(
  { candidates, exponent, volume, volumeExponent }: Report,
  { share }: Goal,
  scaled: ScaledElement,
  margin: number,
): Vec3[] {
  const least = margin + share * timesPowerOfTwo(volume, volumeExponent - 3 * scaled.exponent)
  return candidates
    .filter(({ value }) => timesPowerOfTwo(value, exponent - 3 * scaled.exponent) < least)
    .map(({ point }) => point)
}

const SAME_PLACE = 2 ** -30

function distinct(points: readonly Vec3[]): Vec3[] {
  return points.filter(
    (point, i) =>
      !points.slice(0, i).some(other => point.every((x, axis) => Math.abs(x - (other[axis] as number)) < SAME_PLACE)),
  )
}

/** Bits of a move's longest component: more would make the numbers of exact arithmetic long. */
const MOVE_BITS = 40

/** The element with its vertices moved, in its own units. */
export function movedVertices(vertices: Vertices, moves: readonly Vec3[], { exponent }: ScaledElement): Vertices {
  const longest = Math.max(...moves.flat().map(Math.abs))
  const unit = 2 ** (Math.floor(Math.log2(longest || 1)) - MOVE_BITS)
  return vertices.map((value, i) => {
    const given = moves[Math.floor(i / 3)]?.[i % 3] as number
    const move = unit > 0 ? Math.round(given / unit) * unit : given
    return move === 0 ? value : value + timesPowerOfTwo(move, exponent)
  })
}

function movesBetween(from: Vertices, to: Vertices, { exponent }: ScaledElement): Vec3[] {
  return Array.from({ length: 8 }, (_, v) =>
    map3(axis => timesPowerOfTwo(vertexOf(to, v)[axis] - vertexOf(from, v)[axis], -exponent)),
  )
}

function triples(flat: readonly number[]): Vec3[] {
  return Array.from({ length: flat.length / 3 }, (_, v) => flat.slice(3 * v, 3 * v + 3) as unknown as Vec3)
}

function product(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * (b[i] as number), 0)
}
