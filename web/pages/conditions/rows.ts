/**
 * Conditions as rows of menus, and back as text. A row of menus says that the element is valid or
 * invalid, or compares one quantity with one number; any other condition is a row of text.
 */
import { type ConditionError, parseCondition } from '../../model/condition'
import { NUMBERS, type NumberName } from '../../model/condition/names'
import type { Comparison, NumberNode } from '../../model/condition/parse'
import type { Result } from '../../model/result'

export type Row =
  | { readonly kind: 'claim'; readonly isValid: boolean }
  | {
      readonly kind: 'comparison'
      readonly quantity: NumberName
      readonly comparison: Comparison
      /** As it was typed. */
      readonly number: string
    }
  | { readonly kind: 'text'; readonly text: string }

/** The condition as documents have it. */
export function textOfRow(row: Row): string {
  if (row.kind === 'claim') return row.isValid ? 'valid' : 'not valid'
  if (row.kind === 'text') return row.text.trim()
  return `${row.quantity} ${row.comparison} ${row.number.trim()}`
}

/** A row whose text is the same condition: of menus if they can say it. */
export function rowOf(text: string): Row {
  const trimmed = text.trim()
  const parsed = parseCondition(trimmed)
  if (!parsed.ok) return { kind: 'text', text: trimmed }
  const { claim } = parsed.value
  if (claim.kind === 'claim') return { kind: 'claim', isValid: true }
  if (claim.kind === 'not' && claim.of.kind === 'claim') return { kind: 'claim', isValid: false }
  const [left, right] = claim.kind === 'chain' ? claim.terms : []
  if (claim.kind === 'chain' && claim.terms.length === 2 && left?.kind === 'number' && right && isConstant(right)) {
    const number = /^\w+\s*(?:[<>!]=|[<>=≤≥≠])\s*(.*)$/s.exec(trimmed)?.[1]
    // The name may stand in parentheses, which menus do not say.
    if (number !== undefined)
      return { kind: 'comparison', quantity: left.name, comparison: claim.comparisons[0] as Comparison, number }
  }
  return { kind: 'text', text: trimmed }
}

/** One row for each line that is not empty. */
export function rowsOf(text: string): readonly Row[] {
  return text
    .split('\n')
    .filter(line => line.trim() !== '')
    .map(rowOf)
}

export function textOfRows(rows: readonly Row[]): string {
  return rows.map(textOfRow).join('\n')
}

/** The sentence that a row's reader is told; null if its condition is understood. */
export function mistakeIn(row: Row): string | null {
  if (row.kind === 'comparison' && row.number.trim() === '') return 'Here a number is missing.'
  const result: Result<unknown, ConditionError> = parseCondition(textOfRow(row))
  if (result.ok) {
    const isMenus = row.kind === 'comparison' && rowOf(textOfRow(row)).kind !== 'comparison'
    return isMenus ? 'A number is wanted here, such as 0.2 or 1/3. For more choose “As text”.' : null
  }
  return row.kind === 'text' ? `At character ${result.error.at + 1}: ${result.error.message}` : result.error.message
}

/** The choices of a row's first menu. */
export type Subject = 'valid' | 'invalid' | 'text' | NumberName

export const SUBJECTS: readonly Subject[] = ['valid', 'invalid', ...NUMBERS, 'text']

export function subjectOf(row: Row): Subject {
  if (row.kind === 'claim') return row.isValid ? 'valid' : 'invalid'
  return row.kind === 'text' ? 'text' : row.quantity
}

/** The row with another subject: what was chosen and typed stays where it has a place. */
export function withSubject(row: Row, subject: Subject): Row {
  if (subject === 'text') return { kind: 'text', text: textOfRow(row) }
  if (subject === 'valid' || subject === 'invalid') return { kind: 'claim', isValid: subject === 'valid' }
  const before = row.kind === 'comparison' ? row : NEW_COMPARISON
  return { ...before, quantity: subject }
}

const NEW_COMPARISON = { kind: 'comparison', quantity: 'corner_min', comparison: '>', number: '0' } as const

/** The row that is added: the first subject that no row has. */
export function newRow(rows: readonly Row[]): Row {
  const taken = new Set(rows.map(subjectOf))
  const subject = SUBJECTS.find(each => !taken.has(each) && !(each === 'valid' && taken.has('invalid')))
  return withSubject(NEW_COMPARISON, subject === 'invalid' && taken.has('valid') ? 'boundary_min' : (subject ?? 'text'))
}

export const COMPARISONS_IN_WORDS: Readonly<Record<Comparison, string>> = {
  '<': '< less than',
  '<=': '≤ at most',
  '>': '> more than',
  '>=': '≥ at least',
  '=': '= equal to',
  '!=': '≠ other than',
}

function isConstant(node: NumberNode): boolean {
  switch (node.kind) {
    case 'constant':
      return true
    case 'number':
      return false
    case 'minus':
      return isConstant(node.of)
    default:
      return isConstant(node.left) && isConstant(node.right)
  }
}
