/**
 * Conditions over the numbers of a report: claims of lessons, goals of challenges, properties that searches hunt for, a reader's
 * own inequality. Numbers come as enclosures and arithmetic is exact, so a condition is met only if it certainly is.
 */
import {
  type Enclosure,
  negatedEnclosure,
  productOfEnclosures,
  reciprocalOfEnclosure,
  sumOfEnclosures,
} from './condition/enclosure'
import type { Claim, NumberName, QuantityName } from './condition/names'
import { type ClaimNode, type Comparison, NotACondition, type NumberNode, parseClaim } from './condition/parse'
import { isAtMost } from './rational'
import type { Result } from './result'

export interface Condition {
  readonly text: string
  /** Names in the condition, each once, in the order of the text. */
  readonly names: readonly QuantityName[]
  readonly claim: ClaimNode
}

export interface ConditionError {
  /** One sentence for people. */
  readonly message: string
  /** Index in the text, from 0; its length if something is missing at the end. */
  readonly at: number
}

/** Numbers of an element in true units, length^3 if it is a jacdet. */
export interface Quantities {
  claim(name: Claim): boolean
  /** Enclosed by doubles with their error bounds; null if those say nothing. */
  roughly(name: NumberName): Enclosure | null
  /** Enclosed by exact arithmetic, if the doubles leave the condition open. */
  exactly(name: NumberName): Enclosure
}

export function parseCondition(text: string): Result<Condition, ConditionError> {
  try {
    const claim = parseClaim(text)
    return { ok: true, value: { text, names: [...new Set(namesIn(claim))], claim } }
  } catch (reason) {
    if (reason instanceof NotACondition) return { ok: false, error: { message: reason.message, at: reason.at } }
    throw reason
  }
}

/** True if it certainly holds. */
export function isMet(condition: Condition, quantities: Quantities): boolean {
  return truthOf(condition, quantities) === true
}

/**
 * True or false if that is certain; null if numbers that are only enclosed are too near each other,
 * or if something is divided by what may be zero.
 */
export function truthOf({ claim }: Condition, quantities: Quantities): boolean | null {
  const claimed = (name: Claim) => quantities.claim(name)
  return (
    truth(claim, { claimed, number: name => quantities.roughly(name) }) ??
    truth(claim, { claimed, number: name => quantities.exactly(name) })
  )
}

/** True if the number is certainly less for the one element than for the other. */
export function isCertainlyLess(number: NumberNode, one: Quantities, other: Quantities): boolean {
  const less = (way: 'roughly' | 'exactly') => {
    const [a, b] = [one, other].map(from => numberOf(number, { number: name => from[way](name) }))
    return a && b ? isLess(a, b) : null
  }
  return less('roughly') ?? less('exactly') ?? false
}

interface Valuation {
  claimed(name: Claim): boolean
  number(name: NumberName): Enclosure | null
}

/** Kleene's logic: null is open, and stays so unless the rest decides. */
function truth(node: ClaimNode, valuation: Valuation): boolean | null {
  if (node.kind === 'claim') return valuation.claimed(node.name)
  if (node.kind === 'not') return opposite(truth(node.of, valuation))
  if (node.kind === 'chain') {
    const values = node.terms.map(term => numberOf(term, valuation))
    return allOf(node.comparisons, (sign, i) => compare(values[i] ?? null, sign, values[i + 1] ?? null))
  }
  if (node.kind === 'and') return allOf(node.operands, operand => truth(operand, valuation))
  return opposite(allOf(node.operands, operand => opposite(truth(operand, valuation))))
}

function opposite(value: boolean | null): boolean | null {
  return value === null ? null : !value
}

/** The first that is false ends it: what stands behind it in the text need not be computed. */
function allOf<T>(
  operands: readonly T[],
  truthOfOperand: (operand: T, index: number) => boolean | null,
): boolean | null {
  let all: boolean | null = true
  for (const [index, operand] of operands.entries()) {
    const value = truthOfOperand(operand, index)
    if (value === false) return false
    if (value === null) all = null
  }
  return all
}

function numberOf(node: NumberNode, valuation: Pick<Valuation, 'number'>): Enclosure | null {
  if (node.kind === 'constant') return node.value
  if (node.kind === 'number') return valuation.number(node.name)
  if (node.kind === 'minus') return mapped(numberOf(node.of, valuation), negatedEnclosure)
  const left = numberOf(node.left, valuation)
  const right = mapped(numberOf(node.right, valuation), RIGHT_OPERAND[node.kind])
  if (!left || !right) return null
  return node.kind === '+' || node.kind === '-' ? sumOfEnclosures(left, right) : productOfEnclosures(left, right)
}

/** A difference is a sum, a quotient a product. */
const RIGHT_OPERAND: Readonly<Record<'+' | '-' | '*' | '/', (value: Enclosure) => Enclosure | null>> = {
  '+': value => value,
  '-': negatedEnclosure,
  '*': value => value,
  '/': reciprocalOfEnclosure,
}

function mapped(value: Enclosure | null, map: (value: Enclosure) => Enclosure | null): Enclosure | null {
  return value && map(value)
}

function compare(a: Enclosure | null, sign: Comparison, b: Enclosure | null): boolean | null {
  if (!a || !b) return null
  switch (sign) {
    case '<':
      return isLess(a, b)
    case '>':
      return isLess(b, a)
    case '>=':
      return opposite(isLess(a, b))
    case '<=':
      return opposite(isLess(b, a))
    case '=':
      return isEqual(a, b)
    case '!=':
      return opposite(isEqual(a, b))
  }
}

function isLess(a: Enclosure, b: Enclosure): boolean | null {
  if (isAtMost(b.upper, a.lower)) return false
  return isAtMost(b.lower, a.upper) ? null : true
}

function isEqual(a: Enclosure, b: Enclosure): boolean | null {
  if (isLess(a, b) || isLess(b, a)) return false
  return isAtMost(a.upper, b.lower) && isAtMost(b.upper, a.lower) ? true : null
}

function namesIn(node: ClaimNode | NumberNode): QuantityName[] {
  switch (node.kind) {
    case 'constant':
      return []
    case 'claim':
    case 'number':
      return [node.name]
    case 'not':
    case 'minus':
      return namesIn(node.of)
    case 'and':
    case 'or':
      return node.operands.flatMap(namesIn)
    case 'chain':
      return node.terms.flatMap(namesIn)
    default:
      return [...namesIn(node.left), ...namesIn(node.right)]
  }
}
