/** Facts of VTK's formats and of others that are made for pictures. */
import { vtuOf } from '../unit/vtu-text'
import { CUBE, changedHdf5, type FormatFacts, fact, MADE, MADE_WITH_VOXEL, made, ONE, ROWS, rows } from './fact'

const cube = vtuOf([CUBE])
const voxel = vtuOf([[0, 1, 3, 2, 4, 5, 7, 6].flatMap(v => ROWS[v] as number[])])
  .replace('<Cells>', '<Cells>')
  .replace(/(Name="types"[^>]*>)12/, '$111')
const withIds = cube.replace(
  '<Points>',
  '<CellData><DataArray type="Int64" Name="GlobalCellIds" format="ascii">77</DataArray><DataArray type="Int32" Name="MaterialIds" format="ascii">3</DataArray></CellData><Points>',
)
const vtkFile = (type: string) => ({ 'a.vtu': `<VTKFile type="${type}"></VTKFile>` })

const legacy = (sections: string, version = '3.0') => ({
  'a.vtk': `# vtk DataFile Version ${version}\ntitle\nASCII\n${sections}`,
})
const points = `POINTS 8 double\n${CUBE.join(' ')}\n`
const unstructured = `DATASET UNSTRUCTURED_GRID\n${points}CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n`
const offsets = `DATASET UNSTRUCTURED_GRID\n${points}CELLS 2 8\nOFFSETS vtktypeint64\n0 8\nCONNECTIVITY vtktypeint64\n0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n`
const polyhedron = '6 4 0 3 2 1 4 4 5 6 7 4 0 1 5 4 4 1 2 6 5 4 2 3 7 6 4 3 0 4 7'
const streamed = `DATASET UNSTRUCTURED_GRID\n${points}CELLS 1 32\n31 ${polyhedron}\nCELL_TYPES 1\n42\n`

const grid = `<Grid Name="mesh"><Topology TopologyType="Hexahedron"><DataItem Dimensions="1 8" NumberType="Int">0 1 2 3 4 5 6 7</DataItem></Topology><Geometry GeometryType="XYZ"><DataItem Dimensions="8 3">${CUBE.join(' ')}</DataItem></Geometry></Grid>`
const xdmf = (grids: string) => ({
  'a.xdmf': `<?xml version="1.0"?>\n<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>\n<Xdmf Version="3.0"><Domain>${grids}</Domain></Xdmf>`,
})
const bytesBeside = {
  ...xdmf(
    grid.replace(
      /<DataItem Dimensions="8 3">.*?<\/DataItem>/,
      '<DataItem Dimensions="8 3" Format="Binary" Precision="8" Endian="Little" Seek="8">a.bin</DataItem>',
    ),
  ),
  'a.bin': new Uint8Array(Float64Array.from([7, ...CUBE]).buffer),
}
const lattice =
  '<Grid><Topology TopologyType="3DCoRectMesh" Dimensions="2 3 4"/><Geometry GeometryType="ORIGIN_DXDYDZ"><DataItem Dimensions="3">0 0 0</DataItem><DataItem Dimensions="3">3 2 1</DataItem></Geometry></Grid>'
const times = `<Grid GridType="Collection" CollectionType="Temporal">${['0.5', '2'].map(time => grid.replace('<Topology', `<Time Value="${time}"/><Topology`)).join('')}</Grid>`
const including = `<Grid GridType="Collection" CollectionType="Temporal">${['0.5', '2'].map(time => `<Grid><xi:include xpointer="xpointer(//Grid[@Name=&quot;mesh&quot;]/*[self::Topology or self::Geometry])"/><Time Value="${time}"/></Grid>`).join('')}</Grid>`
const withFunction = grid.replace(
  '<DataItem Dimensions="8 3">',
  '<DataItem ItemType="Function" Function="$0" Dimensions="8 3">',
)

const tecplot = (zone: string, nodes = '1 2 3 4 5 6 7 8') => ({
  'a.dat': `VARIABLES = "X" "Y" "Z"\nZONE ${zone}\n${rows(row => row.join(' '))}\n${nodes}\n`,
})
const tecplotBlocks = {
  'a.dat': `VARIABLES = "X" "Y" "Z"\nZONE NODES=8 ELEMENTS=1 ZONETYPE=FEBRICK DATAPACKING=BLOCK\n${[0, 1, 2].map(axis => ROWS.map(row => row[axis]).join(' ')).join('\n')}\n1 2 3 4 5 6 7 8\n`,
}
const ucd = (nodes: string) => ({
  'a.inp': `8 2 0 0 0\n${rows((row, id) => `${id} ${row.join(' ')}`)}\n7 1 hex ${nodes}\n8 1 tet 1 2 3 5\n`,
})
const box = 'f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n'
const obj = (faces: string) => ({ 'a.obj': `o box\n${rows(row => `v ${row.join(' ')}`)}\n${faces}` })

export const vtkFacts: readonly FormatFacts[] = [
  {
    format: 'VTU',
    read: [
      fact(
        'text, base64 and raw bytes',
        made('vtk-ascii.vtu', 'vtk-app64-none.vtu', 'vtk-raw-none.vtu'),
        MADE_WITH_VOXEL,
      ),
      fact(
        'zlib, LZ4 and LZMA',
        made('vtk-raw-zlib.vtu', 'vtk-inline-lz4.vtu', 'vtk-inline-lzma.vtu', 'vtk-app64-lzma.vtu'),
        MADE_WITH_VOXEL,
      ),
      fact(
        '32 or 64 bits before each block, bytes in either order',
        made('vtk-raw-none-u32.vtu', 'vtk-inline-zlib-u32.vtu', 'vtk-raw-none-big.vtu'),
        MADE_WITH_VOXEL,
      ),
      fact('`Float32`, with a note on what that can move', made('vtk-raw-none-f32.vtu'), { note: /stored as Float32/ }),
      fact('voxels, in an order of their own', { 'a.vtu': voxel }, ONE),
      fact('arrays of ids and of materials', { 'a.vtu': withIds }, { ids: [77], blocks: ['MaterialIds 3'] }),
      fact('`.pvtu` with its pieces', made('pvtu/mesh.pvtu'), { hexahedra: 45 }),
      fact(
        '`.pvd` with its time steps',
        {
          'a.pvd':
            '<VTKFile type="Collection"><Collection><DataSet timestep="0.5" part="0" file="a.vtu"/><DataSet timestep="1" part="0" file="b.vtu"/></Collection></VTKFile>',
          'a.vtu': cube,
          'b.vtu': cube,
        },
        { ...ONE, steps: ['0.5', '1'] },
        'last',
      ),
    ],
    notRead: [
      fact('polyhedra are counted, also those with six faces', made('vtk-polyhedra-ascii.vtu'), {
        other: { polyhedron: 2 },
      }),
      fact(
        '`PolyData`, `ImageData` and structured files are refused',
        ['PolyData', 'ImageData', 'RectilinearGrid', 'StructuredGrid'].map(vtkFile),
        /type “\w+”, which is not read: ParaView saves it/,
      ),
    ],
  },
  {
    format: 'VTK',
    read: [
      fact(
        'legacy files of version 1 to 5.1 in text',
        [...['1.0', '2.0', '3.0', '4.2'].map(version => legacy(unstructured, version)), legacy(offsets, '5.1')],
        ONE,
      ),
      fact('the same in bytes', made('vtk-legacy51-bin.vtk'), MADE_WITH_VOXEL),
      fact(
        'what meshio and Gmsh write',
        made('meshio-vtk42-bin.vtk', 'meshio-vtk51-ascii.vtk', 'gmsh-ascii.vtk'),
        MADE,
      ),
      fact('grids of points', legacy('DATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n'), {
        hexahedra: 2,
        vertices: CUBE,
      }),
      fact('structured and rectilinear grids', ['pastes/31-vtk-structured.vtk', 'pastes/68-vtk-rectilinear.vtk'], {
        hexahedra: 1,
      }),
    ],
    notRead: [
      fact('polyhedra are counted', legacy(streamed), { hexahedra: 0, other: { polyhedron: 1 } }),
      fact(
        '`POLYDATA` and `FIELD` are refused',
        ['POLYDATA', 'FIELD'].map(type => legacy(`DATASET ${type}\n`)),
        /has no cells that are read/,
      ),
    ],
  },
  {
    format: 'VTKHDF',
    read: [
      fact('`UnstructuredGrid`', made('vtk.vtkhdf'), MADE_WITH_VOXEL),
      fact('parts', 'hdf5/parts.vtkhdf', { hexahedra: 3 }),
      fact('arrays of ids and of materials', 'hdf5/parts.vtkhdf', { blocks: ['MaterialIds 0', 'MaterialIds 1'] }),
      fact('time steps', 'hdf5/steps.vtkhdf', { hexahedra: 1, steps: ['0', '0.5', '1'] }, 'last'),
      fact('collections, whose grids are blocks', 'hdf5/collection.vtkhdf', {
        hexahedra: 3,
        blocks: ['MaterialIds 0', 'MaterialIds 1', 'left', 'right'],
      }),
    ],
    notRead: [
      fact(
        'other types of grids are refused',
        changedHdf5('parts.vtkhdf', 'UnstructuredGrid', 'OverlappingAMR\0\0'),
        /it holds data of type “OverlappingAMR”/,
      ),
      fact('blocks in other files are refused', 'hdf5/linked.vtkhdf', /block “right” is a link to another file/),
    ],
  },
  {
    format: 'XDMF',
    read: [
      fact('numbers in the text or in HDF5', [...made('meshio-XML.xdmf', 'meshio-HDF.xdmf')], MADE),
      fact('in the bytes of a file beside', bytesBeside, ONE),
      fact('mixed cells', made('meshio-XML.xdmf'), {
        other: { quadrilateral: 2, tetrahedron: 2, wedge: 1, pyramid: 1 },
      }),
      fact('lattices', xdmf(lattice), { hexahedra: 6 }),
      fact('collections in time', xdmf(times), { ...ONE, steps: ['0.5', '2'] }, 'last'),
      fact(
        'steps that include the mesh which stands beside them',
        xdmf(grid + including),
        { ...ONE, steps: ['0.5', '2'] },
        'last',
      ),
    ],
    notRead: [
      fact('items that compute or select numbers are refused', xdmf(withFunction), /Function/),
      fact(
        'so is a document type with definitions',
        {
          'a.xdmf': (xdmf(grid)['a.xdmf'] as string).replace('[]', '[<!ENTITY a "b">]'),
        },
        /a document type or an entity/,
      ),
    ],
  },
  {
    format: 'Tecplot',
    read: [
      fact(
        'text with zones `FEBRICK`, points or blocks',
        [tecplot('N=8, E=1, F=FEPOINT, ET=BRICK'), tecplotBlocks],
        ONE,
      ),
      fact('what meshio writes', made('meshio-tec.dat'), MADE),
      fact(
        'bricks with repeated nodes, as such, with a note',
        tecplot('N=8, E=1, F=FEPOINT, ET=BRICK', '1 2 3 3 5 5 5 5'),
        { hexahedra: 1, note: /1 bricks repeat nodes/ },
      ),
    ],
    notRead: [
      fact('ordered zones are refused', tecplot('I=2 J=2 K=2'), /ORDERED/),
      fact(
        'zones that share numbers are refused',
        tecplot('N=8 E=1 ZONETYPE=FEBRICK VARSHARELIST=([1-3]=1)'),
        /shares/,
      ),
    ],
  },
  {
    format: 'UCD',
    read: [
      fact('`hex` with either of its two faces first', ['1 2 3 4 5 6 7 8', '5 6 7 8 1 2 3 4'].map(ucd), {
        ...ONE,
        ids: [7],
        other: { tetrahedron: 1 },
      }),
    ],
    notRead: [
      fact(
        'bytes are refused',
        { 'a.inp': Uint8Array.of(7, 0, 0, 0, 8, 0, 0, 0, 1) },
        /in no format that is known here/,
      ),
    ],
  },
  {
    format: 'OBJ',
    read: [fact('a closed box of six faces is a hexahedron', obj(box), { ...ONE, ids: ['box'] })],
    notRead: [fact('other surfaces are refused', obj('f 1 2 3\n'), /surface/)],
  },
]
