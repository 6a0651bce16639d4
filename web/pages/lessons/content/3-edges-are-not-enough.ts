import { foldout } from './foldout'
import type { Lesson } from './lessons'
import { display, frac, math, of, row, sub, subsup, sup, words } from './mathml'

const J = math('J')
const q = (i: number) => sub('q', i)
const rest = of(1, '−', 'r')

const fromBelow = { direction: [0.5, -0.75, -0.6], zoom: 1, pan: [0, 0, 0] } as const

/** Its coefficients on the edge from vertex 3 to 2 are 1, -1/2 and 1: "bernstein-negative" of the gallery. */
const steep = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 0, -1],
  [0, 1, 0],
  [0, 0, 1],
  [1, 1, 0],
  [1, 1, -2],
  [0, 1, 1],
] as const

/** Half of the way from the unit cube to the preset face-negative. */
const halfWay = [
  [0.25, 0.125, 0.125],
  [1, 0, 0.5],
  [0.75, 0.875, 0.125],
  [0, 1, 0.5],
  [0, 0, 0.5],
  [0.875, 0.25, 0.875],
  [1, 1, 0.5],
  [0.125, 0.75, 0.875],
] as const

export const lesson: Lesson = {
  id: 'edges-are-not-enough',
  title: 'Edges are not enough',
  summary: 'Twelve positive edges, and a face that is negative in the middle.',
  steps: [
    {
      title: 'An edge without samples',
      text: `<p>On an edge no samples are needed. Three numbers determine the whole parabola. ${math(q(0))} and ${math(q(2))} are ${J} at the two ends.
        ${math(q(1))} is the height at which the tangents at the ends meet, half of the way along. The dashed line through the three is the
        <em>control polygon</em>.</p>
        <p>The edge is positive exactly if ${math(q(0), '>', 0)}, ${math(q(2), '>', 0)} and</p>
        ${display(q(1), '≥', 0, words('or'), subsup('q', 1, 2), '<', q(0), q(2))}
        ${foldout(
          'Why exactly then',
          `<p>With ${math('r')} from 0 to 1 along the edge</p>
          ${display('J', '=', sup(rest, 2), q(0), '+', 2, 'r', rest, q(1), '+', sup('r', 2), q(2))}
          <p>If ${math(q(1), '≥', 0)}, no term is negative. If ${math(q(1), '<', 0)}, the parabola is least between the ends, with the value</p>
          ${display(frac(row(q(0), q(2), '−', subsup('q', 1, 2)), row(q(0), '−', 2, q(1), '+', q(2))))}
          <p>The denominator is positive, so the numerator decides.</p>`,
        )}`,
      task: `Here ${math(q(1), '=', '−', frac(1, 2))}, and the tangents meet below zero. Yet the parabola stays above it. Drag vertex 2 until
        it does not.`,
      claims: [
        { says: 'All twelve edges are positive', holds: 'edge_min > 0' },
        { says: 'The least jacdet on them is 1/4', holds: 'edge_min = 1/4' },
      ],
      figure: { kind: 'edge', edge: 2, hasCoefficients: true },
      element: steep,
      views: 'scene verdict',
      state: { selectedVertex: 2 },
    },
    {
      title: 'Twelve good edges',
      question: {
        asks: `<p>This element is valid. It is half of the way from the unit cube to another one. The vertices go on along straight lines. At the
          end ${J} is still at least 1/32 at the vertices, and at least 1/56 on the edges.</p>
          <p>And on the faces?</p>`,
        answer: {
          kind: 'choice',
          choices: [
            { says: 'It is positive on all of every face', holds: 'boundary_min > 0' },
            { says: 'It just touches zero on a face', holds: 'boundary_min = 0' },
            { says: 'It is negative on some part of a face', holds: 'boundary_min < 0' },
          ],
        },
        because: `<p>A face is more than its four edges. The numbers of the edges say nothing certain about the middle.</p>`,
        before: { element: halfWay },
      },
      text: `<p>This element lies in the unit cube. A quarter turn followed by a reflection maps it to itself. ${J} is positive at all its vertices
        and on all its edges. But in the middle of the bottom face ${math('J', '=', '−', frac(1, 16))}, and in the middle of the top face as
        well.</p>`,
      task: 'Turn the element: the red part of the bottom face touches no edge.',
      claims: [
        { says: 'Vertices: at least 1/32', holds: 'corner_min = 1/32' },
        { says: 'Edges: at least 1/56', holds: 'edge_min = 1/56' },
        { says: 'Faces: as low as −1/16', holds: 'boundary_min = -1/16' },
      ],
      element: 'face-negative',
      views: 'scene verdict',
      state: { camera: fromBelow },
    },
    {
      title: 'A face by itself',
      text: `<p>Here only the bottom face is drawn. Its four vertices do not lie in one plane: it is bent like a saddle. ${J} becomes smaller
        from all four edges towards the middle.</p>`,
      task: 'Point at the outline of the red part: there jacdet is zero. On all four edges it is more.',
      claims: [{ says: 'Positive on the edges, negative on a face', holds: 'edge_min > 0 and boundary_min < 0' }],
      element: 'face-negative',
      views: 'scene verdict',
      state: {
        camera: { direction: [0.25, -0.3, -1], zoom: 1.15, pan: [0, 0, 0] },
        faceDisplay: 4,
        selectedFace: 4,
      },
    },
    {
      title: 'Who would notice?',
      text: `<p>The last element is negative at its centre, where many checks look. This one is not. At its vertices, edges, centre and Gauss
        points ${J} is positive, and its scaled Jacobian is above 0.2. Only on its top face ${J} falls a little below zero.</p>`,
      task: 'Read the table. The last two checks reject the element. But they also reject some elements that are valid.',
      claims: [
        { says: 'Vertices and edges are positive', holds: 'edge_min > 0' },
        { says: 'The centre and the Gauss points, too', holds: 'centre > 0 and gauss2_min > 0 and gauss3_min > 0' },
        { says: 'The scaled Jacobian is above 0.2', holds: 'scaled_jacobian > 0.2' },
        { says: 'A face is negative', holds: 'boundary_min < 0' },
      ],
      element: [
        [0.5, 0, 0.5],
        [1, 0, 0],
        [1.75, 1.75, 0.25],
        [0.25, 1, 0],
        [0, 0, 1.5],
        [1.75, -0.75, 0.5],
        [0.5, 1, 0.5],
        [0, 1, 0.25],
      ],
      views: 'scene verdict checks',
      state: { camera: { direction: [0.2, -0.55, 0.8], zoom: 1, pan: [0, 0, 0] } },
    },
  ],
}
