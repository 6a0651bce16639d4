/**
 * Coordinates that code sets one by one, "c[0][2] = 0.5;", "x(1,3) = 0.5d0" and "x[0] = 0; y[0] = 0; z[0] = 0;", and vectors as R prints
 * them, whose lines begin with the number of their first entry.
 */
import { areDistinct, type NumberTable, numberTable, transposed } from './number-table'
import { Tokens } from './tokens'

const SUBSCRIPT = '\\s?[[(]\\s?\\d{1,9}(?:\\s?,\\s?\\d{1,9})?\\s?[\\])]'
const ASSIGNED = new RegExp(
  `(?<![\\w.\\])])([A-Za-z_]\\w{0,40})?((?:${SUBSCRIPT}){1,2})(\\.[xyz])?\\s{0,8}=\\s{0,8}([-+−]?[\\d.][^\\s,;)\\]}]{0,40})`,
  'g',
)
const FEWEST = 24

interface Entry {
  readonly at: readonly [number, number]
  readonly value: number
  readonly digits: number
}

export function tablesOfAssignments(text: string): NumberTable[] {
  const entries = new Map<string, Entry[]>()
  for (const [, name = '', subscripts = '', member, word = ''] of text.matchAll(ASSIGNED)) {
    const tokens = new Tokens(word)
    if (tokens.next() !== 'number') continue
    const places = (subscripts.match(/\d+/g) ?? []).map(Number)
    const axis = 'xyz'.indexOf(member?.[1] ?? (name.at(-1)?.toLowerCase() || '-'))
    const [first = 0, second] = places
    if (places.length > 2) continue
    // One subscript has an axis, that of a member or of the name's last letter; or it counts all coordinates.
    const key = second === undefined && member === undefined && axis >= 0 ? `${name.slice(0, -1)}*` : name
    const list = entries.get(key) ?? []
    list.push({ at: [first, second ?? Math.max(0, axis)], value: tokens.value, digits: tokens.digits })
    entries.set(key, list)
  }
  return [...entries].flatMap(([name, list]) => tableOfEntries(name, list) ?? [])
}

/** Null where an entry is missing or set twice, or where they are no points. */
function tableOfEntries(name: string, entries: readonly Entry[]): NumberTable | null {
  if (entries.length < FEWEST) return null
  const [firsts, seconds] = ([0, 1] as const).map(k =>
    [...new Set(entries.map(({ at }) => at[k]))].sort((a, b) => a - b),
  ) as [number[], number[]]
  if (firsts.length * seconds.length !== entries.length) return null
  if (seconds.length === 1) return countedTable(name, entries)
  if (seconds.length !== 3 && firsts.length !== 3) return null
  const [rowOf, columnOf] = [firsts, seconds].map(values => new Map(values.map((value, i) => [value, i]))) as [
    Map<number, number>,
    Map<number, number>,
  ]
  const rows = firsts.map(() => seconds.map(() => Number.NaN))
  const seen = new Set<number>()
  for (const { at, value } of entries) {
    const [row, column] = [rowOf.get(at[0]) as number, columnOf.get(at[1]) as number]
    seen.add(row * seconds.length + column)
    ;(rows[row] as number[])[column] = value
  }
  if (seen.size !== entries.length) return null
  return tableOf([name], seconds.length === 3 ? rows : transposed(rows), mostDigits(entries))
}

/** One coordinate after another: the subscripts count up. */
function countedTable(name: string, entries: readonly Entry[]): NumberTable | null {
  const first = entries[0]?.at[0] as number
  if (!entries.every(({ at }, i) => at[0] === first + i)) return null
  return tableOf([name], [entries.map(({ value }) => value)], mostDigits(entries))
}

function mostDigits(entries: readonly Entry[]): number {
  return entries.reduce((most, { digits }) => Math.max(most, digits), 0)
}

function tableOf(names: readonly string[], rows: number[][], digits: number): NumberTable {
  return numberTable(rows, false, { names, digits })
}

/** A node's place in its cell, where one is given, and its number. */
const SET_ID =
  /\b(?:SetId\(\s?(\d)\s?,|set_node\(\s?(\d)\s?(?:\)\s?=|,)\s?[\w.>-]{0,40}\(|(?:conn|cell|elem|hex|ids|nodes?\b|vertices)[\w[\].]{0,40}[[(](\d)[\])]\s?=|n(\d)\s?[=:]|InsertNextId\()\s?(\d{1,9})(?![\w.,])/gi

/** The nodes of cells that are set one by one: SetId(0, …) and InsertNextId(…) of VTK, libMesh's set_node, conn[0] = …, "N1=…". */
export function tablesOfSetIds(text: string): NumberTable[] {
  const rows: number[][] = []
  let first = 0
  for (const [, a, b, c, d, id] of text.matchAll(SET_ID)) {
    const given = a ?? b ?? c ?? d
    let row = rows.at(-1)
    const place = given === undefined ? (row?.length ?? 0) % 8 : Number(given)
    if (row === undefined || place === 0 || place !== row.length + first) {
      row = []
      rows.push(row)
      first = place
    }
    row.push(Number(id))
  }
  const whole = rows.filter(row => row.length === 8 && areDistinct(row))
  if (whole.length === 0) return []
  return [{ ...tableOf(['cells'], whole, 0), integers: whole[0]?.map(() => true) ?? [], base: first === 0 ? 0 : null }]
}

const VECTOR_LINE = /^[ \t]*\[(\d{1,9})\][ \t]+(?=[-+.\d])([^\n]*)$/gm

/** Lines "[1] 0 0 1" and "[4] 1 0 1", each of which counts the entries before it. */
export function tablesOfVectors(text: string): NumberTable[] {
  const tables: NumberTable[] = []
  let values: number[] = []
  let digits = 0
  const end = () => {
    if (values.length >= FEWEST) tables.push(tableOf([], [values], digits))
    values = []
    digits = 0
  }
  for (const [, start, rest = ''] of text.matchAll(VECTOR_LINE)) {
    const first = Number(start)
    if (first !== values.length + 1) end()
    if (first !== values.length + 1) continue
    const tokens = new Tokens(rest)
    while (tokens.next() === 'number') {
      values.push(tokens.value)
      digits = Math.max(digits, tokens.digits)
    }
  }
  end()
  return tables
}
