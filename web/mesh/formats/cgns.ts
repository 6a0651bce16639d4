/**
 * CGNS in HDF5: a tree of nodes, each a group with a label and perhaps numbers in the dataset " data". Zones are structured, a lattice of points
 * that implies its cells, or unstructured, with sections of elements. Each zone is a block, and so is each of several sections with hexahedra.
 */
import { type Hdf5Dataset, type Hdf5File, within } from '../hdf5/hdf5-file'
import { type Mesh, MOST_IMPLIED_CELLS } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import { shown } from '../shown'
import type { MeshFile, ReadOptions } from '../source'
import { CGNS_MIXED, CGNS_NFACE, CGNS_NGON, cgnsType } from './cgns-types'
import { addRows, countedFrom } from './node-rows'

const DATA = ' data'

export function isCgns(hdf5: Hdf5File): boolean {
  return hdf5.hasGroup('/', 'CGNSLibraryVersion')
}

export function readCgns(hdf5: Hdf5File, file: MeshFile, options: ReadOptions): readonly Mesh[] {
  const reader = new CgnsReader(hdf5, new MeshBuilder('CGNS', file.name), options)
  return [reader.mesh()]
}

interface Section {
  readonly path: string
  readonly name: string
  readonly type: number
  /** The number of its first element, and how many there are. */
  readonly first: number
  readonly count: number
}

class CgnsReader {
  readonly #hdf5: Hdf5File
  readonly #builder: MeshBuilder
  readonly #options: ReadOptions
  #largest = 0

  constructor(hdf5: Hdf5File, builder: MeshBuilder, options: ReadOptions) {
    this.#hdf5 = hdf5
    this.#builder = builder
    this.#options = options
  }

  mesh(): Mesh {
    const bases = this.#labelled('/', 'CGNSBase_t')
    const zones = bases.flatMap(base =>
      this.#labelled(within('/', base), 'Zone_t').map(name => ({ base, name, path: within(within('/', base), name) })),
    )
    if (zones.length === 0) this.#hdf5.refuse('this CGNS file has no zone.')
    for (const { base, name, path } of zones) {
      this.#options.throwIfCancelled()
      const block = bases.length > 1 ? `${base}/${name}` : name
      if (this.#textOf(path, 'ZoneType') === 'Structured') this.#structured(path, block)
      else this.#unstructured(path, block)
    }
    const note = float32Note(this.#largest)
    if (note !== null) this.#builder.note(note)
    return this.#builder.mesh()
  }

  /** Names of the nodes below one that have a label. A link to another file is refused: nothing is to be missing. */
  #labelled(path: string, label: string): readonly string[] {
    return this.#hdf5.groups(path).filter(name => {
      const own = within(path, name)
      if (this.#hdf5.textAttribute(own, 'type') === 'LK')
        this.#hdf5.refuse(`${shown(own)} is a link to another node; links are not followed.`)
      return this.#hdf5.textAttribute(own, 'label') === label
    })
  }

  /** Numbers of a node below another; null if there is none. */
  #find(path: string, name: string): Hdf5Dataset | null {
    return this.#hdf5.hasGroup(path, name) ? this.#hdf5.findDataset(within(path, name), DATA) : null
  }

  #integers(dataset: Hdf5Dataset | null, count: number, what: string): number[] {
    if (dataset === null || dataset.count < count || dataset.count > 1000)
      this.#hdf5.refuse(`${what} should have ${count} numbers and has ${dataset?.count ?? 'none'}.`)
    return Array.from(dataset.all(Float64Array))
  }

  #textOf(path: string, name: string): string | null {
    return this.#find(path, name)?.strings()[0]?.trim() ?? null
  }

  /** Adds the points; returns how many there are. `expected` is null where any number is right. */
  #points(zone: string, expected: number): number {
    const hdf5: Hdf5File = this.#hdf5
    const [grid] = this.#labelled(zone, 'GridCoordinates_t').toSorted(
      (a, b) => Number(b === 'GridCoordinates') - Number(a === 'GridCoordinates'),
    )
    if (grid === undefined) hdf5.refuse(`${shown(zone)} has no coordinates (GridCoordinates_t).`)
    const path = within(zone, grid)
    if (
      this.#find(path, 'Rind')
        ?.all(Float64Array)
        .some(rind => rind !== 0)
    )
      hdf5.refuse(`${shown(path)} has rind points, which are not read.`)
    if (!hdf5.hasGroup(path, 'CoordinateX'))
      hdf5.refuse(`${shown(path)} has no CoordinateX; Cartesian coordinates are read.`)
    const axes = ['X', 'Y', 'Z'].map(axis => this.#find(path, `Coordinate${axis}`))
    const lists = axes.map(axis => {
      if (axis === null) return null
      if (axis.count !== expected)
        hdf5.refuse(`${shown(axis.path)} has ${axis.count} numbers; the zone has ${expected} points.`)
      const list = axis.all(Float64Array)
      if (axis.isFloat32) this.#largest = Math.max(this.#largest, largestOf(list))
      return list
    })
    const [xs, ys, zs] = lists
    this.#builder.reserve(expected, 0)
    for (let i = 0; i < expected; ++i) this.#builder.point(xs?.[i] ?? 0, ys?.[i] ?? 0, zs?.[i] ?? 0)
    return expected
  }

  #structured(path: string, block: string): void {
    const hdf5: Hdf5File = this.#hdf5
    const builder = this.#builder
    const size = hdf5.dataset(path, DATA)
    const dimensions = size.shape.at(-1) ?? 0
    if (size.shape.length !== 2 || size.shape[0] !== 3 || !(dimensions >= 1 && dimensions <= 3))
      hdf5.refuse(`${shown(size.path)} has the shape ${size.shape.join(' x ')}; three rows of sizes were expected.`)
    const [ni = 1, nj = 1, nk = 1] = this.#integers(size, 3 * dimensions, shown(size.path)).slice(0, dimensions)
    if (![ni, nj, nk].every(n => Number.isSafeInteger(n) && n >= 1))
      hdf5.refuse(`the zone ${shown(block)} has ${[ni, nj, nk].join(' x ')} points.`)
    const cells = (ni - 1) * (nj - 1) * (nk - 1)
    if (cells > MOST_IMPLIED_CELLS)
      hdf5.refuse(`the zone ${shown(block)} implies ${cells} cells; at most ${MOST_IMPLIED_CELLS} are read.`)
    if (cells === 0) {
      const flat = [ni, nj, nk].filter(n => n > 1).map(n => n - 1)
      const kind = (['vertex', 'line', 'quadrilateral'] as const)[flat.length] ?? 'quadrilateral'
      builder.otherCell(
        kind,
        flat.reduce((product, n) => product * n, 1),
      )
      return
    }
    const first = builder.pointCount
    this.#points(path, ni * nj * nk)
    builder.reserve(0, cells)
    const from = builder.cellCount
    const layer = ni * nj
    for (let k = 0; k + 1 < nk; ++k)
      for (let j = 0; j + 1 < nj; ++j)
        for (let i = 0; i + 1 < ni; ++i) {
          const p = first + i + ni * j + layer * k
          const q = p + layer
          builder.hexahedron([p, p + 1, p + 1 + ni, p + ni, q, q + 1, q + 1 + ni, q + ni])
        }
    builder.restInBlock(block, from)
  }

  #unstructured(path: string, block: string): void {
    const hdf5: Hdf5File = this.#hdf5
    const size = hdf5.dataset(path, DATA)
    const [points = 0] = this.#integers(size, 3, shown(size.path))
    if (!Number.isSafeInteger(points) || points < 0) hdf5.refuse(`the zone ${shown(block)} has ${points} points.`)
    const first = this.#builder.pointCount
    this.#points(path, points)
    const from = this.#builder.cellCount
    const parts: { readonly name: string; readonly from: number; readonly to: number }[] = []
    for (const section of this.#sections(path)) {
      const before = this.#builder.cellCount
      this.#section(section, first, points)
      const to = this.#builder.cellCount
      if (to > before) parts.push({ name: `${block}/${section.name}`, from: before, to })
    }
    this.#builder.restInBlock(block, from)
    if (parts.length < 2) return
    for (const { name, from, to } of parts) for (let cell = from; cell < to; ++cell) this.#builder.inBlock(name, cell)
  }

  /** In the order of their elements' numbers. */
  #sections(zone: string): Section[] {
    return this.#labelled(zone, 'Elements_t')
      .map(name => {
        const path = within(zone, name)
        const [type = 0] = this.#integers(this.#hdf5.dataset(path, DATA), 1, shown(path))
        const place = shown(within(path, 'ElementRange'))
        const [first = 0, last = 0] = this.#integers(this.#find(path, 'ElementRange'), 2, place)
        if (!Number.isSafeInteger(first) || !Number.isSafeInteger(last) || last < first - 1)
          this.#hdf5.refuse(`${place} runs from ${first} to ${last}.`)
        return { path, name, type, first, count: last - first + 1 }
      })
      .sort((a, b) => a.first - b.first)
  }

  #section(section: Section, firstPoint: number, points: number): void {
    const { path, type: number, first, count } = section
    const builder = this.#builder
    const hdf5: Hdf5File = this.#hdf5
    if (number === CGNS_NGON || number === CGNS_NFACE) {
      builder.otherCell(number === CGNS_NGON ? 'polygon' : 'polyhedron', count)
      return
    }
    if (count === 0) return
    const dataset = this.#find(path, 'ElementConnectivity')
    if (dataset === null) hdf5.refuse(`${shown(path)} has no ElementConnectivity.`)
    const nodes = dataset.all(Uint32Array)
    if (number === CGNS_MIXED) {
      this.#mixed(section, nodes, firstPoint, points)
      return
    }
    const type = cgnsType(number)
    if (type === null) hdf5.refuse(`${shown(path)} has elements of type ${number}, which CGNS does not have.`)
    if (nodes.length !== count * type.nodes)
      hdf5.refuse(`${shown(path)} has ${nodes.length} nodes for ${count} elements of ${type.nodes}.`)
    const ids = type.kind === 'hexahedron' ? countedFrom(first, count) : null
    addRows(builder, { type, nodes, firstNode: 1, firstPoint, points, ids, place: path })
  }

  /** Each element with its type in front. */
  #mixed({ path, first, count }: Section, nodes: Uint32Array, firstPoint: number, points: number): void {
    const hdf5: Hdf5File = this.#hdf5
    const builder = this.#builder
    const corners = [0, 0, 0, 0, 0, 0, 0, 0]
    let at = 0
    for (let i = 0; i < count; ++i) {
      const number = nodes[at] ?? 0
      const type = cgnsType(number)
      if (at >= nodes.length) hdf5.refuse(`${shown(path)} ends after ${i} of its ${count} elements.`)
      if (type === null)
        hdf5.refuse(`element ${first + i} of ${shown(path)} has type ${number}, which CGNS does not have.`)
      const from = at + 1
      at = from + type.nodes
      if (at > nodes.length) hdf5.refuse(`${shown(path)} ends within its element ${first + i}.`)
      for (let n = from; n < at; ++n) {
        const node = nodes[n] as number
        if (node < 1 || node > points)
          hdf5.refuse(`element ${first + i} of ${shown(path)} names node ${node}; the nodes are 1 to ${points}.`)
      }
      if (type.kind !== 'hexahedron' && type.kind !== 'curved') {
        builder.otherCell(type.kind)
        continue
      }
      for (let v = 0; v < 8; ++v) corners[v] = (nodes[from + v] as number) - 1 + firstPoint
      if (type.kind === 'hexahedron') builder.hexahedron(corners, first + i)
      else
        builder.quadraticCell(
          corners,
          Array.from(nodes.subarray(from + 8, at), node => node - 1 + firstPoint),
        )
    }
    if (at < nodes.length)
      hdf5.refuse(`${shown(path)} has ${nodes.length - at} numbers more than its ${count} elements.`)
  }
}
