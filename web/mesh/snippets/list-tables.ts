/** Tables from lists in brackets: rows from lists in a list, from ends of lines or semicolons, or from what the code around makes of them. */
import { inRowsOf, type NumberTable, numberTable, transposed } from './number-table'

/** Characters behind a list in which a change of its shape is looked for. */
const BEHIND = 160
/** Characters of a text that show its language. */
const HEAD = 20_000

/** A list of numbers, or of lists, as it stands in a text. */
export class List {
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

  /** Notes that something is left out here. */
  cut(): void {
    this.cutAt ??= { values: this.values.length, lists: this.lists.length }
  }
}

/** Habits of the language that a text is written in. */
export interface Language {
  readonly isOneBased: boolean
  /** True if Eigen's matrices in it have three rows. */
  readonly hasThreeRows: boolean
}

export function languageOf(text: string): Language {
  const head = text.slice(0, HEAD)
  return {
    isOneBased: /\b(?:Float64|Matrix\{|julia|msh\.|using Ferrite)|^[ \t]*\w{1,60}[ \t]*=[ \t]*\[[^[\]\n]{0,200};/m.test(
      head,
    ),
    hasThreeRows: /\bMatrix(?:<\s?\w+\s?,\s?3\s?,\s?(?!3\b)|3X[df]\b)/.test(head),
  }
}

/** The table that a list is; null if it is no more than a number. */
export function tableOf(list: List, text: string, { isOneBased, hasThreeRows }: Language): NumberTable | null {
  const { rows, isCut, areIntegers, digits } = rowsOf(list)
  // One number is neither a point nor a cell.
  if (rows.length === 0 || (rows.length === 1 && (rows[0] as readonly number[]).length < 2)) return null
  return numberTable(shaped(rows, list, text, hasThreeRows), areIntegers, {
    names: list.callee === '' ? list.names : [...list.names, list.callee],
    isCut,
    digits,
    base: isOneBased || list.hasSemicolons ? 1 : 0,
  })
}

/** A list of 24 that the code around it makes a matrix of: row by row, or column by column. */
function shaped(rows: number[][], list: List, text: string, hasThreeRows: boolean): number[][] {
  const [values, shape] = rows as [number[], number[]?]
  if (rows.length === 2 && shape?.length === 2 && (shape[0] as number) * (shape[1] as number) === values.length) {
    // NumPy's function goes by rows, that of Fortran by columns.
    const isByRows = /\.reshape$/.test(list.callee)
    return shape[isByRows ? 0 : 1] === 3 ? inRowsOf(values, values.length / 3) : [values]
  }
  if (rows.length !== 1) return rows
  if (list.isStreamed && hasThreeRows) return inRowsOf(values, values.length / 3)
  const behind = text.slice(list.end, list.end + BEHIND)
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
    const around = `${text.slice(Math.max(list.from - 40, list.parent?.from ?? 0), list.from)} ${behind}`
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
