/** Nastran bulk data: grid points in their frames, and elements by property. */

import { RowPattern } from '../../core/reading-interface'
import type { Mesh } from '../mesh'
import type { OtherCell } from '../mesh-builder'
import { PrintedDigits } from '../precision'
import { Runs } from '../runs'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'
import { includedLines } from './includes'
import { type Card, GRID_X, shortText, splitCard } from './nastran-card'
import { Cards, WANTED } from './nastran-cards'
import { Frames } from './nastran-frames'
import { NodeModel } from './node-model'
import { collect } from './placements'
import { TextLines } from './text-lines'

const [DOLLAR, STAR] = [36, 42] as const

/** Usual forms by the byte behind the name: in columns, in wide columns and between commas. */
const GRID_ROWS: Readonly<Record<number, RowPattern>> = {
  32: new RowPattern(['=GRID    ', 'whole8', 'blank8', 'real8', 'real8', 'real8', 'end']),
  42: new RowPattern(['=GRID*   ', 'whole16', 'blank16', 'real16', 'real16', 'end', '=*       ', 'real16', 'end']),
  44: new RowPattern(['=GRID', ',', 'whole', ',', ',', ...['real', ',', 'real', ',', 'real'], 'end']),
}
const times = (count: number, ...parts: readonly string[]) => Array.from({ length: count }, () => parts).flat()
const HEXAHEDRON_ROWS: Readonly<Record<number, RowPattern>> = {
  32: new RowPattern(['=CHEXA   ', ...times(8, 'whole8'), 'end', '=        ', 'whole8', 'whole8', 'end']),
  42: new RowPattern([
    ...['=CHEXA*  ', ...times(4, 'whole16'), 'end', '=*       ', ...times(4, 'whole16'), 'end'],
    ...['=*       ', 'whole16', 'whole16', 'end'],
  ]),
  44: new RowPattern(['=CHEXA', ...times(8, ',', 'whole'), 'end', ...times(2, ',', 'whole'), 'end']),
}

const OTHERS: Readonly<Record<string, OtherCell>> = wordTable({
  CTETRA: 'tetrahedron',
  CPENTA: 'wedge',
  CPYRAM: 'pyramid',
  CPYRA: 'pyramid',
  ...both(
    'quadrilateral',
    'CQUAD CQUAD4 CQUAD8 CQUADR CQUADX CQUADX4 CQUADX8 CPLSTN4 CPLSTN8 CPLSTS4 CPLSTS8 CSHEAR CQUAD1 CQUAD2',
  ),
  ...both(
    'triangle',
    'CTRIA3 CTRIA6 CTRIAR CTRIAX CTRIAX6 CTRAX3 CTRAX6 CPLSTN3 CPLSTN6 CPLSTS3 CPLSTS6 CTRIA1 CTRIA2',
  ),
  ...both('line', 'CBAR CBEAM CBEAM3 CROD CONROD CTUBE CBEND'),
  ...both('other', 'CELAS1 CELAS2 CELAS3 CELAS4 CDAMP1 CDAMP2 CDAMP3 CDAMP4 CDAMP5 CBUSH CBUSH1D CBUSH2D CGAP CVISC'),
  ...both('other', 'CMASS1 CMASS2 CMASS3 CMASS4 CONM1 CONM2 CFAST CWELD CIHEX1 CIHEX2 CIHEX3 CHEXA1 CHEXA2'),
})

function both(type: OtherCell, names: string): Record<string, OtherCell> {
  return Object.fromEntries(names.split(' ').map(name => [name, type]))
}

/** A CHEXA of 20 nodes: bottom edges, upright edges, top edges; as places among its nodes, in VTK order. */
const ORDER_OF_20 = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15]

export const nastran: MeshFormat = {
  name: 'Nastran',
  recognizes(head, name) {
    const text = headText(head)
    if (/^[> \t]*BEGIN[ \t]+(?:BULK|SUPER)/im.test(text)) return 'yes'
    if (/^[> \t]*(?:GRID|CHEXA|CTETRA|CPENTA|CQUAD4|CORD2R)(?:\*|,|\t|[ ]{2})/im.test(text)) return 'yes'
    return /\.(?:bdf|nas|blk|pch)$/.test(name) ? 'maybe' : 'no'
  },
  read: (file, options) => [new NastranReader(file, options).read()],
}

class NastranReader {
  readonly #options: ReadOptions
  readonly #precision = new PrintedDigits()
  readonly #notes = new Set<string>()
  readonly #model = new NodeModel()
  readonly #frames: Frames
  readonly #cards: Cards
  #lines: TextLines
  #isBulk = false
  #isOver = false
  #isCutOff = false

  constructor(file: MeshFile, options: ReadOptions) {
    this.#options = options
    this.#lines = new TextLines(file, options)
    this.#frames = new Frames(this.#model, (what, line) => this.#lines.refuse(what, line))
    this.#cards = new Cards(this.#precision, card => this.#take(card))
  }

  read(): Mesh {
    this.#readLines(0)
    this.#cards.finishAll(this.#lines)
    this.#intoBasicFrame()
    return collect({
      format: 'Nastran',
      fileName: this.#lines.file.name,
      placements: [{ model: this.#model, name: null, move: null }],
      precision: this.#precision,
      notes: this.#notes,
      isCutOff: this.#isCutOff,
    })
  }

  #readLines(depth: number): void {
    const lines = this.#lines
    while (!this.#isOver && lines.next()) {
      if (lines.isElision) {
        this.#isCutOff = true
        continue
      }
      if (this.#isBulk && this.#readRows()) continue
      lines.scan(DOLLAR)
      const end = lines.to
      let first = lines.from
      while (first < end && (lines.bytes[first] as number) <= 32) first++
      if (first === end) continue
      if (!this.#isBulk || isWord(lines, first, end, 'INCLUDE') || isWord(lines, first, end, 'BEGIN')) {
        if (this.#control(lines.text(first, end), depth)) continue
      }
      this.#bulkLine(first)
    }
  }

  /** Entries of the usual forms that begin with this line, many at once; false if it is none of them. */
  #readRows(): boolean {
    const lines = this.#lines
    const isGrid = lines.at(0) === 71
    const form = isGrid ? GRID_ROWS[lines.at(4)] : lines.at(0) === 67 ? HEXAHEDRON_ROWS[lines.at(5)] : undefined
    const rows = form === undefined ? null : lines.rows(form)
    if (rows === null) return false
    this.#cards.finish()
    const { count, numbers, pattern } = rows
    if (isGrid) {
      this.#model.defineRows(lines, rows, slot => this.#frames.putWithout(slot))
      this.#precision.seeAll(rows)
      return true
    }
    const first = this.#model.addRows(rows)
    let [last, cells] = [-1, new Runs()]
    for (let row = 0; row < count; ++row) {
      const property = numbers[pattern.numberCount * row + 1] as number
      if (property !== last) cells = this.#model.block(`PID ${property}`)
      last = property
      cells.add(first + row)
    }
    return true
  }

  /** Reads control lines and files that are included; false for a line of bulk data. */
  #control(text: string, depth: number): boolean {
    if (/^include\b/i.test(text)) {
      this.#include(text, depth)
      return true
    }
    if (/^begin\b/i.test(text)) {
      if (this.#model.nodeCount > 0 || /super|arbmodel|auxmodel|massid/i.test(text))
        this.#lines.refuse(`${shown(text)}: a second model in the file is not read here.`)
      this.#isBulk = true
      return true
    }
    if (this.#isBulk) return false
    const name = (/^([a-z]+\d?[a-z]?)\*?(?:[\s,]|$)/i.exec(text.slice(0, 9))?.[1] ?? '').toUpperCase()
    this.#isBulk = (WANTED[name] !== undefined || OTHERS[name] !== undefined) && !text.includes('=')
    return !this.#isBulk
  }

  #include(text: string, depth: number): void {
    const lines: TextLines = this.#lines
    let name = text.slice(7).trim()
    const quote = name[0] === "'" || name[0] === '"' ? name[0] : ''
    while (quote !== '' && name.indexOf(quote, 1) < 0 && name.length < 4096 && lines.next()) name += lines.text().trim()
    name = quote === '' ? name : (name.slice(1).split(quote)[0]?.trim() ?? '')
    if (name === '') lines.refuse('INCLUDE names no file.')
    const included = includedLines(lines, this.#options, 'INCLUDE', name, depth)
    this.#cards.finish()
    this.#model.forgetPlaces()
    this.#lines = included
    this.#readLines(depth + 1)
    this.#cards.finish()
    this.#lines = lines
  }

  #bulkLine(first: number): void {
    const lines = this.#lines
    const byte = lines.bytes[first] as number
    if (byte === 61) lines.refuse('lines that repeat others with “=” are not read here: write the entries out.')
    const layout = splitCard(lines)
    const isContinuation = byte === 43 || byte === 42 || lines.isFieldBlank(0)
    if (isContinuation) {
      this.#cards.goOn(lines, layout)
      return
    }
    this.#cards.finish()
    const name = nameOf(lines)
    if (name === 'ENDDATA') {
      this.#isOver = true
      return
    }
    const other = OTHERS[name]
    if (WANTED[name] !== undefined) this.#cards.begin(name, lines, layout)
    else if (other !== undefined) this.#model.addOther(other)
  }

  #take(card: Card): void {
    const lines = this.#lines
    if (card.name === 'GRID') this.#grid(card)
    else if (card.name === 'CHEXA') this.#hexahedron(card)
    else if (card.name === 'GRDSET') this.#frames.ofOthers = card.isGiven[1] === 1 ? card.id(1, 'a frame', lines) : 0
    else if (card.name.startsWith('CORD1')) this.#frames.defineByNodes(card, lines)
    else this.#frames.defineByPoints(card, lines)
  }

  #grid(card: Card): void {
    const lines = this.#lines
    const id = card.id(0, 'a number of a node', lines)
    const given = card.isGiven
    const [x, y, z] = [
      card.values[GRID_X] as number,
      card.values[GRID_X + 1] as number,
      card.values[GRID_X + 2] as number,
    ]
    if (card.isFree && card.count < GRID_X + 3) {
      this.#model.defineShortNode(lines, id, [x, y].slice(0, Math.max(0, card.count - GRID_X)), card.line)
      return
    }
    const isNew = this.#model.definedSlot(id) < 0
    const slot = this.#model.defineNode(lines, id, x, y, z)
    const frame = given[1] === 1 ? card.id(1, 'a frame', lines) : -1
    if (frame > 0) {
      if (!this.#frames.put(slot, frame, isNew))
        lines.refuse(`node ${id} is defined again, in another frame.`, card.line)
    } else if (frame < 0) this.#frames.putWithout(slot)
    const hasAll = given[GRID_X] === 1 && given[GRID_X + 1] === 1 && given[GRID_X + 2] === 1
    if (!hasAll) this.#notes.add('Blank coordinates are 0, as Nastran reads them.')
    if (frame > 0 || !hasAll) this.#model.forgetPlaces()
    else
      for (let axis = 0; axis < 3; ++axis)
        this.#model.place(lines, slot, axis, card.placeFrom[axis] as number, card.placeLength[axis] as number)
  }

  #hexahedron(card: Card): void {
    const lines = this.#lines
    const id = card.id(0, 'a number of an element', lines)
    const property = card.isGiven[1] === 1 ? card.id(1, 'a property', lines) : id
    const slots: number[] = []
    for (let field = 2; field < 10; ++field) {
      if (card.isGiven[field] !== 1 || card.values[field] === 0)
        lines.refuse(`CHEXA ${id} has ${this.#nodesOf(card)} nodes; 8 or 20 were expected.`, card.line)
      slots.push(this.#model.slot(card.id(field, 'a node', lines)))
    }
    let further = 0
    const order = ORDER_OF_20.map(at => {
      const field = 2 + at
      if (at < 8) return at
      if (card.isGiven[field] !== 1 || card.values[field] === 0) return -1
      further++
      slots[at] = this.#model.slot(card.id(field, 'a node', lines))
      return at
    })
    if (card.isGiven[22] === 1) lines.refuse(`CHEXA ${id} has more than 20 nodes.`, card.line)
    if (further > 0) this.#model.addQuadratic(id, slots, order)
    else this.#model.block(`PID ${property}`).add(this.#model.addHexahedron(id, slots))
  }

  #nodesOf(card: Card): number {
    let count = 0
    for (let field = 2; field < 22; ++field) if (card.isGiven[field] === 1 && card.values[field] !== 0) count++
    return count
  }

  #intoBasicFrame(): void {
    const count = this.#frames.intoBasic()
    if (count === 0) return
    this.#model.forgetPlaces()
    this.#notes.add(
      `${count} nodes are given in frames of their own; they are turned into the basic frame, and rounded to doubles.`,
    )
  }
}

function isWord(lines: TextLines, from: number, end: number, word: string): boolean {
  if (from + word.length > end) return false
  for (let i = 0; i < word.length; ++i)
    if (((lines.bytes[from + i] as number) & ~32) !== word.charCodeAt(i)) return false
  return true
}

/** The name of the entry, without the star of wide fields. */
function nameOf(lines: TextLines): string {
  let to = lines.fieldTo(0)
  while (to > lines.fieldFrom(0) && ((lines.bytes[to - 1] as number) <= 32 || lines.bytes[to - 1] === STAR)) to--
  return shortText(lines, lines.fieldFrom(0), Math.min(to, lines.fieldFrom(0) + 16))
}
