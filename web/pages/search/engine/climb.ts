/**
 * Climbs from an element that has the property to ones that have it too and are more extreme: a
 * random search near the best so far. Vertices move as the distribution lets them: on its grid, in
 * its box or within reach, with its symmetry, and no others than have moved if some have to stay. A step is taken
 * only if exact arithmetic or error bounds are certain of the property and of the greater measure,
 * so no element on the way is less extreme than the one before. It goes from long moves to short
 * ones, until that leads up no more. The same steps on every machine.
 */

import { FALSE, filterOf } from '../../../core/filter/filter'
import { quantitiesOf } from '../../../core/quantities'
import { isCertainlyLess, isMet, type Quantities } from '../../../model/condition'
import { COORDINATE_COUNT, VERTEX_COUNT, type Vertices } from '../../../model/hexahedron'
import { copiedOrbits, copyAlong, type Distribution, STEPS } from './distribution'
import { measured } from './measure'
import type { ParsedQuery } from './query'
import { type Random, randomOf } from './random'
import { analysis, type Cores } from './search-piece'
import { symmetries } from './symmetry'

export interface Climbed {
  readonly vertices: Vertices
  /** The measure of the query. */
  readonly extremeness: number
  /** Steps up, and elements that were tried for them. */
  readonly steps: number
  readonly tried: number
}

/** Elements that are tried at most: a few seconds. */
export const MOST_TRIED = 20_000
/** Elements that are tried between two reports of the progress. */
const REPORT_EVERY = 256
/** Tries with moves of one size. If one in five leads up, the moves may be longer; if none, shorter. */
const TRIES = 200
const MANY = TRIES / 5
/** From the first size of moves to the last. */
const HALVINGS = 24
/** Deviations by which a coordinate may leave the start's: a search goes farther once in 5e8 draws. */
const REACH = 6
/** A stream of random numbers that no search gets to. */
const STREAM = 2 ** 32 - 1

/** `onProgress` is told of each step, and now and then of tries. */
export function climb(
  parsed: ParsedQuery,
  from: Vertices,
  cores: Cores,
  onProgress: (best: Climbed) => void = () => {},
): Climbed {
  const { query, measure, start } = parsed
  const { law, grid } = query.distribution
  const higher = higherOf(parsed, cores)
  const random = randomOf(query.seed, STREAM)
  const displacement = displacementsOf(query.distribution, from, start, random)
  const isWithin = (x: number, i: number) =>
    law.kind === 'box' ? x >= law.least && x <= law.greatest : Math.abs(x - (start[i] as number)) <= REACH * law.sigma

  const report = analysis(cores.core, from)
  let best: Height = {
    vertices: from,
    extremeness: measured(measure, report, start),
    quantities: quantitiesOf(report, start),
  }
  let [steps, tried] = [0, 0]
  const progress = (): Climbed => ({ vertices: best.vertices, extremeness: best.extremeness, steps, tried })

  function leadsUp(move: Float64Array, factor: number): boolean {
    tried += 1
    const vertices = best.vertices.map((x, i) => x + factor * (move[i] as number))
    const isOther = move.some(d => d !== 0)
    const next = isOther && vertices.every(isWithin) ? higher(vertices, best) : null
    if (next) {
      best = next
      steps += 1
    }
    if (next || tried % REPORT_EVERY === 0) onProgress(progress())
    return next !== null
  }

  const first = law.kind === 'box' ? (law.greatest - law.least) / 4 : law.sigma
  // Moves of half a grid step are mostly of one coordinate.
  const last = Math.max(STEPS[grid] / 2, first * 2 ** -HALVINGS)
  for (let before = -1; before < steps && tried < MOST_TRIED; ) {
    before = steps
    for (let size = first; size >= last && tried < MOST_TRIED; ) {
      let ups = 0
      for (let t = 0; t < TRIES && tried < MOST_TRIED; ++t) {
        const move = displacement(size)
        for (let factor = 1; leadsUp(move, factor); factor *= 2) ups += 1
      }
      if (ups === 0) size /= 2
      else if (ups > MANY) size = Math.min(2 * size, first)
    }
  }
  return progress()
}

interface Height {
  readonly vertices: Vertices
  readonly extremeness: number
  readonly quantities: Quantities
}

/** A function that gives the height of an element if it certainly has the property and is more extreme. */
function higherOf({ property, measure, start }: ParsedQuery, { core }: Cores) {
  const filter = filterOf(property, measure, start, core)
  const list = new Float64Array(COORDINATE_COUNT)
  return (vertices: Vertices, best: Height): Height | null => {
    const verdict = core.isValid(vertices)
    if (!verdict.ok) return null
    list.set(vertices)
    if (filter.judge(list, 0, verdict.value) === FALSE || filter.measureAtMost() <= best.extremeness) return null
    const report = analysis(core, vertices)
    const extremeness = measured(measure, report, start)
    if (!(extremeness > best.extremeness)) return null
    const quantities = quantitiesOf(report, start)
    if (!isMet(property, quantities) || !isCertainlyLess(measure, best.quantities, quantities)) return null
    return { vertices, extremeness, quantities }
  }
}

/** A function that draws displacements of a size: of all vertices that may move, or of those of one orbit. */
function displacementsOf(
  { grid, symmetry, moved }: Distribution,
  from: Vertices,
  start: Vertices,
  random: Random,
): (size: number) => Float64Array {
  const step = STEPS[grid]
  const hasMoved = (v: number) => [3 * v, 3 * v + 1, 3 * v + 2].some(i => from[i] !== start[i])
  const free = copiedOrbits(symmetries[symmetry]).filter(({ orbit }) => moved === VERTEX_COUNT || orbit.some(hasMoved))
  const normals = new Float64Array(COORDINATE_COUNT)
  return size => {
    const move = new Float64Array(COORDINATE_COUNT)
    random.normals(normals)
    const one = Math.floor(2 * random.unit() * free.length)
    for (const [k, { orbit, copies }] of free.entries()) {
      if (one < free.length && k !== one) continue
      for (const v of orbit)
        for (let i = 3 * v; i < 3 * v + 3; ++i) move[i] = Math.round((size * (normals[i] as number)) / step) * step
      copyAlong(copies, move, 0, 0)
    }
    return move
  }
}
