/**
 * XDMF, versions 2 and 3: XML with grids of a topology and a geometry, whose numbers are items in the text, in the bytes of a file beside, or in
 * HDF5. Collections in time are steps, of which one is read; in space, and trees, they are parts of one mesh.
 */
import { answered, hdf5For } from '../hdf5-reader'
import { type Mesh, MeshRefusal, MOST_IMPLIED_CELLS } from '../mesh'
import { headText } from '../snippet-text'
import { type MeshFile, type MeshFormat, progressOf, type ReadOptions } from '../source'
import { missingStep } from '../step-note'
import { shown } from '../text-cursor'
import { wordTable } from '../word-table'
import { VtkMesh } from './vtk-mesh'
import { precisionOf } from './vtk-middles'
import { isNumberType, type NumberList, type NumberType, putNumbers, sizeOf } from './vtk-numbers'
import { readArray } from './vtu-arrays'
import { childrenOf, resolved, treeOf, type XmlNode } from './xdmf-tree'

/** Reads the numbers of a dataset in an HDF5 file that lies beside. Throws a MeshRefusal. */
export type Hdf5Source = (file: MeshFile, path: string) => Float64Array

/** Types of topologies: VTK's type, and the number of nodes, 0 where the file says it. */
const TYPES: Readonly<Record<string, readonly [number, number]>> = wordTable({
  POLYVERTEX: [2, 0],
  POLYLINE: [4, 0],
  POLYGON: [7, 0],
  TRIANGLE: [5, 3],
  QUADRILATERAL: [9, 4],
  TETRAHEDRON: [10, 4],
  PYRAMID: [14, 5],
  WEDGE: [13, 6],
  HEXAHEDRON: [12, 8],
  EDGE_3: [21, 3],
  TRIANGLE_6: [22, 6],
  TRI_6: [22, 6],
  QUADRILATERAL_8: [23, 8],
  QUAD_8: [23, 8],
  QUADRILATERAL_9: [28, 9],
  QUAD_9: [28, 9],
  TETRAHEDRON_10: [24, 10],
  TET_10: [24, 10],
  PYRAMID_13: [27, 13],
  WEDGE_15: [26, 15],
  WEDGE_18: [32, 18],
  HEXAHEDRON_20: [25, 20],
  HEX_20: [25, 20],
  HEXAHEDRON_24: [33, 24],
  HEX_24: [33, 24],
  HEXAHEDRON_27: [29, 27],
  HEX_27: [29, 27],
})
/** The same by the numbers that stand for them among mixed cells; a count follows those of any number of nodes. */
const MIXED: ReadonlyMap<number, string> = new Map([
  [1, 'POLYVERTEX'],
  [2, 'POLYLINE'],
  [3, 'POLYGON'],
  [4, 'TRIANGLE'],
  [5, 'QUADRILATERAL'],
  [6, 'TETRAHEDRON'],
  [7, 'PYRAMID'],
  [8, 'WEDGE'],
  [9, 'HEXAHEDRON'],
  [34, 'EDGE_3'],
  [35, 'QUAD_9'],
  [36, 'TRI_6'],
  [37, 'QUAD_8'],
  [38, 'TET_10'],
  [39, 'PYRAMID_13'],
  [40, 'WEDGE_15'],
  [41, 'WEDGE_18'],
  [48, 'HEX_20'],
  [49, 'HEX_24'],
  [50, 'HEX_27'],
])
const MIXED_POLYHEDRON = 16
const VTK_POLYHEDRON = 42
const STRUCTURED = /^3D(?:SMESH|RECTMESH|CORECTMESH)$/
const AT_ONCE = 1024 * 1024
const LONGEST_WORD = 4096

export const xdmf: MeshFormat = {
  name: 'XDMF',
  recognizes: head => (/<Xdmf\b/.test(headText(head)) ? 'yes' : 'no'),
  read: (file, options) =>
    readXdmf(file, options, (beside, path) => answered(hdf5For(beside, options).numbers(beside, path)).values),
}

/** Reads the mesh; without a source for them, numbers in HDF5 are refused. */
export function readXdmf(file: MeshFile, options: ReadOptions, hdf5: Hdf5Source | null): readonly Mesh[] {
  return [new XdmfReader(file, options, hdf5).read()]
}

class XdmfReader {
  readonly #file: MeshFile
  readonly #options: ReadOptions
  readonly #hdf5: Hdf5Source | null
  readonly #root: XmlNode
  readonly #mesh: VtkMesh
  readonly #paths = new Map<string, readonly XmlNode[] | null>()
  /** The text of the coordinates of the only grid. */
  #places: { readonly from: number; readonly to: number } | null = null

  constructor(file: MeshFile, options: ReadOptions, hdf5: Hdf5Source | null) {
    this.#file = file
    this.#options = options
    this.#hdf5 = hdf5
    this.#root = treeOf(file, 'Xdmf', progressOf(file, options))
    this.#mesh = new VtkMesh('XDMF', what => this.#refuse(what))
  }

  #refuse(what: string): never {
    throw new MeshRefusal(`${this.#file.name}: ${what}`)
  }

  read(): Mesh {
    const grids = childrenOf(this.#root, 'Domain').flatMap(domain => childrenOf(domain, 'Grid'))
    const leaves = grids.flatMap(grid => this.#leaves(grid))
    if (leaves.length === 0) this.#refuse('it has no <Grid> with cells.')
    const parts = leaves.map((grid, i) => ({
      name: grid.attributes.get('Name') ?? `grid ${i + 1}`,
      topology: this.#partOf(grid, 'Topology'),
      geometry: this.#partOf(grid, 'Geometry'),
    }))
    // A grid may stand beside the steps that include it.
    const own = parts.filter(
      ({ topology, geometry }, i) =>
        parts.findIndex(other => other.topology === topology && other.geometry === geometry) === i,
    )
    this.#mesh.noteSteps(this.#options.step)
    for (const { name, topology, geometry } of own) this.#grid(topology, geometry, own.length > 1 ? name : null)
    if (own.length === 1 && this.#places !== null) this.#mesh.coordinatePlaces = { kind: 'run', ...this.#places }
    return this.#mesh.mesh()
  }

  /** The grids with cells, of one step where there are several. */
  #leaves(grid: XmlNode): readonly XmlNode[] {
    const type = (grid.attributes.get('GridType') ?? 'Uniform').toUpperCase()
    const inner = childrenOf(grid, 'Grid')
    if (type === 'UNIFORM') return [grid]
    if (type !== 'COLLECTION' && type !== 'TREE') this.#refuse(`grids of type ${shown(type)} are not read.`)
    const isInTime = type === 'COLLECTION' && /^temporal$/i.test(grid.attributes.get('CollectionType') ?? '')
    return isInTime ? this.#step(grid, inner) : inner.flatMap(one => this.#leaves(one))
  }

  #step(collection: XmlNode, grids: readonly XmlNode[]): readonly XmlNode[] {
    const listed = this.#listedTimes(collection)
    const times = grids.map((grid, i) => childrenOf(grid, 'Time')[0]?.attributes.get('Value') ?? listed[i] ?? '')
    const { step } = this.#options
    const at = step === 'last' ? grids.length - 1 : step
    const grid = grids[at]
    if (grid === undefined) this.#refuse(missingStep(grids.length, step))
    // Of several collections each has the same steps.
    const isFirst = this.#mesh.steps.length === 0
    if (!isFirst && this.#mesh.steps.length !== times.length)
      this.#refuse(`its collections have ${this.#mesh.steps.length} and ${times.length} time steps.`)
    this.#mesh.steps = times
    const first = this.#meshIn(grid)
    const isSteady = grids.every(one => this.#meshIn(one) === first)
    this.#mesh.isSteady = isSteady && (isFirst || this.#mesh.isSteady)
    return this.#leaves(grid)
  }

  /** A text that two grids have in common if their topologies and geometries are the same parts of the files; any other if they are refused. */
  #meshIn(grid: XmlNode): string {
    const type = (grid.attributes.get('GridType') ?? 'Uniform').toUpperCase()
    if (type !== 'UNIFORM')
      return childrenOf(grid, 'Grid')
        .map(one => this.#meshIn(one))
        .join('|')
    try {
      return [this.#partOf(grid, 'Topology'), this.#partOf(grid, 'Geometry')].map(part => this.#placeOf(part)).join('+')
    } catch (error) {
      if (!(error instanceof MeshRefusal)) throw error
      return `refused at ${grid.from}`
    }
  }

  /** Where the numbers of a part of a grid are: their own place in the file, or that in another file. */
  #placeOf(part: XmlNode): string {
    const items = childrenOf(part, 'DataItem').map(item => this.#resolvedItem(item))
    if (items.length === 0) return `${part.from}`
    const written = (node: XmlNode) => [...node.attributes].map(([name, value]) => `${name}=${value}`).join(' ')
    const placed = (item: XmlNode) => (formatOf(item) === 'XML' ? item.from : `${written(item)}: ${this.#word(item)}`)
    return [written(part), ...items.map(placed)].join(', ')
  }

  /** Times that the collection has for all of its grids: a list, or the first, the distance and the count. */
  #listedTimes(collection: XmlNode): readonly string[] {
    const [time] = childrenOf(collection, 'Time')
    const [item] = time === undefined ? [] : childrenOf(time, 'DataItem')
    const type = time?.attributes.get('TimeType')?.toUpperCase()
    if (item === undefined || (type !== 'LIST' && type !== 'HYPERSLAB')) return []
    const numbers = Array.from(this.#numbers(item, Float64Array).list)
    if (type === 'LIST') return numbers.map(String)
    const [first = 0, distance = 0] = numbers
    return childrenOf(collection, 'Grid').map((_, i) => String(first + i * distance))
  }

  /** The children of this name, in the grid itself or where it refers to. */
  #partOf(grid: XmlNode, name: string): XmlNode {
    const [own] = childrenOf(grid, name)
    const reference = own?.attributes.get('Reference')
    if (own !== undefined && reference === undefined) return own
    const paths =
      reference === undefined ? this.#included(grid) : [reference === 'XML' ? this.#word(own as XmlNode) : reference]
    for (const path of paths) {
      const nodes = this.#resolved(path)
      if (nodes === null) this.#refuse(`the reference ${shown(path)} is of a kind that is not read.`)
      const found = nodes.find(node => node.name === name)
      if (found !== undefined && found.attributes.get('Reference') === undefined) return found
    }
    return this.#refuse(`a grid has no <${name}>.`)
  }

  /** Paths of <xi:include xpointer="xpointer(...)">, by which FEniCS repeats a mesh at each step; meshio calls it <ns0:include>. */
  #included(grid: XmlNode): string[] {
    return grid.children
      .filter(({ name }) => name.endsWith(':include'))
      .map(({ attributes }) => {
        const href = attributes.get('href') ?? ''
        if (href !== '') this.#refuse(`it includes ${shown(href)}, which is not read.`)
        return /^xpointer\((.*)\)$/.exec(attributes.get('xpointer') ?? '')?.[1] ?? ''
      })
  }

  #grid(topology: XmlNode, geometry: XmlNode, name: string | null): void {
    const type = (topology.attributes.get('TopologyType') ?? topology.attributes.get('Type') ?? '').toUpperCase()
    if (STRUCTURED.test(type)) {
      this.#structured(type, topology, geometry)
      return
    }
    const { points, declaredPoints, precision } = this.#points(geometry)
    const cells = type === 'MIXED' ? this.#mixed(topology) : this.#cells(type, topology)
    this.#mesh.add(
      {
        points,
        declaredPoints,
        ...cells,
        declaredCells: cells.types.length,
        hasFaceStreams: false,
        precision,
        cellData: null,
      },
      name,
    )
  }

  #cells(type: string, topology: XmlNode) {
    const [vtkType, fixed] = TYPES[type] ?? this.#refuse(`a topology is of type ${shown(type)}, which is not read.`)
    const size = fixed || Number(topology.attributes.get('NodesPerElement') ?? (type === 'POLYVERTEX' ? 1 : 0))
    if (!(Number.isInteger(size) && size > 0)) this.#refuse(`a topology of type ${shown(type)} has no NodesPerElement.`)
    const order = topology.attributes.get('Order')?.trim().split(/\s+/).map(Number)
    if (order?.some((place, i) => place !== i))
      this.#refuse('a topology with an order of nodes of its own is not read.')
    const connectivity = this.#based(topology, this.#numbers(this.#item(topology), Uint32Array).list)
    const count = connectivity.length / size
    if (!Number.isInteger(count)) this.#refuse(`${connectivity.length} nodes are no cells of ${size} nodes.`)
    const declared = this.#declaredCells(topology)
    if (declared !== null && declared !== count) this.#refuse(`${declared} cells are declared, and ${count} are there.`)
    const ends = new Uint32Array(count)
    for (let i = 0; i < count; ++i) ends[i] = size * (i + 1)
    return { connectivity, ends, types: new Uint8Array(count).fill(vtkType) }
  }

  /** Null where the topology does not say it. */
  #declaredCells({ attributes }: XmlNode): number | null {
    const word = attributes.get('NumberOfElements') ?? attributes.get('Dimensions')
    if (word === undefined) return null
    const count = Number(word.trim().split(/\s+/)[0])
    if (!Number.isSafeInteger(count)) this.#refuse(`${shown(word)} is not the number of cells.`)
    return count
  }

  #based({ attributes }: XmlNode, nodes: Uint32Array): Uint32Array {
    const base = Number(attributes.get('BaseOffset') ?? 0)
    if (base !== 0) for (let i = 0; i < nodes.length; ++i) nodes[i] = (nodes[i] as number) - base
    return nodes
  }

  /** Each cell is the number of its type, a count of nodes if the type has none, and its nodes. */
  #mixed(topology: XmlNode) {
    const { list } = this.#numbers(this.#item(topology), Uint32Array)
    const connectivity = new Uint32Array(list.length)
    const ends = new Uint32Array(list.length >> 1)
    const types = new Uint8Array(ends.length)
    let [cell, filled] = [0, 0]
    const cut = () => this.#refuse(`the mixed cells end in the middle of cell ${cell}.`)
    for (let at = 0; at < list.length; ++cell) {
      const kind = list[at++] as number
      if (kind === MIXED_POLYHEDRON) {
        const faces = list[at++] ?? cut()
        for (let face = 0; face < faces; ++face) at += 1 + (list[at] ?? cut())
        if (at > list.length) cut()
        types[cell] = VTK_POLYHEDRON
      } else {
        const [type, fixed] =
          TYPES[MIXED.get(kind) ?? ''] ?? this.#refuse(`cell ${cell} is of type ${kind}, which is not read.`)
        const size = fixed || (list[at++] ?? cut())
        if (at + size > list.length) cut()
        for (let i = 0; i < size; ++i) connectivity[filled++] = list[at++] as number
        types[cell] = type
      }
      ends[cell] = filled
    }
    const declared = this.#declaredCells(topology)
    if (declared !== null && declared !== cell) this.#refuse(`${declared} cells are declared, and ${cell} are there.`)
    return {
      connectivity: this.#based(topology, connectivity.subarray(0, filled)),
      ends: ends.subarray(0, cell),
      types: types.subarray(0, cell),
    }
  }

  #points(geometry: XmlNode) {
    const type = geometryType(geometry)
    const items = childrenOf(geometry, 'DataItem')
    if (type === 'X_Y_Z' || type === 'X_Y') {
      const axes = items.map(item => this.#numbers(item, Float64Array))
      const [x, y] = axes.map(({ list }) => list)
      if (
        x === undefined ||
        y === undefined ||
        axes.length !== (type === 'X_Y' ? 2 : 3) ||
        axes.some(({ list }) => list.length !== x.length)
      )
        this.#refuse(`a geometry of type ${type} has one item for each axis, of equal length.`)
      const points = new Float64Array(3 * x.length)
      for (const [axis, { list }] of axes.entries())
        for (let i = 0; i < list.length; ++i) points[3 * i + axis] = list[i] as number
      return { points, declaredPoints: x.length, precision: (axes[0] as (typeof axes)[number]).precision }
    }
    if (type !== 'XYZ' && type !== 'XY') this.#refuse(`a geometry of type ${shown(type)} is not read.`)
    const item = this.#resolvedItem(this.#item(geometry))
    const { list, count, precision } = this.#numbers(item, Float64Array)
    if (type === 'XYZ') {
      if (count % 3 !== 0) this.#refuse(`${count} coordinates are no points of three.`)
      if (formatOf(item) === 'XML' && list.length === count) this.#places = { from: item.from, to: item.to }
      return { points: list.subarray(0, list.length - (list.length % 3)), declaredPoints: count / 3, precision }
    }
    const points = new Float64Array(3 * Math.floor(list.length / 2))
    for (let i = 0; i < list.length; ++i) points[3 * (i >> 1) + (i & 1)] = list[i] as number
    return { points, declaredPoints: Math.floor(count / 2), precision }
  }

  #structured(type: string, topology: XmlNode, geometry: XmlNode): void {
    const words = topology.attributes.get('Dimensions') ?? topology.attributes.get('NumberOfElements') ?? ''
    const numbers = words.trim().split(/\s+/).map(Number).reverse()
    const [nx = 0, ny = 0, nz = 0] = numbers
    if (numbers.length !== 3 || numbers.some(size => !Number.isSafeInteger(size) || size < 1))
      this.#refuse(`the dimensions ${shown(words)} are not three counts of points.`)
    if (nx * ny * nz > 2 * MOST_IMPLIED_CELLS)
      this.#refuse(`the dimensions ${shown(words)} imply more points than are read.`)
    if (type === '3DSMESH') {
      const { points, precision } = this.#points(geometry)
      if (points.length !== 3 * nx * ny * nz)
        this.#refuse(`the dimensions ${shown(words)} imply ${nx * ny * nz} points, and ${points.length / 3} are there.`)
      this.#mesh.addStructured(() => points, [nx, ny, nz], precision)
      return
    }
    const items = childrenOf(geometry, 'DataItem').map(item => this.#numbers(item, Float64Array))
    const lists = items.map(({ list }) => list)
    const kind = geometryType(geometry)
    const sizes = [nx, ny, nz] as const
    let axes = lists
    if (kind === 'ORIGIN_DXDYDZ') {
      const [origin = [], step = []] = lists
      // Both stand in the order of the dimensions, z first.
      axes = sizes.map((size, axis) =>
        Float64Array.from(
          { length: size },
          (_, i) => (origin[2 - axis] ?? Number.NaN) + i * (step[2 - axis] ?? Number.NaN),
        ),
      )
    } else if (kind !== 'VXVYVZ') this.#refuse(`a geometry of type ${shown(kind)} has no place in a ${type}.`)
    if (axes.length !== 3 || axes.some((list, axis) => list.length !== sizes[axis]))
      this.#refuse(`the coordinates along the axes do not fit the dimensions ${shown(words)}.`)
    const precision = items[0]?.precision ?? precisionOf('Float64', false, 0)
    this.#mesh.addStructured(() => lattice(axes as [Float64Array, Float64Array, Float64Array]), sizes, precision)
  }

  #item(node: XmlNode): XmlNode {
    const [item, ...others] = childrenOf(node, 'DataItem')
    if (item === undefined || others.length > 0)
      this.#refuse(`a <${node.name}> has not one DataItem but ${others.length + (item ? 1 : 0)}.`)
    return item
  }

  /** The item itself, or the one that it refers to. */
  #resolvedItem(item: XmlNode): XmlNode {
    const reference = item.attributes.get('Reference')
    if (reference === undefined) return item
    const path = reference === 'XML' ? this.#word(item) : reference
    const [found] = this.#resolved(path) ?? []
    if (found === undefined || found.attributes.get('Reference') !== undefined)
      this.#refuse(`the reference ${shown(path)} names no item that is there.`)
    return found
  }

  /** Steps refer to the same parts again and again. */
  #resolved(path: string): readonly XmlNode[] | null {
    const known = this.#paths.get(path)
    if (known !== undefined) return known
    const nodes = resolved(this.#root, path)
    this.#paths.set(path, nodes)
    return nodes
  }

  /** The text of an item that is a name or a path. */
  #word({ from, to }: XmlNode): string {
    const bytes = this.#file.read(from, Math.min(to, from + LONGEST_WORD))
    return new TextDecoder().decode(bytes).trim()
  }

  #numbers<T extends NumberList>(given: XmlNode, List: new (length: number) => T) {
    const item = this.#resolvedItem(given)
    const { attributes } = item
    const kind = attributes.get('ItemType') ?? 'Uniform'
    if (kind !== 'Uniform')
      this.#refuse(`an item of type ${shown(kind)}, which selects or computes numbers, is not read.`)
    const type = this.#typeOf(item)
    const sizes = (attributes.get('Dimensions') ?? '').trim().split(/\s+/).map(Number)
    const count = sizes.reduce((product, size) => product * size, 1)
    if (sizes.some(size => !Number.isSafeInteger(size) || size < 0) || !Number.isSafeInteger(count))
      this.#refuse(`the dimensions ${shown(attributes.get('Dimensions') ?? '')} of an item are no counts.`)
    const format = formatOf(item)
    if (format === 'XML') {
      const storage = {
        file: this.#file,
        options: this.#options,
        isLittleEndian: true,
        headerType: 'UInt64',
        decompress: null,
        isZlib: false,
        appended: null,
      } as const
      const array = { name: 'DataItem', type, format: 'ascii', offset: 0, from: item.from, to: item.to } as const
      const { list, digits } = readArray(storage, array, count, List)
      return { list, count, precision: precisionOf(type, true, digits) }
    }
    const list = format === 'HDF' ? this.#hdf(item, count, List) : this.#binary(item, type, count, List)
    return { list, count, precision: precisionOf(type, false, 0) }
  }

  #typeOf({ attributes }: XmlNode): NumberType {
    const name = (attributes.get('NumberType') ?? attributes.get('DataType') ?? 'Float').toUpperCase()
    const bits = 8 * Number(attributes.get('Precision') ?? 4)
    const named: Readonly<Record<string, string>> = {
      FLOAT: `Float${bits}`,
      INT: `Int${bits}`,
      UINT: `UInt${bits}`,
      CHAR: 'Int8',
      UCHAR: 'UInt8',
      SHORT: 'Int16',
      USHORT: 'UInt16',
    }
    const type = Object.hasOwn(named, name) ? (named[name] as string) : ''
    return isNumberType(type)
      ? type
      : this.#refuse(
          `${shown(name)} with a precision of ${shown(attributes.get('Precision') ?? '4')} is no type of an item.`,
        )
  }

  /** The file beside that an item names, whole or before a colon. */
  #beside(name: string): MeshFile {
    const found = this.#options.find(name)
    return found ?? this.#refuse(`it needs ${shown(name)} beside it: give it together with this file.`)
  }

  #hdf<T extends NumberList>(item: XmlNode, count: number, List: new (length: number) => T): T {
    const word = this.#word(item)
    const colon = word.lastIndexOf(':')
    const [name, path] = [word.slice(0, colon), word.slice(colon + 1)]
    if (colon <= 0 || path === '') this.#refuse(`${shown(word)} names no dataset in an HDF5 file, as a.h5:/points.`)
    const file = this.#beside(name)
    const values = (this.#hdf5 ?? this.#refuse('its numbers are in HDF5, which is not read here.'))(file, path)
    if (values.length !== count) this.#refuse(`${shown(word)} has ${values.length} numbers; ${count} were expected.`)
    if (List === (Float64Array as unknown)) return values as NumberList as T
    const list = new List(count)
    for (let i = 0; i < count; ++i) {
      list[i] = values[i] as number
      if (list[i] !== values[i]) this.#refuse(`${shown(word)} has ${values[i]}, where an index from 0 on was expected.`)
    }
    return list
  }

  #binary<T extends NumberList>(item: XmlNode, type: NumberType, count: number, List: new (length: number) => T): T {
    const compression = item.attributes.get('Compression') ?? 'Raw'
    if (!/^raw$/i.test(compression)) this.#refuse(`an item packed by ${shown(compression)} is not read.`)
    const name = this.#word(item)
    const file = this.#beside(name)
    const seek = item.attributes.get('Seek') ?? '0'
    const from = Number(seek)
    const end = from + count * sizeOf(type)
    if (!(Number.isSafeInteger(from) && from >= 0))
      this.#refuse(`an item begins at byte ${shown(seek)} of ${shown(name)}: a whole number from 0 on was expected.`)
    if (end > file.size) this.#refuse(`${shown(name)} has ${file.size} bytes; numbers up to byte ${end} were expected.`)
    const isBig = /^big$/i.test(item.attributes.get('Endian') ?? '')
    const list = new List(count)
    for (let at = from; at < end; at += AT_ONCE) {
      this.#options.throwIfCancelled()
      const done = (at - from) / sizeOf(type)
      const bad = putNumbers(type, file.read(at, Math.min(end, at + AT_ONCE)), isBig, list, done)
      if (bad !== null)
        this.#refuse(
          `${shown(name)} has ${bad.value} as number ${done + bad.at}, where an index from 0 on was expected.`,
        )
    }
    return list
  }
}

function geometryType({ attributes }: XmlNode): string {
  return (attributes.get('GeometryType') ?? attributes.get('Type') ?? 'XYZ').toUpperCase()
}

function formatOf({ attributes }: XmlNode): 'XML' | 'HDF' | 'BINARY' {
  const format = (attributes.get('Format') ?? 'XML').toUpperCase()
  return format === 'HDF' || format === 'BINARY' ? format : 'XML'
}

/** All combinations of coordinates along the axes, x first. */
function lattice([x, y, z]: readonly [Float64Array, Float64Array, Float64Array]): Float64Array {
  const points = new Float64Array(3 * x.length * y.length * z.length)
  let at = 0
  for (const c of z)
    for (const b of y)
      for (const a of x) {
        points[at] = a
        points[at + 1] = b
        points[at + 2] = c
        at += 3
      }
  return points
}
