/** HMF, which meshio writes: the arrays of XDMF in HDF5, without its XML. */
import { type Hdf5File, within } from '../hdf5/hdf5-file'
import type { Mesh } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import { float32Note, largestOf } from '../precision'
import { shown } from '../shown'
import type { MeshFile } from '../source'
import { wordTable } from '../word-table'
import { addRows, type RowType } from './node-rows'

const TYPES = wordTable<Record<string, RowType>>({
  Polyvertex: { kind: 'vertex', nodes: 1 },
  Polyline: { kind: 'line', nodes: 2 },
  Edge_3: { kind: 'line', nodes: 3 },
  Triangle: { kind: 'triangle', nodes: 3 },
  Triangle_6: { kind: 'triangle', nodes: 6 },
  Tri_6: { kind: 'triangle', nodes: 6 },
  Quadrilateral: { kind: 'quadrilateral', nodes: 4 },
  Quadrilateral_8: { kind: 'quadrilateral', nodes: 8 },
  Quadrilateral_9: { kind: 'quadrilateral', nodes: 9 },
  Quad_8: { kind: 'quadrilateral', nodes: 8 },
  Quad_9: { kind: 'quadrilateral', nodes: 9 },
  Tetrahedron: { kind: 'tetrahedron', nodes: 4 },
  Tetrahedron_10: { kind: 'tetrahedron', nodes: 10 },
  Tet_10: { kind: 'tetrahedron', nodes: 10 },
  Pyramid: { kind: 'pyramid', nodes: 5 },
  Pyramid_13: { kind: 'pyramid', nodes: 13 },
  Wedge: { kind: 'wedge', nodes: 6 },
  Wedge_15: { kind: 'wedge', nodes: 15 },
  Wedge_18: { kind: 'wedge', nodes: 18 },
  Hexahedron: { kind: 'hexahedron', nodes: 8 },
  Hexahedron_20: { kind: 'curved', nodes: 20 },
  Hexahedron_24: { kind: 'curved', nodes: 24 },
  Hexahedron_27: { kind: 'curved', nodes: 27 },
  Hex_20: { kind: 'curved', nodes: 20 },
  Hex_24: { kind: 'curved', nodes: 24 },
  Hex_27: { kind: 'curved', nodes: 27 },
})

export function isHmf(hdf5: Hdf5File): boolean {
  return hdf5.textAttribute('/', 'type') === 'hmf'
}

export function readHmf(hdf5: Hdf5File, file: MeshFile): readonly Mesh[] {
  const grids = hdf5.hasGroup('/', 'domain') ? hdf5.groups('/domain') : []
  if (grids.length === 0) hdf5.refuse('this HMF file has no grid in its domain.')
  return grids.map(name => gridOf(hdf5, file, within('/domain', name)))
}

function gridOf(hdf5: Hdf5File, file: MeshFile, path: string): Mesh {
  const builder = new MeshBuilder('HMF', file.name)
  const geometry = hdf5.dataset(path, 'Geometry')
  const [count = 0, dimension = 0] = geometry.shape
  if (geometry.shape.length !== 2 || !(dimension >= 1 && dimension <= 3))
    hdf5.refuse(
      `${shown(geometry.path)} has the shape ${geometry.shape.join(' x ')}; up to three coordinates a row were expected.`,
    )
  const all = geometry.all(Float64Array)
  for (let at = 0; at < all.length; at += dimension)
    builder.point(
      all[at] as number,
      dimension > 1 ? (all[at + 1] as number) : 0,
      dimension > 2 ? (all[at + 2] as number) : 0,
    )
  const note = geometry.isFloat32 ? float32Note(largestOf(all)) : null
  if (note !== null) builder.note(note)
  for (const name of hdf5.names(path).filter(own => /^Topology/.test(own))) {
    const nodes = hdf5.dataset(path, name)
    const called = hdf5.textAttribute(nodes.path, 'TopologyType') ?? ''
    const type = TYPES[called]
    if (type === undefined)
      return hdf5.refuse(`${shown(nodes.path)} has cells of type ${shown(called)}, which is not known.`)
    const all = nodes.all(Uint32Array)
    addRows(builder, { type, nodes: all, firstNode: 0, firstPoint: 0, points: count, ids: null, place: nodes.path })
  }
  return builder.mesh()
}
