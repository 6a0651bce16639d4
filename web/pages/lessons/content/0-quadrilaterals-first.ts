import type { Lesson } from './lessons'
import { det, display, frac, math, of, row, sub, tall, thin } from './mathml'

const J = math('J')
const slope = (by: string) => frac(row('∂', 'F'), row('∂', by))
const columns = (first: string, second: string) => det('[', first, '|', second, ']')
const p = (i: number) => sub('p', i)
const rest = (name: string) => of(1, '−', name)

export const lesson: Lesson = {
  id: 'quadrilaterals-first',
  title: 'Quadrilaterals first',
  summary: 'One dimension less: a square, its map, and why there the corners suffice.',
  steps: [
    {
      title: 'A square, bent',
      text: `<p>A quadrilateral element is the unit square, bent by a map ${math('F')}. Its four corners ${math(p(0))} to ${math(p(3))} say where the
        corners of the square go. Every other point goes to a weighted mean of the four:</p>
        ${display('F', '=', rest('ξ'), rest('η'), p(0), '+', 'ξ', rest('η'), p(1))}
        ${display('+', 'ξ', 'η', p(2), '+', rest('ξ'), 'η', p(3))}
        <p>While one of ${math('ξ')} and ${math('η')} stays as it is, ${math('F')} is linear in the other. It is <em>bilinear</em>, and the lines of the
        grid stay straight.</p>`,
      task: 'Drag a corner. Then point at one of the two pictures, or tap it: the other marks the same point.',
      claims: [],
      quadrilateral: [
        [0, 0],
        [1.5, -0.25],
        [1.75, 1.25],
        [0, 1],
      ],
    },
    {
      title: 'A little square',
      text: `<p>Take a little square around a point. Its image is nearly a parallelogram: the smaller the square, the smaller the difference. The sides of the
        parallelogram are the columns of the Jacobian matrix, times the side of the little square:</p>
        ${display('D', 'F', '=', tall('[', slope('ξ'), '|', slope('η')))}
        <p>The Jacobian determinant, or <em>jacdet</em>, says how many times larger the parallelogram is than the little square:</p>
        ${display('J', '=', det('D', 'F'))}
        <p>The colours show ${J} at every point. Its mean over the square is the area of the quadrilateral.</p>`,
      task: 'Move the little square over the picture. Where the blue is strong, the parallelogram is large.',
      claims: [
        { says: 'The least jacdet is 7/8', holds: 'boundary_min = 7/8' },
        { says: 'The greatest is 19/8', holds: 'boundary_max = 19/8' },
        { says: 'Their mean, the area, is 13/8', holds: 'volume = 13/8' },
      ],
      quadrilateral: [
        [0, 0],
        [2, 0.5],
        [1.25, 1.5],
        [0.25, 1],
      ],
      probe: [0.5, 0.5],
    },
    {
      title: 'Turned inside out',
      question: {
        asks: `<p>Corner 2 will be pushed inwards. At some place ${J} at this corner becomes zero, and further in it is negative. The colours are
          hidden.</p>
          <p>Where is that place? Drag corner 2 to where you expect it.</p>`,
        answer: { kind: 'drag', holds: '-0.15 <= boundary_min <= 0.15' },
        because: `<p>${J} at a corner is zero where the corner lies in line with its two neighbours: its two sides then have one direction, and
          the parallelogram has no area.</p>`,
      },
      text: `<p>Beyond the line from corner 1 to corner 3 the parallelogram turns inside out: the letter in it is mirrored, and its area counts as
        negative. There the colour is red and hatched, and the heavy line is ${math('J', '=', 0)}. The quadrilateral is folded over: two points of the
        square go to one place.</p>
        <p>A solver cannot compute with that. A quadrilateral is <em>valid</em> only if ${math('J', '>', 0)} everywhere.</p>`,
      task: 'Drag corner 2 across the line and back, and point at the red: the letter is mirrored.',
      claims: [],
      quadrilateral: [
        [0, 0],
        [1, 0],
        [1.25, 1.25],
        [0, 1],
      ],
    },
    {
      title: 'Which corner?',
      question: {
        asks: `<p>Here ${J} is positive at all four corners. The colours are hidden again.</p>
          <p>At which corner is ${J} least? Choose one here, or press it in the picture.</p>`,
        answer: { kind: 'vertex', vertices: [0, 1, 2, 3] },
        because: `<p>At a corner ${J} is twice the area of the triangle that the corner makes with its two neighbours. It is small where sides are
          short as well as where the angle is sharp.</p>`,
      },
      text: `<p>Corner 0 has the sharpest angle, but between long sides. So ${J} does not measure angles alone. It says how the size changes, and its
        sign says whether something has turned over.</p>`,
      task: 'Drag corners until another one has the least jacdet. The ring goes there.',
      claims: [
        { says: 'The least jacdet is 11/16', holds: 'boundary_min = 11/16' },
        { says: 'The quadrilateral is valid', holds: 'valid' },
      ],
      quadrilateral: [
        [0, 0],
        [3, 0],
        [2.75, 1],
        [2, 1.25],
      ],
    },
    {
      title: 'The corners suffice',
      text: `<p>Sorted by powers the map is ${math('F', '=', 'p', '+', 'ξ', 'a', '+', 'η', 'b', '+', 'ξ', 'η', 'c')}. Its two columns are
        ${math('a', '+', 'η', 'c')} and ${math('b', '+', 'ξ', 'c')}, so</p>
        ${display('J', '=', columns('a', 'b'), '+', 'ξ', thin, columns('a', 'c'), '+', 'η', thin, columns('c', 'b'))}
        <p>The term with ${math('ξ', 'η')} has the factor ${math(columns('c', 'c'), '=', 0)}. What is left is linear: on the square the lines of equal
        colour are straight and parallel. So ${J} is least at a corner. Four numbers decide.</p>`,
      task: 'Drag corners as you like: the ring of the least jacdet is always at a corner.',
      claims: [
        { says: 'The least jacdet is at a corner', holds: 'boundary_min = corner_min' },
        { says: 'and here it is negative', holds: 'corner_min < 0' },
      ],
      quadrilateral: [
        [0, 0],
        [2, 0],
        [0.5, 0.75],
        [0, 1.5],
      ],
    },
    {
      title: 'Not so in space',
      text: `<p>A hexahedron has a third coordinate ${math('ζ')}, and three columns. Each is bilinear in the two other coordinates. Their determinant
        ${J} has degree two in each coordinate, and these terms do not cancel.</p>
        <p>So ${J} along an edge need not be linear. It may be a parabola, positive at both ends and negative in between. The drawing shows such an edge.</p>`,
      task: 'Find the red on the edge between vertices 0 and 4. At both of its ends jacdet is positive.',
      claims: [
        { says: 'All eight corners are positive', holds: 'corner_min > 0' },
        { says: 'and the element is invalid', holds: 'not valid' },
      ],
      figure: { kind: 'edge', edge: 8 },
      element: 'edge-negative',
      views: 'scene verdict',
      state: { camera: { direction: [-0.6, -0.75, 0.35], zoom: 1, pan: [0, 0, 0] } },
    },
  ],
}
