/**
 * Shrinks an element to simpler coordinates while it keeps its property: vertices back to where the
 * start has them, numbers to integers, halves, quarters, few decimals. Greedy, the greatest saving
 * first; each step lowers the complexity, and there are finitely many elements of such numbers, so
 * it ends. The same steps on every machine.
 */

import { FALSE, filterOf } from '../../../core/filter/filter'
import { quantitiesOf } from '../../../core/quantities'
import { isMet } from '../../../model/condition'
import {
  COORDINATE_COUNT,
  VERTEX_COUNT,
  type Vec3,
  type Vertices,
  vertexOf,
  vertexReference,
  withVertex,
} from '../../../model/hexahedron'
import type { ParsedQuery } from './query'
import { analysis, type Cores } from './search-piece'
import { complexityOf, complexityOfNumber } from './simplicity'

/** Grids to round to: steps per unit. */
const GRIDS = [1, 2, 4, 10, 100] as const
/** Simpler numbers that are tried for each coordinate with those of its vertex. */
const MOST_SIMPLER = 5

export interface Polished {
  readonly vertices: Vertices
  readonly complexity: number
}

/** Polishes an element that has the property. `onStep` is told of each simpler one. */
export function polish(
  parsed: ParsedQuery,
  vertices: Vertices,
  cores: Cores,
  onStep: (simpler: Polished) => void = () => {},
): Polished {
  const { start } = parsed
  const has = propertyOf(parsed, cores)
  let best: Polished = { vertices, complexity: complexityOf(vertices, start) }
  for (const from of [vertices, ...straightened(vertices, start)]) {
    if (from !== vertices && !has(from)) continue
    for (const vertices of descent(from, start, has)) {
      const complexity = complexityOf(vertices, start)
      if (complexity >= best.complexity) continue
      best = { vertices, complexity }
      onStep(best)
    }
  }
  return best
}

/** A function that is true if an element certainly has the property. */
function propertyOf({ property, measure, start }: ParsedQuery, { core }: Cores) {
  const filter = filterOf(property, measure, start, core)
  const list = new Float64Array(COORDINATE_COUNT)
  return (vertices: Vertices): boolean => {
    const verdict = core.isValid(vertices)
    if (!verdict.ok) return false
    list.set(vertices)
    if (filter.judge(list, 0, verdict.value) === FALSE) return false
    return isMet(property, quantitiesOf(analysis(core, vertices), start))
  }
}

/** Simpler and simpler ones, beginning with the element itself. */
function* descent(from: Vertices, start: Vertices, has: (vertices: Vertices) => boolean): Generator<Vertices> {
  for (let at: Vertices | undefined = from; at !== undefined; at = nextStep(at, start, has)) yield at
}

function nextStep(from: Vertices, start: Vertices, has: (vertices: Vertices) => boolean): Vertices | undefined {
  const complexity = complexityOf(from, start)
  const steps = [...candidates(from, start)]
    .map(vertices => ({ vertices, complexity: complexityOf(vertices, start) }))
    .filter(step => step.complexity < complexity)
    .sort((a, b) => a.complexity - b.complexity)
  return steps.find(({ vertices }) => has(vertices))?.vertices
}

/** All rounded at once, a vertex put back, the numbers of a vertex simplified together. */
function* candidates(from: Vertices, start: Vertices): Generator<Vertices> {
  for (const grid of GRIDS) yield from.map(x => rounded(x, grid))
  for (let v = 0; v < VERTEX_COUNT; ++v) {
    const [xs, ys, zs] = [0, 1, 2].map(axis =>
      simpler(from[3 * v + axis] as number, start[3 * v + axis] as number),
    ) as [number[], number[], number[]]
    for (const x of xs) for (const y of ys) for (const z of zs) yield withVertex(from, v, [x, y, z])
  }
}

/** The number itself and the simplest ones beside it, and those of the start and zero. */
function simpler(value: number, start: number): number[] {
  const near = GRIDS.flatMap(grid => [Math.floor(value * grid) / grid + 0, Math.ceil(value * grid) / grid + 0])
  const simple = [...new Set([start, 0, ...near])].filter(other => other !== value)
  return [
    value,
    ...simple.sort((a, b) => complexityOfNumber(a) - complexityOfNumber(b) || a - b).slice(0, MOST_SIMPLER),
  ]
}

function rounded(value: number, grid: number): number {
  return Math.floor(value * grid + 0.5) / grid + 0
}

/**
 * Affine images of the element with one vertex and its three neighbours where the start has them. An affine map of positive determinant
 * multiplies jacdet by a positive constant, so that all its signs stay; what the roundings do is for the property to say.
 */
function straightened(vertices: Vertices, start: Vertices): Vertices[] {
  return vertexReference.flatMap((_, v) => {
    const origin = vertexOf(vertices, v)
    const goal = vertexOf(start, v)
    const edges = [0, 1, 2].map(axis => difference(vertexOf(vertices, neighbour(v, axis)), origin)) as [
      Vec3,
      Vec3,
      Vec3,
    ]
    const goals = [0, 1, 2].map(axis => difference(vertexOf(start, neighbour(v, axis)), goal)) as [Vec3, Vec3, Vec3]
    const determinant = triple(...edges)
    if (!(determinant * triple(...goals) > 0)) return []
    const image = (w: number): Vec3 => {
      if (w === v || [0, 1, 2].some(axis => w === neighbour(v, axis))) return vertexOf(start, w)
      const d = difference(vertexOf(vertices, w), origin)
      const shares = [triple(d, edges[1], edges[2]), triple(edges[0], d, edges[2]), triple(edges[0], edges[1], d)]
      return [0, 1, 2].map(r =>
        goals.reduce(
          (sum, along, axis) => sum + ((shares[axis] as number) / determinant) * (along[r] as number),
          goal[r] as number,
        ),
      ) as unknown as Vec3
    }
    return [vertexReference.flatMap((_, w) => image(w))]
  })
}

/** The vertex at the other end of the edge along the axis. */
function neighbour(vertex: number, axis: number): number {
  const here = vertexReference[vertex] as Vec3
  return vertexReference.findIndex(point => point.every((x, r) => (x === here[r]) !== (r === axis)))
}

function difference(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

function triple(a: Vec3, b: Vec3, c: Vec3): number {
  return (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] + (a[0] * b[1] - a[1] * b[0]) * c[2]
}
