import type { Lesson } from './lessons'
import { det, display, frac, math, of, row, sub, sup, tall } from './mathml'

const J = math('J')
const slopeOfJ = (by: string) => frac(row('∂', 'J'), row('∂', by))
const left = sub('p', '−')
const right = sub('p', '+')
const columns = (first: string, second: string) => det('[', first, '|', second, ']')

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
      text: `<p>In 1990 Patrick Knupp showed that vertices and edges do not suffice, and conjectured that faces do: if ${J} is positive on all six
        faces, it is positive everywhere inside. Paul Zhang has proved it. So the lens looks at the faces, at all of each, and can be
        certain.</p>`,
      task: 'This element is valid. Read the table: two cautious methods reject it all the same.',
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
      text: `<p>In the plane the corners are enough. With ${math('F', '=', 'p', '+', 's', 'a', '+', 't', 'b', '+', 's', 't', 'c')} the two columns are
        ${math('a', '+', 't', 'c')} and ${math('b', '+', 's', 'c')}, and</p>
        ${display('J', '=', columns('a', 'b'), '+', 's', columns('a', 'c'), '+', 't', columns('c', 'b'))}
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
      text: `<p>Fix ${math('ξ')}: that is a square slice of the cube. If its image is flat, with normal ${math('n')}, then
        ${math('J', '=', 'ℓ', 'q')}, where ${math('ℓ')} is the slice’s own determinant, linear as before, and
        ${math('q', '=', 'n', '·', row('∂', 'F'), '/', row('∂', 'ξ'))} is bilinear. If ${J} is positive on the slice’s rim,
        ${math('ℓ')} keeps one sign there and so does ${math('q')}. Both then keep it on the whole slice: ${J} is positive there.</p>`,
      task: 'This frustum has six flat faces, so its twelve edges decide. Bend a face by dragging one vertex.',
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
      text: `<p>Suppose the conjecture were false: faces positive, ${J} negative somewhere inside. The surface ${math('J', '=', 0)} would surround that
        place and touch no face: a <em>bubble</em>. In the element shown the surface is a tube. It leaves through the bottom and the top, and there
        the faces are negative.</p>`,
      task: 'Try to pinch the tube off from both faces by dragging vertices. Nobody can; the next two steps say why.',
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
      text: `<p>On a bubble ${J} grows outwards, from negative to positive, and nowhere pauses: that would need a flat slice. At the leftmost point ${math(left)} outwards is to the left,
        at the rightmost ${math(right)} to the right, and ${J} does not change with ${math('η')} or ${math('ζ')}:</p>
        ${display(slopeOfJ('ξ'), of(left), '<', 0, '<', slopeOfJ('ξ'), of(right))}
        <p>The drawing is the tube of the picture, cut at ${math('ζ', '=', frac(1, 2))}.</p>`,
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
        ${math('U', '=', 'α', 'V', '+', 'β', 'W')}. Where in addition ${J} does not change with ${math('η')} or ${math('ζ')}, some algebra gives</p>
        ${display(slopeOfJ('ξ'), '=', '−', 2, 'α', 'β', 'κ')}
        ${display('κ', '=', det(tall('[', 'V', '|', 'W', '|', frac(row(sup('∂', 2), 'F'), row('∂', 'η', '∂', 'ζ')))))}
        <p>Were one of the factors zero, a slice through that point would be flat. Its rim lies on the faces, where ${J} is positive; then ${J} is
        positive on the slice, and not zero at the point. So on a bubble no factor ever vanishes or changes its sign, and the two slopes have
        the <em>same</em> sign. They cannot have both: there is no bubble.</p>`,
      task: 'And the tube? Rims of its slices run through negative parts of the faces, so its factors may vanish.',
      claims: [{ says: 'The boundary is not positive here', holds: 'boundary_min <= 0' }],
      element: 'face-negative',
      views: 'scene verdict',
      state: tube,
    },
    {
      title: 'The least value, too',
      text: `<p>More is true. If an element is valid, even its least ${J} lies on the boundary: where ${J} has a least value inside, it is constant
        along a line from there to a face.</p>
        <p>Two things are left to explain: how strict <em>positive</em> has to be, and how the least value on a face is found.</p>`,
      task: 'Drag vertices: as long as the word is VALID, the ring at the least value stays on the faces.',
      claims: [
        { says: 'The element is valid', holds: 'valid' },
        { says: 'Its least jacdet is the least on the boundary', holds: 'volume_min = boundary_min' },
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
