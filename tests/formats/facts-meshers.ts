/** Facts of the formats of mesh generators and of flow solvers. */
import { gzipSync } from 'node:zlib'
import { exodusOf, FOAM, FOAM_BINARY, TEXTS, ugridOfBytes } from '../unit/other-formats'
import { changedHdf5, type FormatFacts, fact, type Gives, MADE, made, ONE, ROWS, rows, SHAKEN } from './fact'

const text = (name: string) => TEXTS[name] as string
const shaken = (name: string, change: (text: string) => string = own => own) => ({ [name]: change(text(name)) })

const TWO: Gives = { ...ONE, hexahedra: 2 }

const gmshNodes = `$Nodes\n8\n${rows((row, id) => `${id} ${row.join(' ')}`)}\n$EndNodes\n`
const gmshElement = '1 5 2 3 1 1 2 3 4 5 6 7 8\n'
const msh = (own: string) => ({ 'a.msh': `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n${own}` })
const gmshNames = '$PhysicalNames\n1\n3 3 "left wall"\n$EndPhysicalNames\n'

const medit = {
  'a.mesh': `MeshVersionFormatted 2\nDimension\n3\nVertices\n8\n${rows(row => `${row.join(' ')} 0`)}\nHexahedra\n2\n1 2 3 4 5 6 7 8 1\n1 2 3 4 5 6 7 8 2\nEnd\n`,
}

const mfem = (version: string, vertices: string, more = '') => ({
  'a.mesh': `MFEM mesh ${version}\n\ndimension\n3\n\nelements\n2\n1 5 0 1 2 3 4 5 6 7\n2 5 0 1 2 3 4 5 6 7\n${more}\nboundary\n0\n\nvertices\n8\n${vertices}\n`,
})
const vertices = rows(row => row.join(' '))
const space = (name: string, nodes: string) =>
  `\nnodes\nFiniteElementSpace\nFiniteElementCollection: ${name}\nVDim: 3\nOrdering: 1\n\n${nodes}`
const leaves = {
  'a.mesh': `MFEM NC mesh v1.0\n\ndimension\n3\n\nelements\n3\n-1 1 5 1 1 2\n0 1 5 0 0 8 9 3 4 10 11 7\n0 1 5 0 8 1 2 9 10 5 6 11\n\nboundary\n0\n\nvertex_parents\n4\n8 0 1\n9 2 3\n10 4 5\n11 6 7\n\ncoordinates\n8\n3\n${vertices}\n`,
}

const blockMesh = (more = '') => ({
  blockMeshDict: `FoamFile { object blockMeshDict; }\nscale 0.1;\nvertices\n(\n${ROWS.map((p, v) => `name v${v} (${p.join(' ')})`).join('\n')}\n);\nblocks ( hex (v0 v1 v2 v3 4 5 6 7) zone (20 20 1) simpleGrading (1 1 1) );\n${more}`,
})

export const mesherFacts: readonly FormatFacts[] = [
  {
    format: 'Gmsh',
    read: [
      fact(
        'versions 1 to 4.1, in text and, from 2 on, in bytes',
        made(
          'gmsh-1-ascii.msh',
          'meshio-gmsh22-ascii.msh',
          'gmsh-2.2-bin.msh',
          'gmsh-4.1-ascii.msh',
          'gmsh-4.1-bin.msh',
        ),
        { ...MADE, curved: 3 },
      ),
      fact(
        'physical groups as blocks, by their names',
        msh(`${gmshNames}${gmshNodes}$Elements\n1\n${gmshElement}$EndElements\n`),
        { ...ONE, blocks: ['left wall'] },
      ),
      fact('a text that is cut, as far as its elements are whole', msh(`${gmshNodes}$Elements\n3\n${gmshElement}`), {
        ...ONE,
        isCutOff: true,
      }),
    ],
    notRead: [fact('other versions are refused', 'meshes/malformed/msh-version.msh', /the version is “9\.9”/)],
  },
  {
    format: 'Medit',
    read: [
      fact('`.mesh` and `.meshb`', made('meshio.mesh', 'meshio.meshb'), MADE),
      fact('references as blocks', medit, { ...TWO, blocks: ['reference 1', 'reference 2'] }),
    ],
    notRead: [fact('meshes of two dimensions are refused', 'meshes/malformed/medit-2d.mesh', /two-dimensional/)],
  },
  {
    format: 'MFEM',
    read: [
      fact(
        'versions 1.0 to 1.3; attributes and their sets as blocks',
        ['v1.0', 'v1.1', 'v1.2', 'v1.3'].map(version => mfem(version, `3\n${vertices}`)),
        { ...TWO, blocks: ['attribute 1', 'attribute 2'] },
      ),
      fact('nodes of a grid function of order 1', mfem('v1.0', space('H1_3D_P1', vertices)), TWO),
      fact('leaves of a non-conforming mesh', leaves, { hexahedra: 2 }),
    ],
    notRead: [
      fact(
        'cells whose nodes are of a higher order are counted',
        mfem('v1.0', space('H1_3D_P2', `${vertices}\n${'0.5 0.5 0.5\n'.repeat(19)}`)),
        { hexahedra: 0, curved: 2 },
      ),
      fact(
        'NURBS and INLINE are refused',
        [{ 'a.mesh': 'MFEM NURBS mesh v1.0\n' }, { 'a.mesh': 'MFEM INLINE mesh v1.0\n\ntype = hex\n' }],
        /MFEM (?:NURBS|INLINE) mesh/,
      ),
    ],
  },
  {
    format: 'OVM',
    read: [
      fact('ASCII; the order of a cell’s nodes from its half-faces', made('hand.ovm'), { hexahedra: 4, other: {} }),
    ],
    notRead: [fact('bytes are refused', { 'a.ovm': 'OVM BINARY\n\x01\x02' }, /this OVM file is binary/)],
  },
  {
    format: 'Exodus II',
    read: [
      fact(
        'netCDF classic, with 64-bit offsets and with 64-bit data',
        ([1, 2, 5] as const).map(version => ({ 'a.e': exodusOf(version) })),
        { ...SHAKEN, blocks: ['engine'], steps: ['0', '0.5'] },
      ),
      fact('netCDF-4', ['hdf5/named.exo'], { hexahedra: 2, blocks: ['core'], steps: ['0.5', '1.5'] }),
      fact('ids of `elem_num_map`; names of elements such as `HEX`, `HEX8`', made('classic.e', 'netcdf4.exo'), {
        ...MADE,
        ids: [7, 17, 27],
      }),
      fact(
        'displacements of the nodes, added to the coordinates at each time step, with a note',
        'meshes/real/8-block.g',
        {
          hexahedra: 64,
          note: /displacements disp_X, disp_Y, disp_Z are added/,
        },
      ),
    ],
    notRead: [
      fact(
        'other netCDF files are refused',
        { 'a.nc': new Uint8Array([67, 68, 70, 1, ...new Uint8Array(28)]) },
        /it is no Exodus file/,
      ),
    ],
  },
  {
    format: 'ncdump',
    read: [
      fact('its print of an Exodus file', 'pastes/60-ncdump-exodus.cdl', {
        hexahedra: 1,
        ids: [1],
        blocks: ['block 1'],
      }),
    ],
    notRead: [
      fact(
        'a header alone is refused',
        { 'a.cdl': 'netcdf a {\ndimensions:\n num_nodes = 8 ;\nvariables:\n double coordx(num_nodes) ;\n}\n' },
        /header of a netCDF file alone/,
      ),
    ],
  },
  {
    format: 'SU2',
    read: [
      fact(
        'elements and points with or without their numbers',
        [
          shaken('a.su2'),
          shaken('a.su2', own => own.replace(/^(12(?: \d+){8}) \d+$/gm, '$1').replace(/^(\S+\t\S+\t\S+) \d+$/gm, '$1')),
        ],
        SHAKEN,
      ),
    ],
    notRead: [
      fact(
        'meshes of two dimensions, and of several zones, are refused',
        [shaken('a.su2', own => own.replace('NDIME= 3', 'NDIME= 2')), shaken('a.su2', own => `NZONE= 2\n${own}`)],
        /2 dimensions|2 zones/,
      ),
    ],
  },
  {
    format: 'UGRID',
    read: [
      fact('text', [shaken('a.ugrid')], SHAKEN),
      fact(
        'streams and records of bytes in either order, told by the name or by the size of the file',
        [
          { 'a.b8.ugrid': ugridOfBytes(false, false, 8, 4) },
          { 'a.lb8.ugrid': ugridOfBytes(true, false, 8, 4) },
          { 'a.lr8.ugrid': ugridOfBytes(true, true, 8, 4) },
          { 'a.lb8l.ugrid': ugridOfBytes(true, false, 8, 8) },
          { 'without-a-name': ugridOfBytes(false, false, 8, 8) },
        ],
        SHAKEN,
      ),
    ],
    notRead: [
      fact(
        'a file that is cut is refused',
        shaken('a.ugrid', own => own.slice(0, -40)),
        /the file ends/,
      ),
    ],
  },
  {
    format: 'Fluent',
    read: [
      fact(
        'hexahedra from the faces of sections 13; zones by name',
        { 'a.msh': text('fluent.msh') },
        { ...SHAKEN, blocks: ['air'] },
      ),
      fact('cells that meshio lists with their nodes', made('meshio.ansys.msh'), MADE),
    ],
    notRead: [
      fact(
        'meshes of two dimensions are refused',
        { 'a.msh': text('fluent.msh').replace('(2 3)', '(2 2)') },
        /2.* dimensions has no hexahedra/,
      ),
    ],
  },
  {
    format: 'OpenFOAM',
    read: [
      fact('polyMesh in text and in bytes; hexahedra from their faces; cellZones as blocks', [FOAM, FOAM_BINARY], {
        ...SHAKEN,
        blocks: ['rotor'],
      }),
      fact('its files together, its folder, or the folder of the case', made('foam/constant/polyMesh/faces'), {
        hexahedra: 4,
      }),
      fact(
        'any of its files gzipped',
        Object.fromEntries(Object.entries(FOAM).map(([name, own]) => [`${name}.gz`, new Uint8Array(gzipSync(own))])),
        { ...SHAKEN, blocks: ['rotor'] },
      ),
    ],
    notRead: [
      fact(
        'files of two meshes are refused',
        { ...FOAM, owner: (FOAM.owner as string).replace('constant', '0.5') },
        /they are files of two meshes/,
      ),
      fact('so is one without the others', { owner: FOAM.owner as string }, /give all files of polyMesh together/),
    ],
  },
  {
    format: 'blockMeshDict',
    read: [
      fact('blocks with 8 vertices, by name or number, without the scale, which a note gives', blockMesh(), {
        ...ONE,
        note: /without the scale/,
      }),
    ],
    notRead: [
      fact(
        'variables in place of numbers are refused',
        { blockMeshDict: (blockMesh().blockMeshDict as string).replace('(0 0 0)', '($x 0 0)') },
        /only numbers/,
      ),
    ],
  },
  {
    format: 'CGNS',
    read: [
      fact(
        'structured and unstructured zones and several sections of hexahedra, all of them blocks',
        'hdf5/zones.cgns',
        { hexahedra: 6, blocks: ['lattice', 'mixed', 'mixed/some', 'mixed/plain'] },
      ),
      fact('`HEXA_8` and `MIXED`; cells of higher order are counted', 'hdf5/zones.cgns', {
        hexahedra: 6,
        curved: 1,
        other: { tetrahedron: 1 },
      }),
      fact('ids of elements', made('gmsh.cgns'), { ...MADE, ids: [7, 8, 9] }),
    ],
    notRead: [
      fact('links are refused', changedHdf5('zones.cgns', 'MT\0', 'LK\0'), /is a link to another node/),
      fact(
        'coordinates that are not Cartesian are refused',
        changedHdf5('zones.cgns', 'CoordinateX', 'CoordinateR'),
        /has no CoordinateX; Cartesian coordinates are read/,
      ),
      fact('ADF files are refused', { 'a.cgns': '@(#)ADF Database Version B01012>' }, /CGNS file \(ADF\)/),
    ],
  },
  {
    format: 'MED',
    read: [
      fact('`HE8` and its kin in MED’s order of nodes; groups as blocks; `NUM` as ids', 'hdf5/groups.med', {
        hexahedra: 8,
        ids: [1, 2, 3],
        blocks: ['core'],
      }),
      fact('files of meshio in VTK’s order, which it writes, with a note', made('meshio.med'), {
        ...MADE,
        curved: 3,
        note: /meshio wrote this file/,
      }),
    ],
    notRead: [
      fact('structured meshes are refused', 'hdf5/structured.med', /is a structured one/),
      fact(
        'coordinates that are not Cartesian are refused',
        'hdf5/cylindrical.med',
        /cylindrical or spherical coordinates/,
      ),
    ],
  },
  {
    format: 'MOAB',
    read: [fact('`Hex8`; MOAB’s numbers as ids', 'hdf5/elements.h5m', { hexahedra: 2, ids: [13, 14] })],
    notRead: [],
  },
  {
    format: 'HMF',
    read: [fact('what meshio writes', made('meshio.hmf'), MADE)],
    notRead: [
      fact('an HDF5 file without a mesh of a known kind is refused', 'hdf5/bare.h5', /no mesh of a known kind/),
    ],
  },
]
