/**
 * What a teacher is writing: one plain object, so that it can be kept. A challenge of this page
 * stands in it by its id; of the others the one at `at` is in the form.
 */
import { parseCondition } from '../../model/condition'
import { written } from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import type { Row } from '../conditions/rows'
import { textOfRow } from '../conditions/rows'
import { CHALLENGE_VERSION, type ChallengeDocument } from './challenge'
import { challenges } from './challenges'
import { MOST_CHALLENGES } from './series'

export interface Draft {
  readonly kind: 'draft'
  readonly title: string
  readonly text: string
  readonly goal: readonly Row[]
  readonly hint: string
  /** Null until it is taken: then it is the element as it is. */
  readonly start: Vertices | null
  readonly solution: Vertices | null
}

export interface OfThisPage {
  readonly kind: 'of this page'
  readonly id: string
}

export interface Writing {
  /** At least one. */
  readonly entries: readonly (Draft | OfThisPage)[]
  readonly at: number
}

export function newDraft(): Draft {
  const goal: Row[] = [
    { kind: 'claim', isValid: false },
    { kind: 'comparison', quantity: 'corner_min', comparison: '>', number: '0' },
  ]
  return { kind: 'draft', title: '', text: '', goal, hint: '', start: null, solution: null }
}

export function newWriting(): Writing {
  return { entries: [newDraft()], at: 0 }
}

export function current({ entries, at }: Writing): Draft | OfThisPage {
  return entries[at] as Draft | OfThisPage
}

export function withDraft(writing: Writing, some: Partial<Draft>): Writing {
  const { entries, at } = writing
  const draft = entries[at]
  return draft?.kind === 'draft' ? { ...writing, entries: entries.with(at, { ...draft, ...some }) } : writing
}

export function canGrow({ entries }: Writing): boolean {
  return entries.length < MOST_CHALLENGES
}

/** The new one stands behind the others and is in the form. */
export function withEntry({ entries }: Writing, entry: Draft | OfThisPage): Writing {
  return { entries: [...entries, entry], at: entries.length }
}

/** Exchanges an entry with the one before it or behind it. What is in the form stays there. */
export function withMoved({ entries, at }: Writing, from: number, by: -1 | 1): Writing {
  const to = from + by
  const [moved, other] = [entries[from], entries[to]]
  if (moved === undefined || other === undefined) return { entries, at }
  return { entries: entries.with(from, other).with(to, moved), at: at === from ? to : at === to ? from : at }
}

/** Without the last there is an empty one. */
export function withoutEntry({ entries, at }: Writing, index: number): Writing {
  const left = entries.toSpliced(index, 1)
  if (left.length === 0) return newWriting()
  return { entries: left, at: Math.min(index < at ? at - 1 : at, left.length - 1) }
}

export function titleOf(entry: Draft | OfThisPage): string {
  if (entry.kind === 'draft') return entry.title.trim() || 'Untitled'
  return challenges.find(({ id }) => id === entry.id)?.title ?? entry.id
}

/** `now` is the element on the page. */
export function documentOf(entry: Draft | OfThisPage, now: Vertices): string | ChallengeDocument {
  if (entry.kind === 'of this page') return entry.id
  const { title, text, goal, hint, start, solution } = entry
  return {
    version: CHALLENGE_VERSION,
    title,
    text,
    start: written(start ?? now),
    goal: goal.map(textOfRow),
    ...(hint.trim() === '' ? {} : { hint }),
    ...(solution ? { solution: written(solution) } : {}),
  }
}

/** The rows' conditions; null is one that is not understood. */
export function conditionsOf(rows: readonly Row[]) {
  return rows.map(row => {
    const result = parseCondition(textOfRow(row))
    return result.ok ? result.value : null
  })
}
