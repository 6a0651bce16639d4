/** Numbered nodes and the hexahedra that name them, as every mesh format has them. */
import type { Vec3 } from '../hexahedron'
import { counted, type FoundElement, LISTED, type Reading, Refused } from './format'

export class Mesh {
  readonly nodes = new Map<number, Vec3>()
  readonly #elements: FoundElement[] = []
  #waiting: { readonly name: string; readonly nodes: readonly number[] }[] = []
  #hexahedra = 0
  #others = 0
  #incomplete = 0

  /** Eight node numbers; the nodes may come later. Of those beyond the list only the count is kept. */
  addHexahedron(name: string, nodes: readonly number[]): void {
    this.#hexahedra++
    if (this.#elements.length + this.#waiting.length < LISTED) this.#waiting.push({ name, nodes })
  }

  addOther(): void {
    this.#others++
  }

  /** Ends a part of the file whose node numbers hold in it alone. */
  endPart(): void {
    for (const { name, nodes } of this.#waiting) {
      const points = nodes.map(node => this.nodes.get(node))
      if (nodes.length === 8 && points.every(point => point !== undefined)) {
        this.#elements.push({ name, vertices: points.flat() })
      } else this.#incomplete++
    }
    this.#waiting = []
    this.nodes.clear()
  }

  /** `kind` is what the format calls its eight-node hexahedra. */
  reading(kind: string): Reading {
    this.endPart()
    if (this.#elements.length === 0) throw new Refused(this.#nothing(kind))
    const notes = [
      this.#incomplete > 0
        ? `${counted(this.#incomplete, 'hexahedron names', 'hexahedra name')} nodes that are not there.`
        : '',
      this.#others > 0 ? `${counted(this.#others, 'cell', 'cells')} of other kinds left out.` : '',
    ].filter(note => note !== '')
    const reading = { elements: this.#elements, count: this.#hexahedra - this.#incomplete }
    return notes.length > 0 ? { ...reading, note: notes.join(' ') } : reading
  }

  #nothing(kind: string): string {
    if (this.#hexahedra > 0) {
      return `${counted(this.#hexahedra, 'hexahedron was', 'hexahedra were')} found, but not the nodes that it takes to place ${this.#hexahedra === 1 ? 'it' : 'them'}.`
    }
    return this.#others > 0
      ? `${counted(this.#others, 'cell was', 'cells were')} found, but none is ${kind}.`
      : `No cells were found; this looks for ${kind}.`
  }
}
