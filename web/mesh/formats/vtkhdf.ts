/**
 * VTKHDF: unstructured grids in parts, at one or several times, alone or as the blocks of a collection. The arrays of all parts and times stand one
 * after the other; counts and, in `Steps`, offsets say where those of one begin. `Offsets` has one number more than cells for each part.
 */
import { type Hdf5Dataset, type Hdf5File, within } from '../hdf5/hdf5-file'
import type { Mesh } from '../mesh'
import { shown } from '../shown'
import type { MeshFile, ReadOptions } from '../source'
import { missingStep } from '../step-note'
import { type CellData, cellDataOf, cellDataRank } from './vtk-cell-data'
import { firstFall, VtkMesh } from './vtk-mesh'
import { precisionOf } from './vtk-middles'

const ROOT = '/VTKHDF'
const GRID = 'UnstructuredGrid'
const COLLECTIONS = ['PartitionedDataSetCollection', 'MultiBlockDataSet']
/** vtkDataSetAttributes::DUPLICATECELL */
const IS_COPY = 1

export function isVtkHdf(hdf5: Hdf5File): boolean {
  return hdf5.hasGroup('/', 'VTKHDF')
}

export function readVtkHdf(hdf5: Hdf5File, _: MeshFile, options: ReadOptions): readonly Mesh[] {
  const mesh = new VtkMesh('VTKHDF', what => hdf5.refuse(what))
  const type = hdf5.textAttribute(ROOT, 'Type') ?? ''
  if (type === GRID) new GridReader(hdf5, ROOT, mesh, options).read(null)
  else if (COLLECTIONS.includes(type)) {
    const blocks = hdf5.names(ROOT).filter(name => name !== 'Assembly')
    if (blocks.length === 0) hdf5.refuse('its collection has no blocks.')
    for (const name of blocks) {
      const path = within(ROOT, name)
      if (!hdf5.hasGroup(ROOT, name))
        hdf5.refuse(`block ${shown(name)} is a link to another file; links are not followed.`)
      const own = hdf5.textAttribute(path, 'Type') ?? ''
      if (own === GRID) new GridReader(hdf5, path, mesh, options).read(name)
      else mesh.note(`Block ${shown(name)} is of type ${shown(own)} and was left out: unstructured grids are read.`)
    }
  } else hdf5.refuse(`it holds data of type ${shown(type)}; unstructured grids and collections of them are read.`)
  mesh.noteSteps(options.step)
  return [mesh.mesh()]
}

/** Where the parts of one time begin in each array. */
interface Beginnings {
  readonly step: number | null
  readonly part: number
  readonly parts: number
  readonly point: number
  readonly cell: number
  readonly connectivity: number
}

class GridReader {
  readonly #hdf5: Hdf5File
  readonly #path: string
  readonly #mesh: VtkMesh
  readonly #options: ReadOptions

  constructor(hdf5: Hdf5File, path: string, mesh: VtkMesh, options: ReadOptions) {
    this.#hdf5 = hdf5
    this.#path = path
    this.#mesh = mesh
    this.#options = options
  }

  read(block: string | null): void {
    const counts = {
      points: this.#counts('NumberOfPoints'),
      cells: this.#counts('NumberOfCells'),
      connectivity: this.#counts('NumberOfConnectivityIds'),
    }
    const lengths = [counts.points.length, counts.cells.length, counts.connectivity.length]
    if (new Set(lengths).size > 1)
      this.#hdf5.refuse(
        `${shown(this.#path)} has ${lengths.join(', ')} numbers of points, cells and connectivity; as many of each were expected.`,
      )
    const first = this.#beginnings(counts.points.length)
    let { point, cell, connectivity } = first
    let ghosts = 0
    for (let i = 0; i < first.parts; ++i) {
      this.#options.throwIfCancelled()
      const part = first.part + i
      const points = counts.points[part] as number
      const cells = counts.cells[part] as number
      const ids = counts.connectivity[part] as number
      ghosts += this.#part({ points, cells, ids, point, cell, connectivity, offset: cell + part }, first, block)
      point += points
      cell += cells
      connectivity += ids
    }
    if (ghosts > 0)
      this.#mesh.note(`${ghosts} cells are ghosts, copies of cells of another part; they are counted in both.`)
  }

  /** Returns how many of the cells are copies. */
  #part(
    at: {
      readonly points: number
      readonly cells: number
      readonly ids: number
      readonly point: number
      readonly cell: number
      readonly connectivity: number
      readonly offset: number
    },
    first: Beginnings,
    block: string | null,
  ): number {
    const hdf5: Hdf5File = this.#hdf5
    if (at.points === 0 && at.cells === 0) return 0
    const points = this.#dataset('Points')
    if (points.shape.length !== 2 || points.shape[1] !== 3)
      hdf5.refuse(
        `${shown(points.path)} has the shape ${points.shape.join(' x ')}; three coordinates a row were expected.`,
      )
    const ends = this.#list('Offsets', at.offset, at.cells === 0 ? 0 : at.cells + 1, Uint32Array)
    const falling = firstFall(ends)
    if (falling > 0)
      hdf5.refuse(`offset ${at.offset + falling} is ${ends[falling]}, less than ${ends[falling - 1]}, the one before.`)
    if (at.cells > 0 && (ends[0] !== 0 || ends[at.cells] !== at.ids))
      hdf5.refuse(
        `the offsets of a part run from ${ends[0]} to ${ends[at.cells]}; 0 to ${at.ids}, its NumberOfConnectivityIds, were expected.`,
      )
    this.#mesh.add(
      {
        points: this.#list('Points', 3 * at.point, 3 * at.points, Float64Array),
        declaredPoints: at.points,
        connectivity: this.#list('Connectivity', at.connectivity, at.cells === 0 ? 0 : at.ids, Uint32Array),
        ends: ends.subarray(1),
        types: this.#list('Types', at.cell, at.cells, Uint8Array),
        declaredCells: at.cells,
        hasFaceStreams: false,
        precision: precisionOf(points.isFloat32 ? 'Float32' : 'Float64', false, 0),
        cellData: this.#cellData(at.cell - first.cell, at.cells, first),
      },
      block,
    )
    return this.#ghosts(at.cell - first.cell, at.cells, first)
  }

  #counts(name: string): Float64Array {
    const counts = this.#dataset(name).all(Float64Array)
    const bad = counts.findIndex(count => !Number.isSafeInteger(count) || count < 0 || count > 0xffffffff)
    if (bad >= 0) this.#hdf5.refuse(`number ${bad} of ${shown(name)} is ${counts[bad]}; a count was expected.`)
    return counts
  }

  #dataset(name: string): Hdf5Dataset {
    return this.#hdf5.dataset(this.#path, name)
  }

  #list<T extends Float64Array | Uint32Array | Uint8Array>(
    name: string,
    from: number,
    count: number,
    List: new (length: number) => T,
  ): T {
    if (count === 0) return new List(0)
    const dataset = this.#dataset(name)
    if (from + count > dataset.count)
      this.#hdf5.refuse(`${shown(dataset.path)} has ${dataset.count} numbers; ${count} from ${from} on were expected.`)
    const list = new List(count)
    dataset.read(from, list)
    return list
  }

  #beginnings(all: number): Beginnings {
    const hdf5: Hdf5File = this.#hdf5
    const steps = within(this.#path, 'Steps')
    if (!hdf5.hasGroup(this.#path, 'Steps'))
      return { step: null, part: 0, parts: all, point: 0, cell: 0, connectivity: 0 }
    const times = hdf5.dataset(steps, 'Values').all(Float64Array)
    const { step } = this.#options
    const at = step === 'last' ? times.length - 1 : step
    if (at < 0 || at >= times.length) hdf5.refuse(missingStep(times.length, step))
    const mesh: VtkMesh = this.#mesh
    const values = Array.from(times, String)
    if (mesh.steps.length === 0) {
      mesh.steps = values
      mesh.isSteady = true
    }
    if (values.join() !== mesh.steps.join()) hdf5.refuse(`${shown(steps)} has other times than the block before.`)
    const numberOf = (name: string): number => {
      const dataset = hdf5.dataset(steps, name)
      // Several a step where there are several kinds of cells; unstructured grids have one.
      const width = dataset.count / times.length
      if (!Number.isInteger(width) || width === 0)
        hdf5.refuse(`${shown(dataset.path)} has ${dataset.count} numbers for ${times.length} time steps.`)
      const numbers = dataset.all(Uint32Array)
      if (numbers.some((number, i) => number !== numbers[i % width])) mesh.isSteady = false
      return numbers[width * at] as number
    }
    if (all > 1 && hdf5.kind(steps, 'NumberOfParts') === null)
      hdf5.refuse('it has several parts, and Steps has no NumberOfParts.')
    const part = numberOf('PartOffsets')
    const parts = all > 1 ? numberOf('NumberOfParts') : all
    if (part + parts > all) hdf5.refuse(`time step ${at + 1} has the parts up to ${part + parts}; there are ${all}.`)
    return {
      step: at,
      part,
      parts,
      point: numberOf('PointOffsets'),
      cell: numberOf('CellOffsets'),
      connectivity: numberOf('ConnectivityIdOffsets'),
    }
  }

  /** Numbers of the cells of a part, from one of the arrays of all; null if there are not as many. */
  #ofCells<T extends Float64Array | Uint8Array>(
    name: string,
    from: number,
    count: number,
    { step, cell }: Beginnings,
    List: new (length: number) => T,
  ): T | null {
    const hdf5: Hdf5File = this.#hdf5
    const dataset = hdf5.findDataset(within(this.#path, 'CellData'), name)
    if (dataset === null || dataset.type === null || dataset.shape.length !== 1) return null
    let begin = cell
    const steps = within(this.#path, 'Steps')
    if (step !== null && hdf5.hasGroup(steps, 'CellDataOffsets')) {
      const offsets = hdf5.findDataset(within(steps, 'CellDataOffsets'), name)
      if (offsets !== null && step < offsets.count) {
        const own = new Uint32Array(1)
        offsets.read(step, own)
        begin = own[0] as number
      }
    }
    if (begin + from + count > dataset.count) return null
    const list = new List(count)
    dataset.read(begin + from, list)
    return list
  }

  #cellData(from: number, count: number, first: Beginnings): CellData | null {
    const hdf5: Hdf5File = this.#hdf5
    if (!hdf5.hasGroup(this.#path, 'CellData')) return null
    const group = within(this.#path, 'CellData')
    const globalIds = hdf5.textAttribute(group, 'GlobalIds')
    const arrays = new Map<string, Float64Array>()
    for (const name of hdf5.names(group)) {
      if (cellDataRank(name) < 0 && name !== globalIds) continue
      const values = this.#ofCells(name, from, count, first, Float64Array)
      if (values !== null) arrays.set(name, values)
    }
    return arrays.size === 0 ? null : cellDataOf(arrays, globalIds)
  }

  #ghosts(from: number, count: number, first: Beginnings): number {
    if (!this.#hdf5.hasGroup(this.#path, 'CellData')) return 0
    const ghosts = this.#ofCells('vtkGhostType', from, count, first, Uint8Array)
    return ghosts === null ? 0 : ghosts.reduce((sum, ghost) => sum + (ghost & IS_COPY), 0)
  }
}
