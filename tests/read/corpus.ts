/** The files that are mutated: all of ../shared/meshes and ../shared/pastes, and texts with what these do not have. */
import { readdirSync, readFileSync } from 'node:fs'
import { basename, join, relative } from 'node:path'
import { fileURLToPath } from 'node:url'

export interface CorpusFile {
  /** Below ../shared, or its name alone. */
  readonly path: string
  readonly name: string
  readonly bytes: Uint8Array
}

const shared = fileURLToPath(new URL('../../../shared/', import.meta.url))

const hdf5 = fileURLToPath(new URL('../unit/hdf5/', import.meta.url))

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
}

export const corpus: readonly CorpusFile[] = [
  ...['meshes', 'pastes']
    .flatMap(folder => filesBelow(join(shared, folder)))
    .filter(path => !/(?:manifest|expected)\.json$|README/.test(path))
    .map(path => ({
      path: relative(shared, path),
      name: basename(path),
      bytes: new Uint8Array(readFileSync(path)),
    })),
  ...filesBelow(hdf5)
    .filter(path => !path.endsWith('.py'))
    .map(path => ({ path: `hdf5/${basename(path)}`, name: basename(path), bytes: new Uint8Array(readFileSync(path)) })),
  ...Object.entries(TEXTS).map(([name, text]) => ({ path: name, name, bytes: new TextEncoder().encode(text) })),
].sort((a, b) => (a.path < b.path ? -1 : 1))
