/**
 * The nearest elements of the other verdict: by moves of one vertex, each in turn, and of all eight
 * together. Lengths are Euclidean, of all coordinates that move. What is found is certain on both
 * sides: docs/algorithm.md 12.
 */

import { changesBetween, verdictOf } from '../../../core/crossing'
import { timesPowerOfTwo } from '../../../core/power-of-two'
import type { Core } from '../../../core/report'
import { VERTEX_COUNT, type Vec3, type Vertices, vertexOf, vertexReference } from '../../../model/hexahedron'
import { elementAt } from '../../../model/way'
import { moveDownhill, moveOfAll, moveOfVertex, ofAllVertices, ofVertex } from './distances'
import { analyzed, type Goal, goalOf } from './goal'
import { leastOnBoundary } from './least-on-boundary'
import { movedVertices, nearestValidOfAll, nearestValidOfVertex } from './nearest-valid'
import { columnsAt, map3, type ScaledElement, scaledElement } from './scaled-element'

export interface NearestMove {
  /** The vertex that moves; null if all may. */
  readonly vertex: number | null
  /** The element of the other verdict. */
  readonly vertices: Vertices
  /** The element one double before it on the straight way: still of the first verdict. */
  readonly before: Vertices
  /** Euclidean, over all coordinates. */
  readonly length: number
  /** The way of the vertex that moves most. */
  readonly longest: number
  /** A lower bound, for certain, of any such move's length; 0 if nothing is known. */
  readonly bound: number
  /** `least`: the shortest, to 1 in 10^6. `local`: no small change is shorter. `found`: neither. */
  readonly claim: 'least' | 'local' | 'found'
}

/** Null: none was found. `impossible`: there is none within a million times the size. */
export type NearestAnswer = NearestMove | 'impossible' | null

export interface Nearest {
  readonly vertices: Vertices
  /** The relative minimum that was asked for. */
  readonly share: number
  /** True if the element has it, and invalid ones are looked for; else those that have it are. */
  readonly isMet: boolean
  /** Answers for vertices 0, 1, …, as far as they are done. */
  readonly ofVertex: readonly NearestAnswer[]
  /** The shortest of one vertex: null if there is none, undefined until all are done. */
  readonly ofOne: NearestMove | null | undefined
  /** The shortest of all eight together, undefined until it is done. */
  readonly ofAll: NearestAnswer | undefined
}

/** Lengths in units of the element's largest edge component. */
const OUT_OF_REACH = 2 ** 20
const LEAST = 2 ** -20

/**
 * Yields the answers so far every few milliseconds; the whole may take some tenths of a second.
 * `share` is the relative minimum that a valid element is to have.
 */
export function* searchNearest(core: Core, vertices: Vertices, share = 0): Generator<Nearest, Nearest> {
  const goal = goalOf(core, share)
  const isMet = goal.isMet(vertices)
  const scaled = scaledElement(vertices)
  let nearest: Nearest = { vertices, share, isMet, ofVertex: [], ofOne: undefined, ofAll: undefined }
  for (let vertex = 0; vertex < VERTEX_COUNT; vertex++) {
    const search = isMet
      ? invalidOfVertex(core, vertices, scaled as ScaledElement, vertex)
      : validOfVertex(core, goal, vertices, scaled, vertex)
    const answer = yield* paused(search, nearest)
    nearest = { ...nearest, ofVertex: [...nearest.ofVertex, answer] }
    yield nearest
  }
  nearest = { ...nearest, ofOne: bestOf(nearest.ofVertex) }
  const search = isMet
    ? invalidOfAll(core, vertices, scaled as ScaledElement)
    : validOfAll(core, goal, vertices, scaled, nearest.ofOne ?? null)
  const ofAll = yield* paused(search, nearest)
  return { ...nearest, ofAll: shorterOf(ofAll, nearest.ofOne ?? null) }
}

/** A move of one vertex is one of all: in coarse doubles it may be shorter, or the only one. */
function shorterOf(all: NearestAnswer, one: NearestMove | null): NearestAnswer {
  if (one === null || all === 'impossible' || (all !== null && all.length <= one.length)) return all
  return { ...one, vertex: null, bound: Math.min(all?.bound ?? 0, one.length), claim: 'found' }
}

function* paused<T>(search: Generator<undefined, T>, nearest: Nearest): Generator<Nearest, T> {
  for (;;) {
    const { done, value } = search.next()
    if (done) return value as T
    yield nearest
  }
}

/** The shortest move, of any vertex. */
function bestOf(answers: readonly NearestAnswer[]): NearestMove | null {
  const moves = answers.filter(answer => answer !== null && answer !== 'impossible')
  return moves.reduce<NearestMove | null>(
    (best, move) => (best === null || move.length < best.length ? move : best),
    null,
  )
}

function* invalidOfVertex(
  core: Core,
  vertices: Vertices,
  scaled: ScaledElement,
  vertex: number,
): Generator<undefined, NearestAnswer> {
  const { point, bound } = yield* leastOnBoundary(scaled.edges, ofVertex(vertex))
  const target = invalidBeyond(core, vertices, moveOfVertex(scaled.edges, point, vertex), scaled)
  return yield* moveTo(v => verdictOf(core, v), vertices, target, {
    vertex,
    bound: inUnits(bound, scaled),
    isLocal: true,
  })
}

function* invalidOfAll(core: Core, vertices: Vertices, scaled: ScaledElement): Generator<undefined, NearestAnswer> {
  const { point, bound } = yield* leastOnBoundary(scaled.edges, ofAllVertices)
  const least = moveOfAll(scaled.edges, point)
  const moves = least ?? moveDownhill(scaled.edges, analyzed(core, vertices).minimizer.point)
  const target = invalidBeyond(core, vertices, moves, scaled)
  return yield* moveTo(v => verdictOf(core, v), vertices, target, {
    vertex: null,
    bound: inUnits(bound, scaled),
    isLocal: least !== null,
  })
}

function* validOfVertex(
  core: Core,
  goal: Goal,
  vertices: Vertices,
  scaled: ScaledElement | null,
  vertex: number,
): Generator<undefined, NearestAnswer> {
  if (scaled === null) return 'impossible' // seven vertices in one point
  const { vertices: target, bound, isLocallyLeast } = yield* nearestValidOfVertex(core, goal, vertices, scaled, vertex)
  if (target === null) return bound > OUT_OF_REACH ? 'impossible' : null
  return yield* moveTo(goal.isMet, vertices, target, { vertex, bound: inUnits(bound, scaled), isLocal: isLocallyLeast })
}

function* validOfAll(
  core: Core,
  goal: Goal,
  vertices: Vertices,
  scaled: ScaledElement | null,
  one: NearestMove | null,
): Generator<undefined, NearestAnswer> {
  if (scaled === null) return null // however small a cube is taken, a smaller one is nearer
  const box = yield* wayToBox(goal, vertices, scaled)
  const others = [one?.vertices, box].filter(other => other !== undefined && other !== null)
  const { vertices: target, bound, isLocallyLeast } = yield* nearestValidOfAll(core, goal, vertices, scaled, others)
  const found = target ?? one?.vertices ?? box
  return yield* moveTo(goal.isMet, vertices, found, {
    vertex: null,
    bound: inUnits(bound, scaled),
    isLocal: isLocallyLeast,
  })
}

/** Moves that change nothing in doubles, or no verdict, are doubled as often as this. */
const DOUBLINGS = 64

/** Twice the move that makes jacdet zero, or more until the verdict changes. */
function invalidBeyond(core: Core, vertices: Vertices, moves: readonly Vec3[], scaled: ScaledElement): Vertices | null {
  for (let n = 1; n <= DOUBLINGS; n++) {
    const longer = moves.map(move => map3(axis => 2 ** n * move[axis]))
    const target = movedVertices(vertices, longer, scaled)
    if (!target.every(Number.isFinite)) return null
    if (!verdictOf(core, target)) return target
  }
  return null
}

/** A box with the element's mean edges, or a cube; or the element where the way becomes valid. */
function* wayToBox(
  goal: Goal,
  vertices: Vertices,
  { edges, exponent }: ScaledElement,
): Generator<undefined, Vertices | null> {
  const mean = columnsAt(edges, [0.5, 0.5, 0.5])
  const size = Math.max(...mean.flat().map(Math.abs), 2 ** -10)
  const frames = [mean, map3(column => map3(axis => (axis === column ? size : 0)))]
  const boxes = frames.map(frame =>
    vertexReference.flatMap(corner =>
      map3(axis => {
        const about = corner.reduce((sum, x, column) => sum + (x - 0.5) * (frame[column]?.[axis] as number), 0)
        return centre(vertices, axis) + timesPowerOfTwo(about, exponent)
      }),
    ),
  )
  const box = boxes.find(candidate => candidate.every(Number.isFinite) && goal.isMet(candidate))
  if (box === undefined) return null
  const { far } = yield* changesBetween(goal.isMet, vertices, box, { near: 0, far: 1 })
  return elementAt(vertices, box, far)
}

function centre(vertices: Vertices, axis: 0 | 1 | 2): number {
  return vertexReference.reduce((sum, _, v) => sum + vertexOf(vertices, v)[axis] / VERTEX_COUNT, 0)
}

interface Known {
  readonly vertex: number | null
  readonly bound: number
  readonly isLocal: boolean
}

/**
 * The least share of the way: an element that is itself on the border has neighbours of the other
 * verdict 5e-324 away, whose coordinates span so many powers of two that exact arithmetic takes
 * seconds.
 */
const LEAST_SHARE = 2 ** -64

/** The nearest move that doubles allow on the straight way to the target. */
function* moveTo(
  holds: (vertices: Vertices) => boolean,
  vertices: Vertices,
  target: Vertices | null,
  { vertex, bound, isLocal }: Known,
): Generator<undefined, NearestAnswer> {
  if (!target?.every(Number.isFinite) || holds(target) === holds(vertices)) return null
  const { near, far } = yield* changesBetween(holds, vertices, target, { near: 0, far: 1 }, LEAST_SHARE)
  const found = elementAt(vertices, target, far)
  const ways = vertexReference.map((_, v) =>
    Math.hypot(...map3(axis => vertexOf(found, v)[axis] - vertexOf(vertices, v)[axis])),
  )
  const length = Math.hypot(...ways)
  const isFine = LEAST * length >= spacingOf(vertices)
  const claim = length * (1 - LEAST) <= bound ? 'least' : isLocal && isFine ? 'local' : 'found'
  return {
    vertex,
    vertices: found,
    before: elementAt(vertices, target, near),
    length,
    longest: Math.max(...ways),
    bound: Math.min(bound, length),
    claim,
  }
}

/** The spacing of doubles at the coordinates, or more; it limits how short a move can be. */
function spacingOf(vertices: Vertices): number {
  return Math.max(2 ** -52 * Math.max(...vertices.map(Math.abs)), Number.MIN_VALUE)
}

function inUnits(length: number, { exponent }: ScaledElement): number {
  return timesPowerOfTwo(length, exponent)
}
