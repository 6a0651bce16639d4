/**
 * Lists of numbers in brackets, as languages write and print them: Python, NumPy, C, JavaScript, Julia, MATLAB, R, Mathematica; and lists
 * without brackets behind a name. The brackets are a stack; each list is handed on once.
 */
import type { NumberTable } from './number-table'
import { inRowsOf, transposed } from './number-table'
import { Tokens } from './tokens'

const [OPENING, CLOSING] = ['([{', ')]}']
/** Lists of numbers are not nested as deep; brackets that are count for nothing. */
const DEEPEST = 100
/** Characters behind a list in which a change of its shape is looked for. */
const BEHIND = 160

class List {
  readonly values: number[] = []
  readonly lists: List[] = []
  /** The count of values, or lists, before each end of a row. */
  readonly breaks: number[] = []
  hasCommas = false
  hasSemicolons = false
  /** True if its numbers follow C++'s <<. */
  isStreamed = false
  /** True if words or strings stand in it. */
  isMixed = false
  areIntegers = true
  digits = 0
  /** The counts of values and lists before "..."; null if nothing is left out. */
  cutAt: { readonly values: number; readonly lists: number } | null = null
  /** The last word or string in it, which may name what follows. */
  lastWord = ''
  pending = ''
  /** The index behind its closing bracket. */
  end = 0
  readonly depth: number
  constructor(
    readonly opener: string,
    readonly callee: string,
    readonly names: readonly string[],
    readonly from: number,
    readonly parent: List | null,
  ) {
    this.depth = parent === null ? 0 : parent.depth + 1
  }
}

/** The tables that the lists of a text are, in its order. */
export function tablesOfLists(text: string): NumberTable[] {
  const reader = new ListReader(text)
  return reader.read()
}

class ListReader {
  readonly #text: string
  readonly #tokens: Tokens
  readonly #tables: NumberTable[] = []
  readonly #isOneBased: boolean
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
  readonly #hasPrompts: boolean
  /** True if Eigen's matrices in it have three rows. */
  readonly #hasThreeRows: boolean

  constructor(text: string) {
    this.#text = text
    this.#tokens = new Tokens(text, 0, true)
    this.#hasPrompts = text.includes('>>>')
    this.#hasThreeRows = /\bMatrix(?:<\s?\w+\s?,\s?3\s?,\s?(?!3\b)|3X[df]\b)/.test(text.slice(0, 20_000))
    this.#isOneBased =
      /\b(?:Float64|Matrix\{|julia|msh\.|using Ferrite)|^[ \t]*\w{1,60}[ \t]*=[ \t]*\[[^[\]\n]{0,200};/m.test(
        text.slice(0, 20_000),
      )
  }

  read(): NumberTable[] {
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
      this.#list.cutAt ??= { values: this.#list.values.length, lists: this.#list.lists.length }
      this.#close(this.#text.length)
    }
    return this.#tables
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
    this.#endPlain()
    this.#list.lastWord = word
    this.#word = word
    this.#isString = true
    if (this.#list.parent !== null) this.#list.isMixed = true
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
    } else if (list.parent !== null) list.cutAt ??= { values: list.values.length, lists: list.lists.length }
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
    const isNumeric = !list.isMixed && (count === 0 || list.lists.length === 0)
    const isEmpty = count === 0 && list.lists.length === 0
    if (isEmpty) {
      if (list.cutAt !== null) parent.cutAt ??= { values: parent.values.length, lists: parent.lists.length }
      return
    }
    if (isNumeric && parent.parent !== null) parent.lists.push(list)
    else if (isNumeric) this.#hand(list)
    else for (const inner of list.lists) this.#hand(inner)
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

  #hand(list: List): void {
    const { rows, isCut, areIntegers, digits } = rowsOf(list)
    // One number is neither a point nor a cell.
    if (rows.length === 0 || (rows.length === 1 && (rows[0] as readonly number[]).length < 2)) return
    const shaped = this.#shaped(rows, list)
    const width = shaped.reduce((most, row) => Math.max(most, row.length), 0)
    this.#tables.push({
      names: list.callee === '' ? list.names : [...list.names, list.callee],
      rows: shaped,
      integers: Array.from({ length: width }, () => areIntegers),
      header: null,
      labels: null,
      ids: null,
      isCut,
      digits,
      base: this.#isOneBased || list.hasSemicolons ? 1 : 0,
    })
  }

  /** A list of 24 that the code around it makes a matrix of: row by row, or column by column. */
  #shaped(rows: number[][], list: List): number[][] {
    const [values, shape] = rows as [number[], number[]?]
    if (rows.length === 2 && shape?.length === 2 && (shape[0] as number) * (shape[1] as number) === values.length) {
      // NumPy's function goes by rows, that of Fortran by columns.
      const isByRows = /\.reshape$/.test(list.callee)
      return shape[isByRows ? 0 : 1] === 3 ? inRowsOf(values, values.length / 3) : [values]
    }
    if (rows.length !== 1) return rows
    if (list.isStreamed && this.#hasThreeRows) return inRowsOf(values, values.length / 3)
    const behind = this.#text.slice(list.end, list.end + BEHIND)
    const method = /^[^\n]{0,60}?\.reshape\s*\(\s*[([]?\s*(-?\d{1,9})\s*,\s*(-?\d{1,9})([^\n]{0,40})/.exec(behind)
    if (method !== null) {
      const isByColumns = /order\s*=\s*['"]F/.test(method[3] as string)
      if (!isByColumns && Number(method[1]) === 3) return inRowsOf(values, values.length / 3)
      if (isByColumns && Number(method[2]) === 3) return transposed(inRowsOf(values, values.length / 3))
      return rows
    }
    const callee = list.parent?.callee ?? ''
    // NumPy's function goes by rows, those of Julia, MATLAB and Fortran go by columns.
    if (/\.reshape$/.test(callee) && /^[^\d\n]{0,20}3\s*,/.test(behind)) return inRowsOf(values, values.length / 3)
    if (callee === 'reshape' || callee === 'matrix') {
      const around = `${this.#text.slice(Math.max(list.from - 40, list.parent?.from ?? 0), list.from)} ${behind}`
      const isByRows = /byrow\s*=\s*T/.test(around)
      const columns =
        /ncol\s*=\s*(\d{1,9})/.exec(around)?.[1] ??
        /^[^\d\n]{0,20}(?:nrow\s*=\s*)?\d{1,9}\D{1,6}(\d{1,9})/.exec(behind)?.[1]
      const isThreeWide = columns === '3' || (columns === undefined && /nrow\s*=\s*8/.test(around))
      if (isByRows) return isThreeWide ? rows : inRowsOf(values, values.length / 3)
      if (isThreeWide) return inRowsOf(values, values.length / 3)
    }
    return rows
  }
}

/** The innermost lists one after another, up to where something is left out. */
function rowsOf(list: List): { rows: number[][]; isCut: boolean; areIntegers: boolean; digits: number } {
  const rows: number[][] = []
  let isCut = false
  let areIntegers = true
  let digits = 0
  const waiting: { readonly list: List; next: number }[] = [{ list, next: 0 }]
  while (waiting.length > 0 && !isCut) {
    const top = waiting[waiting.length - 1] as { readonly list: List; next: number }
    const { list: inner } = top
    if (inner.lists.length === 0) {
      const values = inner.cutAt === null ? inner.values : inner.values.slice(0, inner.cutAt.values)
      const parts = isBrokenWhereFull(inner) ? [values] : splitAt(values, inner.breaks)
      // A row that was left in the middle is no row.
      if (inner.cutAt !== null && inner.parent?.opener !== '' && parts.length > 0 && inner.opener !== '=') parts.pop()
      for (const part of parts) rows.push(part)
      areIntegers &&= inner.areIntegers
      digits = Math.max(digits, inner.digits)
      isCut = inner.cutAt !== null
      waiting.pop()
    } else if (top.next >= (inner.cutAt?.lists ?? inner.lists.length)) {
      isCut = inner.cutAt !== null
      waiting.pop()
    } else waiting.push({ list: inner.lists[top.next++] as List, next: 0 })
  }
  return { rows, isCut, areIntegers, digits }
}

function splitAt(values: number[], breaks: readonly number[]): number[][] {
  if (breaks.length === 0) return values.length > 0 ? [values] : []
  const rows: number[][] = []
  let from = 0
  for (const to of [...breaks, values.length]) {
    if (to > from) rows.push(values.slice(from, to))
    from = Math.max(from, to)
  }
  return rows
}

/** True if NumPy broke a list where lines were full: a matrix has rows of other lengths. */
function isBrokenWhereFull({ values, breaks, areIntegers, hasSemicolons }: List): boolean {
  const [width = 0] = breaks
  if (width === 0 || hasSemicolons || values.length % 24 > 0) return false
  const rows = Math.ceil(values.length / width)
  const isEven = breaks.every((end, i) => end === width * (i + 1)) && values.length === width * rows
  return !isEven || (!areIntegers && width > 5 && width !== 8 && width % 24 > 1)
}
