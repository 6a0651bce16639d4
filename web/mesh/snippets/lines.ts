/**
 * Numbers on lines that are written alike: tables, logs, CSV, LaTeX, what programs print of an element's points. Lines that differ in
 * their numbers alone belong together, wherever they stand in the text.
 */

import type { NumberTable } from './number-table'
import { areComponents, titledColumns } from './point-set'
import { NO_POINT_NAME } from './table-names'
import { Tokens } from './tokens'

/** Dates and times are no coordinates. */
const DATE_OR_TIME = /(?<![\w.])(?:\d{4}-\d\d-\d\d|\d\d?:\d\d(?::\d\d(?:\.\d{1,9})?)?)(?![\w.:])/g
const ELEMENT = /\b(?:element|elem|cell|hexahedron|hexahedra|hex|brick)s?\b[\s#:=.(no]{0,12}(\d{1,15})\b/i
const RANK = /\b(?:rank|proc|processor|process|task|pe)\b[\s#:=(]{0,12}(\d{1,9})\b/i
/** A line in whose place others stood. */
const LEFT_OUT =
  /^[\s>|#/*%-]*[[(<{]?\s*(?:\.{3,}|…|⋮|:\s*:|snip(?:ped)?|\.\.\.\s*snip\s*\.\.\.|\\vdots[^\n]*|(?:\.\.\.|…).{0,60}(?:more|omitted|truncated|lines|skipped).{0,40})\s*[\])>}]?[\s,;&\\]*$/i
/** Characters of a line that are searched for words; all its numbers are read. */
const LONGEST_SKELETON = 400
/** Runs of a line that are told apart by their place on it. */
const MOST_PLACES = 64

/** A line that is nothing but a title: "Vertices", "cells:", "begin elements". */
const HEADING = /^[^\w\n]{0,4}\w{1,30}(?:[ _]\w{1,30})?\s{0,4}[:=]?(?:\s{1,8}\d{1,12})?$/
const POINT_WORD = /node|vert|point|pt|grid|corner|^id$|^p$|^v$|^n$/i

/** A comma behind a number at the end of a line, or Nastran's mark for the next one. */
const GOES_ON = /\d\s{0,9},\s{0,9}(?:\+\w{0,7})?\s{0,9}$/

/** Marks between the numbers of a run: of CSV, tables, LaTeX, box drawing. */
const BETWEEN = ',;|&"$│┆┃║，、'
/** Units of length behind each number. */
const UNIT = /^(?:[cmkµn]?m|inch|ft)$/
/** Characters that end all lines of a list but the last, or the last alone. */
const END_MARKS = /[\\)\]}/.'│┃║]+$/

interface Run {
  readonly values: number[]
  readonly integers: boolean[]
  /** The word before it on its line. */
  readonly word: string
  /** A number that stands alone before it, behind a word for a point; else null. */
  readonly id: number | null
}

interface Line {
  readonly number: number
  readonly runs: readonly Run[]
  /** The line without its numbers: lines that are written alike have the same. */
  readonly skeleton: string
  readonly words: readonly string[]
  readonly digits: number
  /** True if it ends with a comma behind a number, so that the next one may go on with it. */
  readonly isOpen: boolean
}

class Group {
  readonly rows: number[][] = []
  readonly labels: (string | null)[] = []
  readonly ids: (number | null)[] = []
  readonly lines: number[] = []
  integers: boolean[]
  digits = 0
  isCut = false
  constructor(
    readonly names: readonly string[],
    readonly header: readonly string[] | null,
    run: Run,
  ) {
    this.integers = [...run.integers]
  }
  /** A row that goes on; rows of a group then differ in length only if the text is cut. */
  goOn(run: Run): void {
    for (const value of run.values) this.rows.at(-1)?.push(value)
    while (this.integers.length < (this.rows.at(-1)?.length ?? 0)) this.integers.push(true)
  }
  add(run: Run, label: string | null, line: Line): void {
    this.rows.push(run.values)
    this.labels.push(label)
    this.ids.push(run.id)
    this.lines.push(line.number)
    this.digits = Math.max(this.digits, line.digits)
    this.integers = this.integers.map((isInteger, c) => isInteger && run.integers[c] !== false)
  }
}

/** True if a line of integers goes on with those of the line before, which ends with a comma. */
function goesOn(before: Line, line: Line): boolean {
  const [run, ...others] = line.runs
  const [first] = before.runs
  if (!before.isOpen || before.runs.length !== 1 || run === undefined || first === undefined || others.length > 0)
    return false
  const isBare = line.skeleton === '#' || line.skeleton === '+#'
  return (
    isBare && run.values.length < first.values.length && run.integers.every(Boolean) && first.integers.every(Boolean)
  )
}

export interface TextLines {
  readonly tables: readonly NumberTable[]
  /** A sentence where the points of several elements or processes are mixed, so that none is certain. */
  readonly mixed: string | null
  /** Counts of numbers and of runs of three, for the sentence that says what was seen. */
  readonly numbers: number
  readonly points: number
}

/** The tables that the lines of a text are, in the order of their first lines. */
export function tablesOfLines(text: string): TextLines {
  const groups = new Map<string, Group>()
  const order: Group[] = []
  const mentions: Mention[] = []
  let label: string | null = null
  let cuts = 0
  let [numbers, points] = [0, 0]
  let before: Line | null = null
  let last: Group | null = null
  let heading: readonly string[] = []
  /** The last titles of columns that say what these are. */
  let columns = ''
  for (const line of linesOf(text)) {
    const words = line.raw
    const short = words.slice(0, LONGEST_SKELETON)
    if (LEFT_OUT.test(short) && words.length < LONGEST_SKELETON) {
      cuts++
      for (const group of order) group.isCut = true
      continue
    }
    const element = ELEMENT.exec(short)?.[1]
    const rank = RANK.exec(short)?.[1]
    const read = readLine(words, line.number)
    if (before !== null && goesOn(before, read) && last !== null) {
      last.goOn(read.runs[0] as Run)
      before = read
      continue
    }
    last = null
    numbers += read.runs.reduce((sum, { values }) => sum + values.length, 0)
    if (read.runs.length === 0 || read.runs.every(({ values }) => values.length < 3)) {
      if (element !== undefined) label = element
      if (element !== undefined || rank !== undefined) mentions.push({ line: line.number, element, rank })
      if (words.trim() !== '') {
        before = read
        if (read.words.length > 0) heading = HEADING.test(short.trim()) ? read.words : []
      }
      continue
    }
    if (element !== undefined) label = element
    const long = read.runs.filter(({ values }) => values.length >= 3).length
    const all = (long > 1 && long % 8 === 0) || long > MOST_PLACES
    for (const [i, run] of read.runs.entries()) {
      if (run.values.length === 3 || run.values.length === 4) points++
      if (run.values.length < 3) continue
      const title = isNoPointTitle(heading) ? heading.join(' ') : ''
      const titles = read.runs.length === 1 ? headerOf(before, run.values.length) : null
      if (titles !== null && (titledColumns(titles) !== null || areComponents(titles))) columns = titles.join(' ')
      const key = `${cuts} ${run.values.length} ${all ? '' : i} ${read.skeleton} ${title} ${columns}`
      let group = groups.get(key)
      if (group === undefined) {
        group = new Group([...heading, ...(run.word === '' ? [] : [run.word])], titles, run)
        groups.set(key, group)
        order.push(group)
      }
      group.add(run, label, read)
      last = group
    }
    before = read
  }
  const firstAfterCut = cuts > 0 ? order.filter(group => !group.isCut) : []
  const tables = order
    .filter(
      (group, i) =>
        !(firstAfterCut.includes(group) && isContinuation(group, order)) && !areColumnNumbers(group, order[i + 1]),
    )
    .map(tableOf)
  return { tables, mixed: mixture(order, mentions), numbers, points }
}

/** True for the numbers 0, 1, 2 over columns whose rows are numbered, too, as pandas prints a table without titles. */
function areColumnNumbers({ rows, lines }: Group, below: Group | undefined): boolean {
  const [titles = []] = rows
  return (
    rows.length === 1 &&
    titles.every((title, c) => title === c) &&
    below?.lines[0] === (lines[0] as number) + 1 &&
    below.rows[0]?.length === titles.length + 1
  )
}

/** True if a group goes on, after a gap, with the lines of one before it. */
function isContinuation(group: Group, order: readonly Group[]): boolean {
  return order.some(
    other =>
      other !== group && other.isCut && other.rows[0]?.length === group.rows[0]?.length && sameNames(other, group),
  )
}

function sameNames(a: Group, b: Group): boolean {
  return a.names.join(' ') === b.names.join(' ')
}

function tableOf(group: Group): NumberTable {
  return {
    names: group.names,
    rows: group.rows,
    integers: group.integers,
    header: group.header,
    labels: group.labels,
    ids: group.ids.includes(null) ? null : (group.ids as number[]),
    isCut: group.isCut,
    digits: group.digits,
    base: null,
  }
}

interface Mention {
  readonly line: number
  readonly element: string | undefined
  readonly rank: string | undefined
}

/** Two ranks, or two elements, that are named one after the other before their points: which points are whose is not certain. */
function mixture(groups: readonly Group[], mentions: readonly Mention[]): string | null {
  for (const { rows, lines } of groups) {
    if (rows.length < 8 || rows[0]?.length !== 3) continue
    const first = lines[0] as number
    for (const what of ['rank', 'element'] as const) {
      const named = mentions.filter(mention => mention[what] !== undefined)
      const before = new Set(named.filter(({ line }) => line < first).map(mention => mention[what]))
      if (named.length < 2 || (what === 'element' && rows.length === 8)) continue
      const between = named.filter(({ line }) => line > first)
      if (before.size > 1 && between.length < Math.max(rows.length / 8 - 1, 0.5)) {
        const kind = what === 'rank' ? 'processes' : 'elements'
        return `two or more ${kind} are named before ${rows.length} points, whose lines may be mixed: which points are whose is not certain.`
      }
    }
  }
  return null
}

/** Under "Jacobian:" and its kin stand no points, however they are written. */
function isNoPointTitle(heading: readonly string[]): boolean {
  return heading.some(word => NO_POINT_NAME.test(word))
}

function headerOf(line: Line | null, count: number): readonly string[] | null {
  if (line === null || line.runs.some(({ values }) => values.length > 2)) return null
  const titles = line.words
  if (titles.length === count) return titles
  // The rows' numbers, which stand before them without a title.
  return titles.length === count - 1 && titledColumns(titles) !== null ? ['#', ...titles] : null
}

function* linesOf(text: string): Generator<{ readonly raw: string; readonly number: number }> {
  let number = 1
  for (let at = 0; at < text.length; number++) {
    const found = text.indexOf('\n', at)
    const end = found < 0 ? text.length : found
    yield { raw: text.slice(at, end), number }
    at = end + 1
  }
}

/** Numbers with nothing but blanks, commas, semicolons, bars and ampersands between them are a run. */
function readLine(raw: string, number: number): Line {
  const text = raw.length < 10_000 ? raw.replace(DATE_OR_TIME, '@') : raw
  const tokens = new Tokens(text)
  const runs: { values: number[]; integers: boolean[]; word: string; id: number | null }[] = []
  let id: number | null = null
  let skeleton = ''
  let isOpen = false
  let word = ''
  let digits = 0
  const axes: string[] = []
  const valued: number[] = []
  for (let kind = tokens.next(); kind !== 'end'; kind = tokens.next()) {
    const at = tokens.from
    if (kind === 'number') {
      const run = isOpen ? runs.at(-1) : undefined
      if (run === undefined) {
        const last = runs.at(-1)
        if (last !== undefined && last.values.length === 1 && last.integers[0] && POINT_WORD.test(last.word))
          id = last.values[0] as number
        runs.push({ values: [tokens.value], integers: [tokens.isInteger], word, id })
      } else {
        run.values.push(tokens.value)
        run.integers.push(tokens.isInteger)
      }
      digits = Math.max(digits, tokens.digits)
      isOpen = true
      if (axes.length > valued.length) valued.push(tokens.value)
      if (skeleton.length < LONGEST_SKELETON) skeleton += skeleton.endsWith('#') ? '' : '#'
      continue
    }
    const token = text.slice(at, Math.min(tokens.to, at + 60))
    if (kind === 'word') {
      word = token
      if (/^[xyz]\d?$/i.test(token)) axes.push(token[0] as string)
    }
    const isBetween = kind === 'word' ? isOpen && UNIT.test(token) : BETWEEN.includes(token)
    if (!isBetween) {
      isOpen = false
      if (skeleton.length < LONGEST_SKELETON)
        skeleton += kind === 'word' ? ` ${token.replace(/\d+|^[A-H]$/g, '#')}` : token
    }
  }
  const labelled = labelledPoints(text, axes.length, runs)
  return {
    number,
    runs: labelled ?? runs,
    skeleton: (labelled === null ? skeleton : skeleton.replace(/#/g, '')).replace(END_MARKS, ''),
    words: wordsOf(raw),
    digits,
    isOpen: GOES_ON.test(raw.slice(-30)),
  }
}

/** The titles on a line: between commas, semicolons or tabs if there are any, else its words. */
function wordsOf(raw: string): string[] {
  if (raw.length > LONGEST_SKELETON) return []
  const line = raw.trim()
  const separator = line.includes(',')
    ? ','
    : line.includes(';')
      ? ';'
      : line.includes('\t')
        ? '\t'
        : line.includes('&')
          ? '&'
          : null
  const parts = separator === null ? line.split(/\s+/) : line.split(separator)
  return parts.map(part => part.replace(/["'$\\]/g, '').trim()).filter(part => /[A-Za-z]/.test(part))
}

const LABELLED =
  /(?<![A-Za-z])["']?x\d{0,4}["']?\s{0,8}[=:]\s{0,8}([^\s,;]{1,40})[\s,;]{1,8}["']?y\d{0,4}["']?\s{0,8}[=:]\s{0,8}([^\s,;]{1,40})[\s,;]{1,8}["']?z\d{0,4}["']?\s{0,8}[=:]\s{0,8}([^\s,;)\]}]{1,40})/gi

/** "x= 1 y= 2 z= 3"; null where a line has none. */
function labelledPoints(text: string, axes: number, runs: readonly Run[]): Run[] | null {
  if (axes < 3) return null
  const found: Run[] = []
  for (const match of text.matchAll(LABELLED)) {
    const values: number[] = []
    for (const word of match.slice(1, 4)) {
      const tokens = new Tokens(word)
      if (tokens.next() === 'number') values.push(tokens.value)
    }
    if (values.length === 3)
      found.push({
        values,
        integers: [false, false, false],
        word: '',
        id: runs[0]?.values.length === 1 && POINT_WORD.test(runs[0].word) ? (runs[0].values[0] as number) : null,
      })
  }
  return found.length > 0 ? found : null
}

/** Marks around numbers with decimal commas, and names of points. */
const AROUND_DECIMALS = /[\s;|&"'()[\]{}:=]+|\b[A-Za-z]\w{0,40}/
/** Dots stand between thousands only where a comma follows. */
const WITH_COMMA = /^[-+−]?(?:\d{1,20}(?:,\d{1,20})?|\d{1,3}(?:\.\d{3}){1,5},\d{1,20})(?:[eE][-+]?\d{1,4})?,?$/

/** The text without commas between thousands, if all its numbers may have them and one has: 1,234.5. */
export function withoutThousands(text: string): string | null {
  if (!/\d,\d{3}\./.test(text) || text.length > 1_000_000) return null
  const words = text.split(/[\s;|&"]+/).filter(word => /\d/.test(word))
  if (!words.every(word => /^[-+−]?(?:\d{1,20}|\d{1,3}(?:,\d{3}){1,6})(?:\.\d*)?(?:[eE][-+]?\d{1,4})?,?$/.test(word)))
    return null
  return text.replace(/(?<=\d),(?=\d{3})/g, '')
}

/** The text with decimal points, if its numbers have decimal commas: eight of them at least; else null. */
export function withDecimalPoints(text: string): string | null {
  if (!text.includes(',') || text.length > 1_000_000) return null
  let fractions = 0
  for (const { raw } of linesOf(text)) {
    for (const word of raw.split(AROUND_DECIMALS)) {
      if (!/\d/.test(word)) continue
      if (!WITH_COMMA.test(word)) return null
      if (/,\d/.test(word)) fractions++
    }
  }
  if (fractions < 8) return null
  return text.replace(/\.(?=\d{3}[.,])/g, '').replace(/(?<=\d),(?=\d)/g, '.')
}
