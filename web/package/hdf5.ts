/**
 * The reader of HDF5 files, a script of its own: workers load it as a script, Node and bundlers as a module. It is left where all of them find it.
 */
import { startHdf5 } from '../mesh/hdf5/start'
import { HDF5_PLACE } from './hdf5-place'

Object.assign(globalThis, { [HDF5_PLACE]: startHdf5 })
