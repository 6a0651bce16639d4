/** Ansys's elements: the types that a file defines, and what becomes of an element of each. */
import { type AnsysType, ansysType } from './ansys-types'
import { isRepeating, type NodeModel, ORDER_OF_20 } from './node-model'
import type { TextLines } from './text-lines'

/** Nodes of the largest element. */
export const MOST_NODES = 32

const HEXAHEDRON: AnsysType = { kind: 'hexahedron' }
const QUADRATIC: AnsysType = { kind: 'quadratic' }

export class AnsysElements {
  readonly #lines: TextLines
  readonly #model: NodeModel
  readonly #notes: string[]
  readonly #routines = new Map<number, number>()
  readonly #firstOptions = new Map<number, number>()
  readonly #types = new Map<number, AnsysType | null>()
  readonly #slots = new Uint32Array(MOST_NODES)
  /** The type of elements that do not name theirs. */
  currentType = 1
  /** Hexahedra that repeat nodes. */
  degenerate = 0

  constructor(lines: TextLines, model: NodeModel, notes: string[]) {
    this.#lines = lines
    this.#model = model
    this.#notes = notes
  }

  defineType(type: number, routine: number): void {
    this.#routines.set(type, routine)
  }

  setFirstOption(type: number, option: number): void {
    this.#firstOptions.set(type, option)
  }

  /** Null for a type that is not defined. */
  typeOf(type = this.currentType): AnsysType | null {
    const known = this.#types.get(type)
    if (known !== undefined) return known
    const routine = this.#routines.get(type)
    const found = routine === undefined ? null : ansysType(routine, this.#firstOptions.get(type) ?? 0)
    if (routine === undefined)
      this.#notes.push(`Type ${type} of elements is not defined: those of 8 nodes are taken for hexahedra.`)
    else if (found === null)
      this.#notes.push(`Elements of type ${routine} are not known here: they are counted as "other".`)
    const taken = found ?? (routine === undefined ? null : ({ kind: 'other', cell: 'other' } as const))
    this.#types.set(type, taken)
    return taken
  }

  /** Adds an element with the first `count` of these nodes, which begins in this line. */
  add(id: number, type: AnsysType | null, nodes: Float64Array, count: number, line: number): void {
    const model = this.#model
    const slots = this.#slots
    const kind = type ?? (count === 8 ? HEXAHEDRON : count === 20 ? QUADRATIC : null)
    if (kind === null) {
      model.addOther(count === 10 ? 'tetrahedron' : 'other')
    } else if (kind.kind === 'other') {
      model.addOther(kind.cell)
    } else if (kind.kind === 'face') {
      model.addOther(count === 3 || count === 6 || nodes[2] === nodes[3] ? 'triangle' : 'quadrilateral')
    } else if (count < 8) {
      model.addOther(count === 4 ? 'tetrahedron' : count === 5 ? 'pyramid' : count === 6 ? 'wedge' : 'other')
    } else if (kind.kind === 'quadratic' && count === 10) {
      model.addOther('tetrahedron')
    } else {
      for (let i = 0; i < 8; ++i)
        if (nodes[i] === 0) this.#lines.refuse(`element ${id} has node 0 among its first 8.`, line)
      for (let i = 0; i < count; ++i) slots[i] = nodes[i] === 0 ? 0 : model.slot(nodes[i] as number)
      if (isRepeating(nodes)) this.degenerate++
      if (kind.kind === 'quadratic')
        model.addQuadratic(
          id,
          slots,
          ORDER_OF_20.map(at => (at < count && nodes[at] !== 0 ? at : -1)),
        )
      else if (count === 8) model.addHexahedron(id, slots)
      else this.#lines.refuse(`element ${id} has ${count} nodes; its type has 8.`, line)
    }
  }
}
