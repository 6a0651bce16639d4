/** MOAB's HDF5 files (.h5m): entities are numbered through, nodes first; elements name their nodes by these numbers. */
import { type Hdf5File, within } from '../hdf5/hdf5-file'
import type { Mesh } from '../mesh'
import { MeshBuilder, type OtherCell } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import { shown } from '../shown'
import type { MeshFile, ReadOptions } from '../source'
import { addRows, countedFrom, type RowType } from './node-rows'

const ROOT = '/tstt'

/** By the beginning of a group's name, behind which its number of nodes stands: "Hex8". */
const KINDS: readonly (readonly [string, OtherCell | 'hexahedron'])[] = [
  ['Hex', 'hexahedron'],
  ['Tet', 'tetrahedron'],
  ['Prism', 'wedge'],
  ['Pyramid', 'pyramid'],
  ['Quad', 'quadrilateral'],
  ['Tri', 'triangle'],
  ['Edge', 'line'],
  ['Polygon', 'polygon'],
  ['Polyhedron', 'polyhedron'],
]

export function isMoab(hdf5: Hdf5File): boolean {
  return hdf5.hasGroup('/', 'tstt')
}

export function readMoab(hdf5: Hdf5File, file: MeshFile, options: ReadOptions): readonly Mesh[] {
  const builder = new MeshBuilder('MOAB', file.name)
  if (!hdf5.hasGroup(ROOT, 'nodes')) hdf5.refuse('this MOAB file has no nodes.')
  const nodes = hdf5.dataset(within(ROOT, 'nodes'), 'coordinates')
  const [count = 0, dimension = 0] = nodes.shape
  if (nodes.shape.length !== 2 || !(dimension >= 1 && dimension <= 3))
    hdf5.refuse(
      `${shown(nodes.path)} has the shape ${nodes.shape.join(' x ')}; up to three coordinates a row were expected.`,
    )
  const all = nodes.all(Float64Array)
  builder.reserve(count, 0)
  for (let i = 0; i < count; ++i) {
    const at = dimension * i
    builder.point(
      all[at] as number,
      dimension > 1 ? (all[at + 1] as number) : 0,
      dimension > 2 ? (all[at + 2] as number) : 0,
    )
  }
  const note = nodes.isFloat32 ? float32Note(largestOf(all)) : null
  if (note !== null) builder.note(note)
  const firstNode = hdf5.numberAttribute(nodes.path, 'start_id')
  if (firstNode === null || !Number.isSafeInteger(firstNode))
    return hdf5.refuse(`${shown(nodes.path)} does not say the number of its first node (start_id).`)
  if (hdf5.hasGroup(ROOT, 'elements'))
    for (const name of hdf5.groups(within(ROOT, 'elements'))) {
      options.throwIfCancelled()
      readElements(hdf5, builder, name, { firstNode, points: count })
    }
  return [builder.mesh()]
}

function readElements(
  hdf5: Hdf5File,
  builder: MeshBuilder,
  name: string,
  { firstNode, points }: { readonly firstNode: number; readonly points: number },
): void {
  const path = within(within(ROOT, 'elements'), name)
  const nodes = hdf5.dataset(path, 'connectivity')
  const kind = KINDS.find(([word]) => name.startsWith(word))?.[1] ?? 'other'
  const [count = 0, width = 0] = nodes.shape
  if (kind === 'polygon' || kind === 'polyhedron') {
    builder.otherCell(kind, hdf5.findDataset(path, 'poly_indices')?.count ?? count)
    return
  }
  if (nodes.shape.length !== 2 || width === 0)
    hdf5.refuse(
      `${shown(nodes.path)} has the shape ${nodes.shape.join(' x ')}; the nodes of an element in a row were expected.`,
    )
  if (kind === 'hexahedron' && width < 8) hdf5.refuse(`the elements of ${shown(path)} have ${width} nodes.`)
  const type: RowType = { kind: kind === 'hexahedron' && width > 8 ? 'curved' : kind, nodes: width }
  const ids = type.kind === 'hexahedron' ? idsOf(hdf5, path, count) : null
  addRows(builder, { type, nodes: nodes.all(Uint32Array), firstNode, firstPoint: 0, points, ids, place: path })
}

/** GLOBAL_ID, if the elements have it; else the numbers that the file gives them. */
function idsOf(hdf5: Hdf5File, path: string, count: number): Float64Array | null {
  if (hdf5.hasGroup(path, 'tags')) {
    const own = hdf5.findDataset(within(path, 'tags'), 'GLOBAL_ID')
    if (own !== null && own.count === count) return own.all(Float64Array)
  }
  const first = hdf5.numberAttribute(within(path, 'connectivity'), 'start_id')
  return first === null ? null : countedFrom(first, count)
}
