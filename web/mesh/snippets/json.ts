/** JSON: elements by their `vertices`, as `analyze` reads them, or points and cells under any names. */
import type { Mesh } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import { shown } from '../text-cursor'
import { meshOfTables } from './interpret'
import { inRowsOf, type NumberTable, numberTable, transposed } from './number-table'

const FORMAT = 'JSON'

/** Null if the text is no JSON, or has neither. */
export function meshOfJson(text: string, fileName: string): Mesh | null {
  if (!/^\s{0,1000}[[{]/.test(text.slice(0, 1001))) return null
  let value: unknown
  try {
    value = JSON.parse(text)
  } catch {
    return null
  }
  const found = search(value)
  // Mesh.to_dict of scikit-fem has these names.
  const isScikitFem = typeof value === 'object' && value !== null && 'p' in value && 't' in value
  const origin = { format: FORMAT, fileName, isScikitFem, hasOwnOrder: isScikitFem }
  return ownElements(found, fileName) ?? meshOfTables(found.tables, origin)
}

interface Found {
  readonly own: { readonly name: string; readonly vertices: unknown }[]
  readonly tables: NumberTable[]
}

/** Depth is on a list of what is still to be looked at, not on the stack. */
function search(whole: unknown): Found {
  const found: Found = { own: [], tables: [] }
  const waiting: { readonly value: unknown; readonly names: readonly string[] }[] = [{ value: whole, names: [] }]
  for (let entry = waiting.pop(); entry !== undefined; entry = waiting.pop()) {
    const { value, names } = entry
    if (Array.isArray(value)) {
      const rows = rowsOf(value)
      if (rows !== null) found.tables.push({ ...tableOf(rows, names), ids: idsOf(value) })
      else
        for (let i = value.length - 1; i >= 0; i--)
          if (typeof value[i] === 'object') waiting.push({ value: value[i], names })
    } else if (typeof value === 'object' && value !== null) {
      if (isOwn(value))
        found.own.push({
          name: typeof value.name === 'string' ? value.name : (names.at(-1) ?? ''),
          vertices: value.vertices,
        })
      else if (isNumbered(value))
        found.tables.push({ ...tableOf(Object.values(value), names), ids: Object.keys(value).map(Number) })
      else {
        for (const [key, inner] of Object.entries(value).reverse())
          if (typeof inner === 'object') waiting.push({ value: inner, names: [...names.slice(-6), key] })
      }
    }
  }
  return found
}

interface Own {
  readonly name?: unknown
  readonly vertices: unknown
}

/** An object whose `vertices` are those of one element, with nothing in it that names them. */
function isOwn(value: object): value is Own {
  if (!('vertices' in value) || !Array.isArray(value.vertices)) return false
  const isSmall = value.vertices.length <= 8 || value.vertices.length === 24
  return isSmall && !Object.entries(value).some(([key, inner]) => CELLS.test(key) && mayBeCells(inner))
}

const CELLS = /cell|elem|face|conn|hex|index|indic/i

/** Eight whole numbers, in lists of lists or not. */
function mayBeCells(value: unknown): boolean {
  return Array.isArray(value) && value.flat().filter(Number.isInteger).length >= 8
}

/** Rows of numbers at any depth of lists; objects with x, y and z are rows as well. */
function rowsOf(list: readonly unknown[]): number[][] | null {
  if (list.length === 0) return null
  if (list.every(isNumber)) return [list as number[]]
  const rows: number[][] = []
  for (const entry of list) {
    if (Array.isArray(entry) && entry.length > 0 && entry.every(isNumber)) rows.push(entry)
    else if (
      Array.isArray(entry) &&
      entry.length > 0 &&
      entry.every(inner => Array.isArray(inner) && inner.length > 0 && inner.every(isNumber))
    ) {
      for (const row of entry as number[][]) rows.push(row)
    } else if (isPoint(entry)) rows.push([entry.x, entry.y, entry.z])
    else {
      const nodes = nodesOf(entry)
      if (nodes === null) return null
      rows.push(nodes)
    }
  }
  return rows
}

function isNumber(value: unknown): value is number {
  return typeof value === 'number'
}

/** An object whose keys are numbers of points or cells: {"1": [0, 0, 0], "2": [1, 0, 0]}. */
function isNumbered(value: object): value is Record<string, number[]> {
  const entries = Object.entries(value)
  return (
    entries.length > 0 &&
    entries.every(([key, row]) => /^\d{1,15}$/.test(key) && Array.isArray(row) && row.length > 0 && row.every(isNumber))
  )
}

/** The ids of a list of objects, null where not every one has its own. */
function idsOf(list: readonly unknown[]): number[] | null {
  const ids = list.map(entry =>
    typeof entry === 'object' && entry !== null && 'id' in entry ? Number(entry.id) : Number.NaN,
  )
  return ids.every(id => Number.isInteger(id)) && new Set(ids).size === ids.length ? ids : null
}

/** The nodes of an object that is a cell, or the coordinates of one that is a point: the only list in it. */
function nodesOf(value: unknown): number[] | null {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return null
  const [nodes, ...others] = Object.entries(value).filter(([, inner]) => Array.isArray(inner))
  if (nodes === undefined || others.length > 0 || !/node|conn|vert|ids|coord|pos|point|xyz/i.test(nodes[0])) return null
  const list = nodes[1] as unknown[]
  // The 24 coordinates of an element, as `analyze` reads them, are no nodes, even where all are whole numbers.
  if (nodes[0] === 'vertices' && list.length === 24) return null
  return list.every(list.length === 3 ? isNumber : Number.isInteger) && list.length >= 3 ? (list as number[]) : null
}

function isPoint(value: unknown): value is { x: number; y: number; z: number } {
  return (
    typeof value === 'object' &&
    value !== null &&
    'x' in value &&
    'y' in value &&
    'z' in value &&
    [value.x, value.y, value.z].every(isNumber)
  )
}

function tableOf(rows: number[][], names: readonly string[]): NumberTable {
  const width = rows.reduce((most, row) => Math.max(most, row.length), 0)
  const integers = Array.from({ length: width }, (_, c) =>
    rows.every(row => row[c] === undefined || Number.isInteger(row[c])),
  )
  return numberTable(rows, false, { names, integers, base: 0 })
}

/** The list that `analyze` reads: its order is this project's own. Null if there is none. */
function ownElements({ own }: Found, fileName: string): Mesh | null {
  if (own.length === 0) return null
  const builder = new MeshBuilder(FORMAT, fileName)
  for (const [i, { name, vertices }] of own.entries()) {
    const points = pointsOf(vertices)
    if (points === null)
      return builder.refuse(
        `the vertices of entry ${i}${name === '' ? '' : ` (${shown(name)})`} are not 24 numbers, nor eight lists of three.`,
      )
    const first = builder.pointCount
    for (const [x, y, z] of points) builder.point(x as number, y as number, z as number)
    builder.hexahedron(
      [0, 1, 2, 3, 4, 5, 6, 7].map(v => first + v),
      name === '' ? null : name,
    )
  }
  return builder.mesh()
}

function pointsOf(vertices: unknown): number[][] | null {
  // JSON has no -0, which the state of an element therefore writes as a text.
  const rows = Array.isArray(vertices) ? rowsOf(vertices.map(value => (value === '-0' ? -0 : value))) : null
  if (rows === null) return null
  if (rows.length === 1 && rows[0]?.length === 24) return inRowsOf(rows[0], 3)
  if (rows.length === 8 && rows.every(row => row.length === 3)) return rows
  return rows.length === 3 && rows.every(row => row.length === 8) ? transposed(rows) : null
}
