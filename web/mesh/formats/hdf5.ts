/** HDF5 files of all kinds: what is in one is found out by the reader that is loaded for them. */
import { answered, hdf5For } from '../hdf5-reader'
import { headText } from '../snippet-text'
import type { MeshFormat } from '../source'
import { HDF5 } from './refused-marks'

export const hdf5: MeshFormat = {
  name: 'HDF5',
  recognizes: head => (headText(head).startsWith(HDF5) ? 'yes' : 'no'),
  read: (file, options) => answered(hdf5For(file, options).read(file, options)),
}
