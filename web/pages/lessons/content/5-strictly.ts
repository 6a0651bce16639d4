import type { Lesson } from './lessons'
import { display, frac, math, matrix, of, row, sup, tall } from './mathml'

const J = math('J')
const half = frac(1, 2)
const rest = (...names: readonly [string, string]) => of(1, '−', names[0], '−', names[1])

/** The paper's element with vertex 6 moved by `by` along each axis. */
const moved = (by: number) =>
  [
    [0, 0, 0],
    [1, 0, 0],
    [0, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [0, 0, 0],
    [by - 1, by - 1, by - 1],
    [0, 0, 0],
  ] as const

export const lesson: Lesson = {
  id: 'strictly',
  title: 'Strictly!',
  summary: 'Zero on the faces, −1/4 in the middle: why positive has to mean more than zero.',
  steps: [
    {
      title: 'Nowhere negative on the faces',
      text: `<p>The theorem says <em>positive</em>. Would <em>not negative</em> do? Take this element from Zhang’s paper:</p>
        ${display('F', '=', matrix([row('ξ', rest('η', 'ζ'))], [row('η', rest('ξ', 'ζ'))], [row('ζ', rest('ξ', 'η'))]))}
        ${display('J', '=', sup(of(1, '−', 'ξ', '−', 'η', '−', 'ζ'), 2), '−', 4, 'ξ', 'η', 'ζ')}
        <p>On ${math('ξ', '=', 0)} that is the square of ${math(1, '−', 'η', '−', 'ζ')}, on ${math('ξ', '=', 1)} that of ${math('η', '−', 'ζ')}, and so on
        for the other faces: nowhere negative.</p>`,
      task: 'Vertices 0, 2, 5 and 7 are in one place, and yet jacdet is 1 at each of them.',
      claims: [
        { says: 'The least jacdet on the faces is exactly 0', holds: 'boundary_min = 0' },
        { says: 'The greatest is 1', holds: 'boundary_max = 1' },
      ],
      element: 'non-strict',
      views: 'scene verdict',
      state: { referenceShown: true },
    },
    {
      title: 'Negative in the middle',
      text: `<p>At the centre the first term is ${math(frac(1, 4))} and the second ${math(frac(1, 2))}:</p>
        ${display('J', tall('(', half, ',', half, ',', half), '=', '−', frac(1, 4))}
        <p>No look at the faces, however close, would have found it.</p>`,
      task: 'The faces are see-through now: the section through the middle is red.',
      claims: [
        { says: 'At the centre jacdet is −1/4', holds: 'centre = -1/4' },
        { says: 'lower than anywhere on the boundary', holds: 'volume_min < boundary_min' },
        { says: 'The volume is 0', holds: 'volume = 0' },
      ],
      element: 'non-strict',
      views: 'scene verdict',
      state: { faceDisplay: 'inside', section: { axis: 2, value: 0.5 }, referenceShown: true },
    },
    {
      title: 'A bubble that touches',
      text: `<p>Here is a bubble, and the theorem is not hurt: it touches the faces. On ${math('ξ', '=', 0)} it does so along
        ${math('η', '+', 'ζ', '=', 1)}, on ${math('ξ', '=', 1)} along ${math('η', '=', 'ζ')}. There rims of slices are zero, and the proof, which wants
        them positive, says nothing.</p>`,
      task: 'Look at the faces of the reference cube: each has its heavy line of zeros, and no red beside it.',
      claims: [
        { says: 'On the boundary: 0, not less', holds: 'boundary_min = 0' },
        { says: 'Inside: less than 0', holds: 'volume_min < 0' },
      ],
      element: 'non-strict',
      views: 'scene verdict',
      state: { referenceShown: true, camera: { direction: [0.6, -0.7, 0.4], zoom: 1, pan: [0, 0, 0] } },
    },
    {
      title: 'No small change rescues it',
      text: `<p>An unlucky set of numbers? At the centre</p>
        ${display('D', 'F', '=', '−', half, matrix([0, 1, 1], [1, 0, 1], [1, 1, 0]))}
        <p>This matrix shortens no vector to less than half its length. To make it singular it has to be changed so much that some unit vector’s image
        moves by ${math(half)}. If every vertex moves by less than ${math('d')}, no image moves by ${math(2, 'd')}. So until some vertex has moved by
        ${math(frac(1, 4))}, ${J} stays negative at the centre, and the element invalid.</p>`,
      task: 'Drag vertices a little, any way you like: INVALID. By the theorem the faces then are not positive either.',
      claims: [
        { says: 'At the centre jacdet is negative', holds: 'centre < 0' },
        { says: 'and on the faces as well now', holds: 'boundary_min < 0' },
      ],
      element: moved(0.125),
      views: 'scene verdict',
      state: { referenceShown: true, selectedVertex: 6 },
    },
    {
      title: 'Not by a tolerance',
      text: `<p>With vertex 6 moved by only 0.001 along each axis, the least ${J} on the faces is about
        ${math('−', 1.56, '·', sup(10, row('−', 8)))}. A program that takes what is above ${math('−', sup(10, row('−', 7)))} for zero, and zero for
        good enough, passes an element that is −0.2498 in the middle.</p>`,
      task: 'Read the number in the picture, and its sign: the lens computes with error bounds, and exactly where they do not decide.',
      claims: [
        { says: 'On the faces: negative, by less than 10⁻⁷', holds: '-1e-7 < boundary_min < 0' },
        { says: 'At the centre: below −0.24', holds: 'centre < -0.24' },
      ],
      element: moved(0.001),
      views: 'scene verdict',
      state: { referenceShown: true },
    },
    {
      title: 'Invalid by nothing at all',
      text: `<p>Here ${J} touches zero in the middle of a face and is positive on all edges. Exactly zero is not valid: at that point the element is
        flat, and the inverse of ${math('D', 'F')}, which every solver needs, does not exist.</p>`,
      task: 'Move a vertex by one key press: choose one with 0 to 7, then press an arrow. Valid or invalid, but no longer zero.',
      claims: [
        { says: 'The least jacdet is exactly 0', holds: 'boundary_min = 0' },
        { says: 'The edges have at least 1/48', holds: 'edge_min = 1/48' },
        { says: 'The element is invalid', holds: 'not valid' },
      ],
      element: 'touching',
      views: 'scene verdict',
      state: { camera: { direction: [0.5, -0.75, -0.6], zoom: 1, pan: [0, 0, 0] } },
    },
  ],
}
