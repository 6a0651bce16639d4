/**
 * The content of an Exodus II file, whatever holds its variables: netCDF classic or HDF5. `connectN` has the nodes of block N's elements,
 * counted from 1; `elem_num_map` the ids of all elements, one block after the other; `eb_names` and `eb_prop1` what the blocks are called.
 */
import type { Mesh } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import type { MeshFile, ReadOptions } from '../source'
import { shown } from '../text-cursor'

export interface Variable {
  /** Lengths of its dimensions, the slowest first; none for a single number. */
  readonly shape: readonly number[]
  readonly isFloat32: boolean
  /** The byte of its first number in the file, big-endian, if all lie there one after the other as floats; else null. */
  readonly floatsFrom: number | null
  /** The text of an attribute; null if it has none of that name, or one of numbers. */
  text(attribute: string): string | null
  /** Fills `into` with its numbers, of any type, from number `from` of all on: `from + into.length` is at most their count. */
  numbers(from: number, into: Float64Array): void
  /** Its strings: characters along the last dimension, up to the first zero. */
  strings(): readonly string[]
}

/** The variables of a netCDF file, by name. */
export interface Variables {
  readonly names: readonly string[]
  /** Null if there is none of that name. */
  variable(name: string): Variable | null
}

/** Numbers that are read at once. */
const AT_ONCE = 65_536
/** Nodes of one element. */
const MOST_NODES = 1024

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
const HEXAHEDRON = /^HEX(?!SHELL)/

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
    this.#points()
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
    this.#steps()
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

  #points(): void {
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
    let largest = 0
    const [xs, ys, zs] = [0, 1, 2].map(() => new Float64Array(Math.min(AT_ONCE, x.length))) as Triple
    this.#inChunks(x.length, 1, (from, some) => {
      x.variable.numbers(x.first + from, xs.subarray(0, some))
      y.variable.numbers(y.first + from, ys.subarray(0, some))
      z?.variable.numbers(z.first + from, zs.subarray(0, some))
      for (let i = 0; i < some; ++i) builder.point(xs[i] as number, ys[i] as number, zs[i] as number)
      if (isFloat32) largest = Math.max(largest, largestOf(xs), largestOf(ys), largestOf(zs))
    })
    const note = float32Note(largest)
    if (note !== null) builder.note(note)
    const from = axes.map(axis => axis && placeOf(axis))
    if (axes.every(axis => axis?.variable.isFloat32 === isFloat32) && from.every(place => place !== null))
      builder.coordinatePlaces = {
        kind: 'blocks',
        blocks: [{ count: x.length, from: from as [number, number, number], stride: isFloat32 ? 4 : 8 }],
        type: isFloat32 ? 'float32' : 'float64',
        isLittleEndian: false,
      }
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
    if (width === 8) builder.reserve(0, Math.min(count, this.#size / 8))
    const points = builder.pointCount
    const nodes = new Float64Array(Math.min(count, Math.max(1, Math.floor(AT_ONCE / width))) * width)
    const own = new Float64Array(nodes.length / width)
    this.#inChunks(count * width, width, (from, some) => {
      connect.variable.numbers(from, nodes.subarray(0, some))
      const before = first + from / width
      const elements = some / width
      if (ids === null) for (let i = 0; i < elements; ++i) own[i] = before + i + 1
      else ids.numbers(before, own.subarray(0, elements))
      for (let i = 0; i < some; ++i) {
        const node = nodes[i] as number
        if (!(node >= 1 && node <= points && Number.isInteger(node)))
          builder.refuse(
            `element ${own[Math.floor(i / width)]} in ${connect.name} names node ${node}; the nodes are 1 to ${points}.`,
          )
      }
      if (width === 8) {
        builder.restInBlock(name, builder.hexahedra(nodes.subarray(0, some), 1, own))
        return
      }
      for (let at = 0; at < some; at += width) {
        const all = Array.from(nodes.subarray(at, at + width), node => node - 1)
        builder.quadraticCell(all.slice(0, 8), all.slice(8))
      }
    })
  }

  /** The numbers of a short variable; none if it is not there. */
  #small(name: string): Float64Array {
    const variable = this.#variables.variable(name)
    const values = new Float64Array(variable === null ? 0 : Math.min(AT_ONCE, lengthOf(variable)))
    variable?.numbers(0, values)
    return values
  }

  /** Displacements are results: the mesh of all steps is the same. */
  #steps(): void {
    const times = this.#small('time_whole')
    if (times.length === 0) return
    const { step } = this.#options
    const at = step === 'last' ? times.length - 1 : step
    if (at >= times.length) this.#builder.refuse(`it has ${times.length} time steps, and step ${at + 1} was asked for.`)
    this.#builder.steps = Array.from(times, String)
    if (times.length > 1) this.#builder.note(`The mesh is the same at all ${times.length} time steps of the file.`)
  }
}

function placeOf({ variable, first }: { readonly variable: Variable; readonly first: number }): number | null {
  return variable.floatsFrom === null ? null : variable.floatsFrom + first * (variable.isFloat32 ? 4 : 8)
}

type Triple = [Float64Array, Float64Array, Float64Array]

/** The count of all its numbers. */
export function lengthOf({ shape }: Pick<Variable, 'shape'>): number {
  return shape.reduce((product, length) => product * length, 1)
}
