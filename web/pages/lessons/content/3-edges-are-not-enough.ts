import type { Lesson } from './lessons'
import { display, frac, math, sub, subsup, words } from './mathml'

const J = math('J')
const q = (i: number) => sub('q', i)

const fromBelow = { direction: [0.5, -0.75, -0.6], zoom: 1, pan: [0, 0, 0] } as const

export const lesson: Lesson = {
  id: 'edges-are-not-enough',
  title: 'Edges are not enough',
  summary: 'Twelve positive edges, and a face that is negative in the middle.',
  steps: [
    {
      title: 'An edge without samples',
      text: `<p>On an edge nothing needs to be sampled. Three numbers determine the whole parabola: ${math(q(0))} and ${math(q(2))}, which are ${J} at
        the ends, and ${math(q(1))}, the height at which the tangents at the ends meet. The edge is positive exactly if ${math(q(0), '>', 0)},
        ${math(q(2), '>', 0)} and</p>
        ${display(q(1), '≥', 0, words('or'), subsup('q', 1, 2), '<', q(0), q(2))}`,
      task: 'The dashed tangents meet below zero, and yet the parabola stays above it.',
      claims: [
        { says: 'All twelve edges are positive', holds: 'edge_min > 0' },
        { says: 'The least jacdet on them is 1/56', holds: 'edge_min = 1/56' },
      ],
      figure: { kind: 'edge', edge: 0 },
      element: 'face-negative',
      views: 'scene verdict',
    },
    {
      title: 'Twelve good edges',
      text: `<p>This element lies in the unit cube, and a quarter turn followed by a reflection maps it to itself. All its vertices and all its
        edges are positive. But in the middle of the bottom face ${math('J', '=', '−', frac(1, 16))}, and in the middle of the top face as
        well.</p>`,
      task: 'Turn the element: the red patch on the bottom touches no edge.',
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
      text: `<p>Here the bottom face is alone. Its four vertices do not lie in one plane: it is bent like a saddle. From the edges ${J} goes down
        to the middle as into a bowl.</p>`,
      task: 'Point at the rim of the patch: there jacdet is zero, and on all four edges it is more.',
      claims: [{ says: 'Positive on the edges, negative on a face', holds: 'edge_min > 0 and boundary_min < 0' }],
      element: 'face-negative',
      views: 'scene verdict',
      state: { camera: fromBelow, faceDisplay: 4, selectedFace: 4 },
    },
    {
      title: 'Who would notice?',
      text: `<p>A look at its centre gives the last element away. This one is not so kind. Its vertices, edges, centre and Gauss points are positive, and
        its scaled Jacobian is above 0.2. Only on its top face ${J} falls a little below zero.</p>`,
      task: 'Read the table. The last two reject it; but they also reject elements that are valid.',
      claims: [
        { says: 'Vertices and edges are positive', holds: 'edge_min > 0' },
        { says: 'Gauss points too', holds: 'gauss2_min > 0 and gauss3_min > 0' },
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
