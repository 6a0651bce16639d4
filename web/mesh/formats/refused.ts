/**
 * Files that are recognized and not read, each with a sentence on what it is and what converts it. A format leaves this table when it gets a
 * file of its own.
 */
import { MeshRefusal } from '../mesh'
import { headText } from '../snippet-text'
import type { MeshFile, MeshFormat } from '../source'
import { shown } from '../text-cursor'

interface Known {
  /** Whether the file is one of these, by the text of its first bytes (latin1) and its name in lower case. */
  readonly is: (head: string, name: string) => boolean
  /** "an Exodus II file (netCDF)" */
  readonly what: string
  /** What to do, as a clause: "meshio converts it: meshio convert a.e a.vtu". */
  readonly instead: string
}

const HDF5 = '\x89HDF\r\n\x1a\n'
/** Bytes of an HDF5 file in which the names of its groups are looked for. */
const HDF5_HEAD = 1024 * 1024

const meshio = (ending: string) => `meshio converts it: meshio convert a.${ending} a.vtu`
const starts =
  (...marks: readonly string[]) =>
  (head: string) =>
    marks.some(mark => head.startsWith(mark))
const has = (pattern: RegExp) => (head: string) => pattern.test(head)
const ends =
  (...endings: readonly string[]) =>
  (_: string, name: string) =>
    endings.some(ending => name.endsWith(ending))
const MAKE_HEXAHEDRA = 'it has no hexahedra; Gmsh or Cubit mesh its inside'
const SAVE_MESH = 'open it in the program that wrote it and export the mesh as VTU, MSH or INP'

/** Which program an HDF5 file is of, by the names in it. */
const hdf5: readonly Known[] = [
  { is: has(/VTKHDF/), what: 'a VTKHDF file', instead: 'ParaView saves it as .vtu' },
  {
    is: has(/CGNSLibraryVersion|CGNSBase_t/),
    what: 'a CGNS file (HDF5)',
    instead: 'Gmsh or ParaView convert it: gmsh a.cgns -save -o a.msh',
  },
  { is: has(/tstt/), what: 'a MOAB file (HDF5, .h5m)', instead: `MOAB or meshio convert it: mbconvert a.h5m a.vtk` },
  {
    is: has(/INFOS_GENERALES|ENS_MAA|MAILLES|\bNOE\b/),
    what: 'a MED file (HDF5)',
    instead: `${meshio('med')}, or gmsh a.med -save -o a.msh`,
  },
  { is: has(/coordx|connect1|eb_prop1|num_nod_per_el/), what: 'an Exodus II file (netCDF-4)', instead: meshio('e') },
  { is: ends('.med', '.rmed', '.mmed'), what: 'a MED file (HDF5)', instead: meshio('med') },
  { is: ends('.cgns'), what: 'a CGNS file (HDF5)', instead: 'Gmsh or ParaView convert it: gmsh a.cgns -save -o a.msh' },
  { is: ends('.vtkhdf', '.vtkh'), what: 'a VTKHDF file', instead: 'ParaView saves it as .vtu' },
  { is: ends('.h5m'), what: 'a MOAB file (HDF5, .h5m)', instead: 'MOAB converts it: mbconvert a.h5m a.vtk' },
  { is: ends('.e', '.exo', '.ex2', '.g', '.gen'), what: 'an Exodus II file (netCDF-4)', instead: meshio('e') },
  { is: ends('.hmf'), what: 'an HMF file (HDF5)', instead: meshio('hmf') },
  {
    is: ends('.cas.h5', '.msh.h5'),
    what: 'an Ansys Fluent file (HDF5)',
    instead: 'Fluent exports it as CGNS or Nastran',
  },
  {
    is: has(/Geometry|Topology|XDMF/i),
    what: 'the HDF5 file of an XDMF mesh',
    instead: 'meshio converts the .xdmf beside it: meshio convert a.xdmf a.vtu',
  },
  { is: () => true, what: 'an HDF5 file', instead: SAVE_MESH },
]

const known: readonly Known[] = [
  // netCDF and other meshes in binary.
  { is: starts('CDF\x01', 'CDF\x02', 'CDF\x05'), what: 'an Exodus II file (netCDF)', instead: meshio('e') },
  {
    is: starts('ADF Database'),
    what: 'a CGNS file (ADF)',
    instead: 'the CGNS tools make it HDF5, then Gmsh reads it: adf2hdf a.cgns',
  },
  { is: starts('#!TDV'), what: 'a Tecplot file in binary', instead: 'Tecplot saves it as ASCII' },
  { is: has(/^[\s\S]{0,200}TetGen/i), what: 'a TetGen file', instead: 'it has no hexahedra, only tetrahedra' },
  // Meshes in XML and text.
  { is: has(/<Xdmf\b/i), what: 'an XDMF file', instead: meshio('xdmf') },
  { is: has(/<febio_spec\b/i), what: 'a FEBio file', instead: 'FEBio Studio exports it as VTK or Abaqus' },
  { is: has(/<dolfin\b/i), what: 'a DOLFIN mesh (XML)', instead: meshio('xml') },
  { is: has(/^[ \t]*NDIME\s{0,9}=\s{0,9}\d/m), what: 'an SU2 mesh', instead: meshio('su2') },
  {
    is: has(/^[ \t]*(?:COOR_[23]D|HEXA(?:8|20|27))\b/m),
    what: 'a Code_Aster .mail file',
    instead: 'Salome or Code_Aster write it as MED, and Gmsh turns that into .msh',
  },
  {
    is: has(/^[ \t]*(?:#RADIOSS STARTER|\/BEGIN\b)/m),
    what: 'a Radioss starter file',
    instead: 'OpenRadioss tools or Gmsh convert it: vortex_radioss, or export as LS-DYNA .k',
  },
  { is: has(/^(?:!PERMAS|[ \t]*\$ENTER COMPONENT)/m), what: 'a PERMAS file', instead: meshio('dato') },
  {
    is: head =>
      /^\s{0,20}\*\s{0,9}FLAC3D/i.test(head) ||
      (/^G[ \t]+\d+[ \t]+\S+[ \t]+\S+[ \t]+\S+/m.test(head) && !/^\$/m.test(head)),
    what: 'a FLAC3D grid',
    instead: meshio('f3grid'),
  },
  {
    is: has(/^\s{0,20}\((?:0|1)\s{0,9}"|^\s{0,20}\(2\s{1,9}3\)|^\s{0,20}\(10\s{1,9}\(0\s/),
    what: 'an Ansys Fluent mesh',
    instead: 'Fluent exports it as CGNS or Nastran, and meshio converts some: meshio convert -i ansys a.msh a.vtu',
  },
  { is: has(/Finite element mesh \(GridFE\)/), what: 'a Diffpack grid', instead: 'Gmsh or Diffpack write it as VTK' },
  {
    is: (head, name) =>
      /^(?:mesh|part)\.(?:nodes|elements|header|boundary)(?:\.\d+)?$/.test(name.split('/').at(-1) ?? '') &&
      /^\s*\d/.test(head),
    what: 'a file of an Elmer mesh',
    instead: 'ElmerGrid converts the folder: ElmerGrid 2 5 mesh',
  },
  { is: has(/^\s{0,20}mesh3d\b/), what: 'a Netgen mesh', instead: meshio('vol') },
  {
    is: (head, name) => /\.(?:b8|lb8|b4|lb4|r8|lr8|r4|lr4)?\.?ugrid$/.test(name) && head.length > 0,
    what: 'a UGRID mesh',
    instead: meshio('ugrid'),
  },
  { is: has(/^[ \t]*type:\s{1,9}ensight/im), what: 'an EnSight case', instead: 'ParaView saves it as .vtu' },
  {
    is: has(/^ {0,4}1C\S/),
    what: 'a CalculiX result file (.frd)',
    instead: 'ccx2paraview converts it: ccx2paraview a.frd vtu',
  },
  {
    is: has(/\bclass\s{1,20}(?:faceList|faceCompactList|labelList|polyBoundaryMesh|cellList)\s{0,9};/),
    what: 'a file of an OpenFOAM mesh (polyMesh)',
    instead: 'foamToVTK converts the case',
  },
  {
    is: head => isLargeFoam(head),
    what: 'the points of an OpenFOAM mesh (polyMesh), whose cells are in the files beside it',
    instead: 'foamToVTK converts the case',
  },
  // Surfaces, point clouds, geometry.
  {
    is: (head, name) =>
      (/^\s{0,20}solid\b/.test(head) && /\bfacet\s+normal\b/.test(head)) || (name.endsWith('.stl') && head.length > 80),
    what: 'a surface of triangles (STL)',
    instead: MAKE_HEXAHEDRA,
  },
  { is: has(/^ply\r?\nformat/), what: 'a surface in PLY', instead: MAKE_HEXAHEDRA },
  { is: has(/^\s{0,20}(?:ST)?C?N?OFF\s/), what: 'a surface in OFF', instead: MAKE_HEXAHEDRA },
  { is: starts('glTF'), what: 'a scene in glTF', instead: MAKE_HEXAHEDRA },
  { is: starts('ISO-10303-21'), what: 'a geometry in STEP', instead: 'it has no mesh; Gmsh makes one' },
  { is: has(/^.{72}S {0,6}1\s*$/m), what: 'a geometry in IGES', instead: 'it has no mesh; Gmsh makes one' },
  {
    is: has(/^DBRep_DrawableShape|^CASCADE Topology/m),
    what: 'a geometry in BREP',
    instead: 'it has no mesh; Gmsh makes one',
  },
  // What is no mesh at all.
  {
    is: starts('\x89PNG'),
    what: 'an image',
    instead:
      'the mesh itself is needed, or a PNG that was taken away from a Hexlens page, which has its element inside',
  },
  {
    is: starts('\xff\xd8\xff', 'GIF8', 'BM6', 'II*\0', 'MM\0*'),
    what: 'an image',
    instead: 'the mesh itself is needed, as a file or as text',
  },
  {
    is: head => head.startsWith('RIFF') && head.slice(8, 12) === 'WEBP',
    what: 'an image',
    instead: 'the mesh itself is needed, as a file or as text',
  },
  { is: starts('%PDF'), what: 'a PDF', instead: 'the numbers can be copied from it and pasted' },
  { is: starts('%!PS'), what: 'a PostScript file', instead: 'the mesh itself is needed, as a file or as text' },
  { is: starts('PK\x03\x04', 'PK\x05\x06'), what: 'a zip archive', instead: 'unpack it, and open the mesh in it' },
  {
    is: starts('7z\xbc\xaf\x27\x1c', 'Rar!', '\xfd7zXZ\0', 'BZh', '\x28\xb5\x2f\xfd'),
    what: 'an archive',
    instead: 'unpack it, and open the mesh in it; gzip is read as it is',
  },
  {
    is: head => head.slice(257, 262) === 'ustar',
    what: 'a tar archive',
    instead: 'unpack it, and open the mesh in it',
  },
  {
    is: has(/^\s{0,200}<(?:!doctype\s{1,9}html|html)\b/i),
    what: 'a web page',
    instead: 'save the file that it shows instead',
  },
  { is: starts('\x7fELF', 'MZ\x90'), what: 'a program', instead: 'a mesh is needed' },
]

/** Names that files of other formats do not have. */
const NAMES_OF_VTK = /\.(vtu|pvtu|pvd|vtk)$/

export const refused: MeshFormat = {
  name: 'not read yet',
  recognizes: (head, name) => (knownOf(headText(head), name) === null ? 'no' : 'yes'),
  read(file) {
    const name = file.name.toLowerCase()
    const head = headOf(file, 65_536)
    const found = head.startsWith(HDF5) ? hdf5Of(file, name) : knownOf(head, name)
    const { what, instead } = found as Known
    const [, claimed] = NAMES_OF_VTK.exec(name) ?? []
    const isNot = claimed === undefined ? '' : `no ${claimed.toUpperCase()} but `
    throw new MeshRefusal(
      `${shown(file.name).slice(1, -1)}: this is ${isNot}${what}. Hexlens does not read it${what.startsWith('an image') ? '' : ' yet'}; ${instead}.`,
    )
  },
}

function headOf(file: MeshFile, most: number): string {
  return headText(file.read(0, Math.min(most, file.size)))
}

function knownOf(head: string, name: string): Known | null {
  if (head.startsWith(HDF5)) return hdf5.at(-1) as Known
  return known.find(({ is }) => is(head, name)) ?? null
}

function hdf5Of(file: MeshFile, name: string): Known {
  const head = headOf(file, HDF5_HEAD)
  return hdf5.find(({ is }) => is(head, name)) as Known
}

/** The points of a mesh, of which there are more than of one element. */
function isLargeFoam(head: string): boolean {
  if (
    !/\bclass\s{1,20}vectorField\s{0,9};/.test(head.slice(0, 5000)) ||
    !/\bobject\s{1,20}points\s{0,9};/.test(head.slice(0, 5000))
  )
    return false
  const count = /\}\s{0,100}(?:\/\/[^\n]{0,200}\s{0,100})?(\d{1,12})\s{0,20}\(/.exec(head.slice(0, 5000))?.[1]
  return count !== '8'
}
