/** Abaqus: nodes, the frames that they are in, and nodes that are generated. */

import { RowPattern } from '../../core/reading-interface'
import { shown } from '../text-cursor'
import { type Context, type Section, wholeNumber } from './abaqus-context'
import { unquoted } from './abaqus-keyword'
import { moveLine, moveOf } from './abaqus-moves'
import type { IdRanges } from './id-ranges'
import { cross, minus, outOfFrame, rigidMove, scaled, unit, type Vector } from './movement'
import type { TextLines } from './text-lines'

const NODE_ROW = new RowPattern(['whole', ',', 'real', ',', 'real', ',', 'real', 'end'])

export function nodeSection(context: Context): Section {
  const { parameters } = context.keyword
  const system = (parameters.get('SYSTEM') ?? 'R').toUpperCase()
  if (system.startsWith('S')) context.lines.refuse('*NODE with SYSTEM=S, spherical coordinates, is not read here.')
  if (!/^[RC]/.test(system))
    context.lines.refuse(`*NODE has an unknown SYSTEM ${shown(system)}: R, C or S was expected.`)
  const isCylindrical = system.startsWith('C')
  const set = parameters.get('NSET')
  const ids = context.part.nodeSet(set)
  const isFar = isCylindrical || context.frame !== null
  if (isFar)
    context.notes.push('Coordinates in frames of their own are turned into global ones, and rounded to doubles.')
  return { line: () => nodeLine(context, ids, isFar, isCylindrical) }
}

function nodeLine(context: Context, ids: IdRanges | null, isFar: boolean, isCylindrical: boolean): void {
  const lines = context.lines
  const model = context.part.model
  const rows = isFar ? null : lines.rows(NODE_ROW)
  if (rows !== null) {
    model.defineRows(lines, rows)
    context.precision.seeAll(rows)
    for (let row = 0; row < rows.count; ++row) ids?.add(rows.numbers[rows.pattern.numberCount * row] as number)
    return
  }
  lines.splitAtCommas()
  const id = lines.id(0, 'a node number')
  if (lines.fieldCount > 8 || (lines.fieldCount === 8 && !lines.isFieldBlank(7)))
    lines.refuse(`node ${id} has ${lines.fieldCount - 1} numbers; 3 coordinates and a normal are expected at most.`)
  ids?.add(id)
  const x = lines.real(1, context.precision)
  const y = lines.real(2, context.precision)
  const z = lines.real(3, context.precision)
  for (let field = 4; field < lines.fieldCount; ++field) lines.real(field)
  if (lines.fieldCount < 4) {
    model.defineShortNode(lines, id, [x, y].slice(0, lines.fieldCount - 1))
    return
  }
  if (lines.isFieldBlank(1) || lines.isFieldBlank(2) || lines.isFieldBlank(3)) {
    context.notes.push('Blank coordinates are 0, as Abaqus reads them.')
    model.forgetPlaces()
  }
  if (isFar) {
    model.forgetPlaces()
    const angle = (y * Math.PI) / 180
    const local: Vector = isCylindrical ? [x * Math.cos(angle), x * Math.sin(angle), z] : [x, y, z]
    const global = context.frame === null ? local : outOfFrame(context.frame, local)
    model.defineNode(lines, id, ...global)
    return
  }
  const slot = model.defineNode(lines, id, x, y, z)
  model.placeFields(lines, slot, 1)
}

/** *SYSTEM: the frame of the nodes that follow. */
export function systemSection(context: Context): Section {
  const given: Vector[] = []
  context.frame = null
  const line = () => {
    const isFirst = given.length === 0
    context.lines.splitAtCommas()
    given.push(vector(context.lines, 0))
    if (isFirst && hasNumbers(context.lines, 3)) given.push(vector(context.lines, 3))
  }
  const end = () => {
    const [origin, onX, inPlane] = given
    if (!origin) return
    if (!onX) {
      context.frame = {
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
    if (x === null || normal === null) context.lines.refuse('*SYSTEM: its points lie on a line.')
    context.frame = { origin, axes: [x, cross(normal, x), normal] }
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
export function nodeLineSection(context: Context): Section {
  const { parameters } = context.keyword
  const lines = context.lines
  const curve = (parameters.get('LINE') ?? 'S').toUpperCase()
  if (curve !== 'S' || parameters.has('SYSTEM'))
    lines.refuse('*NGEN is read for straight lines only: not with LINE or SYSTEM.')
  const part = context.part
  part.model.forgetPlaces()
  const set = parameters.get('NSET')
  const line = () => {
    const at = context.lines
    at.splitAtCommas()
    const [first, last] = [at.id(0, 'a node number'), at.id(1, 'a node number')]
    const step = Math.abs(at.integer(2, 'an increment')) || 1
    part.generateLine(at, first, last, step, part.nodeSet(set))
  }
  return { line }
}

/** *NFILL */
export function nodeFillSection(context: Context): Section {
  const { parameters } = context.keyword
  for (const name of ['SINGULAR', 'TWOSTEP'])
    if (parameters.has(name)) context.lines.refuse(`*NFILL with ${name} is not read here.`)
  if (Number(parameters.get('BIAS') ?? 1) !== 1) context.lines.refuse('*NFILL with BIAS is not read here.')
  const part = context.part
  part.model.forgetPlaces()
  const set = parameters.get('NSET')
  const line = () => {
    const at = context.lines
    at.splitAtCommas()
    const intervals = at.id(2, 'a number of intervals')
    const step = at.isFieldBlank(3) ? 1 : at.integer(3, 'an increment')
    const sets = [at.fieldText(0), at.fieldText(1)].map(name => part.sortedNodes(at, unquoted(name)))
    part.fill(at, sets[0] as number[], sets[1] as number[], intervals, step, part.nodeSet(set))
  }
  return { line }
}

/** *NCOPY */
export function nodeCopySection(context: Context): Section {
  const { parameters } = context.keyword
  const lines: TextLines = context.lines
  const line = lines.number
  for (const name of ['REFLECT', 'POLE'])
    if (parameters.has(name)) lines.refuse(`*NCOPY with ${name} is not read here; SHIFT is.`)
  if (!parameters.has('SHIFT')) lines.refuse('*NCOPY: SHIFT was expected.')
  const change = wholeNumber(context, 'CHANGENUMBER')
  const multiple = parameters.has('MULTIPLE') ? wholeNumber(context, 'MULTIPLE') : 1
  const part = context.part
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
  return { line: () => moveLines.push(moveLine(context.lines)), end }
}
