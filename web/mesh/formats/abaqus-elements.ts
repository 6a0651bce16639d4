/** Abaqus: elements, those that are generated, and sets of nodes and elements. */

import { RowPattern } from '../../core/reading-interface'
import type { Runs } from '../runs'
import { type Context, type Section, wholeNumber } from './abaqus-context'
import { unquoted } from './abaqus-keyword'
import type { AbaqusPart } from './abaqus-part'
import { type AbaqusType, abaqusType, ORDER_OF_27 } from './abaqus-types'
import type { IdRanges } from './id-ranges'
import { ORDER_OF_20 } from './node-model'

const HEXAHEDRON_ROW = new RowPattern(['whole', ...Array.from({ length: 8 }, () => [',', 'whole']).flat(), 'end'])

export function elementSection(context: Context): Section {
  const { parameters } = context.keyword
  const written = parameters.get('TYPE')
  if (written === undefined || written === '')
    context.lines.refuse('*ELEMENT without TYPE: the type of the elements was expected.')
  const type = abaqusType(written)
  const set = parameters.get('ELSET')
  const part = context.part
  const into = set === undefined ? null : part.elementSet(set)
  return type.kind === 'other'
    ? otherSection(context, type, into?.ids ?? null)
    : hexahedronSection(context, type, written, into)
}

function hexahedronSection(
  context: Context,
  type: Exclude<AbaqusType, { kind: 'other' }>,
  written: string,
  into: { cells: Runs; ids: IdRanges } | null,
): Section {
  const { model } = context.part
  const slots = new Uint32Array(32)
  const fewest = type.kind === 'quadratic' ? type.fewest : type.nodes
  let id = -1
  let count = 0
  let line = 0
  const close = () => {
    if (count < fewest) context.lines.refuse(`element ${id} has ${count} nodes; ${written} has ${fewest}.`, line)
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
  const readLine = () => {
    const lines = context.lines
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
  const end = () => {
    if (id >= 0) close()
  }
  return { line: readLine, end }
}

function otherSection(context: Context, type: Extract<AbaqusType, { kind: 'other' }>, ids: IdRanges | null): Section {
  const part = context.part
  let id = -1
  let count = 0
  let line = 0
  const close = () => {
    if (type.nodes !== null && count < type.nodes)
      context.lines.refuse(`element ${id} has ${count} nodes; its type has ${type.nodes}.`, line)
    part.addOther(type.cell, id)
    ids?.add(id)
    id = -1
  }
  const readLine = () => {
    const lines = context.lines
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
  const end = () => {
    if (id >= 0) close()
  }
  return { line: readLine, end }
}

/** *ELGEN */
export function elementLineSection(context: Context): Section {
  const set = context.keyword.parameters.get('ELSET')
  const part = context.part
  part.model.forgetPlaces()
  const line = () => {
    const lines = context.lines
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
  return { line }
}

/** *ELCOPY */
export function copyElements(context: Context): void {
  const { parameters } = context.keyword
  if (parameters.has('REFLECT')) context.lines.refuse('*ELCOPY with REFLECT is not read here.')
  const target = parameters.get('NEWSET')
  context.part.copyElements(
    context.lines,
    parameters.get('OLDSET') ?? '',
    wholeNumber(context, 'ELEMENTSHIFT'),
    wholeNumber(context, 'SHIFTNODES'),
    target === undefined ? null : context.part.elementSet(target),
  )
}

/** *NSET and *ELSET. Null where the set has no numbers of its own. */
export function setSection(context: Context, kind: 'NSET' | 'ELSET', part: AbaqusPart): Section | null {
  const { parameters } = context.keyword
  const name = parameters.get(kind)
  if (name === undefined) context.lines.refuse(`*${kind} without ${kind}: the name of the set was expected.`)
  const { ids, names } =
    kind === 'NSET' ? part.nodeSetWithNames(name) : part.elementSet(name, parameters.has('INTERNAL'))
  if (kind === 'NSET' && parameters.has('ELSET')) return null
  const isGenerated = parameters.has('GENERATE')
  const line = () => {
    const lines = context.lines
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
  return { line }
}
