/**
 * What a teacher is writing: one plain object, so that it can be kept. A challenge of this page
 * stands in it by its id; of the others the one at `at` is in the form.
 */
import { parseCondition } from '../../model/condition'
import { NUMBERS } from '../../model/condition/names'
import { COMPARISONS } from '../../model/condition/parse'
import { written } from '../../model/document-readers'
import { COORDINATE_COUNT, type Vertices } from '../../model/hexahedron'
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
  readonly members: readonly (Draft | OfThisPage)[]
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
  return { members: [newDraft()], at: 0 }
}

export function current({ members, at }: Writing): Draft | OfThisPage {
  return members[at] as Draft | OfThisPage
}

export function withDraft(writing: Writing, some: Partial<Draft>): Writing {
  const { members, at } = writing
  const draft = members[at]
  return draft?.kind === 'draft' ? { ...writing, members: members.with(at, { ...draft, ...some }) } : writing
}

export function canGrow({ members }: Writing): boolean {
  return members.length < MOST_CHALLENGES
}

/** The new one stands behind the others and is in the form. */
export function withMember({ members }: Writing, member: Draft | OfThisPage): Writing {
  return { members: [...members, member], at: members.length }
}

/** Exchanges a member with the one before it or behind it. What is in the form stays there. */
export function withMoved({ members, at }: Writing, from: number, by: -1 | 1): Writing {
  const to = from + by
  const [moved, other] = [members[from], members[to]]
  if (moved === undefined || other === undefined) return { members, at }
  return { members: members.with(from, other).with(to, moved), at: at === from ? to : at === to ? from : at }
}

/** Without the last there is an empty one. */
export function withoutMember({ members, at }: Writing, index: number): Writing {
  const left = members.toSpliced(index, 1)
  if (left.length === 0) return newWriting()
  return { members: left, at: Math.min(index < at ? at - 1 : at, left.length - 1) }
}

export function titleOf(member: Draft | OfThisPage): string {
  if (member.kind === 'draft') return member.title.trim() || 'Untitled'
  return challenges.find(({ id }) => id === member.id)?.title ?? member.id
}

/** `now` is the element on the page. */
export function documentOf(member: Draft | OfThisPage, now: Vertices): string | ChallengeDocument {
  if (member.kind === 'of this page') return member.id
  const { title, text, goal, hint, start, solution } = member
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

/** What was kept, as JSON.parse gives it; null if it is no such thing. */
export function readWriting(value: unknown): Writing | null {
  const { members, at } = (value ?? {}) as Partial<Writing>
  return Array.isArray(members) &&
    members.every(isMember) &&
    Number.isInteger(at) &&
    members[at as number] !== undefined
    ? (value as Writing)
    : null
}

function isMember(value: unknown): boolean {
  const member = (value ?? {}) as Partial<Record<keyof Draft | 'id', unknown>>
  if (member.kind === 'of this page') return challenges.some(({ id }) => id === member.id)
  const areTexts = [member.title, member.text, member.hint].every(each => typeof each === 'string')
  const areElements = [member.start, member.solution].every(each => each === null || isElement(each))
  return member.kind === 'draft' && areTexts && areElements && Array.isArray(member.goal) && member.goal.every(isRow)
}

function isRow(value: unknown): boolean {
  const row = (value ?? {}) as Partial<
    Record<'kind' | 'isValid' | 'quantity' | 'comparison' | 'number' | 'text', unknown>
  >
  if (row.kind === 'claim') return typeof row.isValid === 'boolean'
  if (row.kind === 'text') return typeof row.text === 'string'
  const isKnown = [...NUMBERS].some(name => name === row.quantity) && COMPARISONS.some(sign => sign === row.comparison)
  return row.kind === 'comparison' && isKnown && typeof row.number === 'string'
}

function isElement(value: unknown): boolean {
  return Array.isArray(value) && value.length === COORDINATE_COUNT && value.every(Number.isFinite)
}
