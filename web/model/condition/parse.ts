/**
 * Reads a condition, such as "not valid and corner_min > 0":
 *
 *     either      = both { "or" both }            sum      = product { ("+" | "-") product }
 *     both        = denied { "and" denied }       product  = signed { ("*" | "/") signed }
 *     denied      = { "not" } comparison          signed   = { "-" } primary
 *     comparison  = sum { ("<" | "<=" | ">" | ">=" | "=" | "!=") sum }
 *     primary     = number | name | "(" either ")"
 */
import { decimalFraction } from '../rational'
import { type Enclosure, exactly } from './enclosure'
import { CLAIMS, type Claim, NUMBERS, type NumberName } from './names'

export const COMPARISONS = ['<', '<=', '>', '>=', '=', '!='] as const
export type Comparison = (typeof COMPARISONS)[number]

export type NumberNode =
  | { readonly kind: 'constant'; readonly value: Enclosure }
  | { readonly kind: 'number'; readonly name: NumberName }
  | { readonly kind: 'minus'; readonly of: NumberNode }
  | { readonly kind: '+' | '-' | '*' | '/'; readonly left: NumberNode; readonly right: NumberNode }

export type ClaimNode =
  | { readonly kind: 'claim'; readonly name: Claim }
  | { readonly kind: 'not'; readonly of: ClaimNode }
  | { readonly kind: 'and' | 'or'; readonly operands: readonly ClaimNode[] }
  /** A chain: every neighbouring pair compares as said. */
  | { readonly kind: 'chain'; readonly terms: readonly NumberNode[]; readonly comparisons: readonly Comparison[] }

type Node = NumberNode | ClaimNode

/** The text does not parse at the index `at`. */
export class NotACondition extends Error {
  readonly at: number

  constructor(message: string, at: number) {
    super(message)
    this.at = at
  }
}

interface Token {
  readonly kind: 'number' | 'name' | 'sign' | 'end'
  readonly text: string
  readonly at: number
}

const TOKEN =
  /(?<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?<name>[A-Za-z_]\w*)|(?<sign><=|>=|!=|[<>=+\-*/()≤≥≠−·×])/y

/** Signs as they are printed. */
const TYPED: ReadonlyMap<string, string> = new Map([
  ['≤', '<='],
  ['≥', '>='],
  ['≠', '!='],
  ['−', '-'],
  ['·', '*'],
  ['×', '*'],
])

/** Longer texts, and powers of ten beyond these, are refused: what follows then ends soon. */
const GREATEST_LENGTH = 1000
const GREATEST_POWER = 400

/** Throws NotACondition. */
export function parseClaim(text: string): ClaimNode {
  if (text.length > GREATEST_LENGTH)
    throw new NotACondition(`A condition has at most ${GREATEST_LENGTH} characters.`, GREATEST_LENGTH)
  return new Parser(tokensOf(text)).whole()
}

function tokensOf(text: string): Token[] {
  const tokens: Token[] = []
  for (let at = 0; at < text.length; ) {
    if (/\s/.test(text.charAt(at))) {
      ++at
      continue
    }
    TOKEN.lastIndex = at
    const groups = TOKEN.exec(text)?.groups
    const kind = (['number', 'name', 'sign'] as const).find(name => groups?.[name] !== undefined)
    if (!groups || !kind) throw new NotACondition(`“${text.charAt(at)}” is nothing that a condition knows.`, at)
    const found = groups[kind] as string
    tokens.push({ kind, text: TYPED.get(found) ?? found, at })
    at += found.length
  }
  return [...tokens, { kind: 'end', text: '', at: text.length }]
}

class Parser {
  readonly #tokens: readonly Token[]
  #next = 0

  constructor(tokens: readonly Token[]) {
    this.#tokens = tokens
  }

  whole(): ClaimNode {
    if (this.#tokens.length === 1) throw new NotACondition('There is no condition.', 0)
    const node = this.#either()
    const { kind, text, at } = this.#token
    if (kind !== 'end') throw new NotACondition(`“${text}” cannot stand here.`, at)
    return this.#asClaim(0, node)
  }

  get #token(): Token {
    return this.#tokens[this.#next] as Token
  }

  /** The sign or word that comes next, if it is one of these. */
  #taken<const Text extends string>(...texts: readonly Text[]): Text | null {
    const { kind, text } = this.#token
    const found = kind === 'number' ? undefined : texts.find(given => given === text)
    if (found === undefined) return null
    ++this.#next
    return found
  }

  #either(): Node {
    return this.#joined('or', () => this.#joined('and', () => this.#denied()))
  }

  #joined(kind: 'and' | 'or', operand: () => Node): Node {
    const { at } = this.#token
    const first = operand()
    const operands: ClaimNode[] = []
    while (this.#taken(kind)) {
      if (operands.length === 0) operands.push(this.#asClaim(at, first))
      const { at: start } = this.#token
      operands.push(this.#asClaim(start, operand()))
    }
    return operands.length > 0 ? { kind, operands } : first
  }

  #denied(): Node {
    if (!this.#taken('not')) return this.#comparison()
    const { at } = this.#token
    return { kind: 'not', of: this.#asClaim(at, this.#denied()) }
  }

  #comparison(): Node {
    const { at } = this.#token
    const first = this.#sum()
    const terms: NumberNode[] = []
    const comparisons: Comparison[] = []
    for (let sign = this.#taken(...COMPARISONS); sign; sign = this.#taken(...COMPARISONS)) {
      if (terms.length === 0) terms.push(asNumber(at, first))
      comparisons.push(sign)
      const { at: start } = this.#token
      terms.push(asNumber(start, this.#sum()))
    }
    return terms.length > 0 ? { kind: 'chain', terms, comparisons } : first
  }

  #sum(): Node {
    return this.#operations(['+', '-'], () => this.#product())
  }

  #product(): Node {
    return this.#operations(['*', '/'], () => this.#signed())
  }

  #operations(signs: readonly ('+' | '-' | '*' | '/')[], operand: () => Node): Node {
    const { at } = this.#token
    let left = operand()
    for (let kind = this.#taken(...signs); kind; kind = this.#taken(...signs)) {
      const { at: start } = this.#token
      left = { kind, left: asNumber(at, left), right: asNumber(start, operand()) }
    }
    return left
  }

  #signed(): Node {
    if (!this.#taken('-')) return this.#primary()
    const { at } = this.#token
    return { kind: 'minus', of: asNumber(at, this.#signed()) }
  }

  #primary(): Node {
    const { kind, text, at } = this.#token
    if (this.#taken('(')) {
      const inside = this.#either()
      if (!this.#taken(')')) throw new NotACondition('Here a parenthesis has to close.', this.#token.at)
      return inside
    }
    if (kind === 'end') throw new NotACondition('The condition breaks off: a number or a name is missing.', at)
    if (kind === 'sign' || KEYWORDS.includes(text))
      throw new NotACondition(`Before “${text}” a number or a name is missing.`, at)
    ++this.#next
    return kind === 'number' ? constant(text, at) : named(text, at)
  }

  #asClaim(at: number, node: Node): ClaimNode {
    if (isNumber(node)) throw new NotACondition('This is a number; compare it with another, as in “> 0”.', at)
    return node
  }
}

const KEYWORDS: readonly string[] = ['and', 'or', 'not']

function isNumber(node: Node): node is NumberNode {
  return ['constant', 'number', 'minus', '+', '-', '*', '/'].includes(node.kind)
}

function asNumber(at: number, node: Node): NumberNode {
  if (!isNumber(node)) throw new NotACondition('This is true or false, and no number.', at)
  return node
}

function named(text: string, at: number): Node {
  const number = NUMBERS.find(name => name === text)
  if (number) return { kind: 'number', name: number }
  const claim = CLAIMS.find(name => name === text)
  if (claim) return { kind: 'claim', name: claim }
  throw new NotACondition(`“${text}” is not a name that a condition knows: ${[...CLAIMS, ...NUMBERS].join(', ')}.`, at)
}

/** A decimal as the fraction that it is. */
function constant(text: string, at: number): NumberNode {
  const value = decimalFraction(text, GREATEST_POWER)
  if (value === null) throw new NotACondition('This number is too large or too small.', at)
  return { kind: 'constant', value: exactly(value) }
}
