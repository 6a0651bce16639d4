/** LS-DYNA keyword files: nodes, solids and thick shells by part, in columns of each width or between commas. */
import type { Mesh } from '../mesh'
import { PrintedDigits } from '../precision'
import { type Runs, runsOf } from '../runs'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'
import { LONG, nextCard, STANDARD, skipCards, splitCard, TEN, widthsOf } from './dyna-cards'
import { includedLines } from './includes'
import { isRepeating, NodeModel, ORDER_OF_20 } from './node-model'
import { collect } from './placements'
import { TextLines } from './text-lines'

const [DOLLAR, STAR] = [36, 42] as const

/** Nodes of a solid whose option says how many it has; they stand ten on a line. */
const NODES_OF_OPTION: Readonly<Record<string, number>> = wordTable({
  H20: 20,
  H27: 27,
  H64: 64,
  T15: 15,
  T20: 20,
  P21: 21,
  P40: 40,
})
/** Lines that an option adds to each element. */
const LINES_OF_OPTION: Readonly<Record<string, number>> = wordTable({ ORTHO: 2, DOF: 1 })
/** Elements that the code makes into others; what they are made of is read. */
const CONVERSIONS = new Set(['TET4TOTET10', 'H8TOH20', 'H8TOH27', 'H8TOH64'])
const SHELL_LINES: Readonly<Record<string, number>> = wordTable({ THICKNESS: 1, BETA: 1, MCID: 1, OFFSET: 1, DOF: 1 })
const BEAM_LINES: Readonly<Record<string, number>> = wordTable({
  ...{ THICKNESS: 1, SCALAR: 1, SCALR: 1, SECTION: 1, PID: 1, OFFSET: 1, ORIENTATION: 1, WARPAGE: 1, DOF: 1 },
})

const passOver = () => {}

export const lsDyna: MeshFormat = {
  name: 'LS-DYNA',
  recognizes(head, name) {
    const text = headText(head)
    if (/^[> \t]*\*ELEMENT_(?:SOLID|SHELL|TSHELL|BEAM|DISCRETE|MASS)/im.test(text)) return 'yes'
    if (/^[> \t]*\*KEYWORD\b/im.test(text)) return 'yes'
    if (!/\.(?:k|key|dyn|k\d+)$/.test(name)) return 'no'
    return /^[> \t]*\*(?:NODE|PART|INCLUDE)/im.test(text) ? 'yes' : 'maybe'
  },
  read: (file, options) => [new DynaReader(file, options).read()],
}

class DynaReader {
  readonly #options: ReadOptions
  readonly #model = new NodeModel()
  readonly #precision = new PrintedDigits()
  readonly #notes = new Set<string>()
  readonly #cellsOfPart = new Map<number, Runs>()
  readonly #partNames = new Map<number, string>()
  readonly #nodes = new Float64Array(64)
  readonly #slots = new Uint32Array(64)
  #lines: TextLines
  #isCutOff = false
  #degenerate = 0
  /** The widths of the file, and of the keyword. */
  #usual = STANDARD
  #widths = STANDARD
  #keyword = ''
  /** Reads a data line of the keyword. */
  #readLine: () => void = passOver

  constructor(file: MeshFile, options: ReadOptions) {
    this.#options = options
    this.#lines = new TextLines(file, options)
  }

  read(): Mesh {
    this.#readLines(0)
    this.#makeBlocks()
    if (this.#degenerate > 0)
      this.#notes.add(`${this.#degenerate} elements of 8 nodes repeat some: as hexahedra they have J <= 0 somewhere.`)
    return collect({
      format: 'LS-DYNA',
      fileName: this.#lines.file.name,
      placements: [{ model: this.#model, name: null, move: null }],
      precision: this.#precision,
      notes: this.#notes,
      isCutOff: this.#isCutOff,
    })
  }

  #readLines(depth: number): void {
    const lines = this.#lines
    this.#readLine = passOver
    let blank = 0
    while (lines.next()) {
      const first = lines.at(0)
      if (lines.isBlank) blank = lines.number
      if (first === STAR) {
        if (!this.#startKeyword(depth)) return
      } else if (first === DOLLAR || lines.isBlank) continue
      else if (lines.isElision) this.#isCutOff = true
      else if (blank > 0 && this.#isOfNumbers() && lines.isProseAfter(blank)) {
        this.#readLine = passOver
        this.#notes.add(`Line ${lines.number} is text: what follows it, up to the next keyword, is passed over.`)
      } else this.#readLine()
    }
  }

  /** True if lines of the keyword begin with numbers, not with titles or names. */
  #isOfNumbers(): boolean {
    return this.#readLine !== passOver && /^\*(?:NODE|ELEMENT)/.test(this.#keyword)
  }

  /** False for *END. */
  #startKeyword(depth: number): boolean {
    const lines = this.#lines
    const text = lines.text().trim()
    const name = (/^\*[^\s+%(,-]*/.exec(text)?.[0] ?? '').toUpperCase()
    this.#keyword = name
    this.#widths = widthsOf(text, name, this.#usual)
    this.#readLine = passOver
    const [, base = '', options = ''] = /^\*(ELEMENT_[A-Z]+|INCLUDE|PART|[A-Z0-9]+)_?(.*)$/.exec(name) ?? []
    switch (base) {
      case 'KEYWORD':
        if (/\bLONG\s*=\s*Y/i.test(text)) this.#usual = LONG
        else if (/\bI10\s*=\s*Y/i.test(text)) this.#usual = TEN
        break
      case 'END':
        return false
      case 'NODE':
        if (options === '' || options === 'RIGID_SURFACE') this.#readLine = () => this.#nodeLine()
        else if (options === 'TRANSFORM') this.#refuseKeyword()
        break
      case 'ELEMENT_SOLID':
        this.#startSolids(options)
        break
      case 'ELEMENT_TSHELL':
        this.#startThickShells(options)
        break
      case 'ELEMENT_SHELL':
        this.#startShells(options)
        break
      case 'ELEMENT_BEAM':
        this.#startBeams(options)
        break
      case 'ELEMENT_DISCRETE':
      case 'ELEMENT_MASS':
      case 'ELEMENT_SEATBELT':
      case 'ELEMENT_SPH':
        if (options === '') this.#readLine = () => this.#model.addOther('other')
        break
      case 'PART':
        this.#startPart(options)
        break
      case 'INCLUDE':
        if (options === '') this.#readLine = () => this.#include(depth)
        else if (!options.startsWith('PATH')) this.#refuseKeyword()
        break
      default:
        if (base.startsWith('ELEMENT_'))
          this.#notes.add(`${shown(name)} is not read here, and its elements are not counted.`)
    }
    return true
  }

  #refuseKeyword(): never {
    this.#lines.refuse(`${shown(this.#keyword)} is not read here: write the nodes and elements themselves.`)
  }

  #split(integers: number, reals = 0): void {
    splitCard(this.#lines, this.#widths, integers, reals)
  }

  // Nodes

  #nodeLine(): void {
    const lines = this.#lines
    this.#split(1, 3)
    const id = lines.id(0, 'a number of a node')
    if (lines.fieldCount < 4) {
      const given = [1, 2].slice(0, lines.fieldCount - 1).map(field => lines.real(field, this.#precision))
      this.#model.defineShortNode(lines, id, given)
    } else if (!this.#model.defineFields(lines, id, this.#precision))
      this.#notes.add('Blank coordinates are 0, as LS-DYNA reads them.')
  }

  // Elements

  #startSolids(options: string): void {
    let nodeCount = 0
    let further = 0
    for (const option of options.split('_')) {
      if (option === '') continue
      const nodes = NODES_OF_OPTION[option]
      const lines = LINES_OF_OPTION[option]
      if (nodes !== undefined) nodeCount = nodes
      else if (lines !== undefined) further += lines
      else if (CONVERSIONS.has(option))
        this.#notes.add(`${shown(this.#keyword)}: the elements are read as they are written.`)
      else this.#refuseKeyword()
    }
    if (nodeCount > 0 && options.includes('DOF')) this.#refuseKeyword()
    this.#readLine = nodeCount > 0 ? () => this.#manyNodes(nodeCount, further) : () => this.#solid(further)
  }

  /** A solid: element, part, eight nodes; on two lines, element and part, then 8 or 10 nodes. */
  #solid(further: number): void {
    const lines = this.#lines
    this.#split(10)
    const id = lines.id(0, 'a number of an element')
    const part = lines.id(1, 'a number of a part')
    let first = 2
    if (lines.filledCount <= 2) {
      nextCard(lines, `element ${id} has no line of nodes.`)
      this.#split(10)
      first = 0
    }
    let count = this.#readNodes(id, first, Math.min(lines.filledCount, first + 10), 0)
    while (count > 8 && this.#nodes[count - 1] === 0) count--
    const line = lines.number
    skipCards(lines, further, `element ${id} lacks the lines of ${this.#keyword}.`)
    if (count === 10 && this.#nodes[8] !== 0) this.#model.addOther('tetrahedron')
    else this.#eightNodes(id, part, count, line)
  }

  #readNodes(id: number, from: number, to: number, count: number): number {
    const lines = this.#lines
    let next = count
    for (let field = from; field < to; ++field) {
      if (next >= this.#nodes.length) lines.refuse(`element ${id} has more than ${this.#nodes.length} nodes.`)
      this.#nodes[next++] = lines.isFieldBlank(field) ? 0 : lines.id(field, 'a number of a node')
    }
    return next
  }

  #eightNodes(id: number, part: number, count: number, line: number): void {
    const nodes = this.#nodes
    let given = 0
    while (given < count && nodes[given] !== 0) given++
    if (given !== 8 || count !== 8) this.#lines.refuse(`element ${id} has ${given} nodes; 8 were expected.`, line)
    const n = (a: number, b: number) => nodes[a] === nodes[b]
    if (n(3, 4) && n(4, 5) && n(5, 6) && n(6, 7)) {
      this.#model.addOther('tetrahedron')
      return
    }
    if (n(4, 5) && n(6, 7) && !n(5, 6)) {
      this.#model.addOther('wedge')
      return
    }
    for (let i = 0; i < 8; ++i) this.#slots[i] = this.#model.slot(nodes[i] as number)
    if (isRepeating(nodes)) this.#degenerate++
    runsOf(this.#cellsOfPart, part).add(this.#model.addHexahedron(id, this.#slots))
  }

  #manyNodes(nodeCount: number, further: number): void {
    const lines = this.#lines
    this.#split(10)
    const id = lines.id(0, 'a number of an element')
    const line = lines.number
    // Gmsh writes the nodes on from the first line.
    const areInline = lines.filledCount > 2
    let count = areInline ? this.#readNodes(id, 2, lines.filledCount, 0) : 0
    while (count < nodeCount) {
      nextCard(lines, `element ${id} has ${count} nodes; ${nodeCount} were expected.`)
      this.#split(10)
      const wanted = Math.min(areInline ? lines.filledCount : 10, nodeCount - count)
      if (lines.filledCount < wanted)
        lines.refuse(`element ${id} has ${count + lines.filledCount} nodes; ${nodeCount} were expected.`)
      count = this.#readNodes(id, 0, wanted, count)
    }
    skipCards(lines, further, `element ${id} lacks the lines of ${this.#keyword}.`)
    if (nodeCount === 15 || (nodeCount === 20 && this.#keyword.includes('T20'))) this.#model.addOther('tetrahedron')
    else if (nodeCount === 21 || nodeCount === 40) this.#model.addOther('wedge')
    else {
      for (let i = 0; i < 8; ++i)
        if (this.#nodes[i] === 0) lines.refuse(`element ${id} has ${i} nodes; ${nodeCount} were expected.`, line)
      const further = nodeCount === 64 ? [] : ORDER_OF_20.slice(8)
      for (const i of [...ORDER_OF_20.slice(0, 8), ...further])
        this.#slots[i] = this.#nodes[i] === 0 ? 0 : this.#model.slot(this.#nodes[i] as number)
      const has = (i: number) => (i < 8 || (nodeCount !== 64 && this.#nodes[i] !== 0) ? i : -1)
      if (nodeCount > 20)
        this.#notes.add(
          `${shown(this.#keyword)}: nodes beyond those on the edges are not looked at, nor whether they lie at the middles.`,
        )
      this.#model.addQuadratic(id, this.#slots, ORDER_OF_20.map(has))
    }
  }

  #startThickShells(options: string): void {
    if (options !== '' && options !== 'BETA') this.#refuseKeyword()
    this.#readLine = () => this.#solid(options === 'BETA' ? 1 : 0)
  }

  /** The options of elements that are counted; null if one of them is not known here. */
  #knownOptions(options: string, table: Readonly<Record<string, number>>): string[] | null {
    const given = options.split('_').filter(option => option !== '')
    if (given.every(option => table[option] !== undefined)) return given
    this.#notes.add(`${shown(this.#keyword)}: its elements are not counted.`)
    return null
  }

  #startShells(options: string): void {
    const known = this.#knownOptions(options, SHELL_LINES)
    if (known === null) return
    const further = known.reduce((sum, option) => sum + (SHELL_LINES[option] as number), 0)
    const hasThickness = known.includes('THICKNESS')
    // The thickness and the angle stand on one line.
    const shared = hasThickness && (known.includes('BETA') || known.includes('MCID')) ? 1 : 0
    this.#readLine = () => {
      const lines = this.#lines
      this.#split(10)
      const id = lines.id(0, 'a number of an element')
      const count = this.#readNodes(id, 2, Math.min(lines.filledCount, 10), 0)
      if (count < 3) lines.refuse(`element ${id} has ${count} nodes; 3 or more were expected.`)
      const [third, fourth] = [this.#nodes[2], count > 3 ? this.#nodes[3] : 0]
      const hasMiddles = count > 4 && this.#nodes[4] !== 0
      this.#model.addOther(fourth === 0 || fourth === third ? 'triangle' : 'quadrilateral')
      skipCards(
        lines,
        further - shared + (hasThickness && hasMiddles ? 1 : 0),
        `element ${id} lacks the lines of ${this.#keyword}.`,
      )
    }
  }

  #startBeams(options: string): void {
    const known = this.#knownOptions(options, BEAM_LINES)
    if (known === null) return
    this.#readLine = () => {
      this.#model.addOther('line')
      skipCards(this.#lines, known.length, `an element lacks the lines of ${this.#keyword}.`)
    }
  }

  // Parts

  #startPart(options: string): void {
    let title: string | null = null
    this.#readLine = () => {
      const lines = this.#lines
      if (title === null) {
        title = lines.text().trim()
        return
      }
      splitCard(lines, this.#widths === LONG ? LONG : TEN, 1)
      this.#partNames.set(lines.id(0, 'a number of a part'), title)
      title = null
      // Lines of the options follow, whose number depends on what they say.
      if (options !== '') this.#readLine = passOver
    }
  }

  #makeBlocks(): void {
    const used = new Set<string>()
    for (const [part, runs] of this.#cellsOfPart) {
      const title = this.#partNames.get(part) || `Part ${part}`
      const name = used.has(title) ? `${title} (${part})` : title
      used.add(name)
      this.#model.block(name).addAll(runs)
    }
  }

  #include(depth: number): void {
    const lines: TextLines = this.#lines
    let name = lines.text().trim()
    while (name.endsWith(' +') && name.length < 4096 && lines.next()) name = name.slice(0, -2) + lines.text().trim()
    const included = includedLines(lines, this.#options, '*INCLUDE', name, depth)
    const [readLine, usual] = [this.#readLine, this.#usual]
    this.#model.forgetPlaces()
    this.#lines = included
    this.#readLines(depth + 1)
    this.#lines = lines
    this.#usual = usual
    this.#readLine = readLine
  }
}
