/** HDF5 files of all kinds: what is in one is found out by the reader that is loaded for them. */
import { answered, hdf5For } from '../hdf5-reader'
import { type Mesh, MeshRefusal } from '../mesh'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { HDF5 } from './refused-marks'

export const hdf5: MeshFormat = {
  name: 'HDF5',
  recognizes: head => (headText(head).startsWith(HDF5) ? 'yes' : 'no'),
  read: (file, options) => answered(hdf5For(file, options).read(file, options)),
}

/** The formats in such files alone, for those who name one. */
export const inHdf5: readonly MeshFormat[] = ['CGNS', 'MED', 'VTKHDF', 'MOAB', 'HMF'].map(name => ({
  name,
  recognizes: () => 'no',
  read: (file, options) => readNamed(name, file, options),
}))

/** The format as it is named for a file that begins so: formats may lie in HDF5 and in other files. */
export function namedFor(head: Uint8Array, format: MeshFormat): MeshFormat {
  if (format === hdf5 || hdf5.recognizes(head, '') === 'no') return format
  return { ...format, read: (file, options) => readNamed(format.name, file, options) }
}

function readNamed(name: string, file: MeshFile, options: ReadOptions): readonly Mesh[] {
  const meshes = hdf5.read(file, options)
  const other = meshes.find(({ format }) => format !== name)
  if (other) throw new MeshRefusal(`${file.name}: this is ${other.format}, not ${name}.`)
  return meshes
}
