import { foldout } from './foldout'
import type { Lesson } from './lessons'
import { det, display, frac, math, matrix, of, row, tall } from './mathml'

const J = math('J')
const less = row('t', '−', 1)
const slope = (by: string) => frac(row('∂', 'F'), row('∂', by))

/** 2 × 1 × 1, sheared. */
const block = [
  [0, 0, 0],
  [2, 0, 0],
  [2.5, 1, 0],
  [0.5, 1, 0],
  [0, 0.5, 1],
  [2, 0.5, 1],
  [2.5, 1.5, 1],
  [0.5, 1.5, 1],
] as const

/** The unit cube with vertex 6 at (t, t, t). */
const pulled = (t: number) =>
  [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
    [0, 0, 1],
    [1, 0, 1],
    [t, t, t],
    [0, 1, 1],
  ] as const

/** The unit cube with vertex 6 past vertex 5: jacdet at vertex 5 is the y of vertex 6. */
const past = pulled(1).with(6, [2, -0.5, 1.5])

/** The way from vertex 6 to vertex 0 is seen from the side: drags are in the plane of the screen. */
const ontoDiagonal = { direction: [0.8, -0.3, 0.5], zoom: 1, pan: [0, 0, 0] } as const

export const lesson: Lesson = {
  id: 'what-the-jacobian-determinant-is',
  title: 'What the Jacobian determinant is',
  summary: 'A map, its three columns, and the sign of their volume.',
  steps: [
    {
      title: 'A cube, bent',
      text: `<p>A hexahedral element is the unit cube, bent by a map ${math('F')}. The eight vertices say where the cube’s corners go. In
        between, ${math('F')} is linear in each of the three reference coordinates ${math('ξ')}, ${math('η')}, ${math('ζ')}: it is
        <em>trilinear</em>. Straight edges stay straight; faces may bend.</p>`,
      task: 'Point at a face in one picture, or tap it. The other marks the same point.',
      claims: [],
      element: [
        [0, 0, 0],
        [1.25, -0.25, 0],
        [1, 1, 0],
        [0, 1, 0],
        [0, 0, 1],
        [1, 0, 1],
        [1.5, 1.25, 1.5],
        [0, 1, 1],
      ],
      views: 'scene verdict',
      state: { referenceShown: true },
    },
    {
      title: 'Three columns',
      text: `<p>Take a tiny box at some point of the cube. ${math('F')} makes a tiny slanted box of it. Its sides point along the columns of
        the Jacobian matrix:</p>
        ${display('D', 'F', '=', tall('[', slope('ξ'), '|', slope('η'), '|', slope('ζ')))}
        <p>At a vertex they are the three edges that meet there.</p>`,
      task: 'Point at a face: the three arrows are the columns at that point. In this block they are the same everywhere.',
      claims: [],
      element: block,
      views: 'scene verdict',
    },
    {
      title: 'Their volume',
      text: `<p>The Jacobian determinant, or <em>jacdet</em>, is the signed volume that the three columns span:</p>
        ${display('J', '=', det('D', 'F'))}
        <p>It says how many times larger the tiny box has become. This block was 2 × 1 × 1 before it was sheared. Shearing changes no
        volume.</p>`,
      task: `Drag vertex 6 anywhere: the columns are no longer the same everywhere, and neither is ${J}.`,
      claims: [
        { says: 'jacdet is nowhere less than 2', holds: 'boundary_min = 2' },
        { says: 'and nowhere more', holds: 'boundary_max = 2' },
        { says: 'The volume is 2', holds: 'volume = 2' },
      ],
      element: block,
      views: 'scene verdict',
    },
    {
      title: 'From place to place',
      text: `<p>Here vertex 6 of the unit cube is pulled outwards. Near vertex 0 nothing has changed. Towards vertex 6 the boxes grow. ${J} is
        a polynomial of degree two in each of ${math('ξ')}, ${math('η')} and ${math('ζ')}. Its mean over the cube is the element’s
        volume.</p>`,
      task: `Look from vertex 0 to vertex 6: the stronger the blue, the larger ${J}.`,
      claims: [
        { says: 'The least jacdet is 1', holds: 'boundary_min = 1' },
        { says: 'The greatest is 5/2', holds: 'boundary_max = 5/2' },
        { says: 'Their mean, the volume, is 11/8', holds: 'volume = 11/8' },
      ],
      element: pulled(1.5),
      views: 'scene verdict',
    },
    {
      title: 'Inside out',
      text: `<p>The sign of ${J} says whether a box is mirrored. In this cube bottom and top have changed places. So every tiny box is mirrored, and
        ${math('J', '=', '−', 1)} everywhere. Its edges look like those of any cube. A solver reports a <em>negative Jacobian</em> and stops.</p>`,
      task: 'Find vertex 0: it is on top. The usual cause is a file whose nodes come in another order.',
      claims: [
        { says: 'jacdet is nowhere more than −1', holds: 'boundary_max = -1' },
        { says: 'The volume is −1', holds: 'volume = -1' },
      ],
      element: 'inverted',
      views: 'scene verdict',
    },
    {
      title: 'About to turn',
      text: `<p>Now vertex 6 is pushed in. With vertex 6 at ${math(of('t', ',', 't', ',', 't'))} its three edges span
        ${math('J', '=', 3, 't', '−', 2)}. At ${math('t', '=', frac(3, 4))} that is ${math(frac(1, 4))}, still positive.</p>
        ${foldout(
          'Where the formula comes from',
          `<p>The three edges at vertex 6 come from vertices 7, 5 and 2. As columns they are</p>
          ${display(matrix(['t', less, less], [less, 't', less], [less, less, 't']))}
          <p>This is the unit matrix plus ${math('t', '−', 1)} times the matrix of ones. So its determinant is
          ${math(1, '+', 3, of('t', '−', 1), '=', 3, 't', '−', 2)}.</p>`,
        )}`,
      task: 'Drag vertex 6 towards vertex 0 until VALID becomes INVALID. On the diagonal that is at t = 2/3, where the formula gives zero.',
      claims: [
        { says: 'The element is valid', holds: 'valid' },
        { says: 'The least jacdet is 1/4, at a vertex', holds: 'boundary_min = 1/4 and corner_min = 1/4' },
      ],
      element: pulled(0.75),
      views: 'scene verdict',
      state: { selectedVertex: 6, camera: ontoDiagonal },
    },
    {
      title: 'Turned',
      question: {
        asks: `<p>Vertex 6 goes on, to ${math('t', '=', frac(1, 2))}. There ${J} at vertex 6 is ${math('−', frac(1, 2))}: the boxes near it are
          turned inside out. Will the volume of the element be negative as well?</p>`,
        answer: {
          kind: 'choice',
          choices: [
            { says: 'The volume is negative as well', holds: 'volume < 0' },
            { says: 'The volume is zero', holds: 'volume = 0' },
            { says: 'The volume is still positive', holds: 'volume > 0' },
          ],
        },
        because:
          '<p>The volume is the mean of jacdet. Much that is positive makes up for a little that is negative.</p>',
        before: { element: pulled(0.75) },
      },
      text: `<p>At ${math('t', '=', frac(1, 2))} the boxes near vertex 6 are mirrored: red, hatched, and bounded by the heavy line
        ${math('J', '=', 0)}. The volume does not show it: it is still positive. So an element counts as <em>valid</em> only if
        ${math('J', '>', 0)} everywhere.</p>
        <p>How can one be sure of <em>everywhere</em>? The next lessons are about that.</p>`,
      task: 'Compare: at the 2×2×2 Gauss points, where solvers evaluate it, jacdet is positive here.',
      claims: [
        { says: 'jacdet is −1/2 at a vertex', holds: 'corner_min = -1/2' },
        { says: 'The element is invalid', holds: 'not valid' },
        { says: 'Its volume is positive', holds: 'volume > 0' },
        { says: 'and so is jacdet at the 2×2×2 Gauss points', holds: 'gauss2_min > 0' },
      ],
      element: pulled(0.5),
      views: 'scene verdict',
      state: { selectedVertex: 6, camera: ontoDiagonal },
    },
    {
      title: 'The volume box',
      question: {
        asks: `<p>From the unit cube, vertex 6 moves to ${math(of(2, ',', row('−', frac(1, 2)), ',', frac(3, 2)))}, past vertex 5. At one vertex the
          tiny boxes turn inside out. At which?</p>`,
        answer: { kind: 'vertex', vertices: [2, 5, 6, 7] },
        because: `<p>At vertex 5 one column has changed, the edge to vertex 6. It now points to negative ${math('y')}. At vertex 6 all three
          columns have changed, and ${J} is 1 again.</p>`,
        before: { element: pulled(1) },
      },
      text: `<p>Where you point, a little cube stands in the reference cube. In the element you see its <em>volume box</em>, the linear image,
        enlarged: the three columns are its sides. Its signed volume is ${J} times that of the little cube.</p>
        <p>Towards a place with ${math('J', '=', 0)} the box becomes flat. Beyond, where ${math('J', '<', 0)}, it is inside out: hatched, since one
        sees its faces from inside.</p>`,
      task: 'Point at vertex 5, or press P in the picture. Then point along the edge to vertex 1, and watch the box become flat and turn.',
      claims: [
        { says: 'At a vertex the box has half the volume, inside out', holds: 'corner_min = -1/2' },
        { says: 'Elsewhere it is not: between them it is flat', holds: 'boundary_min < 0 and boundary_max > 0' },
        { says: 'The element is invalid', holds: 'not valid' },
      ],
      element: past,
      views: 'scene verdict',
      state: { referenceShown: true },
    },
  ],
}
