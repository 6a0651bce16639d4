/** Where hexlens.hdf5.js leaves what starts the reader. */
import type { Hdf5Reader } from '../mesh/source'

export const HDF5_PLACE = Symbol.for('hexlens.hdf5')

/** The reader of the script, which has run. */
export function startedHdf5(): Promise<Hdf5Reader> {
  const start = (globalThis as { readonly [HDF5_PLACE]?: () => Promise<Hdf5Reader> })[HDF5_PLACE]
  if (!start) throw new Error('hexlens.hdf5.js is not what was loaded')
  return start()
}
