/**
 * `hexlens/mesh`: meshes out of files and texts, as `hexlens check` and the page read them, in Node, a worker or a page.
 *
 *     const [mesh] = readMeshes(fileOfBytes('part.inp', bytes))   // or throws a MeshRefusal, whose message is a sentence
 *     const { points, cells } = mesh                               // as `hexlens/batch` takes them
 *     const vertices = verticesOf(mesh, 0)                         // as `hexlens/core` takes them
 *
 * CGNS, MED and others lie in HDF5; without the reader of these, such a file throws Hdf5Needed:
 *
 *     const meshes = readMeshes(file, { hdf5: await loadHdf5() })
 */
export { Hdf5Needed } from '../mesh/hdf5-reader'
export { type Block, type Mesh, MeshRefusal, type NotTrilinear } from '../mesh/mesh'
export { MissingFiles, readMeshes, readTogether } from '../mesh/read-mesh'
export {
  type FindFile,
  fileOfBytes,
  type Hdf5Numbers,
  type Hdf5Reader,
  type MeshFile,
  type ReadOptions,
} from '../mesh/source'
export { verticesOf } from '../mesh/vertices-of'
export { loadHdf5 } from './hdf5-module'
