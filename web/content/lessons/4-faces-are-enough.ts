import type { Lesson } from '../lessons'
import { det, display, frac, math, of, row, sub, sup } from '../mathml'

const J = math('J')
const slopeOfJ = (by: string) => frac(row('∂', 'J'), row('∂', by))
const left = math(sub('p', '−'))
const right = math(sub('p', '+'))

export const lesson: Lesson = {
  id: 'faces-are-enough',
  title: 'Faces are enough',
  summary: 'Knupp’s conjecture of 1990, now a theorem, and the idea of its proof.',
  steps: [
    {
      title: 'Knupp’s conjecture',
      text: `<p>Patrick Knupp showed in 1990 that vertices and edges do not suffice, and conjectured that faces do: if ${J} is positive on the six
        faces, it is positive everywhere inside. Paul Zhang has proved it. This is why the lens can be certain: it looks at the faces, all of
        them, and at nothing else.</p>`,
      task: 'A stretched top, turned by 143°: valid, just. Move the section through it with the slider of Inside.',
      claims: [
        { says: 'All of the boundary is positive', holds: 'boundary_min > 0' },
        { says: 'so the element is valid', holds: 'valid' },
      ],
      element: 'twisted-before',
      views: 'scene verdict inside',
      state: { faceDisplay: 'inside', openPanels: ['inside'], section: { axis: 2, value: 0.5 } },
    },
    {
      title: 'Why quadrilaterals are easy',
      text: `<p>In the plane four corners are enough. With ${math('F', '=', 'p', '+', 's', 'a', '+', 't', 'b', '+', 's', 't', 'c')} the two columns are
        ${math('a', '+', 't', 'c')} and ${math('b', '+', 's', 'c')}, and</p>
        ${display('J', '=', det('[', 'a', '|', 'b', ']'), '+', 's', det('[', 'a', '|', 'c', ']'), '+', 't', det('[', 'c', '|', 'b', ']'))}
        <p>The term with ${math('s', 't')} is ${math(det('[', 'c', '|', 'c', ']'), '=', 0)}. What is left is linear, and so it is least at a
        corner.</p>`,
      task: 'A quadrilateral, drawn out to a block: in the reference cube the lines of equal colour are straight and parallel.',
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
      state: { referenceShown: true },
    },
    {
      title: 'A flat slice is easy too',
      text: `<p>Fix ${math('ξ')}: a square slice of the cube. If its image lies in a plane with normal ${math('n')}, then ${math('J', '=', 'ℓ', 'q')}:
        ${math('ℓ')} is the quadrilateral’s own determinant, linear as before, and
        ${math('q', '=', 'n', '·', frac(row('∂', 'F'), row('∂', 'ξ')))} is bilinear. If ${J} is positive on the slice’s rim, both keep one sign at its
        four corners, the same, and so everywhere on it: ${J} is positive on the slice.</p>`,
      task: 'This frustum has six flat faces: its twelve edges decide. Bend a face by dragging one vertex.',
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
      title: 'Where could it hide?',
      text: `<p>Suppose the conjecture were false: faces positive, ${J} negative somewhere inside. Then the surface ${math('J', '=', 0)} would
        surround that place and touch no face: a <em>bubble</em>. In the element here the surface is a tube. It runs through the bottom and the
        top, which are red where it does.</p>`,
      task: 'Turn it. Can you pinch the tube off from both faces by dragging vertices? Nobody can: the next two steps say why.',
      claims: [
        { says: 'jacdet is negative at the centre', holds: 'centre < 0' },
        { says: 'and on the boundary', holds: 'boundary_min < 0' },
      ],
      element: 'face-negative',
      views: 'scene verdict',
      state: { faceDisplay: 'inside', section: { axis: 2, value: 0.5 } },
    },
    {
      title: 'The two ends of a bubble',
      text: `<p>Look at the bubble in the reference cube. Outside it ${J} is positive, inside negative, so ${J} grows outwards all over it. At its
        leftmost point ${left} outwards is to the left, at its rightmost ${right} to the right:</p>
        ${display(slopeOfJ('ξ'), of(sub('p', '−')), '<', 0, '<', slopeOfJ('ξ'), of(sub('p', '+')))}
        <p>and ${math('J')} does not change with ${math('η')} or ${math('ζ')} there. The drawing is of the tube, cut at
        ${math('ζ', '=', frac(1, 2))}.</p>`,
      task: 'Compare the two slopes under the drawing: one sign each.',
      claims: [{ says: 'jacdet is negative at the centre', holds: 'centre < 0' }],
      figure: { kind: 'section', value: 0.5 },
      element: 'face-negative',
      views: 'scene verdict',
      state: { faceDisplay: 'inside', section: { axis: 2, value: 0.5 } },
    },
    {
      title: 'But both have the same sign',
      text: `<p>Where ${math('J', '=', 0)} the columns ${math('U')}, ${math('V')}, ${math('W')} lie in a plane:
        ${math('U', '=', 'α', 'V', '+', 'β', 'W')}. If besides ${J} does not change with ${math('η')} or ${math('ζ')}, a few lines of algebra give</p>
        ${display(slopeOfJ('ξ'), '=', '−', 2, 'α', 'β', 'κ', ',')}
        ${display('κ', '=', det('[', 'V', '|', 'W', '|', frac(row(sup('∂', 2), 'F'), row('∂', 'η', '∂', 'ζ')), ']'))}
        <p>If one of the three factors were zero, one of the three slices through the point would be flat. Its rim is on the faces, where
        ${J} is positive, so ${J} would be positive at the point as well, not zero. So none of them ever vanishes on the bubble, each keeps its sign, and
        the slopes at ${left} and ${right} have the <em>same</em> sign. There is no bubble.</p>`,
      task: 'The tube may have both signs: its slices have rims on faces that are not positive, so a factor can vanish.',
      claims: [{ says: 'The boundary is not positive here', holds: 'boundary_min <= 0' }],
      figure: { kind: 'section', value: 0.5 },
      element: 'face-negative',
      views: 'scene verdict',
      state: { faceDisplay: 'inside', section: { axis: 2, value: 0.5 } },
    },
    {
      title: 'The least value, too',
      text: `<p>More is true: of a valid element not only the sign is decided on the boundary. The least ${J} of all lies there. An interior minimum
        with ${math('J', '>', 0)} has to be constant along a line to the boundary.</p>
        <p>So two things are left to explain: what <em>positive</em> has to mean, and how the least value on a face is found.</p>`,
      task: 'Drag a vertex while the element stays valid: the ring that marks the least jacdet never leaves the faces.',
      claims: [
        { says: 'The element is valid', holds: 'valid' },
        { says: 'The least jacdet inside is the least on the boundary', holds: 'volume_min = boundary_min' },
      ],
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
      state: { faceDisplay: 'see-through' },
    },
  ],
}
