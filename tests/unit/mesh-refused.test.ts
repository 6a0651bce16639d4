/** Formats that are not read, by their first bytes: each is called by its name, and something is said of what to do. */
import { expect, test } from 'vitest'
import { MeshRefusal } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes } from '../../web/mesh/source'

const points = '0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n'
const numbered = points
  .trim()
  .split('\n')
  .map((row, i) => `${i + 1} ${row}`)
  .join('\n')

test.each<[string, string, string]>([
  [
    'a.mphtxt',
    `# Created by COMSOL Multiphysics\n0 1\n4 Mesh # class\n# Mesh vertex coordinates\n${points}3 hex # type name\n0 1 2 3 4 5 6 7\n`,
    'COMSOL',
  ],
  ['a.gmv', 'gmvinput ascii\nnodes 8\n', 'GMV'],
  ['a.geo', 'EnSight Model Geometry File\nEnSight 7.4.1\nnode id given\n', 'EnSight'],
  ['a.geo', `C Binary${'\0'.repeat(72)}EnSight Model Geometry File`, 'EnSight'],
  ['a.neu', '25       0       0       1       0       0       0       0       0\nPATRAN NEUTRAL FILE\n', 'Patran'],
  ['a.neu', '        CONTROL INFO 2.4.6\n** GAMBIT NEUTRAL FILE\n', 'Gambit'],
  ['a.vrt', `PROSTAR_VERTEX\n4000 0 0 0 0 0 0 0\n${numbered}\n`, 'Star-CD'],
  ['a.vol', `# Generated\nmesh3d\ndimension\n3\npoints\n8\n${points}`, 'Netgen'],
  ['a.geof', `***geometry\n**node\n8 3\n${numbered}\n**element\n1\n1 c3d8 1 2 3 4 5 6 7 8\n***return\n`, 'Z-set'],
  ['a.dat', 'title job\nsizing 0 1 8 0\nconnectivity\n0 0 1\n', 'Marc'],
  ['a.dat', 'echo -yes\nnumber_of_space_dimensions 3\n', 'Tochnog'],
  ['a.geo', 'SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, 1, 1, 1};\n', 'Gmsh'],
  ['a.frd', '    1C\n    1UUSER\n', 'CalculiX'],
  ['a.gltf', '{"asset":{"version":"2.0"},"scene":0}', 'glTF'],
  ['a.wrl', `#VRML V2.0 utf8\nCoordinate { point [ ${points} ] }`, 'VRML'],
  ['a.x3d', `<?xml version="1.0"?>\n<X3D><Coordinate point="${points}"/></X3D>`, 'X3D'],
  ['a.dae', `<?xml version="1.0"?><COLLADA><float_array count="24">${points}</float_array></COLLADA>`, 'COLLADA'],
  ['a.pcd', `# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nDATA ascii\n${points}`, 'PCD'],
  ['a.dxf', '  0\nSECTION\n  2\nHEADER\n', 'DXF'],
  ['a.igs', `${'Gmsh generated file'.padEnd(72)}S0000001\n`, 'IGES'],
  ['a.x_t', '**ABCDEFGHIJKLMNOPQRSTUVWXYZ\n**PART1;\n', 'Parasolid'],
  ['a.sat', '700 0 1 0\n16 Autodesk AutoCAD\n', 'ACIS'],
  ['a.3mf', `PK\x03\x04${'\0'.repeat(26)}3D/3dmodel.model`, '3MF'],
  ['a.docx', `PK\x03\x04${'\0'.repeat(26)}word/document.xml`, 'Word'],
  ['a.xlsx', `PK\x03\x04${'\0'.repeat(26)}[Content_Types].xml PK\x01\x02${'\0'.repeat(9)}xl/workbook.xml`, 'Excel'],
  ['a.npy', '\x93NUMPY\x01\0', 'NumPy'],
  ['a.pkl', '\x80\x04\x95\0\0', 'pickle'],
  ['a.mat', 'MATLAB 5.0 MAT-file, Platform: GLNXA64', 'MATLAB'],
  ['a.svg', '<svg xmlns="http://www.w3.org/2000/svg"></svg>', 'image'],
  ['a.png', '\x89PNG\r\n\x1a\n', 'image'],
  ['a.odb', 'ABAQODB\0\0', 'Abaqus result'],
  ['d3plot', '\0\0\0\0', 'd3plot'],
])('%s: %#', (name, text, what) => {
  // A byte for each character.
  const bytes = Uint8Array.from(text, character => character.charCodeAt(0))
  const read = () => readMeshes(fileOfBytes(name, bytes))
  expect(read).toThrow(MeshRefusal)
  expect(read).toThrow(new RegExp(`^${name}: this is .*${what}.*\\. Hexlens does not read it.*; .+\\.$`))
})
