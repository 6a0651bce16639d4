/** Exodus II in netCDF-4, which is HDF5: a variable is a dataset of the root group. */
import type { Hdf5Dataset, Hdf5File } from '../hdf5/hdf5-file'
import type { Mesh } from '../mesh'
import type { MeshFile, ReadOptions } from '../source'
import { exodusMesh, isExodus } from './exodus-model'
import type { Variable, Variables } from './netcdf-variables'

export function isExodusHdf5(hdf5: Hdf5File): boolean {
  return isExodus(hdf5.names('/'))
}

export function readExodusHdf5(hdf5: Hdf5File, file: MeshFile, options: ReadOptions): readonly Mesh[] {
  const variables: Variables = {
    names: hdf5.names('/'),
    variable(name) {
      const dataset = hdf5.findDataset('/', name)
      return dataset && variableOf(hdf5, dataset)
    },
  }
  return [exodusMesh(file, variables, options)]
}

function variableOf(hdf5: Hdf5File, dataset: Hdf5Dataset): Variable {
  return {
    shape: dataset.shape,
    isFloat32: dataset.isFloat32,
    floatsFrom: null,
    text: attribute => hdf5.textAttribute(dataset.path, attribute),
    numbers: (from, into) => dataset.read(from, into),
    indices(from, into) {
      dataset.read(from, into)
      return null
    },
    strings: () => dataset.strings(),
  }
}
