/** Commands of Ansys for one node, N, or one element, E, EN and EMORE, as people write them and CDWRITE does without blocks. */
import type { PrintedDigits } from '../precision'
import { shown } from '../shown'
import { MOST_NODES } from './ansys-elements'
import type { NodeModel } from './node-model'
import type { TextLines } from './text-lines'

const [COMMA, EXCLAMATION] = [44, 33] as const

export class AnsysCommands {
  readonly #lines: TextLines
  readonly #model: NodeModel
  readonly #precision: PrintedDigits
  readonly #take: (id: number, nodes: Float64Array, line: number) => void
  /** The element of the last E or EN, which EMORE may go on with. */
  #pending: { readonly id: number; readonly nodes: number[]; readonly line: number } | null = null
  #lastNode = 0
  #lastElement = 0
  /** The number of the active frame, in which the coordinates of N are. */
  frame = '0'

  /** `take` gets each element when it is whole. */
  constructor(
    lines: TextLines,
    model: NodeModel,
    precision: PrintedDigits,
    take: (id: number, nodes: Float64Array, line: number) => void,
  ) {
    this.#lines = lines
    this.#model = model
    this.#precision = precision
    this.#take = take
  }

  node(): void {
    const lines = this.#lines
    if (Number(this.frame) !== 0)
      lines.refuse(
        `N: coordinates in frame ${/^\d+$/.test(this.frame) ? this.frame : shown(this.frame)} are not read; frame 0 was expected.`,
      )
    this.#split(4)
    const id = lines.isFieldBlank(0) ? this.#lastNode + 1 : lines.id(0, 'a number of a node')
    this.#lastNode = Math.max(this.#lastNode, id)
    this.#model.defineFields(lines, id, this.#precision)
  }

  /** `name` is E, EN or EMORE. */
  element(name: string): void {
    const lines = this.#lines
    this.#split(1)
    if (name !== 'EMORE') {
      this.endElement()
      const id = name === 'EN' ? lines.id(0, 'a number of an element') : this.#lastElement + 1
      this.#pending = { id, nodes: [], line: lines.number }
      this.#lastElement = Math.max(this.#lastElement, id)
    }
    const pending = this.#pending
    if (pending === null) {
      lines.refuse('EMORE: an element of E or EN was expected before it.')
      return
    }
    for (let i = name === 'EN' ? 1 : 0; i < lines.filledCount; ++i)
      pending.nodes.push(lines.isFieldBlank(i) ? 0 : lines.id(i, 'a number of a node'))
    if (pending.nodes.length > MOST_NODES) lines.refuse(`element ${pending.id} has more than ${MOST_NODES} nodes.`)
  }

  endElement(): void {
    if (this.#pending === null) return
    const { id, nodes, line } = this.#pending
    this.#pending = null
    this.#take(id, Float64Array.from(nodes), line)
  }

  /** Fields between commas behind the command, at least so many. */
  #split(least: number): void {
    const lines = this.#lines
    lines.startFields()
    let from = -1
    for (let at = lines.from; ; ++at) {
      const byte = at < lines.to ? lines.at(at - lines.from) : EXCLAMATION
      if (byte !== COMMA && byte !== EXCLAMATION) continue
      if (from >= 0) lines.addField(from, at)
      from = at + 1
      if (byte === EXCLAMATION) break
    }
    while (lines.fieldCount < least) lines.addField(lines.to, lines.to)
  }
}
