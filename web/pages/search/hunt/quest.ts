/** What a search looks for, and where. */
import { type Condition, type ConditionError, parseCondition } from '../../../model/condition'
import type { NumberNode } from '../../../model/condition/parse'
import type { Vertices } from '../../../model/hexahedron'
import { type Distribution, refusalOf, startOf } from './distribution'
import { parseMeasure } from './measure'

export interface Quest {
  /** In the language of conditions. */
  readonly property: string
  /** The number that is greatest for the most extreme. */
  readonly measure: string
  readonly distribution: Distribution
  /** An integer in [0, 2^32). */
  readonly seed: number
}

/** A quest that can be gone on. */
export interface ReadQuest {
  readonly quest: Quest
  readonly property: Condition
  readonly measure: NumberNode
  /** What `moved` counts from. */
  readonly start: Vertices
}

export interface QuestError extends Partial<ConditionError> {
  readonly field: 'property' | 'measure' | 'distribution' | 'seed'
  readonly message: string
}

export const MOST_SEED = 2 ** 32 - 1

export type QuestResult =
  | { readonly ok: true; readonly value: ReadQuest }
  | { readonly ok: false; readonly errors: readonly QuestError[] }

export function readQuest(quest: Quest): QuestResult {
  const property = parseCondition(quest.property)
  const measure = parseMeasure(quest.measure)
  const refused = refusalOf(quest.distribution)
  const isSeed = Number.isInteger(quest.seed) && quest.seed >= 0 && quest.seed <= MOST_SEED
  if (property.ok && measure.ok && refused === null && isSeed)
    return {
      ok: true,
      value: { quest, property: property.value, measure: measure.value, start: startOf(quest.distribution) },
    }
  const errors: QuestError[] = []
  if (!property.ok) errors.push({ field: 'property', ...property.error })
  if (!measure.ok) errors.push({ field: 'measure', ...measure.error })
  if (refused !== null) errors.push({ field: 'distribution', message: refused })
  if (!isSeed) errors.push({ field: 'seed', message: `The seed is a whole number from 0 to ${MOST_SEED}.` })
  return { ok: false, errors }
}
