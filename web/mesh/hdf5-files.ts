/** The reader of HDF5 files as a script that is loaded when it is needed. */
import type { Hdf5Reader } from './source'

export async function hdf5Files(): Promise<Hdf5Reader> {
  const { startHdf5 } = await import('./hdf5/start')
  return startHdf5()
}
