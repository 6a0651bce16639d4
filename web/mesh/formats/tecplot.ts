/**
 * Tecplot in ASCII: zones of finite elements, FEBRICK (old: FEPOINT or FEBLOCK with ET=BRICK), with values by points or in blocks. Bricks
 * have VTK's order; a brick whose nodes coincide may be any other cell, and is a degenerate hexahedron here.
 */
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { headText } from '../snippet-text'
import { titledColumns } from '../snippets/point-set'
import { type MeshFile, type MeshFormat, progressOf, type ReadOptions } from '../source'
import { shown, TextCursor } from '../text-cursor'
import { wordTable } from '../word-table'
import { isRepeating } from './node-model'

/** Nodes of a zone's cells. */
const CELLS: Readonly<Record<string, readonly [OtherCell | 'hexahedron', number]>> = wordTable({
  FEBRICK: ['hexahedron', 8],
  FETETRAHEDRON: ['tetrahedron', 4],
  FEQUADRILATERAL: ['quadrilateral', 4],
  FETRIANGLE: ['triangle', 3],
  FELINESEG: ['line', 2],
})
const OLD_TYPES: Readonly<Record<string, string>> = wordTable({
  BRICK: 'FEBRICK',
  TETRAHEDRON: 'FETETRAHEDRON',
  QUADRILATERAL: 'FEQUADRILATERAL',
  TRIANGLE: 'FETRIANGLE',
  LINESEG: 'FELINESEG',
})
const KEYWORD = /^[ \t]*(?:TITLE|FILETYPE|VARIABLES|ZONE|TEXT|GEOMETRY|DATASETAUXDATA|VARAUXDATA)\b/i
const PARAMETER = /([A-Za-z]+)\s{0,20}=\s{0,20}("[^"]{0,1000}"|\((?:[^()]|\([^()]{0,1000}\)){0,4000}\)|[^\s,]+)/g

interface Zone {
  readonly type: string
  readonly nodes: number
  readonly cells: number
  readonly isBlock: boolean
  /** Variables, from 0, that have a value for each cell. */
  readonly ofCells: ReadonlySet<number>
}

export const tecplot: MeshFormat = {
  name: 'Tecplot',
  recognizes: head => {
    const text = headText(head)
    return /^[ \t]*ZONE\b/im.test(text) && /^[ \t]*(?:TITLE|VARIABLES)\s{0,20}=/im.test(text) ? 'yes' : 'no'
  },
  read(file, options) {
    return [new Reader(file, options).read()]
  },
}

class Reader {
  readonly #builder: MeshBuilder
  readonly #cursor: TextCursor
  readonly #onRecord: (position: number) => void
  readonly #size: number
  #axes: readonly number[] = [0, 1, 2]
  #variables = 3
  #degenerate = 0

  constructor(file: MeshFile, options: ReadOptions) {
    this.#builder = new MeshBuilder('Tecplot', file.name)
    this.#cursor = new TextCursor(file)
    this.#onRecord = progressOf(file, options)
    this.#size = file.size
  }

  read() {
    const cursor = this.#cursor
    for (cursor.skipBlanks(); !cursor.isAtEnd; cursor.skipBlanks()) {
      if (cursor.peek() === 35) {
        cursor.skipLine()
        continue
      }
      const header = this.#header()
      if (/^\s*VARIABLES/i.test(header)) this.#readVariables(header)
      else if (/^\s*ZONE/i.test(header)) this.#readZone(this.#zoneOf(header))
      else if (!/^\s*(?:TITLE|FILETYPE|DATASETAUXDATA|VARAUXDATA)/i.test(header))
        cursor.refuse(`${shown(header.trim().slice(0, 40))} stands where a zone was expected.`)
    }
    if (this.#degenerate > 0)
      this.#builder.note(`${this.#degenerate} bricks repeat nodes: as hexahedra they have J <= 0 somewhere.`)
    return this.#builder.mesh()
  }

  /** The keyword that ended the header before. */
  #pending = ''

  /** A keyword's line with those that go on with it, up to the next keyword or the first number. */
  #header(): string {
    const cursor = this.#cursor
    let header = `${this.#pending} ${cursor.nextLine() ?? ''}`
    this.#pending = ''
    for (;;) {
      cursor.skipBlanks()
      const next = cursor.peek()
      const isNumber = (next >= 48 && next <= 57) || next === 45 || next === 46 || next === 43
      if (next === -1 || isNumber || next === 35) return header
      const word = cursor.word()
      if (KEYWORD.test(word.split('=')[0] as string)) {
        this.#pending = word
        return header
      }
      header += ` ${word} ${cursor.nextLine() ?? ''}`
      if (header.length > 100_000) cursor.refuse('the header of a zone does not end.')
    }
  }

  #readVariables(header: string): void {
    const names = Array.from(
      header.slice(header.indexOf('=') + 1).matchAll(/"([^"]{0,1000})"|([^\s,"]+)/g),
      match => match[1] ?? match[2] ?? '',
    )
    const axes = titledColumns(names)
    if (axes === null) this.#cursor.refuse('among the variables are no X, Y and Z.')
    this.#axes = axes
    this.#variables = names.length
  }

  #zoneOf(header: string): Zone {
    const given = new Map(
      Array.from(header.matchAll(PARAMETER), ([, key, value]) => [
        (key as string).toUpperCase(),
        (value as string).replace(/^"|"$/g, ''),
      ]),
    )
    const old = given.get('F')?.toUpperCase()
    const type = (
      given.get('ZONETYPE') ??
      OLD_TYPES[given.get('ET')?.toUpperCase() ?? ''] ??
      (old?.startsWith('FE') ? 'FEQUADRILATERAL' : 'ORDERED')
    ).toUpperCase()
    if (given.has('VARSHARELIST') || given.has('CONNECTIVITYSHAREZONE'))
      this.#cursor.refuse(
        'a zone shares its points or cells with another one, which is not read yet: write zones in full.',
      )
    if (CELLS[type] === undefined)
      this.#cursor.refuse(
        `a zone is of type ${shown(type)}; zones of type FEBRICK are read: meshio or Tecplot convert others.`,
      )
    const count = (...names: string[]) => {
      const word = names.map(name => given.get(name)).find(value => value !== undefined)
      const value = Number(word)
      if (word === undefined || !Number.isSafeInteger(value) || value < 0)
        this.#cursor.refuse(`the zone does not say its number of ${names[0]?.toLowerCase()}.`)
      if (2 * value > this.#size) this.#cursor.refuse(`the file is too short for ${value} ${names[0]?.toLowerCase()}.`)
      return value
    }
    const isBlock = (given.get('DATAPACKING') ?? old ?? 'POINT').toUpperCase().includes('BLOCK')
    return {
      type,
      nodes: count('NODES', 'N'),
      cells: count('ELEMENTS', 'E'),
      isBlock,
      ofCells: cellCentred(given.get('VARLOCATION') ?? '', this.#variables),
    }
  }

  #readZone({ type, nodes, cells, isBlock, ofCells }: Zone): void {
    const cursor = this.#cursor
    const builder = this.#builder
    const first = builder.pointCount
    if (isBlock) {
      const axes = this.#axes.map(() => new Float64Array(nodes))
      for (let variable = 0; variable < this.#variables; variable++) {
        const into = axes[this.#axes.indexOf(variable)]
        const length = ofCells.has(variable) ? cells : nodes
        for (let i = 0; i < length; i++) {
          const value = cursor.number('a value')
          if (into === undefined) continue
          builder.digits.see(value, cursor.digits)
          into[i] = value
        }
        this.#onRecord(cursor.position)
      }
      const [x, y, z] = axes as [Float64Array, Float64Array, Float64Array]
      for (let i = 0; i < nodes; i++) builder.point(x[i] as number, y[i] as number, z[i] as number)
    } else {
      const list = () => new Float64Array(this.#variables)
      const [row, from, to, digits] = [list(), list(), list(), list()]
      const [x = 0, y = 1, z = 2] = this.#axes
      for (let i = 0; i < nodes; i++) {
        for (let variable = 0; variable < row.length; variable++) {
          row[variable] = cursor.number('a value')
          from[variable] = cursor.numberFrom
          to[variable] = cursor.position
          digits[variable] = cursor.digits
        }
        for (const axis of [x, y, z]) {
          builder.digits.see(row[axis] as number, digits[axis] as number)
          builder.coordinateToken(from[axis] as number, (to[axis] as number) - (from[axis] as number))
        }
        builder.point(row[x] as number, row[y] as number, row[z] as number)
        this.#onRecord(cursor.position)
      }
    }
    const [kind, size] = CELLS[type] as readonly [OtherCell | 'hexahedron', number]
    for (let cell = 0; cell < cells; cell++) {
      const indices = Array.from({ length: size }, () => {
        const node = cursor.count('the number of a node')
        if (node < 1 || node > nodes) cursor.refuse(`cell ${cell + 1} names node ${node}; the nodes are 1 to ${nodes}.`)
        return first + node - 1
      })
      if (kind === 'hexahedron') {
        if (isRepeating(indices)) this.#degenerate++
        builder.hexahedron(indices, builder.cellCount + 1)
      } else builder.otherCell(kind)
      this.#onRecord(cursor.position)
    }
  }
}

/** "([4-5,7]=CELLCENTERED)" */
function cellCentred(locations: string, variables: number): ReadonlySet<number> {
  const found = new Set<number>()
  for (const [, list = ''] of locations.matchAll(/\[?([\d,\s-]{1,1000})\]?\s{0,9}=\s{0,9}CELLCENTERED/gi)) {
    for (const part of list.split(',')) {
      const [from = 0, to = from] = part.split('-').map(Number)
      for (let i = from; i <= Math.min(to, variables); i++) found.add(i - 1)
    }
  }
  return found
}
