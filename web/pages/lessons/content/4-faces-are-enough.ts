import { foldout } from './foldout'
import type { Lesson } from './lessons'
import { det, display, frac, math, of, row, sub, sup, tall, thin } from './mathml'

const J = math('J')
const slopeOfJ = (by: string) => frac(row('∂', 'J'), row('∂', by))
const left = sub('p', '−')
const right = sub('p', '+')
const columns = (...all: readonly [string, ...string[]]) => {
  const [first, ...others] = all
  return det('[', first, ...others.flatMap(column => ['|', column]), ']')
}
const second = (...by: readonly [string, string]) => frac(row(sup('∂', 2), 'F'), row('∂', by[0], '∂', by[1]))

const tube = {
  faceDisplay: 'inside',
  section: { axis: 2, value: 0.5 },
  referenceShown: true,
  camera: { direction: [0.5, -0.85, 0.35], zoom: 1, pan: [0, 0, 0] },
} as const

export const lesson: Lesson = {
  id: 'faces-are-enough',
  title: 'Faces are enough',
  summary: 'Knupp’s conjecture of 1990, now a theorem, and the idea of its proof.',
  steps: [
    {
      title: 'Knupp’s conjecture',
      text: `<p>In 1990 Patrick Knupp showed that vertices and edges do not suffice. He conjectured that faces do: if ${J} is positive on all six
        faces, it is positive everywhere inside. Paul Zhang has proved it. So the lens examines all of each face, and its verdict is
        certain.</p>`,
      task: 'This element is valid. Read the table: two of the checks reject it.',
      claims: [
        { says: 'jacdet is positive on the boundary', holds: 'boundary_min > 0' },
        { says: 'so the element is valid', holds: 'valid' },
        { says: 'Subdivision to depth 4 rejects it', holds: 'subdivision <= 0' },
      ],
      element: 'depth-guard',
      views: 'scene verdict checks',
    },
    {
      title: 'Quadrilaterals are easy',
      text: `<p>In the plane the corners suffice, as lesson 0 shows. With ${math('F', '=', 'p', '+', 's', 'a', '+', 't', 'b', '+', 's', 't', 'c')} the two columns are
        ${math('a', '+', 't', 'c')} and ${math('b', '+', 's', 'c')}, and</p>
        ${display('J', '=', columns('a', 'b'), '+', 's', thin, columns('a', 'c'), '+', 't', thin, columns('c', 'b'))}
        <p>The term with ${math('s', 't')} has the factor ${math(columns('c', 'c'), '=', 0)}. What is left is linear, and so it is least at a
        corner.</p>`,
      task: 'A quadrilateral, drawn out to a block: the lines of equal colour on the reference cube are straight and parallel.',
      claims: [{ says: 'The least jacdet is at a vertex', holds: 'boundary_min = corner_min' }],
      element: [
        [0, 0, 0],
        [2, 0, 0],
        [1.5, 1.5, 0],
        [0, 1, 0],
        [0, 0, 1],
        [2, 0, 1],
        [1.5, 1.5, 1],
        [0, 1, 1],
      ],
      views: 'scene verdict',
      state: { referenceShown: true, camera: { direction: [0.45, -0.6, 0.8], zoom: 1, pan: [0, 0, 0] } },
    },
    {
      title: 'A flat slice is easy, too',
      text: `<p>Keep ${math('ξ')} as it is: that is a square slice of the cube. Suppose that its image is flat, with normal ${math('n')}. Then
        ${math('J', '=', 'ℓ', 'q')}. The factor ${math('ℓ')} is the slice’s own determinant, linear as before. The factor
        ${math('q', '=', 'n', '·', row('∂', 'F'), '/', row('∂', 'ξ'))} is bilinear.</p>
        <p>If ${J} is positive on the rim of the slice, neither factor changes its sign there. Both are greatest and least at corners, so
        they keep their signs on the whole slice: ${J} is positive on it.</p>`,
      task: 'This element has six flat faces, so its twelve edges decide. Bend a face by dragging one vertex.',
      claims: [
        { says: 'The edges are positive', holds: 'edge_min > 0' },
        { says: 'and the element is valid', holds: 'valid' },
      ],
      element: [
        [0, 0, 0],
        [2, 0, 0],
        [2, 2, 0],
        [0, 2, 0],
        [0.5, 0.5, 1],
        [1.5, 0.5, 1],
        [1.5, 1.5, 1],
        [0.5, 1.5, 1],
      ],
      views: 'scene verdict',
      state: { faceDisplay: 'see-through' },
    },
    {
      title: 'Where could it be negative?',
      question: {
        asks: `<p>This is the element of lesson 3. ${J} is positive on all its edges, and negative in the middle of the bottom face and of the top
          face. The faces hide what is inside.</p>
          <p>What is ${J} at the centre of the element?</p>`,
        answer: {
          kind: 'choice',
          choices: [
            { says: 'Positive: the two red parts are apart', holds: 'centre > 0' },
            { says: 'Exactly zero', holds: 'centre = 0' },
            { says: 'Negative: red goes through from bottom to top', holds: 'centre < 0' },
          ],
        },
        because: '<p>The two red parts are the ends of one tube.</p>',
        before: { views: 'scene', state: { camera: tube.camera } },
      },
      text: `<p>Suppose the conjecture were false: ${J} positive on the faces, and negative somewhere inside. The surface ${math('J', '=', 0)} would
        surround that place and touch no face: a <em>bubble</em>. In this element the surface is a tube. It meets the bottom and the top,
        and there the faces are negative.</p>`,
      task: 'Try to detach the tube from both faces by dragging vertices. It is impossible: the next two steps say why.',
      claims: [
        { says: 'jacdet is negative at the centre', holds: 'centre < 0' },
        { says: 'and on the boundary', holds: 'boundary_min < 0' },
      ],
      element: 'face-negative',
      views: 'scene verdict',
      state: tube,
    },
    {
      title: 'The two ends of a bubble',
      text: `<p>Inside a bubble ${J} is negative, outside it is positive. So on its surface ${J} grows outwards. At the leftmost point ${math(left)}
        outwards is to the left, at the rightmost point ${math(right)} to the right. There ${J} does not change with ${math('η')} or
        ${math('ζ')}, so</p>
        ${display(slopeOfJ('ξ'), of(left), '<', 0, '<', slopeOfJ('ξ'), of(right))}
        <p>The drawing is the tube of the picture, cut at ${math('ζ', '=', frac(1, 2))}.</p>
        ${foldout(
          'Why no slope is zero',
          `<p>Suppose that all three slopes of ${J} are zero at a point where ${math('J', '=', 0)}. There the columns ${math('U')},
          ${math('V')}, ${math('W')} of ${math('D', 'F')} lie in a plane. Let two of them be parallel, say ${math('V')} and ${math('W')}. Then the
          slice with the same ${math('ξ')} is flat. Its plane has the directions ${math('V')} and</p>
          ${display(second('η', 'ζ'))}
          <p>If no two are parallel, ${math('U', '=', 'α', 'V', '+', 'β', 'W')} with ${math('α')} and ${math('β')} not zero. The formula of the
          next step then gives ${math('κ', '=', 0)}, and again the slice is flat.</p>
          <p>The rim of the slice lies on the faces, where ${J} is positive. So by the step before last ${J} is positive on all of the slice,
          and not zero at the point.</p>`,
        )}`,
      task: 'Compare the two slopes under the drawing.',
      claims: [{ says: 'jacdet is negative at the centre', holds: 'centre < 0' }],
      figure: { kind: 'section', value: 0.5 },
      element: 'face-negative',
      views: 'scene verdict',
      state: tube,
    },
    {
      title: 'Both have the same sign',
      text: `<p>Where ${math('J', '=', 0)} the columns ${math('U')}, ${math('V')}, ${math('W')} of ${math('D', 'F')} lie in a plane:
        ${math('U', '=', 'α', 'V', '+', 'β', 'W')}. If also ${J} does not change with ${math('η')} or ${math('ζ')}, then</p>
        ${display(slopeOfJ('ξ'), '=', '−', 2, 'α', 'β', 'κ')}
        ${display('κ', '=', det(tall('[', 'V', '|', 'W', '|', second('η', 'ζ'))))}
        ${foldout(
          'The calculation',
          `<p>Let</p>
          ${display('A', '=', second('ξ', 'η'), ',', 'B', '=', second('ξ', 'ζ'), ',', 'C', '=', second('η', 'ζ'))}
          <p>Then ${math('κ', '=', columns('V', 'W', 'C'))}. ${math('F')} is linear in each coordinate, so</p>
          ${display(slopeOfJ('η'), '=', columns('A', 'V', 'W'), '+', columns('U', 'V', 'C'), '=', 0)}
          ${display(slopeOfJ('ζ'), '=', columns('B', 'V', 'W'), '+', columns('U', 'C', 'W'), '=', 0)}
          <p>With ${math('U', '=', 'α', 'V', '+', 'β', 'W')} the second terms are ${math('−', 'β', 'κ')} and ${math('−', 'α', 'κ')}. So</p>
          ${display(columns('A', 'V', 'W'), '=', 'β', 'κ')}
          ${display(columns('B', 'V', 'W'), '=', 'α', 'κ')}
          <p>Now the same for ${math('ξ')}:</p>
          ${display(slopeOfJ('ξ'), '=', columns('U', 'A', 'W'), '+', columns('U', 'V', 'B'))}
          ${display('=', '−', 'α', thin, columns('A', 'V', 'W'), '−', 'β', thin, columns('B', 'V', 'W'))}
          ${display('=', '−', 2, 'α', 'β', 'κ')}`,
        )}
        <p>If one of the factors were zero, a slice through that point would be flat. The rim of the slice lies on the faces, where ${J} is
        positive. Then ${J} would be positive on the slice, and not zero at the point.</p>
        <p>So on a bubble no factor is zero, and none changes its sign. The two slopes then have the <em>same</em> sign. But the step before
        gave them opposite signs: there is no bubble.</p>`,
      task: 'The tube is no bubble: the rims of its slices go through negative parts of the faces. There factors may be zero.',
      claims: [{ says: 'The boundary is not positive here', holds: 'boundary_min <= 0' }],
      element: 'face-negative',
      views: 'scene verdict',
      state: tube,
    },
    {
      title: 'The least value, too',
      text: `<p>More is true. The least ${J} of a valid element is on the boundary. If it is also at a point inside, ${J} is constant along a line from
        there to a face.</p>
        <p>The lens relies on this: of a valid element it computes the boundary alone. So its ring is always on a face, which proves nothing. Below,
        the minimum of the whole element is computed apart. The reference cube is cut into boxes, and in each box ${J} is at least its least
        Bernstein coefficient. The theorem is not used.</p>
        <p>Two things are left to explain: how strict <em>positive</em> has to be, and how the least value on a face is found.</p>`,
      task: 'Drag vertices and compare the two numbers. While the word is VALID, they agree. If it is INVALID, the first may be lower.',
      claims: [{ says: 'The element is valid', holds: 'valid' }],
      figure: { kind: 'boxes' },
      element: [
        [0.25, 0.125, 0.125],
        [1, 0, 0.5],
        [0.75, 0.875, 0.125],
        [0, 1, 0.5],
        [0, 0, 0.5],
        [0.875, 0.25, 0.875],
        [1, 1, 0.5],
        [0.125, 0.75, 0.875],
      ],
      views: 'scene verdict',
      state: { faceDisplay: 'see-through' },
    },
  ],
}
