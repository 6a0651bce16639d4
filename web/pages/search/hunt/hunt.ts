/** The pieces of a search, one after another: their elements drawn, judged, sieved, analysed, and the best handed on. */

import type { BatchCore } from '../../../core/batch/batch-core'
import { quantitiesOf } from '../../../core/quantities'
import type { Core, Report } from '../../../core/report'
import { isMet } from '../../../model/condition'
import { COORDINATE_COUNT, type Vertices } from '../../../model/hexahedron'
import { effortOf } from './beauty'
import { hasCornerAtMost } from './coefficients'
import { sourceOf } from './distribution'
import { measured } from './measure'
import type { ReadQuest } from './quest'
import { randomOf } from './random'
import { type Find, Ranking } from './ranking'
import { coefficientError, FALSE, sieveOf, TRUE } from './sieve'

/** Elements with a stream of random numbers of their own, drawn and judged at once: 200 kB, which caches hold. */
export const BLOCK = 1024

export interface Cores {
  readonly batch: BatchCore
  readonly core: Core
}

/** Some blocks of the stream of elements, one after another. */
export interface Piece {
  readonly first: number
  readonly blocks: number
}

export interface Haul {
  readonly piece: Piece
  /** How many elements have the property. */
  readonly found: number
  /** How many were analysed in full. */
  readonly analysed: number
  /** Those that were among the best when they were found, each with its property checked exactly. */
  readonly finds: readonly Find[]
}

/**
 * Goes through pieces of the stream of elements, in ascending order. What it found before only makes it leave out what cannot be among
 * the best of all any more.
 */
export function hunterOf(read: ReadQuest, { batch, core }: Cores): (piece: Piece) => Haul {
  const { quest, property, measure, start } = read
  const sieve = sieveOf(property, measure, start, core)
  const rankings = [new Ranking('beauty'), new Ranking('extremeness')]
  const elements = new Float64Array(COORDINATE_COUNT * BLOCK)
  const positive = new Float64Array(COORDINATE_COUNT * BLOCK)
  const places = new Uint32Array(BLOCK)

  return piece => {
    const finds: Find[] = []
    let [found, analysed] = [0, 0]

    function look(list: Float64Array, at: number, valid: boolean, index: number): void {
      const truth = sieve.judge(list, at, valid)
      if (truth === FALSE) return
      const vertices = Array.from(list.subarray(at, at + COORDINATE_COUNT))
      const effort = effortOf(vertices, start)
      if (truth === TRUE) {
        const most = sieve.measureAtMost()
        if (!rankings.some(ranking => ranking.mayTake(effort, most))) {
          found += 1
          return
        }
      }
      analysed += 1
      const report = analysis(core, vertices)
      if (!isMet(property, quantitiesOf(report, start))) return
      found += 1
      const find = { index, vertices, effort, extremeness: measured(measure, report, start) }
      const isNew = rankings.map(ranking => ranking.add(find))
      if (isNew.includes(true)) finds.push(find)
    }

    for (let block = piece.first; block < piece.first + piece.blocks; ++block) {
      sourceOf(quest.distribution, randomOf(quest.seed, block))(elements)
      const first = BLOCK * block
      let count = 0
      for (let e = 0; e < BLOCK; ++e) {
        const at = COORDINATE_COUNT * e
        if (hasCornerAtMost(elements, at, -coefficientError(elements, at))) {
          if (sieve.mayBe.withoutPositiveCorners) look(elements, at, false, first + e)
          continue
        }
        positive.set(elements.subarray(at, at + COORDINATE_COUNT), COORDINATE_COUNT * count)
        places[count++] = e
      }
      const points = positive.subarray(0, COORDINATE_COUNT * count)
      const { valid } = batch.classify({ points, cells: null, firstPoint: 0 }, {})
      for (let n = 0; n < count; ++n) {
        const isValid = valid[n] === 1
        if (isValid ? sieve.mayBe.valid : sieve.mayBe.invalid)
          look(positive, COORDINATE_COUNT * n, isValid, first + (places[n] as number))
      }
    }
    return { piece, found, analysed, finds }
  }
}

export function analysis(core: Core, vertices: Vertices): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}
