import { foldout } from './foldout'
import type { Lesson } from './lessons'
import { display, frac, math, matrix, of, row, sup, tall } from './mathml'

const J = math('J')
const half = frac(1, 2)
const negative = (name: string) => row('−', name)
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
  summary: 'Zero on the faces: why positive has to mean more than zero.',
  steps: [
    {
      title: 'Nowhere negative on the faces',
      text: `<p>The theorem says <em>positive</em>. Is <em>not negative</em> enough? Take this element from Zhang’s paper:</p>
        ${display('F', '=', matrix([row('ξ', rest('η', 'ζ'))], [row('η', rest('ξ', 'ζ'))], [row('ζ', rest('ξ', 'η'))]))}
        ${display('J', '=', sup(of(1, '−', 'ξ', '−', 'η', '−', 'ζ'), 2), '−', 4, 'ξ', 'η', 'ζ')}
        <p>On ${math('ξ', '=', 0)} this is the square of ${math(1, '−', 'η', '−', 'ζ')}, on ${math('ξ', '=', 1)} the square of
        ${math('η', '−', 'ζ')}. The other faces are alike, so ${J} is nowhere negative on the boundary.</p>
        ${foldout(
          'Where the formula comes from',
          `<p>With ${math('σ', '=', 1, '−', 'ξ', '−', 'η', '−', 'ζ')} the matrix is</p>
          ${display('D', 'F', '=', 'σ', 'I', '+', matrix(['ξ', negative('ξ'), negative('ξ')], [negative('η'), 'η', negative('η')], [negative('ζ'), negative('ζ'), 'ζ']))}
          <p>The last matrix has the trace ${math('ξ', '+', 'η', '+', 'ζ')} and the determinant ${math('−', 4, 'ξ', 'η', 'ζ')}. Its three minors
          on the diagonal are zero. So</p>
          ${display('J', '=', sup('σ', 3), '+', sup('σ', 2), of('ξ', '+', 'η', '+', 'ζ'), '−', 4, 'ξ', 'η', 'ζ')}
          <p>and ${math('σ', '+', 'ξ', '+', 'η', '+', 'ζ', '=', 1)}.</p>`,
        )}`,
      task: 'Vertices 0, 2, 5 and 7 are in one place, and yet jacdet is 1 at each of them.',
      claims: [
        { says: 'The least jacdet on the faces is exactly 0', holds: 'boundary_min = 0' },
        { says: 'The greatest is 1', holds: 'boundary_max = 1' },
      ],
      element: 'non-strict',
      views: 'scene',
      state: { referenceShown: true },
    },
    {
      title: 'Negative in the middle',
      question: {
        asks: '<p>On no face is jacdet negative. On each it is zero along a line. What is it at the centre?</p>',
        answer: {
          kind: 'choice',
          choices: [
            { says: 'More than zero', holds: 'centre > 0' },
            { says: 'Exactly zero', holds: 'centre = 0' },
            { says: 'Less than zero', holds: 'centre < 0' },
          ],
        },
        because: '<p>The faces are not strictly positive. So the theorem says nothing about the inside.</p>',
        before: { views: 'scene', state: { referenceShown: true } },
      },
      text: `<p>At the centre the first term is ${math(frac(1, 4))} and the second ${math(frac(1, 2))}:</p>
        ${display('J', tall('(', half, ',', half, ',', half), '=', '−', frac(1, 4))}
        <p>Nothing on the faces shows it.</p>`,
      task: 'The faces are see-through now: the section through the middle is red.',
      claims: [
        { says: 'At the centre jacdet is −1/4', holds: 'centre = -1/4' },
        { says: 'lower than everywhere on the boundary', holds: 'volume_min < boundary_min' },
        { says: 'The volume is 0', holds: 'volume = 0' },
      ],
      element: 'non-strict',
      views: 'scene verdict',
      state: { faceDisplay: 'inside', section: { axis: 2, value: 0.5 }, referenceShown: true },
    },
    {
      title: 'A bubble that touches',
      text: `<p>This is a bubble, and it does not contradict the theorem: it touches the faces. On ${math('ξ', '=', 0)} it touches them along
        ${math('η', '+', 'ζ', '=', 1)}, on ${math('ξ', '=', 1)} along ${math('η', '=', 'ζ')}. There rims of slices are zero. The proof needs
        them positive, so it does not apply.</p>`,
      task: 'Look at the faces of the reference cube: on each there is a heavy line of zeros, and no red beside it.',
      claims: [
        { says: 'On the boundary: 0, not less', holds: 'boundary_min = 0' },
        { says: 'Inside: less than 0', holds: 'volume_min < 0' },
      ],
      element: 'non-strict',
      views: 'scene verdict',
      state: { referenceShown: true, camera: { direction: [0.6, -0.7, 0.4], zoom: 1, pan: [0, 0, 0] } },
    },
    {
      title: 'No small change makes it valid',
      text: `<p>Is this only a matter of these exact numbers? At the centre</p>
        ${display('D', 'F', '=', '−', half, matrix([0, 1, 1], [1, 0, 1], [1, 1, 0]))}
        <p>The image of a unit vector under this matrix has at least length ${math(half)}. For ${math('J', '=', 0)} some unit vector must be
        mapped to zero, so its image has to move by at least ${math(half)}. If every vertex moves by less than ${math('d')}, each image moves by
        less than ${math(2, 'd')}.</p>
        <p>So until some vertex has moved by ${math(frac(1, 4))}, ${J} stays negative at the centre, and the element stays invalid.</p>
        ${foldout(
          'Why one half, and why 2d',
          `<p>A vector ${math('v')} with the components ${math('a')}, ${math('b')}, ${math('c')} has an image with the squared length</p>
          ${display(frac(1, 4), of(sup(of('b', '+', 'c'), 2), '+', sup(of('a', '+', 'c'), 2), '+', sup(of('a', '+', 'b'), 2)))}
          ${display('=', frac(1, 4), of(sup('a', 2), '+', sup('b', 2), '+', sup('c', 2), '+', sup(of('a', '+', 'b', '+', 'c'), 2)))}
          <p>That is at least a quarter of the squared length of ${math('v')}.</p>
          <p>At the centre ${math('D', 'F')} maps ${math('v')} to the sum of the eight vertices, each times
          ${math(of('±', 'a', '±', 'b', '±', 'c'), '/', 4)}, with all eight choices of signs. The mean square of ${math('±', 'a', '±', 'b', '±', 'c')} is
          ${math(sup('a', 2), '+', sup('b', 2), '+', sup('c', 2), '=', 1)}. So the eight absolute values sum up to at most 8, and the image
          moves by less than ${math('8', 'd', '/', 4, '=', 2, 'd')}.</p>`,
        )}`,
      task: 'Drag vertices a little, as you like: it stays INVALID. By the theorem the faces then are not positive either.',
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
        ${math('−', 1.56, '·', sup(10, row('−', 8)))}. A program may take all above ${math('−', sup(10, row('−', 7)))} for zero, and accept
        zero. Then it accepts an element whose ${J} is −0.2498 at the centre.</p>`,
      task: 'Read the number in the picture, and its sign. The lens computes with error bounds. Where they do not decide, it computes exactly.',
      claims: [
        { says: 'On the faces: negative, by less than 10⁻⁷', holds: '-1e-7 < boundary_min < 0' },
        { says: 'At the centre: below −0.24', holds: 'centre < -0.24' },
      ],
      element: moved(0.001),
      views: 'scene verdict',
      state: { referenceShown: true },
    },
    {
      title: 'Exactly zero',
      text: `<p>Here ${J} touches zero in the middle of a face and is positive on all edges. That is not valid. At that point the three columns of
        ${math('D', 'F')} lie in a plane. So ${math('D', 'F')} has no inverse, and every solver needs it.</p>`,
      task: 'Move a vertex a little: the element becomes valid or invalid, and its least jacdet is no longer zero.',
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
