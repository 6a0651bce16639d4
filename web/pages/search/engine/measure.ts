/** A number that a search orders its finds by, written as in a condition: "-boundary_min / boundary_max". */
import { shownNumber } from '../../../core/quantities'
import type { Report } from '../../../core/report'
import { type ConditionError, parseCondition } from '../../../model/condition'
import type { NumberNode } from '../../../model/condition/parse'
import type { Vertices } from '../../../model/hexahedron'
import type { Result } from '../../../model/result'

/** The comparison that makes a condition of the number. */
const COMPARED = ' > 0'

export function parseMeasure(text: string): Result<NumberNode, ConditionError> {
  if (text.trim() === '') return { ok: false, error: { message: 'Write a number here, such as corner_min.', at: 0 } }
  const result = parseCondition(text + COMPARED)
  if (!result.ok) return { ok: false, error: { ...result.error, at: Math.min(result.error.at, text.length) } }
  const { claim } = result.value
  if (claim.kind !== 'chain' || claim.terms.length !== 2)
    return { ok: false, error: { message: 'Write one number here, not a comparison.', at: 0 } }
  return { ok: true, value: claim.terms[0] as NumberNode }
}

/** The number in doubles: an order to look at, no verdict. Minus infinity for NaN. */
export function measured(node: NumberNode, report: Report, start: Vertices): number {
  const value = doubleOf(node, report, start)
  return Number.isNaN(value) ? -Infinity : value
}

function doubleOf(node: NumberNode, report: Report, start: Vertices): number {
  if (node.kind === 'constant') return Number(node.value.lower.numerator) / Number(node.value.lower.denominator)
  if (node.kind === 'number') {
    const { value, exponent } = shownNumber(node.name, report, start)
    return value * 2 ** exponent
  }
  if (node.kind === 'minus') return -doubleOf(node.of, report, start)
  const [left, right] = [doubleOf(node.left, report, start), doubleOf(node.right, report, start)]
  switch (node.kind) {
    case '+':
      return left + right
    case '-':
      return left - right
    case '*':
      return left * right
    case '/':
      return left / right
  }
}
