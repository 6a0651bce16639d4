/** HDF5 files of all kinds: what is in one is found out by the reader that is loaded for them. */
import { answered, hdf5For } from '../hdf5-reader'
import { MeshRefusal } from '../mesh'
import { headText } from '../snippet-text'
import type { MeshFormat } from '../source'
import { HDF5 } from './refused-marks'

export const hdf5: MeshFormat = {
  name: 'HDF5',
  recognizes: head => (headText(head).startsWith(HDF5) ? 'yes' : 'no'),
  read: (file, options) => answered(hdf5For(file, options).read(file, options)),
}

/** The formats in such files, for those who name one. */
export const inHdf5: readonly MeshFormat[] = ['CGNS', 'MED', 'VTKHDF', 'MOAB', 'HMF'].map(name => ({
  name,
  recognizes: () => 'no',
  read(file, options) {
    const meshes = hdf5.read(file, options)
    const other = meshes.find(({ format }) => format !== name)
    if (other) throw new MeshRefusal(`${file.name}: this is ${other.format}, not ${name}.`)
    return meshes
  },
}))
