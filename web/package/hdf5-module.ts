/** The reader of HDF5 files beside a module of the package. */
import type { Hdf5Reader } from '../mesh/source'
import { startedHdf5 } from './hdf5-place'

/** Loads the reader, 1 MB. Rejects if the file is not there. */
export async function loadHdf5(): Promise<Hdf5Reader> {
  await import('virtual:hexlens.hdf5')
  return startedHdf5()
}
