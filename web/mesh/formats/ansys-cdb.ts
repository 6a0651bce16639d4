/** Ansys archives: NBLOCK and EBLOCK by the widths that their format lines give, commands N, E, EN and EMORE, element types, components. */
import type { Mesh } from '../mesh'
import { PrintedDigits } from '../precision'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { AnsysCommands } from './ansys-commands'
import { AnsysElements, MOST_NODES } from './ansys-elements'
import type { AnsysType } from './ansys-types'
import { IdOrder } from './id-ranges'
import { NodeModel } from './node-model'
import { collect } from './placements'
import { TextLines } from './text-lines'

/** Fields of an element in a solid block, before its nodes. */
const SOLID_FIELDS = 11
/** Fields of other blocks: number, section, real constants, material, frame. */
const NONSOLID_FIELDS = 5

export const ansysCdb: MeshFormat = {
  name: 'Ansys',
  recognizes(head, name) {
    const text = headText(head)
    if (/^[> \t]*[NE]BLOCK[ \t]*,/im.test(text)) return 'yes'
    if (/^[ \t]*ET[ \t]*,[ \t]*\d+[ \t]*,/im.test(text) && /^[ \t]*N[ \t]*,[ \t]*\d+[ \t]*,/im.test(text)) return 'yes'
    return name.endsWith('.cdb') || /^[> \t]*\/PREP7/im.test(text) ? 'maybe' : 'no'
  },
  read: (file, options) => [new AnsysReader(file, options).read()],
}

/** Commands that make, move or take away nodes and elements. */
const CHANGES: ReadonlySet<string> = new Set(
  'NGEN EGEN ENGEN NSYM ESYM ENSYM NSCALE NDELE EDELE NREAD EREAD FILL MOVE TRANSFER'.split(' '),
)

/** The first letters of the commands that are looked at, in lower case. */
const FIRST_LETTERS: readonly number[] = [...'netkclfm'].map(letter => letter.charCodeAt(0))

/** Columns of a line: those of integers, then those of reals. */
interface Widths {
  readonly integers: number
  readonly integerWidth: number
  readonly reals: number
  readonly realWidth: number
}

class AnsysReader {
  readonly #lines: TextLines
  readonly #model = new NodeModel()
  readonly #precision = new PrintedDigits()
  readonly #notes: string[] = []
  readonly #components: { name: string; ids: [number, number][] }[] = []
  #isCutOff = false
  readonly #elements: AnsysElements
  readonly #commands: AnsysCommands

  constructor(file: MeshFile, options: ReadOptions) {
    this.#lines = new TextLines(file, options)
    this.#elements = new AnsysElements(this.#lines, this.#model, this.#notes)
    this.#commands = new AnsysCommands(this.#lines, this.#model, this.#precision, (id, nodes, line) =>
      this.#elements.add(id, this.#elements.typeOf(), nodes, nodes.length, line),
    )
  }

  read(): Mesh {
    const lines = this.#lines
    while (lines.next()) {
      if (lines.isElision) this.#isCutOff = true
      else this.#command()
    }
    this.#commands.endElement()
    this.#makeBlocks()
    if (this.#elements.degenerate > 0)
      this.#notes.push(
        `${this.#elements.degenerate} elements repeat nodes, as Ansys writes wedges, pyramids and tetrahedra: as hexahedra they have J <= 0 somewhere.`,
      )
    return collect({
      format: 'Ansys',
      fileName: this.#lines.file.name,
      placements: [{ model: this.#model, name: null, move: null }],
      precision: this.#precision,
      notes: this.#notes,
      isCutOff: this.#isCutOff,
    })
  }

  #command(): void {
    const lines = this.#lines
    const first = lines.at(0) | 32
    // Data lines begin with blanks and digits.
    if (!FIRST_LETTERS.includes(first) && lines.at(0) !== 32) return
    const [name = '', ...rest] =
      lines
        .text()
        .split('!')[0]
        ?.split(',')
        .map(word => word.trim()) ?? []
    const command = name.toUpperCase()
    if (CHANGES.has(command) || (command === 'EMODIF' && /^-?\d+$/.test(rest[1] ?? '')))
      lines.refuse(`${command} is not read here: write the nodes and elements as they are in the end.`)
    switch (command) {
      case 'NBLOCK':
        this.#nodeBlock(rest)
        break
      case 'EBLOCK':
        this.#elementBlock(rest)
        break
      case 'CMBLOCK':
        this.#component(rest)
        break
      case 'ETBLOCK':
        this.#typeBlock()
        break
      case 'ET':
        this.#elementType(rest)
        break
      case 'KEYOP':
      case 'KEYOPT':
        if (Number(rest[1]) === 1) this.#elements.setFirstOption(Number(rest[0]), Number(rest[2]))
        break
      case 'TYPE':
        this.#commands.endElement()
        this.#elements.currentType = Number(rest[0])
        break
      case 'N':
        if (!/^R/i.test(rest[0] ?? '')) this.#commands.node()
        break
      case 'CSYS':
        this.#commands.frame = rest[0] || '0'
        break
      case 'LOCAL':
      case 'CLOCAL':
        // CDWRITE's own form names its release first: such a frame is defined, and not active.
        if (!/^R/i.test(rest[0] ?? '')) this.#commands.frame = rest[0] ?? ''
        break
      case 'NMODIF':
        if (rest.slice(1, 4).some(word => word !== ''))
          lines.refuse('NMODIF of coordinates is not read here: write the nodes where they are in the end.')
        break
      case 'E':
      case 'EN':
      case 'EMORE':
        this.#commands.element(command)
    }
  }

  #elementType([type, routine = '', firstOption = '']: readonly string[]): void {
    const digits = /(\d{1,4})$/.exec(routine)?.[1]
    if (digits !== undefined) this.#elements.defineType(Number(type), Number(digits))
    if (firstOption !== '') this.#elements.setFirstOption(Number(type), Number(firstOption))
  }

  #typeBlock(): void {
    const { integerWidth } = this.#formatLine('ETBLOCK')
    const lines = this.#lines
    while (lines.next()) {
      lines.startFields()
      lines.addColumns(2, integerWidth)
      const type = lines.integer(0, 'a type of elements')
      if (type < 0) return
      this.#elements.defineType(type, lines.integer(1, 'a number of a type'))
    }
  }

  /** "(3i9,6e21.13e3)" */
  #formatLine(block: string): Widths {
    const lines: TextLines = this.#lines
    const expected = `${block}: a format as (3i9,6e21.13e3) was expected`
    if (!lines.next()) lines.refuse(`${expected}, and the file ends.`)
    const text = lines.text().trim()
    const match = /^\((\d{0,3})i(\d{1,2})(?:,(\d{0,3})[a-z](\d{1,3})(?:\.\d{1,3}(?:e\d)?)?)?\)$/i.exec(
      text.replace(/\s/g, ''),
    )
    if (match === null) lines.refuse(`${expected}, not ${shown(text)}.`)
    const [, integers, integerWidth, reals, realWidth] = match
    const widths = {
      integers: Number(integers || 1),
      integerWidth: Number(integerWidth),
      reals: reals === undefined ? 0 : Number(reals || 1),
      realWidth: Number(realWidth ?? 0),
    }
    if (widths.integerWidth === 0 || (widths.reals > 0 && widths.realWidth === 0))
      lines.refuse(`${expected}, not ${shown(text)}.`)
    return widths
  }

  /** True if the line ends a block: -1, or a command. */
  #isEndOfBlock(): boolean {
    const lines = this.#lines
    let at = 0
    while (lines.at(at) === 32 || lines.at(at) === 9) at++
    const byte = lines.at(at)
    return (
      (byte === 45 && lines.at(at + 1) === 49 && lines.from + at + 2 === lines.to) ||
      (byte | 32) >= 97 ||
      byte === 47 ||
      byte === 42
    )
  }

  /** Reads the lines of a block, which must be as many as it declares, if it does. */
  #block(block: string, what: string, stated: string, readLine: () => void): void {
    const lines = this.#lines
    let count = 0
    for (;;) {
      if (!lines.next()) lines.refuse(`the file ends within an ${block}, after ${count} ${what}.`)
      if (lines.isBlank) continue
      if (lines.isElision) {
        this.#isCutOff = true
        continue
      }
      if (this.#isEndOfBlock()) break
      readLine()
      count++
    }
    const declared = Number(stated)
    if (count < declared && !this.#isCutOff) lines.refuse(`${block} has ${count} ${what}; ${declared} are declared.`)
    if (declared > 0 && count > declared && !this.#isCutOff)
      this.#notes.push(`${block} declares ${declared} ${what}, and has ${count}: all are read.`)
    if (!isMinusOne(lines)) lines.hold()
  }

  // Nodes

  #nodeBlock([, , , declared = '']: readonly string[]): void {
    const lines = this.#lines
    const { integers, integerWidth, reals, realWidth } = this.#formatLine('NBLOCK')
    if (integers < 1 || reals < 3)
      lines.refuse('NBLOCK: a number of a node and three coordinates were expected in its format.')
    const coordinates = integers * integerWidth
    let isJustified = false
    this.#block('NBLOCK', 'nodes', declared, () => {
      lines.startFields()
      lines.addColumns(1, integerWidth)
      lines.addColumns(3, realWidth, lines.from + coordinates)
      const id = lines.id(0, 'a number of a node')
      const beyond = lines.to - lines.from - coordinates
      const isWhole = beyond <= 0 ? (lines.to - lines.from) % integerWidth === 0 : beyond % realWidth === 0
      if (isWhole) isJustified = true
      else if (isJustified && beyond < 6 * realWidth)
        lines.refuse(`node ${id}: the last number of the line is cut off.`)
      this.#model.defineFields(lines, id, this.#precision)
    })
    if (/^n,/i.test(lines.text().trim())) lines.next()
  }

  // Elements

  #elementBlock([, key = '', , declared = '']: readonly string[]): void {
    const lines = this.#lines
    const { integers, integerWidth } = this.#formatLine('EBLOCK')
    const isSolid = /^solid$/i.test(key)
    if (!isSolid && key !== '')
      lines.refuse(`EBLOCK with ${shown(key)} is not read here; SOLID or nothing was expected.`)
    const nodes = new Float64Array(MOST_NODES)
    const split = () => {
      lines.startFields()
      lines.addColumns(integers, integerWidth)
    }
    this.#block('EBLOCK', 'elements', declared, () => {
      split()
      const filled = lines.filledCount
      const id = lines.id(isSolid ? SOLID_FIELDS - 1 : 0, 'a number of an element')
      const fields = isSolid ? SOLID_FIELDS : NONSOLID_FIELDS
      const type = this.#elements.typeOf(isSolid ? lines.id(1, 'a type of an element') : undefined)
      const wanted = isSolid ? lines.id(8, 'a number of nodes') : Math.max(filled - fields, 0)
      if (wanted > MOST_NODES || wanted < 1)
        lines.refuse(`element ${id} has ${wanted} nodes; 1 to ${MOST_NODES} were expected.`)
      let has = 0
      const line = lines.number
      for (let i = fields; i < filled && has < MOST_NODES; ++i) nodes[has++] = lines.id(i, 'a number of a node')
      if (isSolid) has = this.#furtherNodes(nodes, has, wanted, id, line, split)
      else if (filled === integers) has = this.#nodesOfSecondLine(nodes, has, type, split)
      this.#elements.add(id, type, nodes, isSolid ? wanted : has, line)
    })
  }

  #furtherNodes(
    nodes: Float64Array,
    first: number,
    wanted: number,
    id: number,
    line: number,
    split: () => void,
  ): number {
    const lines = this.#lines
    let has = first
    if (has < Math.min(wanted, 8)) lines.refuse(`element ${id} has ${has} nodes; ${wanted} are declared.`)
    while (has < wanted) {
      if (!lines.next() || this.#isEndOfBlock())
        lines.refuse(`element ${id} has ${has} nodes; ${wanted} are declared.`, line)
      split()
      const filled = lines.filledCount
      if (filled === 0 || has + filled > wanted)
        lines.refuse(`element ${id} has ${has} nodes, then a line of ${filled}; ${wanted} are declared.`)
      for (let i = 0; i < filled; ++i) nodes[has++] = lines.id(i, 'a number of a node')
    }
    return has
  }

  /** An element of more nodes than its line has columns goes on in a line that has nothing else. */
  #nodesOfSecondLine(nodes: Float64Array, first: number, type: AnsysType | null, split: () => void): number {
    const lines = this.#lines
    let has = first
    if (type?.kind !== 'quadratic') return has
    if (!lines.next()) return has
    split()
    const filled = lines.filledCount
    for (let i = 0; i < filled && has < MOST_NODES; ++i) nodes[has++] = lines.id(i, 'a number of a node')
    return has
  }

  // Components

  #component([name = '', kind = '']: readonly string[]): void {
    const lines = this.#lines
    const { integers, integerWidth } = this.#formatLine('CMBLOCK')
    const isOfElements = /^elem/i.test(kind)
    const ids: [number, number][] = []
    while (lines.next()) {
      if (this.#isEndOfBlock() && !isMinusOne(lines)) {
        lines.hold()
        break
      }
      if (!isOfElements || isMinusOne(lines)) continue
      lines.startFields()
      lines.addColumns(integers, integerWidth)
      for (let i = 0; i < lines.filledCount; ++i) {
        const id = lines.integer(i, 'a number of an element')
        const last = ids.at(-1)
        if (id > 0) ids.push([id, id])
        else if (last !== undefined && -id >= last[1]) last[1] = -id
        else lines.refuse(`component ${shown(name)}: ${id} ends a range that begins nowhere.`)
      }
    }
    if (isOfElements) this.#components.push({ name, ids })
  }

  /** A component names elements by ranges of their numbers. */
  #makeBlocks(): void {
    if (this.#components.length === 0) return
    const order = new IdOrder(this.#model.cellIds.values, this.#model.cellCount)
    for (const { name, ids } of this.#components) {
      const block = this.#model.block(name)
      order.forEachIn(
        ids.map(([first, last]) => ({ first, last, step: 1 })),
        cell => block.add(cell),
      )
    }
  }
}

function isMinusOne(lines: TextLines): boolean {
  return lines.text().trim() === '-1'
}
