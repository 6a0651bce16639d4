/** Abaqus: nodes, the frames that they are in, and nodes that are generated. */

import { RowPattern } from '../../core/reading-interface'
import { shown } from '../text-cursor'
import { unquoted } from './abaqus-keyword'
import { moveLine, moveOf } from './abaqus-moves'
import { type Reading, type Section, wholeNumber } from './abaqus-reading'
import type { IdRanges } from './id-ranges'
import { cross, minus, outOfFrame, rigidMove, scaled, unit, type Vector } from './movement'
import type { TextLines } from './text-lines'

const NODE_ROW = new RowPattern(['whole', ',', 'real', ',', 'real', ',', 'real', 'end'])

export function nodeSection(reading: Reading): Section {
  const { parameters } = reading.keyword
  const system = (parameters.get('SYSTEM') ?? 'R').toUpperCase()
  if (system.startsWith('S')) reading.lines.refuse('*NODE with SYSTEM=S, spherical coordinates, is not read here.')
  if (!/^[RC]/.test(system))
    reading.lines.refuse(`*NODE has an unknown SYSTEM ${shown(system)}: R, C or S was expected.`)
  const isCylindrical = system.startsWith('C')
  const set = parameters.get('NSET')
  const ids = reading.part.nodeSet(set)
  const isFar = isCylindrical || reading.frame !== null
  if (isFar)
    reading.notes.push('Coordinates in frames of their own are turned into global ones, and rounded to doubles.')
  return { line: () => nodeLine(reading, ids, isFar, isCylindrical) }
}

function nodeLine(reading: Reading, ids: IdRanges | null, isFar: boolean, isCylindrical: boolean): void {
  const lines = reading.lines
  const model = reading.part.model
  const rows = isFar ? null : lines.rows(NODE_ROW)
  if (rows !== null) {
    model.defineRows(lines, rows)
    reading.precision.seeAll(rows)
    for (let row = 0; row < rows.count; ++row) ids?.add(rows.numbers[rows.pattern.numberCount * row] as number)
    return
  }
  lines.splitAtCommas()
  const id = lines.id(0, 'a node number')
  if (lines.fieldCount > 8 || (lines.fieldCount === 8 && !lines.isFieldBlank(7)))
    lines.refuse(`node ${id} has ${lines.fieldCount - 1} numbers; 3 coordinates and a normal are expected at most.`)
  ids?.add(id)
  const x = lines.real(1, reading.precision)
  const y = lines.real(2, reading.precision)
  const z = lines.real(3, reading.precision)
  for (let field = 4; field < lines.fieldCount; ++field) lines.real(field)
  if (lines.fieldCount < 4) {
    model.defineShortNode(lines, id, [x, y].slice(0, lines.fieldCount - 1))
    return
  }
  if (lines.isFieldBlank(1) || lines.isFieldBlank(2) || lines.isFieldBlank(3)) {
    reading.notes.push('Blank coordinates are 0, as Abaqus reads them.')
    model.forgetPlaces()
  }
  if (isFar) {
    model.forgetPlaces()
    const angle = (y * Math.PI) / 180
    const local: Vector = isCylindrical ? [x * Math.cos(angle), x * Math.sin(angle), z] : [x, y, z]
    const global = reading.frame === null ? local : outOfFrame(reading.frame, local)
    model.defineNode(lines, id, ...global)
    return
  }
  const slot = model.defineNode(lines, id, x, y, z)
  model.placeFields(lines, slot, 1)
}

/** *SYSTEM: the frame of the nodes that follow. */
export function systemSection(reading: Reading): Section {
  const given: Vector[] = []
  reading.frame = null
  const line = () => {
    const isFirst = given.length === 0
    reading.lines.splitAtCommas()
    given.push(vector(reading.lines, 0))
    if (isFirst && hasNumbers(reading.lines, 3)) given.push(vector(reading.lines, 3))
  }
  const end = () => {
    const [origin, onX, inPlane] = given
    if (!origin) return
    if (!onX) {
      reading.frame = {
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
    if (x === null || normal === null) reading.lines.refuse('*SYSTEM: its points lie on a line.')
    reading.frame = { origin, axes: [x, cross(normal, x), normal] }
  }
  return { line, end }
}

function hasNumbers(lines: TextLines, from: number): boolean {
  return [from, from + 1, from + 2].some(field => !lines.isFieldBlank(field))
}

function vector(lines: TextLines, from: number): Vector {
  return [lines.real(from), lines.real(from + 1), lines.real(from + 2)]
}

/** *NGEN */
export function nodeLineSection(reading: Reading): Section {
  const { parameters } = reading.keyword
  const lines = reading.lines
  const curve = (parameters.get('LINE') ?? 'S').toUpperCase()
  if (curve !== 'S' || parameters.has('SYSTEM'))
    lines.refuse('*NGEN is read for straight lines only: not with LINE or SYSTEM.')
  const part = reading.part
  part.model.forgetPlaces()
  const set = parameters.get('NSET')
  const line = () => {
    const at = reading.lines
    at.splitAtCommas()
    const [first, last] = [at.id(0, 'a node number'), at.id(1, 'a node number')]
    const step = Math.abs(at.integer(2, 'an increment')) || 1
    part.generateLine(at, first, last, step, part.nodeSet(set))
  }
  return { line }
}

/** *NFILL */
export function nodeFillSection(reading: Reading): Section {
  const { parameters } = reading.keyword
  for (const name of ['SINGULAR', 'TWOSTEP'])
    if (parameters.has(name)) reading.lines.refuse(`*NFILL with ${name} is not read here.`)
  if (Number(parameters.get('BIAS') ?? 1) !== 1) reading.lines.refuse('*NFILL with BIAS is not read here.')
  const part = reading.part
  part.model.forgetPlaces()
  const set = parameters.get('NSET')
  const line = () => {
    const at = reading.lines
    at.splitAtCommas()
    const intervals = at.id(2, 'a number of intervals')
    const step = at.isFieldBlank(3) ? 1 : at.integer(3, 'an increment')
    const sets = [at.fieldText(0), at.fieldText(1)].map(name => part.sortedNodes(at, unquoted(name)))
    part.fill(at, sets[0] as number[], sets[1] as number[], intervals, step, part.nodeSet(set))
  }
  return { line }
}

/** *NCOPY */
export function nodeCopySection(reading: Reading): Section {
  const { parameters } = reading.keyword
  const lines: TextLines = reading.lines
  const line = lines.number
  for (const name of ['REFLECT', 'POLE'])
    if (parameters.has(name)) lines.refuse(`*NCOPY with ${name} is not read here; SHIFT is.`)
  if (!parameters.has('SHIFT')) lines.refuse('*NCOPY: SHIFT was expected.')
  const change = wholeNumber(reading, 'CHANGENUMBER')
  const multiple = parameters.has('MULTIPLE') ? wholeNumber(reading, 'MULTIPLE') : 1
  const part = reading.part
  part.model.forgetPlaces()
  const old = part.sortedNodes(lines, parameters.get('OLDSET') ?? '')
  const target = parameters.get('NEWSET')
  const moveLines: number[][] = []
  const end = () => {
    const { translation, rotation } = moveOf(moveLines, lines, line)
    if (multiple > 1 && rotation !== null && rotation.degrees !== 0)
      lines.refuse('*NCOPY with MULTIPLE and a rotation is not read here.', line)
    for (let k = 1; k <= multiple; ++k) {
      const move = rigidMove(scaled(translation, k), rotation)
      if (move === null) lines.refuse('the two points of the axis are the same.', line)
      part.copyNodes(lines, old, k * change, move, part.nodeSet(target))
    }
  }
  return { line: () => moveLines.push(moveLine(reading.lines)), end }
}
