/** Files of meshes that are recognized and not read. A format leaves this table when it gets a file of its own. */
import { ends, has, type Known, meshio, starts } from './refused-marks'

export const refusedMeshes: readonly Known[] = [
  // Meshes in binary.
  {
    // "@(#)", with a bit more in some files.
    is: has(/^[\s\S]{4}ADF Database Version/),
    what: 'a CGNS file (ADF)',
    instead: 'the CGNS tools make it HDF5, then Gmsh reads it: adf2hdf a.cgns',
  },
  { is: starts('#!TDV'), what: 'a Tecplot file in binary', instead: 'Tecplot saves it as ASCII' },
  { is: has(/^[\s\S]{0,200}TetGen/i), what: 'a TetGen file', instead: 'it has no hexahedra, only tetrahedra' },
  // Meshes in XML and text.
  { is: has(/<dolfin\b/i), what: 'a DOLFIN mesh (XML)', instead: meshio('xml') },
  { is: has(/Finite element mesh \(GridFE\)/), what: 'a Diffpack grid', instead: 'Gmsh or Diffpack write it as VTK' },
  { is: has(/^[ \t]{0,20}mesh3d[ \t]*\r?$/m), what: 'a Netgen mesh', instead: meshio('vol') },
  { is: has(/^[ \t]*type:\s{1,9}ensight/im), what: 'an EnSight case', instead: 'ParaView saves it as .vtu' },
  {
    is: has(/^ {0,4}1C(?:\S|\s)/),
    what: 'a CalculiX result file (.frd)',
    instead: 'ccx2paraview converts it: ccx2paraview a.frd vtu',
  },
  // Meshes of programs, in text.
  {
    is: has(
      /^# Created by COMSOL|^\s{0,9}\d+ Mesh # class|^\d+ # number of mesh (?:points|vertices)|^# Mesh (?:point|vertex) coordinates/m,
    ),
    what: 'a COMSOL mesh (.mphtxt)',
    instead: 'COMSOL exports it as NASTRAN, which is read',
  },
  { is: starts('gmvinput'), what: 'a GMV file', instead: 'VisIt or ParaView convert it to VTK' },
  {
    is: head =>
      /^.{0,80}EnSight (?:Model )?Geometry|^EnSight|^[CF](?:ortran)? Binary/i.test(head) &&
      /ensight|node id|part/i.test(head),
    what: 'an EnSight geometry',
    instead: 'ParaView opens its .case and saves .vtu',
  },
  {
    is: has(/^[ \t]{0,40}PATRAN NEUTRAL|^25 {7}0 {7}0 {7}1 {7}0|^26 {7}0 {7}0 {7}1\s+\d+\s+\d+\s+\d+\s+\d+\s+\d+\s*$/m),
    what: 'a Patran neutral file',
    instead: 'Patran exports it as NASTRAN, which is read',
  },
  {
    is: has(/^\*\* GAMBIT NEUTRAL FILE|^\s{0,20}CONTROL INFO \d/m),
    what: 'a Gambit neutral file (.neu)',
    instead: 'Gambit or Fluent export it as NASTRAN or CGNS; neu2foam and fluent3DMeshToFoam read it, too',
  },
  {
    is: (head, name) =>
      /^PROSTAR_(?:VERTEX|CELL|BOUNDARY)/.test(head) || (/\.(?:vrt|cel|bnd)$/.test(name) && /^\s*\d/.test(head)),
    what: 'a file of a Star-CD mesh (.vrt, .cel, .bnd)',
    instead: 'star4ToFoam and foamToVTK convert it, or Star-CD exports NASTRAN',
  },
  {
    is: has(/^\*{3}geometry\b/m),
    what: 'a Z-set mesh (.geof)',
    instead: 'Zmaster exports it as Abaqus .inp',
  },
  {
    is: head => /^connectivity\b/m.test(head) && /^(?:title|sizing|extended)\b/m.test(head),
    what: 'a Marc input file',
    instead: 'Mentat exports it as Abaqus .inp or NASTRAN',
  },
  {
    is: has(/^[ \t]{0,20}\(----Tochnog|^[ \t]*number_of_space_dimensions\s|^[ \t]*echo\s+-(?:yes|no)\b/m),
    what: 'a Tochnog input file',
    instead: 'GiD or Gmsh, which write it, write .msh as well',
  },
  {
    is: has(
      /^[ \t]*(?:SetFactory\s*\(|Transfinite (?:Volume|Surface|Curve|Line)\b|Physical (?:Volume|Surface)\s*\(|Point\s*\(\d+\)\s*=\s*\{|(?:Box|Extrude)\s*(?:\(\d+\)\s*=)?\s*\{)/m,
    ),
    what: 'a geometry for Gmsh (.geo)',
    instead: 'Gmsh meshes it: gmsh a.geo -3 -o a.msh',
  },
  {
    is: has(/^[ \t]*(?:create|mesh|export)\s+(?:brick|volume|genesis|cylinder|sphere|mesh)\b/im),
    what: 'a journal for Cubit',
    instead: 'Cubit runs it and exports Abaqus .inp or Exodus',
  },
  {
    is: (head, name) => /\.(?:p3d|p3dfmt|p2dfmt|plot3d)$/.test(name) && head.length > 0,
    what: 'a Plot3D grid',
    instead: 'ParaView opens it and saves .vtu',
  },
  {
    is: ends('.celum', '.celum_f', '.celum_s', '.ir3', '.ply2', '.rad'),
    what: 'a file that Gmsh has exported',
    instead: 'Gmsh writes .msh as well, which is read',
  },
  {
    is: (head, name) =>
      name.endsWith('.mail') && /^\s*\d+\s+\d+\s*\n\s*[-+.\dE]+\s+[-+.\dE]+\s+[-+.\dE]+\s*\n/.test(head),
    what: 'a mesh of triangles (.mail)',
    instead: 'it has no hexahedra; Gmsh writes .msh as well',
  },
  // Results in binary.
  { is: ends('.odb'), what: 'an Abaqus result file (.odb)', instead: 'the .inp beside it has the mesh' },
  { is: ends('.op2', '.xdb'), what: 'a Nastran result file', instead: 'the .bdf beside it has the mesh' },
  {
    is: (head, name) => /^d3plot\d*$|\.d3plot$/.test(name) && head.includes('\0'),
    what: 'an LS-DYNA result file (d3plot)',
    instead: 'the .k beside it has the mesh',
  },
  {
    is: (head, name) => /\.(?:rst|rth|db|mechdb|wbpz)$/.test(name) && head.includes('\0'),
    what: 'an Ansys database or result file',
    instead: 'CDWRITE writes the mesh as .cdb, which is read',
  },
  {
    is: (head, name) => /\.(?:cae|hm|mph|prt|sldprt|catpart|modfem)$/.test(name) && head.includes('\0'),
    what: 'the file of a preprocessor',
    instead: 'it exports the mesh as Abaqus .inp or NASTRAN .bdf',
  },
]
