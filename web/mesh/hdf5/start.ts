/** Starts the reader of HDF5 files: the library and the readers of the formats that lie in such files. */
import { isCgns, readCgns } from '../formats/cgns'
import { isExodusHdf5, readExodusHdf5 } from '../formats/exodus-hdf5'
import { isHmf, readHmf } from '../formats/hmf'
import { isMed, readMed } from '../formats/med'
import { isMoab, readMoab } from '../formats/moab'
import { isVtkHdf, readVtkHdf } from '../formats/vtkhdf'
import { type Mesh, MeshRefusal } from '../mesh'
import { shown } from '../shown'
import type { Hdf5Reader, MeshFile, ReadOptions } from '../source'
import { Hdf5File } from './hdf5-file'
import { Hdf5Library } from './library'

interface Kind {
  readonly is: (hdf5: Hdf5File) => boolean
  readonly read: (hdf5: Hdf5File, file: MeshFile, options: ReadOptions) => readonly Mesh[]
}

const KINDS: readonly Kind[] = [
  { is: isVtkHdf, read: readVtkHdf },
  { is: isCgns, read: readCgns },
  { is: isMed, read: readMed },
  { is: isMoab, read: readMoab },
  { is: isExodusHdf5, read: readExodusHdf5 },
  { is: isHmf, read: readHmf },
]

const NOT_READ: readonly { readonly is: (hdf5: Hdf5File) => boolean; readonly sentence: string }[] = [
  {
    is: hdf5 => hdf5.hasGroup('/', 'meshes'),
    sentence: 'this is an Ansys Fluent file (HDF5). Hexlens does not read it yet; Fluent exports it as CGNS.',
  },
  {
    is: () => true,
    sentence:
      'this is an HDF5 file with no mesh of a known kind. Hexlens does not read it; give the .xdmf beside it, if there is one, or export the mesh as VTU, MSH or INP.',
  },
]

export async function startHdf5(): Promise<Hdf5Reader> {
  const library = await Hdf5Library.start()
  return {
    get isWhole() {
      return library.isWhole
    },
    read: (file, options) =>
      inFile(library, file, hdf5 => {
        const kind = KINDS.find(({ is }) => is(hdf5))
        if (kind) return kind.read(hdf5, file, options)
        return hdf5.refuse(NOT_READ.find(({ is }) => is(hdf5))?.sentence ?? '')
      }),
    numbers: (file, path) =>
      inFile(library, file, hdf5 => {
        const parts = path.split('/').filter(part => part !== '')
        const name = parts.pop() ?? ''
        let group = '/'
        for (const part of parts) {
          if (!hdf5.hasGroup(group, part)) hdf5.refuse(`it has no dataset ${shown(path)}.`)
          group = group === '/' ? `/${part}` : `${group}/${part}`
        }
        const dataset = hdf5.dataset(group, name)
        return { shape: dataset.shape, isFloat32: dataset.isFloat32, values: dataset.all(Float64Array) }
      }),
  }
}

function inFile<T>(library: Hdf5Library, file: MeshFile, work: (hdf5: Hdf5File) => T): T | string {
  const hdf5 = new Hdf5File(library, file)
  try {
    hdf5.open()
    return work(hdf5)
  } catch (error) {
    if (error instanceof MeshRefusal) return error.message
    throw error
  } finally {
    hdf5.close()
  }
}
