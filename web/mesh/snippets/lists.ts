/**
 * Lists of numbers in brackets, as languages write and print them: Python, NumPy, C, JavaScript, Julia, MATLAB, R, Mathematica; and lists
 * without brackets behind a name. The brackets are a stack; each list is handed on once.
 */
import { List, languageOf, tableOf } from './list-tables'
import type { NumberTable } from './number-table'
import { Tokens } from './tokens'

const [OPENING, CLOSING] = ['([{', ')]}']
/** The deepest nesting of lists of numbers; brackets inside of it count for nothing. */
const DEEPEST = 100
/** Eight numbers, behind a quotation mark. */
const NUMBERS = /^\s{0,20}(?:[-+.\de]{1,30}\s{1,20}){7}/i
/** Characters behind Fortran's “&” in which its line ends. */
const BEHIND = 160

/** The tables that the lists of a text are, in its order. */
export function tablesOfLists(text: string): NumberTable[] {
  const language = languageOf(text)
  return new ListReader(text).read().flatMap(list => tableOf(list, text, language) ?? [])
}

class ListReader {
  readonly #text: string
  readonly #tokens: Tokens
  readonly #lists: List[] = []
  #list: List = new List('', '', [], 0, null)
  /** The end of the last word, which a bracket that touches it belongs to. */
  #wordEnd = -1
  #word = ''
  /** True until something stands on the line. */
  #isLineStart = true
  /** True behind a name and "=": numbers may follow without brackets. */
  #isAssigned = false
  #isStreamed = false
  /** True if the last word was a string. */
  #isString = false
  #promptWord = ''
  #hasNoCommentEnd = false
  /** Open brackets that are too deep for a list. */
  #deeper = 0
  /** True in a list that a quotation mark ends. */
  #isQuoted = false
  readonly #hasPrompts: boolean

  constructor(text: string) {
    this.#text = text
    this.#tokens = new Tokens(text, 0, true)
    this.#hasPrompts = text.includes('>>>')
  }

  /** The lists of numbers, and of lists of numbers, in the order in which they end. */
  read(): List[] {
    const tokens = this.#tokens
    for (let kind = tokens.next(); kind !== 'end'; kind = tokens.next()) {
      if (kind === 'number') this.#number()
      else if (kind === 'word') this.#wordToken(tokens.word)
      else if (kind === 'string') this.#stringToken(tokens.word.slice(1, -1))
      else if (kind === 'line') this.#line()
      else this.#mark(tokens.word)
      if (kind !== 'line') this.#isLineStart = false
    }
    this.#endPlain()
    while (this.#list.parent !== null) {
      this.#list.cut()
      this.#close(this.#text.length)
    }
    return this.#lists
  }

  #number(): void {
    const { value, isInteger, digits } = this.#tokens
    const list = this.#list
    if (list.parent === null) {
      if (!this.#isAssigned) return
      this.#open('=', '')
    }
    const into = this.#list
    into.values.push(value)
    into.areIntegers &&= isInteger
    into.digits = Math.max(into.digits, digits)
    this.#isAssigned = false
  }

  #wordToken(word: string): void {
    this.#endPlain()
    const list = this.#list
    this.#word = word
    this.#isString = false
    this.#wordEnd = this.#tokens.to
    const next = this.#text[this.#tokens.to] ?? ''
    list.lastWord = word
    // A word that calls something is no entry of the list.
    if (list.parent !== null && word !== 'new' && !(next !== '' && OPENING.includes(next))) list.isMixed = true
    if (list.parent === null) this.#isAssigned = false
  }

  #stringToken(word: string): void {
    if (this.#opensQuoted()) return
    this.#endPlain()
    this.#list.lastWord = word
    this.#word = word
    this.#isString = true
    if (this.#list.parent !== null) this.#list.isMixed = true
  }

  /** Numbers in quotes behind a name, as MOOSE's input has them, are a list. */
  #opensQuoted(): boolean {
    const { from } = this.#tokens
    if (!this.#isAssigned || !NUMBERS.test(this.#text.slice(from + 1, from + BEHIND))) return false
    this.#tokens.to = from + 1
    this.#open('[', '')
    this.#isQuoted = true
    return true
  }

  #line(): void {
    const list = this.#list
    this.#isLineStart = true
    if (list.opener === '=') {
      if (!list.hasCommas || !this.#followsComma()) this.#endPlain()
    } else if (list.opener === '[' && !list.hasCommas) this.#endRow()
    if (list.parent === null) this.#promptWord = ''
  }

  #followsComma(): boolean {
    let at = this.#tokens.from - 1
    while (at > 0 && (this.#text.charCodeAt(at) === 32 || this.#text.charCodeAt(at) === 9)) at--
    return this.#text[at] === ',' || this.#text[at] === '='
  }

  #endRow(): void {
    const list = this.#list
    const count = list.values.length
    if (count > (list.breaks.at(-1) ?? 0)) list.breaks.push(count)
  }

  #mark(mark: string): void {
    const list = this.#list
    const text = this.#text
    const at = this.#tokens.from
    if (mark === ',') {
      list.hasCommas = true
      if (!this.#isString) list.lastWord = ''
    } else if (mark === ';') {
      if (list.opener === '=') this.#endPlain()
      else if (list.parent !== null) {
        list.hasSemicolons = true
        this.#endRow()
      } else {
        list.lastWord = ''
        list.pending = ''
        this.#isAssigned = false
      }
    } else if (mark === '=' || mark === ':') {
      if (text[at + 1] === ':') return
      list.pending = list.lastWord
      this.#isAssigned = list.parent === null && list.pending !== ''
      this.#isStreamed = false
    } else if (mark === '<' && text[at + 1] === '<') {
      this.#tokens.to = at + 2
      list.pending = list.lastWord
      this.#isAssigned = list.parent === null
      this.#isStreamed = true
    } else if (mark === '>' && text.startsWith('>>>', at)) {
      this.#tokens.to = at + 3
      this.#endPlain()
      this.#prompt()
    } else if (mark === '#' || mark === '%') this.#skipLine()
    else if (mark === '/' && text[at + 1] === '/') this.#skipLine()
    else if (mark === '/' && text[at + 1] === '*') this.#skipComment()
    else if (mark === '.' || mark === '…') this.#dots(mark)
    else if (OPENING.includes(mark)) {
      // An array's type and its size in brackets: "double v[8][3] = {".
      this.#open(mark, this.#wordEnd === at ? this.#word : '')
    } else if (CLOSING.includes(mark)) {
      this.#endPlain()
      if (this.#deeper > 0) this.#deeper--
      else if (this.#list.parent !== null) this.#close(at + 1)
    } else if (mark === "'" || mark === '"') {
      if (!this.#isQuoted) this.#opensQuoted()
      else {
        this.#isQuoted = false
        this.#close(at)
      }
    } else if (mark === '&' && this.#isFortranEnd(at)) this.#isLineStart = false
    else if (mark === '|' || mark === '&' || mark === '\\') list.isMixed = list.parent !== null
  }

  /** Fortran's mark for a line that goes on, at its end or at the beginning of the next one. */
  #isFortranEnd(at: number): boolean {
    return this.#isLineStart || /^&[ \t]*(?:\n|$|![^\n]{0,200}\n)/.test(this.#text.slice(at, at + BEHIND))
  }

  /** ">>> mesh.points": what is printed below has this name. */
  #prompt(): void {
    if (this.#list.parent !== null) return
    const line = this.#text.slice(this.#tokens.to, this.#tokens.to + 100)
    const [whole, word] = /^[ \t]*(?:print\()?([\w.]{1,60})\)?[ \t]*\n/.exec(line) ?? []
    if (whole === undefined) return
    this.#promptWord = word as string
    this.#tokens.to += whole.length
    this.#isLineStart = true
  }

  #skipLine(): void {
    const end = this.#text.indexOf('\n', this.#tokens.from)
    this.#tokens.to = end < 0 ? this.#text.length : end
  }

  #skipComment(): void {
    if (this.#hasNoCommentEnd) return
    const end = this.#text.indexOf('*/', this.#tokens.to)
    if (end < 0) this.#hasNoCommentEnd = true
    else this.#tokens.to = end + 2
  }

  /** "..." that ends a line with something on it goes on there; elsewhere it leaves something out. */
  #dots(mark: string): void {
    const at = this.#tokens.from
    const isThree = mark === '…' || this.#text.startsWith('...', at)
    if (!isThree) return
    const end = mark === '…' ? at + 1 : at + 3
    this.#tokens.to = end
    const behind = /^[ \t]*\n/.test(this.#text.slice(end, end + 20))
    const list = this.#list
    // Python's prompt for a line that goes on.
    if (this.#isLineStart && this.#hasPrompts && this.#text[end] === ' ') return
    if (behind && !this.#isLineStart) {
      this.#tokens.to = this.#text.indexOf('\n', end) + 1
    } else if (list.parent !== null) list.cut()
  }

  #open(opener: string, callee: string): void {
    const parent = this.#list
    if (parent.depth === DEEPEST) {
      parent.isMixed = true
      this.#deeper++
      return
    }
    const own = parent.pending || (parent.parent === null ? this.#promptWord : '') || (callee ? '' : parent.lastWord)
    const isNew = own !== '' && own !== parent.names.at(-1)
    this.#list = new List(
      opener,
      callee,
      isNew ? [...parent.names.slice(-6), own] : parent.names,
      this.#tokens.from,
      parent,
    )
    this.#list.isStreamed = opener === '=' && this.#isStreamed
    this.#isAssigned = false
  }

  /** Ends a list that has no brackets. */
  #endPlain(): void {
    if (this.#list.opener === '=') this.#close(this.#tokens.from)
  }

  #close(to: number): void {
    const list = this.#list
    const parent = list.parent as List
    list.end = to
    this.#list = parent
    const isAttached = list.callee !== '' || (list.opener === '[' && this.#text[list.from - 1] === ']')
    const count = list.values.length
    if (isAttached && !list.isMixed && list.lists.length === 0 && count <= 1) {
      // v[8], np.float64(0.5): an index, or a number in its own words; Vec{3}(…): its type.
      if (list.opener === '(' && count === 1) this.#wrapped(list, parent)
      return
    }
    if (isAttached && list.opener === '{' && this.#text[to] === '(') return
    // Mathematica's ElementMesh[points, cells] and its kin hold several lists.
    const isNumeric = !list.isMixed && (count === 0 || list.lists.length === 0) && !/Mesh/.test(list.callee)
    const isEmpty = count === 0 && list.lists.length === 0
    if (isEmpty) {
      if (list.cutAt !== null) parent.cut()
      return
    }
    if (isNumeric && parent.parent !== null) parent.lists.push(list)
    else if (isNumeric) this.#lists.push(list)
    else for (const inner of list.lists) this.#lists.push(inner)
    parent.pending = ''
    if (parent.parent === null) {
      parent.lastWord = ''
      this.#promptWord = ''
    }
  }

  #wrapped(list: List, parent: List): void {
    if (parent.parent === null) return
    parent.values.push(list.values[0] as number)
    parent.areIntegers &&= list.areIntegers
    parent.digits = Math.max(parent.digits, list.digits)
  }
}
