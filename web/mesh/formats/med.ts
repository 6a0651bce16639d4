/**
 * MED, Salome's and Code_Aster's HDF5 files. All numbers stand component by component: x of all nodes, then y, then z; first nodes of all cells,
 * then second ones. A hexahedron's nodes run the other way round than VTK's. Families, which are numbers of cells, belong to groups, which are names.
 */
import { type Hdf5File, within } from '../hdf5/hdf5-file'
import type { Mesh } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import { shown } from '../shown'
import type { MeshFile, ReadOptions } from '../source'
import { missingStep, stepNote } from '../step-note'
import { wordTable } from '../word-table'
import { addRows, type RowType } from './node-rows'

const MESHES = '/ENS_MAA'
const FAMILIES = '/FAS'

/** Types of cells by their names; 0 nodes for those that have any number of them. */
const TYPES = wordTable<Record<string, RowType>>({
  PO1: { kind: 'vertex', nodes: 1 },
  SE2: { kind: 'line', nodes: 2 },
  SE3: { kind: 'line', nodes: 3 },
  SE4: { kind: 'line', nodes: 4 },
  TR3: { kind: 'triangle', nodes: 3 },
  TR6: { kind: 'triangle', nodes: 6 },
  TR7: { kind: 'triangle', nodes: 7 },
  QU4: { kind: 'quadrilateral', nodes: 4 },
  QU8: { kind: 'quadrilateral', nodes: 8 },
  QU9: { kind: 'quadrilateral', nodes: 9 },
  TE4: { kind: 'tetrahedron', nodes: 4 },
  T10: { kind: 'tetrahedron', nodes: 10 },
  PY5: { kind: 'pyramid', nodes: 5 },
  P13: { kind: 'pyramid', nodes: 13 },
  PE6: { kind: 'wedge', nodes: 6 },
  P15: { kind: 'wedge', nodes: 15 },
  P18: { kind: 'wedge', nodes: 18 },
  HE8: { kind: 'hexahedron', nodes: 8 },
  H20: { kind: 'curved', nodes: 20 },
  H27: { kind: 'curved', nodes: 27 },
  O12: { kind: 'other', nodes: 12 },
  POG: { kind: 'polygon', nodes: 0 },
  PO2: { kind: 'polygon', nodes: 0 },
  POE: { kind: 'polyhedron', nodes: 0 },
})

/** The corner of MED that stands in each place of VTK's order. */
const MED_ORDER = [0, 3, 2, 1, 4, 7, 6, 5] as const
/** meshio writes VTK's order. */
const MESHIO = 'Mesh created with meshio'

const [CARTESIAN, UNSTRUCTURED] = [0, 0] as const

export function isMed(hdf5: Hdf5File): boolean {
  return hdf5.hasGroup('/', 'ENS_MAA')
}

export function readMed(hdf5: Hdf5File, file: MeshFile, options: ReadOptions): readonly Mesh[] {
  const meshes = hdf5.groups(MESHES)
  if (meshes.length === 0) hdf5.refuse('this MED file has no mesh in ENS_MAA.')
  return meshes.map(name => new MedReader(hdf5, name, new MeshBuilder('MED', file.name), options).mesh())
}

class MedReader {
  readonly #hdf5: Hdf5File
  readonly #name: string
  readonly #path: string
  readonly #builder: MeshBuilder
  readonly #options: ReadOptions
  /** Names of the blocks of each family, by its number. */
  readonly #blocks = new Map<number, readonly string[]>()

  constructor(hdf5: Hdf5File, name: string, builder: MeshBuilder, options: ReadOptions) {
    this.#hdf5 = hdf5
    this.#name = name
    this.#path = within(MESHES, name)
    this.#builder = builder
    this.#options = options
  }

  mesh(): Mesh {
    const hdf5: Hdf5File = this.#hdf5
    const number = (attribute: string, otherwise: number) => hdf5.numberAttribute(this.#path, attribute) ?? otherwise
    if (number('TYP', UNSTRUCTURED) !== UNSTRUCTURED)
      hdf5.refuse(`the mesh ${shown(this.#name)} is a structured one; unstructured MED meshes are read.`)
    if (number('REP', CARTESIAN) !== CARTESIAN)
      hdf5.refuse(`the mesh ${shown(this.#name)} has cylindrical or spherical coordinates; Cartesian ones are read.`)
    const dimension = number('ESP', number('DIM', 3))
    if (![1, 2, 3].includes(dimension))
      hdf5.refuse(`the mesh ${shown(this.#name)} has ${dimension} dimensions; 1 to 3 were expected.`)
    const step = this.#step()
    const points = this.#points(step, dimension)
    this.#families()
    this.#cells(step, points)
    return this.#builder.mesh()
  }

  /** The group that has nodes and cells: of a time step, in old files of the mesh itself. */
  #step(): string {
    const hdf5: Hdf5File = this.#hdf5
    if (hdf5.hasGroup(this.#path, 'NOE')) return this.#path
    const steps = hdf5.groups(this.#path).filter(name => hdf5.hasGroup(within(this.#path, name), 'NOE'))
    if (steps.length === 0) hdf5.refuse(`the mesh ${shown(this.#name)} has no nodes (NOE).`)
    const { step } = this.#options
    const at = step === 'last' ? steps.length - 1 : step
    const own = steps[at]
    if (own === undefined) hdf5.refuse(missingStep(steps.length, step))
    const times = steps.map(name => String(hdf5.numberAttribute(within(this.#path, name), 'PDT') ?? name))
    if (steps.length > 1) {
      this.#builder.steps = times
      this.#builder.note(stepNote(times, at))
    }
    return within(this.#path, own)
  }

  #points(step: string, dimension: number): number {
    const builder = this.#builder
    const dataset = this.#hdf5.dataset(within(step, 'NOE'), 'COO')
    if (dataset.count % dimension !== 0)
      builder.refuse(`${shown(dataset.path)} has ${dataset.count} coordinates for ${dimension} dimensions.`)
    const all = dataset.all(Float64Array)
    const count = all.length / dimension
    builder.reserve(count, 0)
    for (let i = 0; i < count; ++i)
      builder.point(
        all[i] as number,
        dimension > 1 ? (all[count + i] as number) : 0,
        dimension > 2 ? (all[2 * count + i] as number) : 0,
      )
    const note = dataset.isFloat32 ? float32Note(largestOf(all)) : null
    if (note !== null) builder.note(note)
    return count
  }

  /** In old files families belong to the mesh, in newer ones to the file. */
  #families(): void {
    const hdf5: Hdf5File = this.#hdf5
    const own = hdf5.hasGroup(this.#path, 'FAS')
      ? within(this.#path, 'FAS')
      : hdf5.hasGroup('/', 'FAS') && hdf5.hasGroup(FAMILIES, this.#name)
        ? within(FAMILIES, this.#name)
        : null
    if (own === null) return
    for (const folder of [own, ...(hdf5.hasGroup(own, 'ELEME') ? [within(own, 'ELEME')] : [])])
      for (const name of hdf5.groups(folder)) {
        const path = within(folder, name)
        const number = hdf5.numberAttribute(path, 'NUM')
        // Family 0 is that of the cells in no group.
        if (number === null || number === 0) continue
        const groups = hdf5.hasGroup(path, 'GRO') ? (hdf5.findDataset(within(path, 'GRO'), 'NOM')?.strings() ?? []) : []
        const named = groups.map(group => group.trim()).filter(group => group !== '')
        this.#blocks.set(number, named.length > 0 ? named : [name])
      }
  }

  #cells(step: string, points: number): void {
    const hdf5: Hdf5File = this.#hdf5
    const builder = this.#builder
    if (!hdf5.hasGroup(step, 'MAI')) hdf5.refuse(`the mesh ${shown(this.#name)} has no cells (MAI).`)
    const cells = within(step, 'MAI')
    const isMeshio = hdf5.textAttribute(this.#path, 'DES') === MESHIO
    for (const name of hdf5.groups(cells)) {
      this.#options.throwIfCancelled()
      const path = within(cells, name)
      const type: RowType = TYPES[name] ?? { kind: 'other', nodes: 0 }
      const nodes = hdf5.dataset(path, 'NOD')
      if (type.nodes === 0) {
        // As many cells as there are places where one begins, but for the last, where all end.
        const ends = hdf5.findDataset(path, 'INN')
        builder.otherCell(
          type.kind === 'hexahedron' || type.kind === 'curved' ? 'other' : type.kind,
          Math.max(0, (ends?.count ?? 1) - 1),
        )
        continue
      }
      const order = isMeshio ? {} : { order: MED_ORDER }
      const first = addRows(builder, {
        type,
        nodes: nodes.all(Uint32Array),
        ...order,
        isByNode: true,
        firstNode: 1,
        firstPoint: 0,
        points,
        ids: type.kind === 'hexahedron' ? this.#ids(path) : null,
        place: path,
      })
      if (isMeshio && (type.kind === 'hexahedron' || type.kind === 'curved'))
        builder.note('meshio wrote this file, with the nodes in VTK’s order in place of MED’s: it is read so.')
      if (type.kind === 'hexahedron') this.#putInBlocks(path, first)
    }
  }

  /** The numbers of the cells, if they have any. */
  #ids(path: string): Float64Array | null {
    return this.#hdf5.findDataset(path, 'NUM')?.all(Float64Array) ?? null
  }

  #putInBlocks(path: string, first: number): void {
    const dataset = this.#hdf5.findDataset(path, 'FAM')
    if (dataset === null) return
    const builder = this.#builder
    const families = dataset.all(Float64Array)
    if (families.length !== builder.cellCount - first)
      builder.refuse(`${shown(dataset.path)} has ${families.length} numbers for ${builder.cellCount - first} cells.`)
    for (let i = 0; i < families.length; ++i)
      for (const block of this.#blocks.get(families[i] as number) ?? []) builder.inBlock(block, first + i)
  }
}
