/** The pieces of a search: elements are drawn, judged, filtered, analysed, the best handed on. */

import type { BatchCore } from '../../../core/batch/batch-core'
import { hasCornerAtMost } from '../../../core/filter/coefficients'
import { coefficientError, FALSE, filterOf, TRUE } from '../../../core/filter/filter'
import { quantitiesOf } from '../../../core/quantities'
import type { Core, Report } from '../../../core/report'
import { isMet } from '../../../model/condition'
import { COORDINATE_COUNT, type Vertices } from '../../../model/hexahedron'
import { sourceOf } from './distribution'
import { measured } from './measure'
import type { ParsedQuery } from './query'
import { randomOf } from './random'
import { type Find, Ranking } from './ranking'
import { complexityOf } from './simplicity'

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

export interface PieceFinds {
  readonly piece: Piece
  /** Elements that have the property. */
  readonly found: number
  /** The time that it took. */
  readonly milliseconds: number
  /** The best when they were found, each with its property checked exactly. */
  readonly finds: readonly Find[]
}

/**
 * Goes through pieces of the stream of elements, in ascending order. Earlier finds only make it
 * leave out elements that cannot be among the best of all any more.
 */
export function pieceSearcherOf(parsed: ParsedQuery, { batch, core }: Cores): (piece: Piece) => PieceFinds {
  const { query, property, measure, start } = parsed
  const filter = filterOf(property, measure, start, core)
  const rankings = [new Ranking('simplicity'), new Ranking('extremeness')]
  const elements = new Float64Array(COORDINATE_COUNT * BLOCK)
  const positive = new Float64Array(COORDINATE_COUNT * BLOCK)
  const indices = new Uint32Array(BLOCK)

  return piece => {
    const began = performance.now()
    const finds: Find[] = []
    let found = 0

    function look(list: Float64Array, at: number, valid: boolean, index: number): void {
      const truth = filter.judge(list, at, valid)
      if (truth === FALSE) return
      const vertices = Array.from(list.subarray(at, at + COORDINATE_COUNT))
      const complexity = complexityOf(vertices, start)
      if (truth === TRUE) {
        const most = filter.measureAtMost()
        if (!rankings.some(ranking => ranking.mayTake(complexity, most))) {
          found += 1
          return
        }
      }
      const report = analysis(core, vertices)
      if (!isMet(property, quantitiesOf(report, start))) return
      found += 1
      const find = { index, vertices, complexity, extremeness: measured(measure, report, start) }
      const isNew = rankings.map(ranking => ranking.add(find))
      if (isNew.includes(true)) finds.push(find)
    }

    for (let block = piece.first; block < piece.first + piece.blocks; ++block) {
      sourceOf(query.distribution, randomOf(query.seed, block))(elements)
      const first = BLOCK * block
      let count = 0
      for (let e = 0; e < BLOCK; ++e) {
        const at = COORDINATE_COUNT * e
        if (hasCornerAtMost(elements, at, -coefficientError(elements, at))) {
          if (filter.mayBe.withoutPositiveCorners) look(elements, at, false, first + e)
          continue
        }
        positive.set(elements.subarray(at, at + COORDINATE_COUNT), COORDINATE_COUNT * count)
        indices[count++] = e
      }
      const points = positive.subarray(0, COORDINATE_COUNT * count)
      const { valid } = batch.classify({ points, cells: null, firstPoint: 0 }, {})
      for (let n = 0; n < count; ++n) {
        const isValid = valid[n] === 1
        if (isValid ? filter.mayBe.valid : filter.mayBe.invalid)
          look(positive, COORDINATE_COUNT * n, isValid, first + (indices[n] as number))
      }
    }
    return { piece, found, milliseconds: performance.now() - began, finds }
  }
}

export function analysis(core: Core, vertices: Vertices): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}
