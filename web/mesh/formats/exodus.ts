/** Exodus II in netCDF's classic formats. */
import { MeshRefusal } from '../mesh'
import type { MeshFormat } from '../source'
import { exodusMesh, isExodus } from './exodus-model'
import { ClassicVariables, isClassicNetcdf } from './netcdf'

/** Bytes that tell of netCDF. */
const MARK = 4

export const exodus: MeshFormat = {
  name: 'Exodus II',
  recognizes: head => (isClassicNetcdf(head) ? 'yes' : 'no'),
  read(file, options) {
    if (!isClassicNetcdf(file.read(0, Math.min(MARK, file.size))))
      throw new MeshRefusal(`${file.name}: this is no netCDF file, and Exodus II is in such files.`)
    const variables = new ClassicVariables(file)
    if (!isExodus(variables.names))
      throw new MeshRefusal(`${file.name}: this netCDF file has no coordx and no connect1: it is no Exodus file.`)
    return [exodusMesh(file, variables, options, () => variables.position)]
  },
}
