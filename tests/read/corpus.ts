/** The files that are mutated: all of ../shared/meshes and ../shared/pastes, and texts with what these do not have. */
import { readdirSync, readFileSync } from 'node:fs'
import { basename, join, relative } from 'node:path'
import { fileURLToPath } from 'node:url'
import { ELMER, exodusOf, FOAM_BINARY, TEXTS as OTHER_TEXTS, ugridOfBytes } from '../unit/other-formats'

export interface CorpusFile {
  /** Below ../shared, or its name alone. */
  readonly path: string
  readonly name: string
  readonly bytes: Uint8Array
  /** The path of the file that names this one and is read in its place; null where it is read itself. */
  readonly readBy: string | null
}

const shared = fileURLToPath(new URL('../../../shared/', import.meta.url))

/** Files of the unit tests. */
const FOLDERS = ['hdf5', 'steps']

function filesBelow(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap(entry => {
    const path = join(folder, entry.name)
    return entry.isDirectory() ? filesBelow(path) : [path]
  })
}

const CUBE = ['0 0 0', '1 0 0', '1 1 0', '0 1 0', '0 0 1', '1 0 1', '1 1 1', '0 1 1']
const cubeWith = (separator: string) => CUBE.map(point => point.replaceAll(' ', separator))

/** Sections and keywords that no given file has. */
const TEXTS: Readonly<Record<string, string>> = {
  'generators.inp': `*NODE,NSET=A
1,0,0,0
2,1,0,0
*SYSTEM
1,1,1,2,1,1
1,2,1
*NODE,SYSTEM=C
3,1,90,0
*NGEN,NSET=B
1,2
*NSET,NSET=C,GENERATE
1,9,2
*NFILL
A,A,2,9
*NCOPY,OLD SET=A,CHANGE NUMBER=9,SHIFT,MULTIPLE=2
1,1,1
0,0,0,0,0,1,90
*ELEMENT,TYPE=C3D8,ELSET=E
1,1,2,1,2,1,2,1,2
*ELGEN,ELSET=E
1,9,1,1,9,9,9
*ELSET,ELSET=F,GENERATE
1,99999999999
*ELCOPY,OLD SET=F,ELEMENT SHIFT=9,SHIFT NODES=1
`,
  'nek.rea': `  **MESH DATA** 6 lines are X,Y,Z;X,Y,Z. Columns corners 1-4;5-8
  1  3  1  NEL,NDIM,NELV
 ELEMENT  1 [  1a]  GROUP  0
 0 1 1 0
 0 0 1 1
 0 0 0 0
 0 1 1 0
 0 0 1 1
 1 1 1 1
  ***** CURVED SIDE DATA *****
  2 Curved sides follow IEDGE,IEL,CURVE(I),I=1,5, CCURVE
`,
  'voxels.vtk': `# vtk DataFile Version 3.0
voxels
ASCII
DATASET STRUCTURED_POINTS
DIMENSIONS 3 4 5
ORIGIN 0 0 0
SPACING 1 0.5 0.1
FIELD names 1
label 1 2 string
a b
c
METADATA
INFORMATION 0

CELL_DATA 24
`,
  'grid.vtk': `# vtk DataFile Version 2.0
grid
ASCII
DATASET STRUCTURED_GRID
DIMENSIONS 2 2 2
POINTS 8 double
${CUBE.join('\n')}
POINT_DATA 8
`,
  'frames.bdf': `CEND
BEGIN BULK
CORD2R,1,,0.,0.,0.,0.,0.,1.
,1.,0.,0.
CORD2C  2       1       0.      0.      0.      0.      0.      1.
        1.      0.      0.
${cubeWith(',')
  .map((point, i) => `GRID,${i + 1},1,${point}`)
  .join('\n')}
GRID    9       2       1.0-3   9.+1    0.
CHEXA,1,1,1,2,3,4,5,6
,7,8
ENDDATA
`,
  'tree.mesh': `MFEM NC mesh v1.1

dimension
3

elements
1
0 1 5 0 0 1 2 3 4 5 6 7

boundary
0

vertex_parents
1
8 0 1 0.5

coordinates
8
3
${CUBE.join('\n')}
mfem_mesh_end
`,
  'groups.msh': `$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
3 7 "left, wall"
2 1 "in"
$EndPhysicalNames
$Nodes
8
${CUBE.map((point, i) => `${i + 1} ${point}`).join('\n')}
$EndNodes
$Elements
2
1 5 2 7 1 1 2 3 4 5 6 7 8
2 3 2 1 1 1 2 3 4
$EndElements
`,
  'a.su2': `% one
NDIME= 3
NELEM= 2
12 0 1 2 3 4 5 6 7 0
12 0 1 2 3 4 5 6 7 1
NPOIN= 8 8 0
${CUBE.map((point, i) => `${point} ${i}`).join('\n')}
NMARK= 1
MARKER_TAG= wall
MARKER_ELEMS= 1
9 0 1 2 3
`,
  'a.mail': ` TITRE
one
 FINSF
 %
 COOR_3D NOM=INDEFINI NBOBJ=8 NBLIGE=1
${CUBE.map((point, i) => ` N${i + 1} ${point}`).join('\n')}
 FINSF
 HEXA8
 M1 N1 N2 N3 N4
    N5 N6 N7 N8
 FINSF
 GROUP_MA
 LEFT M1
 FINSF
 FIN
`,
  'mesh.nodes': CUBE.map((point, i) => `${i + 1} -1 ${point}\n`).join(''),
  'mesh.elements': '1 1 808 1 2 3 4 5 6 7 8\n2 1 504 1 2 3 5\n',
  'faces.msh': `(0 "one (1) \\" cube")
(2 3)
(10 (0 1 8 0 3))
(12 (0 1 1 0))
(10 (1 1 8 1 3)(
${CUBE.join('\n')}
))
(12 (2 1 1 1 4))
(13 (3 1 4 3 4)(
1 2 3 4 1 0
5 8 7 6 1 0
1 5 6 2 1 0
2 6 7 3 1 0
))
(13 (4 5 6 3 0)(
4 3 7 8 4 1 0
4 1 4 8 5 1 0
))
(45 (2 fluid air)())
`,
  'steps.xdmf': `<?xml version="1.0"?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="3.0"><Domain>
<Grid Name="mesh"><Topology TopologyType="Mixed" NumberOfElements="2"><DataItem Dimensions="15" NumberType="Int">
9 0 1 2 3 4 5 6 7 16 1 3 0 1 2</DataItem></Topology>
<Geometry GeometryType="XYZ"><DataItem Dimensions="8 3" Precision="8">${CUBE.join(' ')}</DataItem></Geometry></Grid>
<Grid Name="u" GridType="Collection" CollectionType="Temporal">
<Grid><xi:include xpointer="xpointer(//Grid[@Name=&quot;mesh&quot;]/*[self::Topology or self::Geometry])"/><Time Value="0.5"/></Grid>
<Grid><xi:include xpointer="xpointer(/Xdmf/Domain/Grid[1]/*[self::Topology or self::Geometry])"/><Time Value="2"/></Grid>
</Grid>
<Grid><Topology TopologyType="3DCoRectMesh" Dimensions="2 3 4"/><Geometry GeometryType="ORIGIN_DXDYDZ">
<DataItem Dimensions="3">0 0 0</DataItem><DataItem Dimensions="3">1 1 2</DataItem></Geometry></Grid>
</Domain></Xdmf>
`,
  'binary.xdmf': `<Xdmf Version="2.0"><Domain><Grid><Topology TopologyType="Hexahedron" NumberOfElements="1">
<DataItem Dimensions="1 8" NumberType="UInt" Precision="4" Format="Binary" Seek="192" Endian="Little">numbers.bin</DataItem></Topology>
<Geometry><DataItem Dimensions="8 3" Precision="8" Format="Binary" Endian="Little">numbers.bin</DataItem></Geometry>
</Grid></Domain></Xdmf>
`,
  'blocks.dat': `TITLE = "cube"
VARIABLES = "X", "Y", "Z", "T"
ZONE T="a", N=8, E=1, DATAPACKING=BLOCK, ZONETYPE=FEBRICK, VARLOCATION=([4]=CELLCENTERED)
0 1 1 0 0 1 1 0
0 0 1 1 0 0 1 1
0 0 0 0 1 1 1 1
7
1 2 3 4 5 6 7 8
`,
  'v4.feb': `<?xml version="1.0"?>
<febio_spec version="4.0"><Mesh><Nodes name="all">
${CUBE.map((point, i) => `<node id="${i + 1}">${point.replaceAll(' ', ',')}</node>`).join('\n')}
</Nodes><Elements type="hex8" name="part"><elem id="3">1,2,3,4,5,6,7,8</elem></Elements></Mesh></febio_spec>
`,
  cellZones: `FoamFile { version 2.0; format ascii; class regIOobject; object cellZones; }
1
(
rotor
{
    type cellZone;
    cellLabels List<label> 2(0 2);
}
)
`,
}

/** UGRID in bytes: a cube. */
function cubeOfBytes(): Uint8Array {
  const bytes = new DataView(new ArrayBuffer(7 * 4 + 24 * 8 + 8 * 4))
  for (const [i, count] of [8, 0, 0, 0, 0, 0, 1].entries()) bytes.setInt32(4 * i, count)
  for (const [i, value] of CUBE.join(' ').split(' ').entries()) bytes.setFloat64(28 + 8 * i, Number(value))
  for (let v = 0; v < 8; ++v) bytes.setInt32(220 + 4 * v, v + 1)
  return new Uint8Array(bytes.buffer)
}

/** Points, and then nodes, in the bytes that binary.xdmf names. */
function numbersOfXdmf(): Uint8Array {
  const coordinates = Float64Array.from(CUBE.join(' ').split(' '), Number)
  return new Uint8Array([
    ...new Uint8Array(coordinates.buffer),
    ...new Uint8Array(Uint32Array.of(0, 1, 2, 3, 4, 5, 6, 7).buffer),
  ])
}

/** Sections of bytes: points, and the faces of a cube. */
function fluentOfBytes(): Uint8Array {
  const coordinates = Float64Array.from(CUBE.join(' ').split(' '), Number)
  const faces = [
    [1, 2, 3, 4],
    [5, 8, 7, 6],
    [1, 5, 6, 2],
    [2, 6, 7, 3],
    [4, 3, 7, 8],
    [1, 4, 8, 5],
  ]
  const numbers = Int32Array.from(faces.flatMap(face => [...face, 1, 0]))
  const parts = [
    '(2 3)\n(10 (0 1 8 0 3))\n(12 (0 1 1 0))\n(3010 (1 1 8 1 3)(',
    new Uint8Array(coordinates.buffer),
    ')\nEnd of Binary Section   3010)\n(12 (2 1 1 1 4))\n(2013 (3 1 6 3 4)(',
    new Uint8Array(numbers.buffer),
    ')\nEnd of Binary Section   2013)\n(45 (2 fluid air)())\n',
  ]
  return new Uint8Array(Buffer.concat(parts.map(part => Buffer.from(part))))
}

/** FLAC3D in bytes: a cube, a tetrahedron, a group and a face. */
function flac3dOfBytes(): Uint8Array {
  const words = (...list: readonly number[]) => new Uint8Array(Uint32Array.from(list).buffer)
  const gridpoints = CUBE.flatMap((point, i) => [
    words(i + 1),
    new Uint8Array(Float64Array.from(point.split(' '), Number).buffer),
  ])
  const zones = words(2, 7, 8, 1, 2, 4, 5, 3, 8, 6, 7, 9, 4, 1, 2, 3, 5, 1)
  const name = (text: string) => [new Uint8Array(Uint16Array.of(text.length).buffer), Buffer.from(text)]
  const parts = [words(1_375_135_718, 3, 8), ...gridpoints, zones, ...name('rock'), ...name('Default')]
  return new Uint8Array(Buffer.concat([...parts, words(1, 7, 1, 1, 4, 1, 2, 3, 4, 0)]))
}

const BYTES: Readonly<Record<string, Uint8Array>> = {
  'a.b8.ugrid': cubeOfBytes(),
  'a.lb8l.ugrid': ugridOfBytes(true, false, 8, 8),
  'a.r4.ugrid': ugridOfBytes(false, true, 4, 4),
  'bytes.f3grid': flac3dOfBytes(),
  'bytes.msh': fluentOfBytes(),
  'numbers.bin': numbersOfXdmf(),
  ...Object.fromEntries(([1, 2, 5] as const).map(version => [`netcdf-${version}.e`, exodusOf(version)])),
  ...within('binary', FOAM_BINARY),
  ...within('elmer', ELMER),
  ...within('others', OTHER_TEXTS),
}

function within(folder: string, files: Readonly<Record<string, string | Uint8Array>>): Record<string, Uint8Array> {
  const bytes = (content: string | Uint8Array) =>
    typeof content === 'string' ? new TextEncoder().encode(content) : content
  return Object.fromEntries(Object.entries(files).map(([name, content]) => [`${folder}/${name}`, bytes(content)]))
}

const READ_BY: Readonly<Record<string, string>> = {
  'meshes/made/meshio-HDF.h5': 'meshes/made/meshio-HDF.xdmf',
  'numbers.bin': 'binary.xdmf',
}

/** Names without folders; files of OpenFOAM and Elmer find each other in their folder. */
function corpusFile(path: string, bytes: Uint8Array): CorpusFile {
  return { path, name: basename(path), bytes, readBy: READ_BY[path] ?? null }
}

export const corpus: readonly CorpusFile[] = [
  ...['meshes', 'pastes']
    .flatMap(folder => filesBelow(join(shared, folder)))
    .filter(path => !/(?:manifest|expected)\.json$|README/.test(path))
    .map(path => corpusFile(relative(shared, path), new Uint8Array(readFileSync(path)))),
  ...FOLDERS.flatMap(folder => filesBelow(fileURLToPath(new URL(`../unit/${folder}/`, import.meta.url))))
    .filter(path => !path.endsWith('.py'))
    .map(path => corpusFile(path.split('/').slice(-2).join('/'), new Uint8Array(readFileSync(path)))),
  ...Object.entries(TEXTS).map(([path, text]) => corpusFile(path, new TextEncoder().encode(text))),
  ...Object.entries(BYTES).map(([path, bytes]) => corpusFile(path, bytes)),
].sort((a, b) => (a.path < b.path ? -1 : 1))

/** The file that another, at `path`, names: the one beside it, or any where it is in no folder. */
export function fileBeside(path: string, wanted: string): CorpusFile | null {
  const name = wanted.replace(/^.*[\\/]/, '')
  const folder = path.slice(0, path.lastIndexOf('/') + 1)
  const named = corpus.filter(other => other.name === name)
  return named.find(other => other.path === folder + name) ?? (folder === '' ? named[0] : null) ?? null
}
