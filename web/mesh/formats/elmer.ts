/**
 * Elmer's meshes, folders of files: `mesh.nodes` has an id, a number of no meaning and three coordinates a line, `mesh.elements` an id, a body, a
 * type and its nodes, `mesh.names` what bodies are called. The type's hundreds are the shape, the rest the number of nodes.
 */
import { type Mesh, MeshRefusal } from '../mesh'
import type { OtherCell } from '../mesh-builder'
import { headText, isText, snippetText } from '../snippet-text'
import { isNamed, type MeshFile, type MeshFormat, type ReadOptions } from '../source'
import { RowText } from './row-text'

const NAMES = /^mesh\.(?:nodes|elements|header|boundary|names)$/
const SHAPES: ReadonlyMap<number, OtherCell | 'hexahedron'> = new Map([
  [1, 'vertex'],
  [2, 'line'],
  [3, 'triangle'],
  [4, 'quadrilateral'],
  [5, 'tetrahedron'],
  [6, 'pyramid'],
  [7, 'wedge'],
  [8, 'hexahedron'],
])

export const elmer: MeshFormat = {
  name: 'Elmer',
  recognizes: (head, name) =>
    NAMES.test(name.split('/').at(-1) ?? '') && isText(head) && /^\s*(?:\d|[!$])/.test(headText(head)) ? 'yes' : 'no',
  read(file, options) {
    return [new ElmerReader(file, options).read()]
  },
}

class ElmerReader {
  readonly #file: MeshFile
  readonly #options: ReadOptions

  constructor(file: MeshFile, options: ReadOptions) {
    this.#file = file
    this.#options = options
  }

  #found(name: string): MeshFile | null {
    return isNamed(this.#file, name) ? this.#file : this.#options.find(name)
  }

  read(): Mesh {
    const [nodes, elements] = [this.#found('mesh.nodes'), this.#found('mesh.elements')]
    const names = this.#found('mesh.names')
    // They say nothing of the cells.
    for (const name of ['mesh.header', 'mesh.boundary', 'entities.sif']) this.#found(name)
    if (nodes === null || elements === null)
      throw new MeshRefusal(
        `${this.#file.name}: this is a file of an Elmer mesh; it needs “${nodes === null ? 'mesh.nodes' : 'mesh.elements'}” beside it: give all files of the folder together.`,
      )
    const text = new RowText('Elmer', nodes, this.#options)
    text.builder.areCoordinatesElsewhere = nodes !== this.#file
    text.lines(
      () => false,
      () => readNode(text),
      line => {
        const partition = /^\s*\d+(\s+-?\d+)\s/.exec(line)?.[1]
        if (partition === undefined) return false
        // The number without a meaning is the same in all lines, as a rule.
        const rows = text.rows('wrrrr')
        if (rows !== null) text.builder.pointRows(rows, true)
        return rows !== null
      },
    )
    const cells = text.of(elements)
    this.#elements(cells, namesOf(names))
    return text.builder.mesh()
  }

  #elements(text: RowText, names: ReadonlyMap<number, string>): void {
    const { builder, cursor } = text
    const bodyName = (body: number) => names.get(body) ?? `body ${body}`
    text.lines(
      () => false,
      () => {
        // A copy of an element in another partition has that behind its id: 17/2.
        const id = Number(/^\d+/.exec(cursor.word())?.[0])
        if (!Number.isSafeInteger(id)) text.refuse('the number of an element was expected.')
        const body = cursor.count('the number of a body')
        const type = cursor.count('the type of an element')
        const nodes = text.numbers('the number of a node')
        const cell = SHAPES.get(Math.floor(type / 100)) ?? text.refuse(`${type} is no type of an element of Elmer.`)
        if (nodes.length !== type % 100) text.refuse(`element ${id} of type ${type} has ${nodes.length} nodes.`)
        if (cell === 'hexahedron') text.hexahedron(id, nodes, own => builder.inBlock(bodyName(body), own))
        else builder.otherCell(cell)
        cursor.skipLine()
      },
      line => {
        if (!/^\s*\d+\s+\d+\s+808\s/.test(line)) return false
        const rows = text.rows('wwwwwwwwwww')
        if (rows === null) return false
        const { numbers, count } = rows
        for (let row = 0; row < count; ++row)
          if (numbers[11 * row + 2] !== 808) text.refuse('elements of eight nodes are of type 808.')
        let at = 1
        return text.hexahedronRows(rows, 0, 3, cell => {
          builder.inBlock(bodyName(numbers[at] as number), cell)
          at += 11
        })
      },
    )
  }
}

function readNode(text: RowText): void {
  const { builder, cursor } = text
  const id = cursor.count('the number of a node')
  cursor.number('an integer')
  builder.pointWithId(id, ...builder.readPoint(cursor))
  cursor.skipLine()
}

/** Lines "$ name = 1" up to a remark that boundaries follow. */
function namesOf(file: MeshFile | null): ReadonlyMap<number, string> {
  const [bodies = ''] = (file === null ? '' : (snippetText(file) ?? '')).split(/names for boundaries/i)
  return new Map(
    Array.from(bodies.matchAll(/^\s*\$\s*(\S{1,200})\s*=\s*(\d{1,9})\s*$/gm), ([, name = '', body]) => [
      Number(body),
      name,
    ]),
  )
}
