/** Files that are recognized and are no meshes: surfaces, geometry, images, documents, archives. */
import { has, type Known, MAKE_HEXAHEDRA, starts } from './refused-marks'

const COPY = 'the numbers can be copied from it and pasted'
const PRINT = 'Python prints it, and what is printed can be pasted: print(points.tolist())'

/** True if a zip archive has an entry whose name begins so, among its first. */
function isZipOf(head: string, name: string): boolean {
  return (
    head.startsWith('PK\x03\x04') && (head.startsWith(name, 30) || head.includes(`\0${name}`) || head.includes(name))
  )
}

export const refusedOthers: readonly Known[] = [
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
  { is: has(/^.{72}S[ 0]{0,6}1\s*$/m), what: 'a geometry in IGES', instead: 'it has no mesh; Gmsh makes one' },
  {
    is: has(/^DBRep_DrawableShape|^CASCADE Topology/m),
    what: 'a geometry in BREP',
    instead: 'it has no mesh; Gmsh makes one',
  },
  {
    is: has(/^\s*"asset"\s*:|^\s*\{\s*"asset"\s*:|"asset"\s*:\s*\{[^{}]*"version"/),
    what: 'a scene in glTF',
    instead: MAKE_HEXAHEDRA,
  },
  { is: has(/^#VRML|^#Inventor/), what: 'a scene in VRML', instead: MAKE_HEXAHEDRA },
  { is: has(/<X3D\b/), what: 'a scene in X3D', instead: MAKE_HEXAHEDRA },
  { is: has(/<COLLADA\b/), what: 'a scene in COLLADA', instead: MAKE_HEXAHEDRA },
  { is: starts('Kaydara FBX', '; FBX '), what: 'a scene in FBX', instead: MAKE_HEXAHEDRA },
  { is: starts('BLENDER'), what: 'a Blender file', instead: MAKE_HEXAHEDRA },
  {
    is: has(/^# \.PCD v|^VERSION \.?\d[\s\S]{0,200}^FIELDS x y z/m),
    what: 'a point cloud (PCD)',
    instead: 'it has points and no cells',
  },
  { is: starts('LASF'), what: 'a point cloud (LAS)', instead: 'it has points and no cells' },
  { is: has(/^\s{0,20}0\s*\r?\n\s{0,9}SECTION\s*\r?\n/), what: 'a drawing in DXF', instead: MAKE_HEXAHEDRA },
  { is: has(/^AC10\d\d/), what: 'a drawing in DWG', instead: MAKE_HEXAHEDRA },
  {
    is: has(/^\*\*ABCDEFGHIJKLMNOPQRSTUVWXYZ|^\*\*PART1;/),
    what: 'a geometry in Parasolid',
    instead: 'it has no mesh; Gmsh makes one of its STEP',
  },
  {
    is: (head, name) => name.endsWith('.sat') && /^\d+ \d+ \d+ \d+/.test(head),
    what: 'a geometry in ACIS',
    instead: 'it has no mesh; Gmsh makes one of its STEP',
  },
  // Files that are no meshes at all.
  {
    is: head => isZipOf(head, '3D/'),
    what: 'a 3MF file',
    instead: 'it has no hexahedra; Gmsh or Cubit mesh its inside',
  },
  { is: head => isZipOf(head, 'word/'), what: 'a Word document', instead: COPY },
  {
    is: head => isZipOf(head, 'xl/'),
    what: 'an Excel spreadsheet',
    instead: 'it exports CSV, or the cells can be copied and pasted',
  },
  { is: head => isZipOf(head, 'ppt/'), what: 'a PowerPoint document', instead: COPY },
  { is: head => isZipOf(head, 'mimetype'), what: 'an OpenDocument file', instead: COPY },
  { is: (head, name) => isZipOf(head, '') && name.endsWith('.npz'), what: 'arrays of NumPy', instead: PRINT },
  { is: starts('\xd0\xcf\x11\xe0'), what: 'an Office document', instead: COPY },
  { is: starts('{\\rtf'), what: 'a document in RTF', instead: COPY },
  { is: starts('\x93NUMPY'), what: 'an array of NumPy', instead: PRINT },
  {
    is: starts('\x80\x02', '\x80\x03', '\x80\x04', '\x80\x05'),
    what: 'a pickle of Python',
    instead: 'meshio or PyVista save the mesh as .vtu',
  },
  {
    is: starts('MATLAB 5.0 MAT-file'),
    what: 'a MATLAB file (.mat)',
    instead: 'the matrices can be printed and pasted',
  },
  { is: has(/^[\s\S]{0,400}<svg\b/), what: 'an image', instead: 'the mesh itself is needed, as a file or as text' },
  {
    is: head => /^ftyp(?:hei|mif|avif)/.test(head.slice(4)),
    what: 'an image',
    instead: 'the mesh itself is needed, as a file or as text',
  },
  {
    is: head => head.slice(4, 8) === 'ftyp' || head.startsWith('\x1aE\xdf\xa3'),
    what: 'a video',
    instead: 'the mesh itself is needed',
  },
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
