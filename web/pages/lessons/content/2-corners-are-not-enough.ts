import { foldout } from './foldout'
import type { Lesson } from './lessons'
import { display, frac, math, of, row, sub } from './mathml'

const J = math('J')
const length = (by: string) => row('|', sub('F', by), '|')
const link = (href: string, text: string) => `<a href="${href}">${text}</a>`
const CUBIT =
  'https://cubit.sandia.gov/files/cubit/16.14/help_manual/WebHelp/mesh_generation/mesh_quality_assessment/hexahedral_metrics.htm'
const VERDICT = 'https://public.kitware.com/Wiki/images/6/6b/VerdictManual-revA.pdf'

/** Nine-point checks and Gauss points accept it: "scaled-0-57" of the gallery. */
const accepted = [
  [1, 0, -1],
  [1, 0, 0],
  [0.125, 1, 0],
  [0, 1, 0],
  [0, -1, 0],
  [1, -1, 0.5],
  [1, 1, 1],
  [0, 1, 1],
] as const

/** The unit cube with vertex 6 at (3/4, 3/4, 3/4). */
const pushed = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 0, 1],
  [0.75, 0.75, 0.75],
  [0, 1, 1],
] as const

const towardsEdge = { direction: [0.8, 0.45, 0.4], zoom: 1, pan: [0, 0, 0] } as const

export const lesson: Lesson = {
  id: 'corners-are-not-enough',
  title: 'Corners are not enough',
  summary: 'Eight positive corners, and still invalid; what the common checks say.',
  steps: [
    {
      title: 'Eight good corners',
      text: `<p>The quickest check computes ${J} at the eight vertices. At each it is the volume that three edges span. Here the least of the
        eight is 1/8, and the others go up to 4. Yet the element is invalid.</p>`,
      task: 'Find the red. Turn the picture if it is hidden: drag beside the element.',
      claims: [
        { says: 'At the vertices jacdet is at least 1/8', holds: 'corner_min = 1/8' },
        { says: 'The element is invalid', holds: 'not valid' },
      ],
      element: accepted,
      views: 'scene verdict',
      state: { camera: towardsEdge },
    },
    {
      title: 'Between two corners',
      text: `<p>Along an edge ${J} is a polynomial of degree two: its graph is a parabola. Along the edge from vertex 1 to vertex 2 it is positive
        at both ends and negative in between.</p>`,
      task: 'Drag vertex 1 or 2 and watch the parabola. Can you lift all of it above zero?',
      claims: [
        { says: 'Somewhere on an edge jacdet is negative', holds: 'edge_min < 0' },
        {
          says: 'It falls below −0.03, and no face goes lower',
          holds: 'edge_min < -0.03 and boundary_min = edge_min',
        },
      ],
      figure: { kind: 'edge', edge: 1 },
      element: accepted,
      views: 'scene verdict',
      state: { camera: towardsEdge, selectedVertex: 1 },
    },
    {
      title: 'The centre as well',
      text: `<p>Many programs divide ${J} by the lengths of the three columns, so that size does not matter:</p>
        ${display(frac('J', row(length('ξ'), length('η'), length('ζ'))))}
        <p>This <em>scaled Jacobian</em> is 1 where the columns are at right angles, and 0 where they lie in a plane. HexaLab and Verdict, which VTK has,
        look at the eight vertices and the centre, and take the least.</p>
        <p>Here that is 0.57. The manuals of ${link(CUBIT, 'Cubit')} and ${link(VERDICT, 'Verdict')} call 0.5 to 1 acceptable. But nine points
        are still points. The gallery has an invalid element with ${link('./gallery.html#scaled-0-86', '0.86')}.</p>`,
      task: 'Read the second line of the table. It says 0.56637, and “accepts: wrong”.',
      claims: [
        { says: 'At the vertices jacdet is at least 1/8', holds: 'corner_min = 1/8' },
        { says: 'At the centre it is 31/32', holds: 'centre = 31/32' },
        { says: 'The scaled Jacobian is above 1/2', holds: 'scaled_jacobian > 1/2' },
        { says: 'Yet the element is invalid', holds: 'not valid' },
      ],
      element: accepted,
      views: 'scene verdict checks',
      state: { camera: towardsEdge },
    },
    {
      title: 'The points of a solver',
      text: `<p>A solver evaluates ${J} only where it integrates: often at 2×2×2 Gauss points, sometimes at 3×3×3. All of them lie inside, away
        from the edge that has turned. So it integrates over a folded element and reports nothing.</p>`,
      task: 'Read down the table: who accepts the element, who rejects it?',
      claims: [
        { says: 'All 2×2×2 Gauss points have more than 1/4', holds: 'gauss2_min > 1/4' },
        { says: 'All 3×3×3 have more than 1/7', holds: 'gauss3_min > 1/7' },
      ],
      element: accepted,
      views: 'scene verdict checks',
      state: { camera: towardsEdge },
    },
    {
      title: 'When does a solver notice?',
      question: {
        asks: `<p>Vertex 6 of a cube is pushed towards vertex 0, as in lesson 1. At ${math('t', '=', frac(2, 3))} the element becomes invalid. A
          solver with 2×2×2 Gauss points does not notice yet.</p>
          <p>How far does vertex 6 have to go until one of these eight points has ${math('J', '=', 0)}? Drag it to where you expect that.</p>`,
        answer: { kind: 'drag', holds: '-0.1 <= gauss2_min <= 0.1' },
        because: `<p>On the diagonal the first Gauss point turns at ${math('t', '=', 0.464)}. From 0.667 to there the element is invalid, and all
          eight points are positive.</p>`,
        before: { views: 'scene verdict' },
      },
      text: `<p>The Gauss point next to vertex 6 lies at ${math('ξ', '=', 'η', '=', 'ζ', '=', 0.789)}. Red has to grow as far as that point
        before the solver stops. Until then it computes with an element that is folded over.</p>
        ${foldout(
          'Where 0.464 comes from',
          `<p>With vertex 6 at ${math(of('t', ',', 't', ',', 't'))} the columns of ${math('D', 'F')} are those of the cube, changed by multiples of
          one vector:</p>
          ${display('J', '=', 1, '+', of('t', '−', 1), of('η', 'ζ', '+', 'ξ', 'ζ', '+', 'ξ', 'η'))}
          <p>At the Gauss point the second bracket is 1.866. So ${J} is zero at ${math('t', '=', 1, '−', 1, '/', 1.866, '=', 0.464)}.</p>`,
        )}`,
      task: 'Point at the row of the Gauss points: the picture marks them. Drag vertex 6 until their number changes its sign.',
      claims: [{ says: 'At the 2×2×2 Gauss points jacdet is positive', holds: 'gauss2_min > 0' }],
      element: pushed,
      views: 'scene verdict checks',
      state: { selectedVertex: 6, camera: { direction: [0.8, -0.3, 0.5], zoom: 1, pan: [0, 0, 0] } },
    },
    {
      title: 'Mend it',
      text: `<p>A simpler one: a unit cube with three vertices moved. At its vertices ${J} is at least 1/2. Yet ${J} is negative on one edge, where it
        falls to −1/48. More sample points would help here. The next such part may be narrower, and lie between them.</p>`,
      task: 'Drag vertex 3 back towards its corner of the cube, until the parabola lies above zero.',
      claims: [
        { says: 'At the vertices jacdet is at least 1/2', holds: 'corner_min = 1/2' },
        { says: 'On an edge it is −1/48', holds: 'edge_min = -1/48' },
        {
          says: 'The 2×2×2 and 3×3×3 Gauss points and the scaled Jacobian are positive',
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
