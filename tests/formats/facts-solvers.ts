/** Facts of the formats of solvers in structural mechanics. */
import { ELMER, TEXTS } from '../unit/other-formats'
import { type FormatFacts, fact, MADE, made, ONE, ROWS, rows, SHAKEN } from './fact'

const text = (name: string) => TEXTS[name] as string
const shaken = (name: string, change: (text: string) => string = own => own) => ({ [name]: change(text(name)) })

const inpNodes = `*NODE\n${rows((row, id) => `${id}, ${row.join(', ')}`)}\n`
const inpElement = (type = 'C3D8') => `*ELEMENT, TYPE=${type}, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n`
const inp = (own: string) => ({ 'a.inp': own })
const part = `*PART, NAME=P\n${inpNodes}${inpElement()}*END PART\n`
const generated =
  '*NODE\n1,0,0,0\n3,2,0,0\n7,0,2,0\n9,2,2,0\n19,0,0,2\n21,2,0,2\n25,0,2,2\n27,2,2,2\n*NGEN, NSET=A\n1,3\n7,9,1\n*NGEN, NSET=B\n19,21\n25,27\n*NSET, NSET=A1\n1,2,3\n*NSET,NSET=A2\n7,8,9\n*NSET,NSET=B1,GENERATE\n19,21\n*NSET,NSET=B2,GENERATE\n25,27,1\n*NFILL,NSET=BOTTOM\nA1,A2,2,3\n*NFILL,NSET=TOP\nB1,B2,2,3\n*NFILL\nBOTTOM,TOP,2,9\n*ELEMENT,TYPE=C3D8,ELSET=E\n1,1,2,5,4,10,11,14,13\n*ELGEN,ELSET=E\n1,2,1,1,2,3,2,2,9,4\n'

/** A corner, the three beside it, xy, yz, xz, and the one across. */
const BRICK = [1, 2, 4, 5, 3, 8, 6, 7]
const bytes = (list: Uint32Array | Float64Array) => Buffer.from(list.buffer)
const flac3d = (version: number) =>
  new Uint8Array(
    Buffer.concat([
      bytes(Uint32Array.of(0x51f6e7e6, version, 8)),
      ...ROWS.flatMap((row, i) => [bytes(Uint32Array.of(i + 1)), bytes(Float64Array.from(row))]),
      bytes(Uint32Array.of(1, 1, 8, ...BRICK, 0, 0, 0)),
    ]),
  )

const grids = `${rows((row, id) => `GRID,${id},,${row.map(x => `${x}.`)}`)}\n`
const chexa = 'CHEXA,1,5,1,2,3,4,5,6\n,7,8\n'
const bdf = (own: string) => ({ 'a.bdf': own })
const framed = `CORD2R,1,,1.,0.,0.,1.,0.,1.\n,2.,0.,0.\n${rows(([x = 0, y, z], id) => `GRID,${id},1,${x - 1}.,${y}.,${z}.`)}\n${chexa}`

const columns = (width: number, ...values: readonly (number | string)[]) =>
  values.map(value => String(value).padStart(width)).join('')
const IDS = [1, 2, 3, 4, 5, 6, 7, 8]

const nblock = `NBLOCK,6,SOLID,       8,       8\n(3i9,6e21.13e3)\n${rows((row, id) => columns(9, id, 0, 0) + columns(21, ...row.map(x => x.toExponential(13))))}\nN,R5.3,LOC,       -1,\n`
const eblock = `EBLOCK,19,SOLID,  99,  1\n(19i9)\n${columns(9, 1, 1, 1, 1, 0, 0, 0, 0, 8, 0, 5, ...IDS)}\n       -1\n`
const cdb = (own: string) => ({ 'a.cdb': own })
const commands = `/PREP7\nET,1,SOLID185\n${rows((row, id) => `N,${id},${row}`)}\n`

const keyNodes = `*KEYWORD\n*PART\nThe beam\n${columns(10, 1, 1, 1)}\n*NODE\n${rows((row, id) => columns(8, id) + columns(16, ...row.map(x => x.toFixed(1))))}\n`
const key = (own: string) => ({ 'a.k': own })
const solid = columns(8, 5, 1, ...IDS)

const mdpa = `Begin Nodes\n${rows((row, id) => ` ${id} ${row.join(' ')}`)}\nEnd Nodes\nBegin Elements Element3D8N\n 17 0 ${IDS.join(' ')}\nEnd Elements\nBegin SubModelPart inner\n Begin SubModelPartElements\n 17\n End SubModelPartElements\nEnd SubModelPart\n`

const unvNodes = rows((row, id) => `${id} 1 1 11\n${row.map(x => `${x}.0D+00`).join(' ')}`)
const unv = (number: number, elements: string) => ({
  'a.unv': `    -1\n   164\n 1 units\n 1.0D0 1.0D0\n    -1\n    -1\n  ${number}\n${unvNodes}\n    -1\n    -1\n  2412\n${elements}\n    -1\n`,
})

export const solverFacts: readonly FormatFacts[] = [
  {
    format: 'Abaqus',
    read: [
      fact(
        '`C3D8` and all types like it, also of CalculiX',
        ['C3D8', 'C3D8R', 'C3D8I', 'C3D8H', 'SC8R', 'DC3D8', 'AC3D8', 'CSS8'].map(type =>
          inp(inpNodes + inpElement(type)),
        ),
        ONE,
      ),
      fact(
        'lines that go on, CRLF, exponents with D',
        inp(
          `*node,\n** here\nnset=a,\n${inpNodes.slice(6).replace('2, 1, 0, 0', '2, 1.0D+0, 0, 0')}*ELEMENT,\nTYPE = c3d8r\n7,1,2,3,\n4,5,\n6,7,8\n`.replaceAll(
            '\n',
            '\r\n',
          ),
        ),
        {
          ...ONE,
          ids: [7],
        },
      ),
      fact('`ELSET` as blocks', inp(inpNodes + inpElement()), { ...ONE, blocks: ['E'] }),
      fact('parts, and their instances where the assembly has them', made('hand-continued.inp'), {
        hexahedra: 30,
        curved: 6,
        ids: ['A-1.5'],
      }),
      fact('`*NGEN`, `*NFILL`, `*ELGEN`, `*NCOPY`, `*ELCOPY`', inp(generated), { hexahedra: 8, blocks: ['E'] }),
      fact(
        '`*INCLUDE`, of files beside',
        { 'a.inp': `*INCLUDE, INPUT=nodes.inp\n${inpElement()}`, 'nodes.inp': inpNodes },
        ONE,
      ),
    ],
    notRead: [
      fact(
        'coordinates on a sphere, `*NMAP` and curved `*NGEN` are refused',
        [inp('*NODE, SYSTEM=S\n1,0,0,0\n'), inp(`${inpNodes}*NMAP, NSET=A\n`), inp(`${inpNodes}*NGEN, LINE=C\n1,3\n`)],
        /not read here|straight lines only/,
      ),
      fact(
        'instances of parts that are not defined are refused',
        inp('*ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=Q\n*END INSTANCE\n*END ASSEMBLY\n'),
        /is of part “Q”, which is not defined/,
      ),
      fact(
        'a part without an instance is left out, with a note',
        inp(
          `${part}${part.replace('=P', '=Q')}*ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=P\n*END INSTANCE\n*END ASSEMBLY\n`,
        ),
        { ...ONE, note: /Part “Q” has no instance/ },
      ),
    ],
  },
  {
    format: 'Nastran',
    read: [
      fact('small, large and free fields', made('gmsh-small.bdf', 'meshio.bdf', 'gmsh-free.bdf'), MADE),
      fact('exponents without a letter', bdf(grids.replace('GRID,2,,1.,0.,0.', 'GRID,2,,10.-1,0.0+3,.0') + chexa), ONE),
      fact('frames of all kinds, also by nodes and in others', bdf(framed), ONE),
      fact('properties as blocks', bdf(grids + chexa), { ...ONE, blocks: ['PID 5'] }),
      fact(
        '`INCLUDE`, of files beside',
        { 'a.bdf': `BEGIN BULK\nINCLUDE 'nodes.bdf'\n${chexa}ENDDATA\n`, 'nodes.bdf': grids },
        ONE,
      ),
    ],
    notRead: [
      fact('entries that repeat others by `=` are refused', bdf(`${grids}=,*1,=,=,==\n`), /repeat others/),
      fact(
        'a second model in the file is refused',
        bdf(`BEGIN BULK\n${grids}${chexa}BEGIN SUPER=1\n${grids}`),
        /a second model/,
      ),
    ],
  },
  {
    format: 'Ansys',
    read: [
      fact(
        '`NBLOCK` and `EBLOCK` in whatever widths they state',
        [
          cdb(`ET,1,185\n${nblock}${eblock}`),
          cdb(`ET,1,185\n${nblock.replace('3i9,6e21.13e3', '3i9,6e21.13')}${eblock}`),
        ],
        {
          ...ONE,
          ids: [5],
        },
      ),
      fact('the commands `N`, `E`, `EN`, `EMORE`', cdb(`${commands}E,${IDS}\n`), ONE),
      fact(
        'components as blocks',
        cdb(`ET,1,185\n${nblock}${eblock}CMBLOCK,PART,ELEM,1\n(8i10)\n${columns(10, 5)}\n`),
        {
          ...ONE,
          blocks: ['PART'],
        },
      ),
      fact(
        'wedges, pyramids and tetrahedra that are hexahedra with repeated nodes, as such, with a note',
        made('hand.cdb'),
        {
          hexahedra: 19,
          note: /7 elements repeat nodes/,
        },
      ),
    ],
    notRead: [
      fact('coordinates in other frames are refused', cdb('ET,1,185\nCSYS,1\nN,1,1,90,0\n'), /frame 1 are not read/),
    ],
  },
  {
    format: 'LS-DYNA',
    read: [
      fact(
        '`*ELEMENT_SOLID` on one line or two, in columns, wide, at commas or at blanks',
        [
          key(`${keyNodes}*ELEMENT_SOLID\n${solid}\n*END\n`),
          key(`${keyNodes}*ELEMENT_SOLID\n${columns(8, 5, 1)}\n${columns(8, ...IDS)}\n`),
          key(`${keyNodes}*ELEMENT_SOLID +\n${columns(20, 5, 1, ...IDS)}\n`),
          key(`${keyNodes}*ELEMENT_SOLID\n5,1\n${IDS}\n`),
          key(`${keyNodes}*ELEMENT_SOLID\n5 1 ${IDS.join(' ')}\n`),
        ],
        { ...ONE, ids: [5] },
      ),
      fact('parts as blocks, by their titles', key(`${keyNodes}*ELEMENT_SOLID\n${solid}\n`), {
        ...ONE,
        blocks: ['The beam'],
      }),
      fact(
        '`*INCLUDE`, of files beside',
        { 'a.k': `*KEYWORD\n*INCLUDE\nnodes.k\n*ELEMENT_SOLID\n${solid}\n*END\n`, 'nodes.k': keyNodes },
        ONE,
      ),
    ],
    notRead: [
      fact(
        '`*INCLUDE_TRANSFORM` and `*NODE_TRANSFORM` are refused',
        ['*INCLUDE_TRANSFORM\nb.k\n', '*NODE_TRANSFORM\n1\n'].map(own => key(keyNodes + own)),
        /_TRANSFORM/,
      ),
    ],
  },
  {
    format: 'FEBio',
    read: [
      fact(
        'versions 2 to 4, `<Elements>` as blocks',
        [shaken('a.feb'), shaken('a.feb', own => own.replace('2.5', '3.0'))],
        {
          ...SHAKEN,
          blocks: ['Part1'],
        },
      ),
    ],
    notRead: [
      fact(
        'a mesh that is in another file is refused',
        shaken('a.feb', own => own.replace('<Geometry>', '<Geometry from="mesh.feb"/><Geometry>')),
        /its mesh is in “mesh\.feb”/,
      ),
      fact(
        'older versions are refused',
        shaken('a.feb', own => own.replace('2.5', '1.2')),
        /versions 2 to 4 are read/,
      ),
    ],
  },
  {
    format: 'Code_Aster',
    read: [
      fact('names of nodes and elements; `GROUP_MA` as blocks', shaken('a.mail'), { ...SHAKEN, blocks: ['LEFT'] }),
    ],
    notRead: [
      fact(
        '`COOR_2D` is refused',
        shaken('a.mail', own => own.replace('COOR_3D', 'COOR_2D')),
        /two dimensions/,
      ),
    ],
  },
  {
    format: 'Elmer',
    read: [fact('`mesh.nodes` and `mesh.elements`; `mesh.names` for blocks', ELMER, { ...SHAKEN, blocks: ['steel'] })],
    notRead: [
      fact(
        'one of the files without the other is refused',
        { 'mesh.nodes': ELMER['mesh.nodes'] as string },
        /it needs “mesh\.elements” beside it/,
      ),
    ],
  },
  {
    format: 'FLAC3D',
    read: [
      fact('text; bricks in FLAC3D’s own order, `ZGROUP` as blocks', shaken('a.f3grid'), {
        ...SHAKEN,
        blocks: ['hard rock'],
      }),
      fact('bytes of version 3', { 'a.f3grid': flac3d(3) }, ONE),
    ],
    notRead: [fact('bytes of other versions are refused', { 'a.f3grid': flac3d(4) }, /the version is 4; 3 is read/)],
  },
  {
    format: 'PERMAS',
    read: [
      fact(
        '`$COOR` and `$ELEMENT`; lines that go on with `&`',
        [shaken('a.dato'), shaken('a.dato', own => own.replace(/^(\d+ \d+ \d+ \d+ \d+) /m, '$1\n& '))],
        { ...SHAKEN, blocks: ['body'] },
      ),
    ],
    notRead: [
      fact(
        'systems of coordinates are refused',
        shaken('a.dato', own => own.replace('$COOR', '$COOR RSYS=2')),
        /a system of their own/,
      ),
    ],
  },
  {
    format: 'Radioss',
    read: [
      fact('`/NODE`, `/BRICK`; `/PART` as blocks', shaken('a.rad'), { ...SHAKEN, blocks: ['engine block'] }),
      fact('wedges that are written as bricks, as wedges', made('gmsh.rad'), {
        ...MADE,
        other: { quadrilateral: 2, tetrahedron: 2, wedge: 1 },
      }),
    ],
    notRead: [
      fact(
        '`#include` is refused',
        shaken('a.rad', own => own.replace('/NODE', '#include nodes.rad\n/NODE')),
        /it includes “nodes\.rad”/,
      ),
    ],
  },
  {
    format: 'libMesh',
    read: [
      fact('what it prints of elements', ['pastes/04-libmesh-hex8.log', 'pastes/66-libmesh-only-spaces.log'], {
        hexahedra: 1,
        ids: [17],
      }),
    ],
    notRead: [],
  },
  {
    format: 'UNV',
    read: [
      fact('datasets 2411 and 2412; the others are passed over', unv(2411, `4 115 1 1 7 8\n${IDS.join(' ')}`), {
        ...ONE,
        ids: [4],
      }),
      fact(
        'beams and other elements, counted',
        unv(2411, `1 11 1 1 7 2\n0 1 1\n1 2\n4 115 1 1 7 8\n${IDS.join(' ')}`),
        { ...ONE, other: { line: 1 } },
      ),
    ],
    notRead: [
      fact(
        'a file that ends within a dataset is refused',
        { 'a.unv': (unv(2411, `4 115 1 1 7 8\n${IDS.join(' ')}`)['a.unv'] as string).slice(0, -24) },
        /ends/,
      ),
      fact(
        'a file without nodes in 2411 is refused',
        unv(15, `4 115 1 1 7 8\n${IDS.join(' ')}`),
        /nodes were expected/,
      ),
    ],
  },
  {
    format: 'Kratos',
    read: [
      fact(
        'elements of 3D8N; model parts as blocks',
        { 'a.mdpa': mdpa },
        { ...ONE, ids: [17], blocks: ['Element3D8N', 'inner'] },
      ),
    ],
    notRead: [
      fact(
        'an element with another number of nodes is refused',
        { 'a.mdpa': mdpa.replace('17 0 1 2', '17 0 1') },
        /has 7 nodes/,
      ),
    ],
  },
]
