/**
 * The text that ncdump prints of an Exodus file: after "data:" lists of numbers behind names, with commas between and a semicolon at the
 * end. `coordx`, `coordy`, `coordz` are the points, or `coord` one after the other; `connectN` the nodes of block N's cells, from 1.
 */
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { headText, snippetText } from '../snippet-text'
import { Tokens } from '../snippets/tokens'
import type { MeshFormat } from '../source'

const OTHER: readonly (readonly [RegExp, OtherCell])[] = [
  [/^TET/i, 'tetrahedron'],
  [/^(?:WEDGE|PRISM)/i, 'wedge'],
  [/^PYR/i, 'pyramid'],
  [/^(?:QUAD|SHELL)/i, 'quadrilateral'],
  [/^TRI/i, 'triangle'],
  [/^(?:BAR|BEAM|TRUSS|EDGE)/i, 'line'],
]

export const ncdump: MeshFormat = {
  name: 'ncdump',
  recognizes: head => {
    const text = headText(head)
    return /^\s{0,100}netcdf\s[^{\n]{0,500}\{/m.test(text.slice(0, 2000)) && /\bconnect\d+\b|\bcoord[xyz]?\b/.test(text)
      ? 'yes'
      : 'no'
  },
  read(file) {
    const builder = new MeshBuilder('ncdump', file.name)
    const text = snippetText(file) ?? ''
    const data = /^[ \t]*data:/m.exec(text)
    if (data === null)
      return builder.refuse('this is the header of a netCDF file alone: ncdump prints the numbers without -h.')
    const lists = listsOf(text, data.index + data[0].length)
    const points = pointsOf(lists, builder)
    for (const [x, y, z] of points) builder.point(x, y, z)
    const ids = lists.get('elem_num_map') ?? lists.get('elem_map')
    if (ids?.some(id => !Number.isInteger(id))) builder.refuse('the numbers of its elements are no whole numbers.')
    let element = 0
    for (const [name, nodes] of lists) {
      const block = /^connect(\d{1,6})$/.exec(name)?.[1]
      if (block === undefined) continue
      const type = new RegExp(String.raw`\bconnect${block}:elem_type\s{0,9}=\s{0,9}"(\w{1,40})"`).exec(text)?.[1] ?? ''
      const size = sizeOf(text, block) ?? (Number(/\d+$/.exec(type)?.[0]) || (/^HEX/i.test(type) ? 8 : 0))
      if (size === 0 || nodes.length % size !== 0)
        builder.refuse(`the ${nodes.length} numbers of ${name} are no cells of ${size} nodes.`)
      for (let at = 0; at < nodes.length; at += size, element++) {
        const corners = nodes.slice(at, at + 8).map(node => {
          if (!Number.isInteger(node) || node < 1 || node > points.length) {
            // Gaps and infinities of the file have no name in a sentence.
            const what = Number.isInteger(node) ? `node ${node}` : 'what is no whole number'
            builder.refuse(
              `element ${ids?.[element] ?? element + 1} names ${what}; the nodes are 1 to ${points.length}.`,
            )
          }
          return node - 1
        })
        if (!/^HEX/i.test(type)) builder.otherCell(OTHER.find(([pattern]) => pattern.test(type))?.[1] ?? 'other')
        else if (size === 8)
          builder.inBlock(`block ${block}`, builder.hexahedron(corners, ids?.[element] ?? element + 1))
        else builder.notTrilinear(corners)
      }
    }
    return [builder.mesh()]
  },
}

function sizeOf(text: string, block: string): number | null {
  const size = new RegExp(String.raw`\bnum_nod_per_el${block}\s{0,9}=\s{0,9}(\d{1,4})\b`).exec(text)?.[1]
  return size === undefined ? null : Number(size)
}

function listsOf(text: string, from: number): Map<string, number[]> {
  const lists = new Map<string, number[]>()
  const tokens = new Tokens(text, from)
  let word = ''
  let list: number[] | null = null
  for (let kind = tokens.next(); kind !== 'end'; kind = tokens.next()) {
    if (kind === 'number') list?.push(tokens.value)
    else if (kind === 'word') {
      if (list === null) word = tokens.word
      else if (tokens.word === '_') list.push(Number.NaN)
    } else if (tokens.word === '=') {
      list = []
      lists.set(word, list)
    } else if (tokens.word === ';') list = null
  }
  return lists
}

function pointsOf(lists: ReadonlyMap<string, readonly number[]>, builder: MeshBuilder): [number, number, number][] {
  const whole = lists.get('coord')
  const count = (whole?.length ?? 0) / 3
  const axes = ['x', 'y', 'z'].map((axis, a) => lists.get(`coord${axis}`) ?? whole?.slice(a * count, (a + 1) * count))
  const [x, y, z] = axes
  if (x === undefined || y === undefined || z === undefined || x.length !== y.length || y.length !== z.length)
    return builder.refuse('coordx, coordy and coordz of equal length were expected.')
  return x.map((value, i) => [value, y[i] as number, z[i] as number])
}
