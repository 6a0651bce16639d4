/** The property that a search looks for, and the elements it searches. */
import { type Condition, type ConditionError, parseCondition } from '../../../model/condition'
import type { NumberNode } from '../../../model/condition/parse'
import type { Vertices } from '../../../model/hexahedron'
import type { Result } from '../../../model/result'
import { type Distribution, refusalOf, startOf } from './distribution'
import { parseMeasure } from './measure'

export interface Query {
  /** A condition of web/model/condition.ts. */
  readonly property: string
  /** The number that is greatest for the most extreme. */
  readonly measure: string
  readonly distribution: Distribution
  /** An integer in [0, 2^32). */
  readonly seed: number
}

/** A query that is understood. */
export interface ParsedQuery {
  readonly query: Query
  readonly property: Condition
  readonly measure: NumberNode
  /** The element from which `moved` counts. */
  readonly start: Vertices
}

export interface QueryError extends Partial<ConditionError> {
  readonly field: 'property' | 'measure' | 'distribution' | 'seed'
  readonly message: string
}

export const MOST_SEED = 2 ** 32 - 1

export function parseQuery(query: Query): Result<ParsedQuery, readonly QueryError[]> {
  const property = parseCondition(query.property)
  const measure = parseMeasure(query.measure)
  const refused = refusalOf(query.distribution)
  const isSeed = Number.isInteger(query.seed) && query.seed >= 0 && query.seed <= MOST_SEED
  if (property.ok && measure.ok && refused === null && isSeed)
    return {
      ok: true,
      value: { query, property: property.value, measure: measure.value, start: startOf(query.distribution) },
    }
  const errors: QueryError[] = []
  if (!property.ok) errors.push({ field: 'property', ...property.error })
  if (!measure.ok) errors.push({ field: 'measure', ...measure.error })
  if (refused !== null) errors.push({ field: 'distribution', message: refused })
  if (!isSeed) errors.push({ field: 'seed', message: `The seed is a whole number from 0 to ${MOST_SEED}.` })
  return { ok: false, error: errors }
}
