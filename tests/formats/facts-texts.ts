/** Facts of texts with points and cells, as meshio and scikit-fem write and print them. */
import { type FormatFacts, fact, ONE, ROWS } from './fact'

const points = ROWS.map(row => [...row])
const cell = [0, 1, 2, 3, 4, 5, 6, 7]
const tetrahedron = [0, 1, 3, 4]
const json = (mesh: object) => ({ 'a.json': JSON.stringify(mesh) })
const printed = (text: string) => ({ 'a.txt': text })
const list = (rows: readonly (readonly number[])[]) => JSON.stringify(rows).replaceAll('],', '],\n')
const decimals = (rows: readonly (readonly number[])[]) => list(rows).replaceAll(/\d/g, '$&.')
const columns = (rows: readonly (readonly number[])[]) =>
  (rows[0] as readonly number[]).map((_, c) => rows.map(row => row[c] as number))

/** The vertices in scikit-fem's order. */
const OWN = [0, 4, 3, 1, 7, 5, 2, 6]
const collapsed = [0, 1, 2, 3, 4, 4, 4, 4]
const unknown = [0, 1, 2, 3, 9, 9, 9, 9]

export const textFacts: readonly FormatFacts[] = [
  {
    format: 'JSON',
    read: [
      fact(
        'points and cells under the names that meshio gives them',
        [
          json({ points, cells: [cell] }),
          json({ points, cells: [['hexahedron', [cell]]] }),
          json({ points, cells: { hexahedron: [cell] } }),
          json({ points, cells: [{ type: 'hexahedron', data: [cell] }] }),
        ],
        ONE,
      ),
      fact('other cells, counted', json({ points, cells: { tetra: [tetrahedron], hexahedron: [cell] } }), {
        ...ONE,
        other: { tetrahedron: 1 },
      }),
      fact(
        'meshes of scikit-fem, in its own order of nodes, with a note',
        json({ p: points, t: [OWN], boundaries: null, subdomains: null }),
        { ...ONE, note: /scikit-fem’s order/ },
      ),
    ],
    notRead: [
      fact(
        'cells that name points which are not there are refused',
        json({ points, cells: { hexahedron: [[0, 1, 2, 3, 4, 5, 6, 9]] } }),
        /names point 9/,
      ),
    ],
  },
  {
    format: 'NumPy',
    read: [
      fact(
        'what is printed of the points and cells of meshio',
        [
          printed(
            `>>> mesh.points\narray(${decimals(points)})\n>>> mesh.cells_dict["hexahedron"]\narray([${list([cell])}])\n`,
          ),
          printed(
            `In [1]: m.points\nOut[1]: \narray(${decimals(points)})\nIn [2]: m.cells[0].data\nOut[2]: array(${list([cell])})\n`,
          ),
        ],
        ONE,
      ),
      fact(
        'cells that repeat nodes',
        printed(`array(${decimals(points)})\narray(${list([cell, cell, collapsed])})\n`),
        {
          hexahedra: 3,
        },
      ),
      fact(
        'what is printed of scikit-fem’s `p` and `t`, in its own order of nodes where that gives a cell with J > 0 at its corners',
        [
          printed(`>>> mesh.p\narray(${decimals(columns(points))})\n>>> mesh.t\narray(${list(columns([OWN]))})\n`),
          printed(`>>> mesh.p.T\narray(${decimals(points)})\n>>> mesh.t.T\narray(${list([OWN])})\n`),
        ],
        { ...ONE, note: /scikit-fem’s order/ },
      ),
      fact('else in that of the text, which a note says', 'pastes/43-skfem-p.txt', {
        hexahedra: 1,
        note: /in the order of the text/,
      }),
    ],
    notRead: [
      fact(
        'cells that name points which are not there are refused, also where some are collapsed',
        printed(`array(${decimals(points)})\narray(${list([cell, cell, cell, unknown])})\n`),
        /not those that are there/,
      ),
    ],
  },
]
