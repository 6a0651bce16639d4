/**
 * Abaqus and CalculiX input files: parts and their instances, nodes, elements, sets, what is included and what is generated. What moves or
 * makes nodes and is not read here is refused by its name.
 */
import type { Mesh } from '../mesh'
import { PrintedDigits } from '../precision'
import { type FileRows, RowPattern } from '../reading-core'
import type { Runs } from '../runs'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown } from '../text-cursor'
import { type Keyword, keywordOf, unquoted } from './abaqus-keyword'
import { AbaqusPart } from './abaqus-part'
import { type AbaqusType, abaqusType, ORDER_OF_20, ORDER_OF_27 } from './abaqus-types'
import type { IdRanges } from './id-ranges'
import { cross, type Frame, minus, outOfFrame, type Rotation, rigidMove, scaled, unit, type Vector } from './movement'
import { collect, type Placement } from './node-model'
import { TextLines } from './text-lines'

const STAR = 42
const DEEPEST_INCLUDE = 16

/** Options that make, move or bring nodes and elements in ways that are not read. */
const REFUSED = new Set([
  ...['NMAP', 'IMPORT', 'IMPORTNODESET', 'IMPORTELSET', 'SYMMETRICMODELGENERATION', 'SUBSTRUCTUREGENERATE'],
  ...['SOLIDELEMENTGENERATION', 'TRANSFORMNODES'],
])

const passOver = () => {}

const NODE_ROW = new RowPattern(['whole', ',', 'real', ',', 'real', ',', 'real', 'end'])
const HEXAHEDRON_ROW = new RowPattern(['whole', ...Array.from({ length: 8 }, () => [',', 'whole']).flat(), 'end'])

/** The first number of each row. */
function addFirst({ pattern, count, numbers }: FileRows, ids: IdRanges): void {
  for (let row = 0; row < count; ++row) ids.add(numbers[pattern.numberCount * row] as number)
}

interface Instance {
  readonly name: string
  readonly partName: string
  /** What is defined in the instance itself. */
  readonly own: AbaqusPart
  readonly moveLines: number[][]
  readonly line: number
  readonly lines: TextLines
}

export const abaqus: MeshFormat = {
  name: 'Abaqus',
  recognizes(head, name) {
    const text = headText(head)
    if (/^[> \t]*\*(?:KEYWORD\b|ELEMENT_|PART_|SECTION_|CONTROL_|MAT_)/im.test(text)) return 'no'
    if (/^[> \t]*\*ELEMENT[ \t]*,/im.test(text)) return 'yes'
    const isDyna = /\.(?:k|key|dyn)$/.test(name)
    if (/^[> \t]*\*NODE[ \t]*(?:,|\r?$)/im.test(text)) return isDyna ? 'maybe' : 'yes'
    if (/^[> \t]*\*(?:HEADING|PART|INCLUDE|ASSEMBLY|NGEN)\b/im.test(text) && !isDyna)
      return name.endsWith('.inp') ? 'yes' : 'maybe'
    return name.endsWith('.inp') && /^[ \t]*\*[a-z]/im.test(text) ? 'maybe' : 'no'
  },
  read: (file, options) => [new AbaqusReader(file, options).read()],
}

class AbaqusReader {
  readonly #file: MeshFile
  readonly #options: ReadOptions
  readonly #precision = new PrintedDigits()
  readonly #notes: string[] = []
  readonly #parts = new Map<string, { name: string; part: AbaqusPart }>()
  readonly #instances: Instance[] = []
  readonly #global = new AbaqusPart()
  #isCutOff = false

  #part = this.#global
  #lines: TextLines
  #keyword: Keyword = { name: '', written: '', parameters: new Map() }
  /** What a data line of the keyword is for. */
  #readLine: () => void = passOver
  #finish: () => void = passOver
  #frame: Frame | null = null
  #isFar = false

  constructor(file: MeshFile, options: ReadOptions) {
    this.#file = file
    this.#options = options
    this.#lines = new TextLines(file, options)
  }

  read(): Mesh {
    this.#readLines(0)
    this.#finish()
    return collect({
      format: 'Abaqus',
      fileName: this.#file.name,
      placements: this.#placements(),
      precision: this.#precision,
      notes: this.#notes,
      isCutOff: this.#isCutOff,
    })
  }

  #readLines(depth: number): void {
    const lines = this.#lines
    let blank = 0
    while (lines.next()) {
      if (lines.isBlank) {
        blank = lines.number
        continue
      }
      let first = 0
      while (lines.at(first) <= 32) first++
      if (lines.at(first) === STAR) {
        if (lines.at(first + 1) === STAR) continue
        this.#finish()
        this.#finish = passOver
        this.#readLine = passOver
        this.#keyword = this.#nextKeyword()
        this.#start(depth)
      } else if (lines.isElision) {
        this.#isCutOff = true
        this.#part.model.forgetPlaces()
      } else if (blank > 0 && this.#readLine !== passOver && lines.isProseAfter(blank)) {
        this.#finish()
        this.#finish = passOver
        this.#readLine = passOver
        this.#notes.push(`Line ${lines.number} is text: what follows it, up to the next keyword, is passed over.`)
      } else this.#readLine()
    }
  }

  /** The keyword of this line, which goes on after a comma at its end. */
  #nextKeyword(): Keyword {
    const lines = this.#lines
    let text = lines.text()
    while (text.endsWith(',') && text.length < 65_536 && lines.next()) {
      const more = lines.text().trim()
      if (more.startsWith('**')) continue
      if (!/^[a-z]/i.test(more)) {
        lines.hold()
        break
      }
      text += more
    }
    return keywordOf(text.trim())
  }

  #start(depth: number): void {
    const { name, written, parameters } = this.#keyword
    const lines = this.#lines
    switch (name) {
      case 'NODE':
        this.#startNodes(depth)
        break
      case 'ELEMENT':
        this.#startElements(depth)
        break
      case 'INCLUDE':
        this.#include(parameters.get('INPUT') ?? '', depth)
        break
      case 'NSET':
        this.#startSet('NSET')
        break
      case 'ELSET':
        this.#startSet('ELSET')
        break
      case 'PART':
        this.#startPart()
        break
      case 'INSTANCE':
        this.#startInstance()
        break
      case 'ENDPART':
      case 'ENDINSTANCE':
      case 'ASSEMBLY':
      case 'ENDASSEMBLY':
        this.#part = this.#global
        this.#frame = null
        break
      case 'SYSTEM':
        this.#startSystem()
        break
      case 'NGEN':
        this.#startNodeLines()
        break
      case 'NFILL':
        this.#startNodeFill()
        break
      case 'NCOPY':
        this.#startNodeCopy()
        break
      case 'ELGEN':
        this.#startElementLines()
        break
      case 'ELCOPY':
        this.#copyElements()
        break
      case 'IMPERFECTION':
        this.#notes.push('*IMPERFECTION moves nodes in the analysis; the nodes are read as they are written.')
        break
      default:
        if (REFUSED.has(name))
          lines.refuse(`${shown(written)} is not read here: write the nodes and elements themselves.`)
    }
  }

  // Files

  #include(name: string, depth: number): void {
    const lines: TextLines = this.#lines
    const { written } = this.#keyword
    if (name === '') lines.refuse(`${shown(written)} names no file: INPUT=name was expected.`)
    if (depth >= DEEPEST_INCLUDE)
      lines.refuse(`${shown(written)} of ${shown(name)}: files are included ${DEEPEST_INCLUDE} deep.`)
    const file = this.#options.find(name)
    if (file === null)
      lines.refuse(`${shown(written)} names ${shown(name)}, which is missing: give it together with this file.`)
    this.#global.model.forgetPlaces()
    this.#lines = new TextLines(file, this.#options)
    this.#readLines(depth + 1)
    this.#lines = lines
  }

  #dataFile(depth: number): void {
    const name = this.#keyword.parameters.get('INPUT')
    if (name !== undefined) this.#include(name, depth)
  }

  // Nodes

  #startNodes(depth: number): void {
    const { parameters } = this.#keyword
    const system = (parameters.get('SYSTEM') ?? 'R').toUpperCase()
    if (system.startsWith('S')) this.#lines.refuse('*NODE with SYSTEM=S, spherical coordinates, is not read here.')
    if (!/^[RC]/.test(system))
      this.#lines.refuse(`*NODE has an unknown SYSTEM ${shown(system)}: R, C or S was expected.`)
    const isCylindrical = system.startsWith('C')
    const set = parameters.get('NSET')
    const ids = set === undefined ? null : this.#part.nodeSet(set)
    this.#isFar = isCylindrical || this.#frame !== null
    if (this.#isFar)
      this.#notes.push('Coordinates in frames of their own are turned into global ones, and rounded to doubles.')
    this.#readLine = () => this.#nodeLine(ids, isCylindrical)
    this.#dataFile(depth)
  }

  #nodeLine(ids: IdRanges | null, isCylindrical: boolean): void {
    const lines = this.#lines
    const model = this.#part.model
    const rows = this.#isFar ? null : lines.rows(NODE_ROW)
    if (rows !== null) {
      model.defineRows(lines, rows)
      this.#precision.seeAll(rows)
      if (ids !== null) addFirst(rows, ids)
      return
    }
    lines.splitAtCommas()
    const id = lines.id(0, 'a node number')
    if (lines.fieldCount > 8 || (lines.fieldCount === 8 && !lines.isFieldBlank(7)))
      lines.refuse(`node ${id} has ${lines.fieldCount - 1} numbers; 3 coordinates and a normal are expected at most.`)
    ids?.add(id)
    const x = lines.real(1, this.#precision)
    const y = lines.real(2, this.#precision)
    const z = lines.real(3, this.#precision)
    for (let field = 4; field < lines.fieldCount; ++field) lines.real(field)
    if (lines.fieldCount < 4) {
      model.defineShortNode(lines, id, [x, y].slice(0, lines.fieldCount - 1))
      return
    }
    if (lines.isFieldBlank(1) || lines.isFieldBlank(2) || lines.isFieldBlank(3)) {
      this.#notes.push('Blank coordinates are 0, as Abaqus reads them.')
      model.forgetPlaces()
    }
    if (this.#isFar) {
      model.forgetPlaces()
      const angle = (y * Math.PI) / 180
      const local: Vector = isCylindrical ? [x * Math.cos(angle), x * Math.sin(angle), z] : [x, y, z]
      const global = this.#frame === null ? local : outOfFrame(this.#frame, local)
      model.defineNode(lines, id, ...global)
      return
    }
    const slot = model.defineNode(lines, id, x, y, z)
    model.placeFields(lines, slot, 1)
  }

  #startSystem(): void {
    const given: Vector[] = []
    this.#frame = null
    this.#readLine = () => {
      const isFirst = given.length === 0
      this.#lines.splitAtCommas()
      given.push(this.#vector(0))
      if (isFirst && this.#hasNumbers(3)) given.push(this.#vector(3))
    }
    this.#finish = () => {
      const [origin, onX, inPlane] = given
      if (!origin) return
      if (!onX) {
        this.#frame = {
          origin,
          axes: [
            [1, 0, 0],
            [0, 1, 0],
            [0, 0, 1],
          ],
        }
        return
      }
      const along = minus(onX, origin)
      const x = unit(inPlane ? along : [along[0], along[1], 0])
      const normal: Vector | null = inPlane ? unit(cross(along, minus(inPlane, origin))) : [0, 0, 1]
      if (x === null || normal === null) this.#lines.refuse('*SYSTEM: its points lie on a line.')
      this.#frame = { origin, axes: [x, cross(normal, x), normal] }
    }
  }

  #hasNumbers(from: number): boolean {
    return [from, from + 1, from + 2].some(field => !this.#lines.isFieldBlank(field))
  }

  #vector(from: number): Vector {
    const lines = this.#lines
    return [lines.real(from), lines.real(from + 1), lines.real(from + 2)]
  }

  #startNodeLines(): void {
    const { parameters } = this.#keyword
    const lines = this.#lines
    const curve = (parameters.get('LINE') ?? 'S').toUpperCase()
    if (curve !== 'S' || parameters.has('SYSTEM'))
      lines.refuse('*NGEN is read for straight lines only: not with LINE or SYSTEM.')
    const part = this.#part
    part.model.forgetPlaces()
    const set = parameters.get('NSET')
    this.#readLine = () => {
      const at = this.#lines
      at.splitAtCommas()
      const [first, last] = [at.id(0, 'a node number'), at.id(1, 'a node number')]
      const step = Math.abs(at.integer(2, 'an increment')) || 1
      part.generateLine(at, first, last, step, set === undefined ? null : part.nodeSet(set))
    }
  }

  #startNodeFill(): void {
    const { parameters } = this.#keyword
    for (const name of ['SINGULAR', 'TWOSTEP'])
      if (parameters.has(name)) this.#lines.refuse(`*NFILL with ${name} is not read here.`)
    if (Number(parameters.get('BIAS') ?? 1) !== 1) this.#lines.refuse('*NFILL with BIAS is not read here.')
    const part = this.#part
    part.model.forgetPlaces()
    const set = parameters.get('NSET')
    this.#readLine = () => {
      const at = this.#lines
      at.splitAtCommas()
      const intervals = at.id(2, 'a number of intervals')
      const step = at.isFieldBlank(3) ? 1 : at.integer(3, 'an increment')
      const sets = [at.fieldText(0), at.fieldText(1)].map(name => part.sortedNodes(at, unquoted(name)))
      part.fill(
        at,
        sets[0] as number[],
        sets[1] as number[],
        intervals,
        step,
        set === undefined ? null : part.nodeSet(set),
      )
    }
  }

  #startNodeCopy(): void {
    const { parameters } = this.#keyword
    const lines: TextLines = this.#lines
    const line = lines.number
    for (const name of ['REFLECT', 'POLE'])
      if (parameters.has(name)) lines.refuse(`*NCOPY with ${name} is not read here; SHIFT is.`)
    if (!parameters.has('SHIFT')) lines.refuse('*NCOPY: SHIFT was expected.')
    const change = this.#whole('CHANGENUMBER')
    const multiple = parameters.has('MULTIPLE') ? this.#whole('MULTIPLE') : 1
    const part = this.#part
    part.model.forgetPlaces()
    const old = part.sortedNodes(lines, parameters.get('OLDSET') ?? '')
    const target = parameters.get('NEWSET')
    const moveLines: number[][] = []
    this.#readLine = () => this.#moveLine(moveLines)
    this.#finish = () => {
      const { translation, rotation } = this.#moveOf(moveLines, lines, line)
      if (multiple > 1 && rotation !== null && rotation.degrees !== 0)
        lines.refuse('*NCOPY with MULTIPLE and a rotation is not read here.', line)
      for (let k = 1; k <= multiple; ++k) {
        const move = rigidMove(scaled(translation, k), rotation)
        if (move === null) lines.refuse('the two points of the axis are the same.', line)
        part.copyNodes(lines, old, k * change, move, target === undefined ? null : part.nodeSet(target))
      }
    }
  }

  #whole(parameter: string): number {
    const text = this.#keyword.parameters.get(parameter) ?? ''
    if (!/^[-+]?\d{1,15}$/.test(text))
      this.#lines.refuse(`${shown(this.#keyword.written)}: ${parameter} with a whole number was expected.`)
    return Number(text)
  }

  // Moves

  #moveLine(into: number[][]): void {
    const lines = this.#lines
    lines.splitAtCommas()
    into.push(Array.from({ length: Math.max(lines.fieldCount, 7) }, (_, i) => lines.real(i)))
  }

  #moveOf(
    moveLines: readonly number[][],
    lines: TextLines,
    line: number,
  ): { translation: Vector; rotation: Rotation | null } {
    const [shift = [], turn] = moveLines
    if (moveLines.length > 2 || shift.slice(3).some(value => value !== 0))
      lines.refuse('a move is a line of 3 numbers and, for a rotation, one of 7.', line)
    const part = (list: readonly number[], from: number): Vector => [
      list[from] ?? 0,
      list[from + 1] ?? 0,
      list[from + 2] ?? 0,
    ]
    return {
      translation: part(shift, 0),
      rotation: turn && (turn[6] ?? 0) !== 0 ? { from: part(turn, 0), to: part(turn, 3), degrees: turn[6] ?? 0 } : null,
    }
  }

  // Elements

  #startElements(depth: number): void {
    const { parameters } = this.#keyword
    const written = parameters.get('TYPE')
    if (written === undefined || written === '')
      this.#lines.refuse('*ELEMENT without TYPE: the type of the elements was expected.')
    const type = abaqusType(written)
    const set = parameters.get('ELSET')
    const part = this.#part
    const into = set === undefined ? null : part.elementSet(set)
    if (type.kind === 'other') this.#startOthers(type, into?.ids ?? null)
    else this.#startHexahedra(type, written, into)
    this.#dataFile(depth)
  }

  #startHexahedra(
    type: Exclude<AbaqusType, { kind: 'other' }>,
    written: string,
    into: { cells: Runs; ids: IdRanges } | null,
  ): void {
    const { model } = this.#part
    const slots = new Uint32Array(32)
    const fewest = type.kind === 'quadratic' ? type.fewest : type.nodes
    let id = -1
    let count = 0
    let line = 0
    const close = () => {
      if (count < fewest) this.#lines.refuse(`element ${id} has ${count} nodes; ${written} has ${fewest}.`, line)
      if (type.kind === 'hexahedron') {
        const cell = model.addHexahedron(id, slots)
        into?.cells.add(cell)
      } else {
        const order = type.nodes === 27 ? ORDER_OF_27 : ORDER_OF_20
        model.addQuadratic(
          id,
          slots,
          order.map(at => (at < count ? at : -1)),
        )
        into?.ids.add(id)
      }
      id = -1
    }
    this.#readLine = () => {
      const lines = this.#lines
      const rows = id < 0 && type.kind === 'hexahedron' ? lines.rows(HEXAHEDRON_ROW) : null
      if (rows !== null) {
        const first = model.addRows(rows)
        for (let row = 0; row < rows.count; ++row) into?.cells.add(first + row)
        return
      }
      lines.splitAtCommas()
      let fields = lines.fieldCount
      const goesOn = lines.isFieldBlank(fields - 1)
      if (goesOn) fields--
      let field = 0
      if (id < 0) {
        id = lines.id(0, 'an element number')
        line = lines.number
        count = 0
        field = 1
      }
      if (count + fields - field > type.nodes)
        lines.refuse(`element ${id} has more than the ${type.nodes} nodes of ${written}.`)
      for (; field < fields; ++field) slots[count++] = model.slot(lines.id(field, 'a node number'))
      if (count === type.nodes || !(goesOn || fields === 16)) close()
    }
    this.#finish = () => {
      if (id >= 0) close()
    }
  }

  #startOthers(type: Extract<AbaqusType, { kind: 'other' }>, ids: IdRanges | null): void {
    const part = this.#part
    let id = -1
    let count = 0
    let line = 0
    const close = () => {
      if (type.nodes !== null && count < type.nodes)
        this.#lines.refuse(`element ${id} has ${count} nodes; its type has ${type.nodes}.`, line)
      part.addOther(type.cell, id)
      ids?.add(id)
      id = -1
    }
    this.#readLine = () => {
      const lines = this.#lines
      lines.splitAtCommas()
      let fields = lines.fieldCount
      const goesOn = lines.isFieldBlank(fields - 1)
      if (goesOn) fields--
      if (id < 0) {
        id = lines.id(0, 'an element number')
        line = lines.number
        count = fields - 1
      } else count += fields
      if (type.nodes !== null && count >= type.nodes) close()
      else if (!goesOn && fields < 16) close()
    }
    this.#finish = () => {
      if (id >= 0) close()
    }
  }

  #startElementLines(): void {
    const set = this.#keyword.parameters.get('ELSET')
    const part = this.#part
    part.model.forgetPlaces()
    this.#readLine = () => {
      const lines = this.#lines
      lines.splitAtCommas()
      const master = lines.id(0, 'an element number')
      const whole = (field: number) => (lines.isFieldBlank(field) ? 1 : lines.integer(field, 'a whole number'))
      const directions = [1, 4, 7].map(field => ({
        count: whole(field),
        nodeStep: whole(field + 1),
        elementStep: whole(field + 2),
      }))
      part.generateElements(lines, master, directions, set === undefined ? null : part.elementSet(set))
    }
  }

  #copyElements(): void {
    const { parameters } = this.#keyword
    if (parameters.has('REFLECT')) this.#lines.refuse('*ELCOPY with REFLECT is not read here.')
    const target = parameters.get('NEWSET')
    this.#part.copyElements(
      this.#lines,
      parameters.get('OLDSET') ?? '',
      this.#whole('ELEMENTSHIFT'),
      this.#whole('SHIFTNODES'),
      target === undefined ? null : this.#part.elementSet(target),
    )
  }

  // Sets

  #startSet(kind: 'NSET' | 'ELSET'): void {
    const { parameters } = this.#keyword
    const name = parameters.get(kind)
    if (name === undefined) this.#lines.refuse(`*${kind} without ${kind}: the name of the set was expected.`)
    const instance = parameters.get('INSTANCE')
    const part = instance === undefined ? this.#part : this.#partOfInstance(instance)
    if (part === null) return
    const { ids, names } =
      kind === 'NSET' ? part.nodeSetWithNames(name) : part.elementSet(name, parameters.has('INTERNAL'))
    if (kind === 'NSET' && parameters.has('ELSET')) return
    const isGenerated = parameters.has('GENERATE')
    this.#readLine = () => {
      const lines = this.#lines
      lines.splitAtCommas()
      if (isGenerated) {
        const first = lines.id(0, 'a number')
        const last = lines.isFieldBlank(1) ? first : lines.id(1, 'a number')
        const step = lines.isFieldBlank(2) ? 1 : Math.abs(lines.integer(2, 'an increment'))
        if (last < first || step === 0) lines.refuse(`a set cannot be generated from ${first} to ${last} by ${step}.`)
        ids.addRange(first, last, step)
        return
      }
      for (let field = 0; field < lines.fieldCount; ++field) {
        if (lines.isFieldBlank(field)) continue
        const byte = lines.bytes[lines.fieldFrom(field)] as number
        const isNumber = byte >= 48 && byte <= 57 && /^\d+$/.test(lines.fieldText(field))
        if (isNumber) ids.add(lines.id(field, 'a number'))
        else names.push(unquoted(lines.fieldText(field)))
      }
    }
  }

  /** Sets of an instance that an assembly names. */
  #partOfInstance(name: string): AbaqusPart | null {
    const instance = this.#instances.find(other => other.name.toUpperCase() === name.toUpperCase())
    return instance?.own ?? null
  }

  // Parts

  #startPart(): void {
    const name = this.#keyword.parameters.get('NAME') ?? ''
    const key = name.toUpperCase()
    if (this.#parts.has(key)) this.#lines.refuse(`part ${shown(name)} is defined twice.`)
    this.#part = new AbaqusPart()
    this.#frame = null
    this.#parts.set(key, { name, part: this.#part })
  }

  #startInstance(): void {
    const { parameters } = this.#keyword
    const lines = this.#lines
    const [name, partName] = [parameters.get('NAME') ?? '', parameters.get('PART') ?? '']
    if (parameters.has('LIBRARY') || parameters.has('INSTANCE'))
      lines.refuse('*INSTANCE from the library of another analysis is not read here.')
    if (this.#instances.some(other => other.name.toUpperCase() === name.toUpperCase()))
      lines.refuse(`instance ${shown(name)} is defined twice.`)
    const moveLines: number[][] = []
    const instance: Instance = { name, partName, own: new AbaqusPart(), moveLines, line: lines.number, lines }
    this.#instances.push(instance)
    this.#part = instance.own
    this.#frame = null
    this.#readLine = () => this.#moveLine(moveLines)
  }

  #placements(): Placement[] {
    const placements: Placement[] = []
    if (!this.#global.model.isEmpty || this.#parts.size === 0) placements.push(this.#placed(this.#global, null))
    for (const instance of this.#instances) placements.push(...this.#instancePlacements(instance))
    const placed = new Set(this.#instances.map(({ partName }) => partName.toUpperCase()))
    for (const [key, { name, part }] of this.#parts) {
      if (placed.has(key)) continue
      if (this.#instances.length === 0) {
        placements.push(this.#placed(part, name))
        this.#notes.push('The text has parts and no assembly: each part is read once, where it was drawn.')
      } else if (part.model.cellCount > 0)
        this.#notes.push(
          `Part ${shown(name)} has no instance: its ${part.model.cellCount} hexahedra are not in the assembly.`,
        )
    }
    return placements
  }

  #placed(part: AbaqusPart, name: string | null): Placement {
    part.finishSets()
    return { model: part.model, name, move: null }
  }

  #instancePlacements({ name, partName, own, moveLines, line, lines }: Instance): Placement[] {
    const part = this.#parts.get(partName.toUpperCase())?.part
    if (part === undefined && own.model.isEmpty)
      lines.refuse(`instance ${shown(name)} is of part ${shown(partName)}, which is not defined.`, line)
    const { translation, rotation } = this.#moveOf(moveLines, lines, line)
    const isMoved = translation.some(value => value !== 0) || rotation !== null
    const move = isMoved ? rigidMove(translation, rotation) : null
    if (isMoved && move === null)
      lines.refuse(`instance ${shown(name)}: the two points of its axis are the same.`, line)
    if (isMoved) this.#notes.push('Instances are moved as the assembly says; their coordinates are rounded to doubles.')
    const placements: Placement[] = []
    const hasPart = part !== undefined && !part.model.isEmpty
    if (hasPart && (own.model.cellCount > 0 || own.model.others.size > 0) && own.model.nodeCount > 0)
      lines.refuse(
        `instance ${shown(name)} has elements of its own besides those of its part: this is not read here.`,
        line,
      )
    if (hasPart && part) {
      part.finishSets()
      placements.push({ model: part.model, name, move, blocks: this.#isCutOff ? new Map() : own.cellsOfSets(part) })
    }
    if (!own.model.isEmpty) {
      own.finishSets()
      placements.push({ model: own.model, name, move })
    }
    return placements
  }
}
