/**
 * Hexahedra at the border between valid and invalid: a segment between one of each is bisected by the verdict until its ends
 * are neighbours. Both are taken, and others that differ from them by an ulp or two in one coordinate.
 */
import fc from 'fast-check'
import { COORDINATE_COUNT, type Vertices } from '../../web/model/hexahedron'
import { core, unitCube } from '../unit/core-fixtures'
import { displacedBetween, families, smallIntegers, touching } from './hexahedra'
import { moved } from './ulps'

/** Neighbours on both sides of the border, and what surrounds them; all within two ulps of them. */
export interface BorderCrossing {
  readonly valid: Vertices
  readonly invalid: Vertices
  readonly around: readonly Vertices[]
}

/** Hexahedra of a crossing, the two neighbours among them. */
export const CROSSING_SIZE = 16

export function hexahedraOf({ valid, invalid, around }: BorderCrossing): Vertices[] {
  return [valid, invalid, ...around]
}

export function isValid(vertices: Vertices): boolean {
  const result = core.isValid(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** The coordinates that move along the segment: all, one vertex's, one. */
export type Mover = 'all' | 'vertex' | 'coordinate'

interface Segment {
  readonly from: Vertices
  readonly towards: Vertices
  readonly mover: Mover
  readonly coordinate: number
  /** Powers of two that stretch the axes. */
  readonly axes: readonly number[]
  /** Coordinate and ulps of each move at the border. */
  readonly moves: readonly (readonly [number, number])[]
}

const isMoved = (mover: Mover, coordinate: number, i: number) =>
  mover === 'all' || (mover === 'coordinate' ? i === coordinate : Math.floor(i / 3) === Math.floor(coordinate / 3))

/** A valid one: drawn nearer and nearer to the cube until it is. */
function validNear(vertices: Vertices): Vertices {
  for (let share = 1; share > 2 ** -60; share /= 2) {
    const nearer = vertices.map((x, i) => (unitCube[i] as number) + share * (x - (unitCube[i] as number)))
    if (isValid(nearer)) return nearer
  }
  return unitCube
}

/** An invalid one: further and further along the segment; at last the mirror image of a valid one. */
function invalidBeyond(valid: Vertices, { towards, mover, coordinate }: Segment): Vertices {
  for (let share = 1; share < 100; share *= 2) {
    const further = valid.map((x, i) => (isMoved(mover, coordinate, i) ? x + share * ((towards[i] as number) - x) : x))
    if (!isValid(further)) return further
  }
  return valid.map((x, i) => (i % 3 === 0 ? -x : x))
}

function crossing(segment: Segment): BorderCrossing {
  const stretched = (vertices: Vertices) => vertices.map((x, i) => x * 2 ** (segment.axes[i % 3] as number))
  const start = validNear(segment.from)
  let valid: Vertices = stretched(start)
  let invalid: Vertices = stretched(invalidBeyond(start, segment))
  const [from, to] = [valid, invalid]
  let [low, high] = [0, 1]
  for (;;) {
    const middle = low + (high - low) / 2
    const hex = from.map((x, i) => (x === to[i] ? x : (1 - middle) * x + middle * (to[i] as number)))
    if (isSame(hex, valid) || isSame(hex, invalid)) break
    if (isValid(hex)) [valid, low] = [hex, middle]
    else [invalid, high] = [hex, middle]
  }
  const around = segment.moves.map(([i, ulps], n) => {
    const hex = n % 2 === 0 ? valid : invalid
    return hex.with(i, moved(hex[i] as number, ulps))
  })
  return { valid, invalid, around }
}

function isSame(p: Vertices, q: Vertices): boolean {
  return p.every((x, i) => x === q[i])
}

const coordinate = fc.noBias(fc.integer({ min: 0, max: COORDINATE_COUNT - 1 }))
const move = fc.tuple(coordinate, fc.constantFrom(-2, -1, 1, 2))

/** Coordinates on a grid of 1/64, from which a single one leads to zeros that doubles hold exactly. */
const onGrid = displacedBetween(0.1, 0.6).map(vertices => vertices.map(x => Math.round(64 * x) / 64))

export function borderCrossing(...movers: readonly Mover[]): fc.Arbitrary<BorderCrossing> {
  const segment = fc.record<Segment>({
    from: fc.oneof(displacedBetween(0.02, 0.3), onGrid, smallIntegers),
    towards: fc.oneof(
      displacedBetween(0.5, 2),
      displacedBetween(0.5, 2),
      smallIntegers,
      families.scaled,
      onGrid,
      onGrid,
      touching,
    ),
    mover: fc.constantFrom(...movers),
    coordinate,
    axes: fc.oneof(
      fc.constant([0, 0, 0]),
      fc.array(fc.noBias(fc.integer({ min: -60, max: 60 })), { minLength: 3, maxLength: 3 }),
    ),
    moves: fc.array(move, { minLength: CROSSING_SIZE - 2, maxLength: CROSSING_SIZE - 2 }),
  })
  return segment.map(crossing)
}
