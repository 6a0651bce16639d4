/** Marks of files that are not read, and their names. */

export interface Known {
  /** True for one of these, by the text of its first bytes (latin1) and its name in lower case. */
  readonly is: (head: string, name: string) => boolean
  /** "an Exodus II file (netCDF)" */
  readonly what: string
  /** The advice, as a clause: "meshio converts it: meshio convert a.e a.vtu". */
  readonly instead: string
}

export const HDF5 = '\x89HDF\r\n\x1a\n'

export const meshio = (ending: string) => `meshio converts it: meshio convert a.${ending} a.vtu`
export const starts =
  (...marks: readonly string[]) =>
  (head: string) =>
    marks.some(mark => head.startsWith(mark))
export const has = (pattern: RegExp) => (head: string) => pattern.test(head)
export const ends =
  (...endings: readonly string[]) =>
  (_: string, name: string) =>
    endings.some(ending => name.endsWith(ending))
export const MAKE_HEXAHEDRA = 'it has no hexahedra; Gmsh or Cubit mesh its inside'
export const SAVE_MESH = 'open it in the program that wrote it and export the mesh as VTU, MSH or INP'
