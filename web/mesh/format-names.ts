/** The formats that are read, as people know them, for those who do not load their readers: web/mesh/formats.ts is the list. */
export const formatNames = [
  'VTU',
  'VTK',
  'Gmsh',
  'Medit',
  'MFEM',
  'Abaqus',
  'Nastran',
  'Ansys',
  'LS-DYNA',
  'libMesh',
  'UCD',
  'UNV',
  'OVM',
  'Kratos',
  'Tecplot',
  'blockMeshDict',
  'ncdump',
  'OBJ',
] as const

/** Names of what is read and is no mesh format. */
export const otherInputs = 'code, tables and logs with eight points in them, a link or a PNG taken away from here'
