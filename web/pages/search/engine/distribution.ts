/**
 * The elements that a search looks through: how their vertices are drawn. Every coordinate is a multiple of the grid's step and small
 * beside 2^53 steps, so that sums are exact and with them the symmetry.
 */
import { type Axis, COORDINATE_COUNT, VERTEX_COUNT, type Vertices, vertexReference } from '../../../model/hexahedron'
import type { Random } from './random'
import { type Orbit, orbitsOf, type Symmetry, type SymmetryName, symmetries } from './symmetry'

export type Law =
  /** The unit cube's coordinates plus normal ones of this deviation. */
  | { readonly kind: 'normal'; readonly sigma: number }
  /** Coordinates uniform in [least, greatest]. */
  | { readonly kind: 'box'; readonly least: number; readonly greatest: number }

export type GridName = 'free' | 'quarters' | 'integers'

export interface Distribution {
  readonly law: Law
  readonly grid: GridName
  readonly symmetry: SymmetryName
  /** The number of vertices that are drawn, 1 to 8; the others stay where the start has them. */
  readonly moved: number
}

/** Of each grid; that of any numbers is fine enough to be such, coarse enough that 1 - x and the like are exact. */
export const STEPS: Readonly<Record<GridName, number>> = { free: 2 ** -32, quarters: 2 ** -2, integers: 1 }

export const MOST_SIGMA = 100
export const MOST_COORDINATE = 1000

/** A sentence that says what keeps these from being drawn, or null. */
export function refusalOf({ law, grid, symmetry, moved }: Distribution): string | null {
  if (law.kind === 'normal' && !(law.sigma > 0 && law.sigma <= MOST_SIGMA))
    return `Sigma needs a number above 0 and at most ${MOST_SIGMA}.`
  if (law.kind === 'box') {
    const { least, greatest } = law
    if (![least, greatest].every(x => Math.abs(x) <= MOST_COORDINATE))
      return `The box needs two numbers from −${MOST_COORDINATE} to ${MOST_COORDINATE}.`
    const [low, high] = steps(law, STEPS[grid])
    if (!(low < high))
      return grid === 'free'
        ? 'The box needs its least number below its greatest.'
        : `The box needs at least two ${grid} in it.`
  }
  if (!(Number.isInteger(moved) && moved >= 1 && moved <= VERTEX_COUNT))
    return `The number of vertices that move is a whole number from 1 to ${VERTEX_COUNT}.`
  const together = Math.min(...orbitsOf(symmetries[symmetry]).map(({ length }) => length))
  if (moved < together) return `With this symmetry ${together} vertices move together: let at least ${together} move.`
  return null
}

/** The least and the greatest multiple of the step in the box, in steps. */
function steps({ least, greatest }: { readonly least: number; readonly greatest: number }, step: number) {
  return [Math.ceil(least / step), Math.floor(greatest / step)] as [number, number]
}

/** The element from which vertices move: the unit cube, or the box as an element. */
export function startOf({ law, grid }: Distribution): Vertices {
  const [low, high] = law.kind === 'normal' ? [0, 1] : steps(law, STEPS[grid]).map(n => n * STEPS[grid])
  return vertexReference.flatMap(point => point.map(x => (x === 0 ? low : high) as number))
}

/** Fills a list with elements, 24 coordinates each. */
export type Source = (elements: Float64Array) => void

/** The elements of a distribution without a refusal. They depend on the random numbers alone. */
export function sourceOf(distribution: Distribution, random: Random): Source {
  const start = startOf(distribution)
  const arrange = arrangementOf(distribution, start, random)
  const { law } = distribution
  const step = STEPS[distribution.grid]
  if (law.kind === 'normal') {
    const rounding = ROUNDING * step
    return elements => {
      random.normals(elements)
      for (let at = 0; at < elements.length; at += COORDINATE_COUNT) {
        for (let i = 0; i < COORDINATE_COUNT; ++i)
          elements[at + i] = (start[i] as number) + law.sigma * (elements[at + i] as number) + rounding - rounding
        arrange?.(elements, at)
      }
    }
  }
  const [low, high] = steps(law, step)
  const count = high - low + 1
  return elements => {
    random.units(elements)
    for (let at = 0; at < elements.length; at += COORDINATE_COUNT) {
      // + 0 makes a plus zero of a minus zero.
      for (let i = 0; i < COORDINATE_COUNT; ++i)
        elements[at + i] = (low + Math.floor((elements[at + i] as number) * count)) * step + 0
      arrange?.(elements, at)
    }
  }
}

/** Adding and subtracting so many steps rounds to the next: doubles of that size are steps apart. */
const ROUNDING = 1.5 * 2 ** 52

/** Gives a drawn element its symmetry, and moves so many vertices; null if nothing is to do. */
function arrangementOf({ symmetry: name, moved }: Distribution, start: Vertices, random: Random) {
  if (name === 'none' && moved === VERTEX_COUNT) return null
  const symmetry: Symmetry = symmetries[name]
  const order = copiedOrbits(symmetry)
  const doubled = (start[0] as number) + (start[3 * FARTHEST] as number)
  return (elements: Float64Array, at: number): void => {
    if (moved < VERTEX_COUNT) shuffle(order, random)
    let left = moved
    for (const { orbit, copies } of order) {
      if (orbit.length > left) stay(elements, at, orbit, start)
      else {
        copyAlong(copies, elements, at, doubled)
        left -= orbit.length
      }
    }
  }
}

/** The vertex opposite to vertex 0. */
const FARTHEST = 6

/** A copy of one coordinate of the element to another one. */
interface Copy {
  readonly to: number
  readonly from: number
  readonly isMirrored: boolean
}

/** An orbit, and the copies that give its other vertices the symmetry of the first. */
export interface CopiedOrbit {
  readonly orbit: Orbit
  readonly copies: readonly Copy[]
}

export function copiedOrbits(symmetry: Symmetry): CopiedOrbit[] {
  return orbitsOf(symmetry).map(orbit => ({ orbit, copies: copiesOf(orbit, symmetry) }))
}

/** `doubled` is twice the centre's coordinate; 0 for displacements. */
export function copyAlong(copies: readonly Copy[], elements: Float64Array, at: number, doubled: number): void {
  for (const { to, from, isMirrored } of copies) {
    const value = elements[at + from] as number
    elements[at + to] = isMirrored ? doubled - value : value
  }
}

/** Copies in order: each vertex of the orbit is the image of the one before. */
function copiesOf(orbit: Orbit, { sources, signs }: Symmetry): Copy[] {
  const copy = (from: number, to: number, r: Axis) => ({
    to: 3 * to + r,
    from: 3 * from + sources[r],
    isMirrored: signs[r] < 0,
  })
  // A vertex that is its own image lies on the axis of the turn, the diagonal: y is x, and z is y.
  const [first] = orbit as readonly [number]
  if (orbit.length === 1) return sources[0] === 0 ? [] : [copy(first, first, 1), copy(first, first, 2)]
  return orbit.slice(1).flatMap((to, k) => AXES.map(r => copy(orbit[k] as number, to, r)))
}

const AXES: readonly Axis[] = [0, 1, 2]

function stay(elements: Float64Array, at: number, orbit: Orbit, start: Vertices): void {
  for (const v of orbit) for (let i = 3 * v; i < 3 * v + 3; ++i) elements[at + i] = start[i] as number
}

function shuffle<T>(list: T[], random: Random): void {
  for (let i = 0; i < list.length - 1; ++i) {
    const other = i + Math.floor(random.unit() * (list.length - i))
    const value = list[other] as T
    list[other] = list[i] as T
    list[i] = value
  }
}
