/**
 * The content of an Exodus II file, whatever holds its variables: netCDF classic or HDF5. `connectN` has the nodes of block N's elements,
 * counted from 1; `elem_num_map` the ids of all elements, one block after the other; `eb_names` and `eb_prop1` what the blocks are called.
 * The coordinates at a time are those of the file and the displacements of its nodes, if it has these.
 */
import type { Mesh } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import type { MeshFile, ReadOptions } from '../source'
import { missingStep, sameMeshNote, stepNote } from '../step-note'
import { shown } from '../text-cursor'
import { Displacements } from './exodus-displacements'
import { lengthOf, type Variable, type Variables } from './netcdf-variables'

/** Numbers that are read at once. */
const AT_ONCE = 65_536
/** Nodes of one element. */
const MOST_NODES = 1024
/** Numbers of blocks, and times. */
const MOST_SMALL = 1_000_000

const OTHER: readonly (readonly [RegExp, OtherCell])[] = [
  [/^TET/, 'tetrahedron'],
  [/^(?:WEDGE|PRISM)/, 'wedge'],
  [/^PYR/, 'pyramid'],
  [/^(?:QUAD|SHELL(?!3))/, 'quadrilateral'],
  [/^TRI/, 'triangle'],
  [/^(?:BAR|BEAM|TRUSS|EDGE)/, 'line'],
  [/^(?:SPHERE|CIRCLE|POINT)/, 'vertex'],
  [/^NFACED/, 'polyhedron'],
  [/^NSIDED/, 'polygon'],
]
/** Names of the elements with eight corners; a shell of eight nodes around a volume is none. */
const HEXAHEDRON = /^HEX(?!SHELL)|^BRICK/

/** What an element of a block is. */
export function exodusCell(type: string): OtherCell | 'hexahedron' {
  const name = type.toUpperCase()
  return HEXAHEDRON.test(name) ? 'hexahedron' : (OTHER.find(([pattern]) => pattern.test(name))?.[1] ?? 'other')
}

/** True if variables of these names are those of an Exodus file. */
export function isExodus(names: readonly string[]): boolean {
  return names.some(name => /^(?:coord[xyz]?|connect\d+)$/.test(name))
}

/** Reads the mesh. `positionOf` tells how far the reading has come in the file. */
export function exodusMesh(
  file: MeshFile,
  variables: Variables,
  options: ReadOptions,
  positionOf: () => number = () => 0,
): Mesh {
  return new ExodusReader(file, variables, options, positionOf).mesh()
}

interface ElementBlock {
  readonly name: string
  readonly type: string
  readonly count: number
  /** Nodes of each element; 0 where the number differs. */
  readonly width: number
  /** Null for a block of elements that are no list of so many nodes each. */
  readonly connect: { readonly name: string; readonly variable: Variable } | null
}

class ExodusReader {
  readonly #builder: MeshBuilder
  readonly #variables: Variables
  readonly #options: ReadOptions
  readonly #onSome: () => void
  /** Bytes of the file. */
  readonly #size: number

  constructor(file: MeshFile, variables: Variables, options: ReadOptions, positionOf: () => number) {
    this.#builder = new MeshBuilder('Exodus II', file.name)
    this.#variables = variables
    this.#options = options
    this.#size = file.size
    this.#onSome = () => {
      options.throwIfCancelled()
      options.onProgress(Math.min(1, positionOf() / file.size))
    }
  }

  mesh(): Mesh {
    this.#points(this.#displacements())
    const blocks = this.#blocks()
    const ids = this.#variables.variable('elem_num_map')
    const elements = blocks.reduce((sum, { count }) => sum + count, 0)
    if (ids !== null && lengthOf(ids) !== elements)
      this.#builder.refuse(`elem_num_map has ${lengthOf(ids)} ids; the blocks have ${elements} elements.`)
    let first = 0
    for (const block of blocks) {
      this.#read(block, first, ids)
      first += block.count
    }
    return this.#builder.mesh()
  }

  /** Chunks of `length` numbers one after the other, each of at most AT_ONCE in whole rows of `width`. */
  #inChunks(length: number, width: number, read: (from: number, count: number) => void): void {
    const most = Math.max(1, Math.floor(AT_ONCE / width)) * width
    for (let from = 0; from < length; from += most) {
      read(from, Math.min(most, length - from))
      this.#onSome()
    }
  }

  #points(moved: Displacements | null): void {
    const builder: MeshBuilder = this.#builder
    const whole = this.#variables.variable('coord')
    const [dimensions = 0, count = 0] = whole?.shape ?? []
    const axes = ['x', 'y', 'z'].map((axis, a) => {
      const own = this.#variables.variable(`coord${axis}`)
      if (own !== null) return { variable: own, first: 0, length: lengthOf(own) }
      return whole !== null && a < dimensions ? { variable: whole, first: a * count, length: count } : null
    })
    const [x = null, y = null, z = null] = axes
    if (x === null || y === null) builder.refuse('coordx, coordy and coordz were expected, or coord.')
    if (x.length !== y.length || x.length !== (z ?? x).length)
      builder.refuse(`coordx, coordy and coordz have ${x.length}, ${y.length} and ${(z ?? x).length} numbers.`)
    // No more than the file can have, whatever it says.
    builder.reserve(Math.min(x.length, this.#size / 12), 0)
    const { isFloat32 } = x.variable
    moved?.expect(x.length)
    let largest = 0
    const column = new Float64Array(Math.min(AT_ONCE, x.length))
    this.#inChunks(x.length, 1, (from, some) => {
      const points = builder.morePoints(some)
      for (const [axis, own] of [x, y, z].entries()) {
        if (own === null || own.variable.axis?.(own.first + from, points, axis)) continue
        const values = column.subarray(0, some)
        own.variable.numbers(own.first + from, values)
        for (let i = 0; i < some; ++i) points[3 * i + axis] = values[i] as number
      }
      if (isFloat32) largest = Math.max(largest, largestOf(points))
      moved?.add(from, points)
    })
    const note = float32Note(largest)
    if (note !== null) builder.note(note)
    const from = axes.map(axis => axis && placeOf(axis))
    if (!moved && axes.every(axis => axis?.variable.isFloat32 === isFloat32) && from.every(place => place !== null))
      builder.coordinatePlaces = {
        kind: 'blocks',
        blocks: [{ count: x.length, from: from as [number, number, number], stride: isFloat32 ? 4 : 8 }],
        type: isFloat32 ? 'float32' : 'float64',
        isLittleEndian: false,
      }
    for (const sentence of moved?.notes() ?? []) builder.note(sentence)
  }

  #blocks(): ElementBlock[] {
    const { names } = this.#variables
    const numbers = names.flatMap(name => /^(?:connect|facconn)(\d{1,9})$/.exec(name)?.slice(1).map(Number) ?? [])
    const called = this.#variables.variable('eb_names')?.strings() ?? []
    const ids = this.#small('eb_prop1')
    const used = new Set<string>()
    return [...new Set(numbers)]
      .sort((a, b) => a - b)
      .map(n => {
        const own = called[n - 1]?.trim() ?? ''
        const plain = `block ${ids[n - 1] ?? n}`
        const name = own === '' ? plain : used.has(own) ? `${own} (${plain})` : own
        used.add(name)
        return this.#block(n, name)
      })
  }

  #block(n: number, name: string): ElementBlock {
    const key = `connect${n}`
    const variable = this.#variables.variable(key)
    const sizes = this.#variables.variable(`ebepecnt${n}`)
    const own = variable ?? this.#variables.variable(`facconn${n}`)
    const type = own?.text('elem_type')?.trim() ?? ''
    const [count = 0, width = 0] = variable?.shape ?? []
    if (sizes !== null || variable === null)
      return { name, type, count: sizes === null ? 0 : lengthOf(sizes), width: 0, connect: null }
    if (variable.shape.length !== 2)
      this.#builder.refuse(
        `${key} has ${variable.shape.length} dimensions; the elements and their nodes were expected.`,
      )
    return { name, type, count, width, connect: { name: key, variable } }
  }

  #read({ name, type, count, width, connect }: ElementBlock, first: number, ids: Variable | null): void {
    const builder = this.#builder
    const cell = exodusCell(type)
    if (cell !== 'hexahedron' || connect === null) {
      builder.otherCell(cell === 'hexahedron' ? 'other' : cell, count)
      return
    }
    if (width < 8) builder.refuse(`the elements of ${connect.name} are of type ${shown(type)} and have ${width} nodes.`)
    if (width > MOST_NODES)
      builder.refuse(`the elements of ${connect.name} have ${width} nodes, more than elements have.`)
    const points = builder.pointCount
    const most = Math.min(count, Math.max(1, Math.floor(AT_ONCE / width)))
    const nodes = new Uint32Array(width === 8 ? 0 : most * width)
    const own = new Float64Array(most)
    if (width === 8) builder.reserve(0, Math.min(count, this.#size / 8))
    this.#inChunks(count * width, width, (from, some) => {
      const [before, elements] = [first + from / width, some / width]
      if (ids === null) for (let i = 0; i < elements; ++i) own[i] = before + i + 1
      else ids.numbers(before, own.subarray(0, elements))
      const refuseAt = (at: number, value: number | string | undefined) =>
        builder.refuse(
          `element ${own[Math.floor(at / width)]} in ${connect.name} names node ${value}; the nodes are 1 to ${points}.`,
        )
      const fill = (list: Uint32Array) => {
        const bad = connect.variable.indices(from, list)
        if (bad !== null) refuseAt(bad.at, bad.value)
      }
      if (width === 8) {
        const cells = builder.cellCount
        const fillIndices = (list: Uint32Array) => connect.variable.indicesFrom1?.(from, list, points) ?? false
        builder.hexahedraFilled(elements, { fillIndices, fill, ids: own, refuseAt })
        builder.restInBlock(name, cells)
        return
      }
      fill(nodes.subarray(0, some))
      for (let at = 0; at < some; at += width) {
        const cell = Array.from(nodes.subarray(at, at + width), node => node - 1)
        const bad = cell.findIndex(node => !(node >= 0 && node < points))
        if (bad >= 0) refuseAt(at + bad, nodes[at + bad])
        builder.quadraticCell(cell.slice(0, 8), cell.slice(8))
      }
    })
  }

  /** The numbers of a short variable; none if it is not there. */
  #small(name: string): Float64Array {
    const variable = this.#variables.variable(name)
    const count = variable === null ? 0 : lengthOf(variable)
    if (count > MOST_SMALL) this.#builder.refuse(`${name} has ${count} numbers; no more than ${MOST_SMALL} are read.`)
    const values = new Float64Array(count)
    variable?.numbers(0, values)
    return values
  }

  /** Of the time step that is read; null without displacements or times. */
  #displacements(): Displacements | null {
    const builder: MeshBuilder = this.#builder
    const times = this.#small('time_whole')
    const count = times.length
    if (count === 0) return null
    const { step } = this.#options
    const at = step === 'last' ? count - 1 : step
    if (at >= count) builder.refuse(missingStep(count, step))
    const moved = Displacements.of(this.#variables, { step: at, count }, what => builder.refuse(what))
    builder.steps = Array.from(times, String)
    builder.isSteady = moved === null
    if (count > 1)
      builder.note(moved === null ? `${sameMeshNote(count)} It has no displacements.` : stepNote(builder.steps, at))
    return moved
  }
}

function placeOf({ variable, first }: { readonly variable: Variable; readonly first: number }): number | null {
  return variable.floatsFrom === null ? null : variable.floatsFrom + first * (variable.isFloat32 ? 4 : 8)
}
