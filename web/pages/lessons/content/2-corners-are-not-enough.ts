import type { Lesson } from './lessons'
import { display, frac, math, row, sub } from './mathml'

const J = math('J')
const length = (by: string) => row('|', sub('F', by), '|')

/** The nine-point checks and the Gauss points pass it. */
const passed = [
  [0, 1, 0],
  [1, 1, -4],
  [1, 4, -3],
  [-2, -1, -2],
  [-4, 1, 4],
  [4, -1, 4],
  [4, 1, 3],
  [-2, 3, 1],
] as const

const towardsEdge = { direction: [-0.55, -0.75, 0.3], zoom: 1, pan: [0, 0, 0] } as const

export const lesson: Lesson = {
  id: 'corners-are-not-enough',
  title: 'Corners are not enough',
  summary: 'Eight positive corners, and still invalid; what the common checks say.',
  steps: [
    {
      title: 'Eight good corners',
      text: `<p>The quickest check computes ${J} at the eight vertices: each time the volume spanned by three edges. Here the least of the
        eight is 24, far from zero. The element is invalid all the same.</p>`,
      task: 'Find the red. Turn the picture if you must: drag beside the element.',
      claims: [
        { says: 'At the vertices jacdet is at least 24', holds: 'corner_min = 24' },
        { says: 'The element is invalid', holds: 'not valid' },
      ],
      element: passed,
      views: 'scene verdict',
      state: { camera: towardsEdge },
    },
    {
      title: 'Between two corners',
      text: `<p>Along an edge ${J} is a polynomial of degree two: its graph is a parabola. Along the edge from vertex 0 to vertex 4 it starts
        and ends well above zero, and dips in between.</p>`,
      task: 'Drag vertex 0 or 4 and watch the parabola: can you lift all of it above zero?',
      claims: [
        { says: 'Somewhere on an edge jacdet is negative', holds: 'edge_min < 0' },
        {
          says: 'It is as low as −11.28, the least on all faces',
          holds: 'edge_min = -11.28 and boundary_min = edge_min',
        },
      ],
      figure: { kind: 'edge', edge: 8 },
      element: passed,
      views: 'scene verdict',
      state: { camera: towardsEdge, selectedVertex: 4 },
    },
    {
      title: 'The centre as well',
      text: `<p>Many programs divide ${J} by the lengths of the three columns, so that size does not matter:</p>
        ${display(frac('J', row(length('ξ'), length('η'), length('ζ'))))}
        <p>This <em>scaled Jacobian</em> is 1 where the columns are at right angles and 0 where they lie in a plane. HexaLab and Verdict look
        at the eight vertices and the centre. Nine points are still points.</p>`,
      task: 'Read the second line of the table: about 0.29, which counts as decent.',
      claims: [
        { says: 'The scaled Jacobian is above 0.29, and yet', holds: 'scaled_jacobian > 0.29' },
        { says: 'the element is invalid', holds: 'not valid' },
      ],
      element: passed,
      views: 'scene verdict checks',
      state: { camera: towardsEdge },
    },
    {
      title: 'The points of a solver',
      text: `<p>A solver evaluates ${J} only where it integrates: at 2×2×2 Gauss points, or at 3×3×3. All of them lie inside, away from the edge
        that has turned. So it integrates over a folded element, without a word.</p>`,
      task: 'Look down the table: who accepts it, who rejects it?',
      claims: [
        { says: 'All 2×2×2 Gauss points are positive', holds: 'gauss2_min > 0' },
        { says: 'All 3×3×3 are', holds: 'gauss3_min > 0' },
      ],
      element: passed,
      views: 'scene verdict checks',
      state: { camera: towardsEdge },
    },
    {
      title: 'Mend it',
      text: `<p>A plainer one: a unit cube with three vertices moved. Its vertices have at least 1/2, and again one edge dips, to −1/48, which is −0.0208…. More
        sample points would help here, and miss the next, narrower dip.</p>`,
      task: 'Drag vertex 3 back towards its corner of the cube, until the parabola is clear of zero.',
      claims: [
        { says: 'At the vertices jacdet is at least 1/2', holds: 'corner_min = 1/2' },
        { says: 'On an edge it is −1/48', holds: 'edge_min = -1/48' },
        {
          says: 'The Gauss points and the scaled Jacobian see nothing',
          holds: 'gauss2_min > 0 and gauss3_min > 0 and scaled_jacobian > 0.2',
        },
      ],
      figure: { kind: 'edge', edge: 8 },
      element: 'edge-negative',
      views: 'scene verdict',
      state: { selectedVertex: 3, camera: { direction: [-0.6, -0.75, 0.35], zoom: 1, pan: [0, 0, 0] } },
    },
  ],
}
