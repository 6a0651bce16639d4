import { foldout } from './foldout'
import type { Lesson } from './lessons'
import { det, display, frac, math, of, prime, row, sub, sup, thin } from './mathml'

const J = math('J')
const q = (i: number) => sub('q', i)
const columns = (...[a, b, c]: readonly [string, string, string]) => det('[', a, '|', b, '|', c, ']')
const at = (name: string) => row(name, of('t'))

const bent = [
  [0, 0, 0],
  [1.25, -0.25, 0],
  [1, 1, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 0, 1],
  [1.5, 1.25, 1.5],
  [0, 1, 1],
] as const

export const lesson: Lesson = {
  id: 'finding-the-minimum',
  title: 'Finding the minimum',
  summary: 'Parabolas on edges, a quartic on each face, and bounds to skip them.',
  steps: [
    {
      title: 'Finitely many candidates',
      text: `<p>The least ${J} on the boundary is at a vertex, or inside an edge, or inside a face. For each of these a small calculation gives a
        few candidates. Eight vertices, twelve edges and six faces make 26 steps. The least ${J} of the candidates is the least on the
        boundary.</p>`,
      task: 'Go through Algorithm 1 with its buttons: the picture marks each vertex, edge and face in turn.',
      claims: [
        { says: 'The vertices alone would say 3/64', holds: 'corner_min = 3/64' },
        { says: 'On the edges it is below zero', holds: 'edge_min < 0' },
        { says: 'No face goes lower', holds: 'boundary_min = edge_min' },
      ],
      element: 'looks-fine',
      views: 'scene algorithm',
      state: { openPanels: ['algorithm'], following: { query: 'minimum', variant: 'roots-b', step: 8 } },
    },
    {
      title: 'An edge: a parabola',
      text: `<p>An edge has three numbers, as in lesson 3. The lowest point of its parabola lies between the ends exactly if ${math(q(1))} is less than
        both ${math(q(0))} and ${math(q(2))}. It is at</p>
        ${display('r', '=', frac(row(q(0), '−', q(1)), row(q(0), '−', 2, q(1), '+', q(2))))}
        <p>Otherwise ${J} is least at an end. The ends are vertices, and they are candidates already.</p>
        ${foldout(
          'Where the formula comes from',
          `<p>Along the edge the slope of ${J} is</p>
          ${display(2, of(of(1, '−', 'r'), of(q(1), '−', q(0)), '+', 'r', of(q(2), '−', q(1))))}
          <p>It goes linearly from ${math(2, of(q(1), '−', q(0)))} to ${math(2, of(q(2), '−', q(1)))}. It changes from negative to positive
          exactly if ${math(q(1))} is less than both others, and it is zero at ${math('r')}.</p>`,
        )}`,
      task: 'On this edge it is at 7/12 of the way, and there jacdet is −1/48. Drag vertex 4 and watch it move.',
      claims: [{ says: 'The least jacdet is −1/48, on an edge', holds: 'boundary_min = -1/48 and edge_min = -1/48' }],
      figure: { kind: 'edge', edge: 8, hasCoefficients: true },
      element: 'edge-negative',
      views: 'scene verdict',
      state: { selectedVertex: 4, camera: { direction: [-0.6, -0.75, 0.35], zoom: 1, pan: [0, 0, 0] } },
    },
    {
      title: 'A face: a parabola for each t',
      text: `<p>On a face with coordinates ${math('s')} and ${math('t')}</p>
        ${display('J', '=', at('a'), sup('s', 2), '+', at('b'), 's', '+', at('c'))}
        <p>For each ${math('t')} this is a parabola in ${math('s')}. If it opens upwards, ${math('a', '>', 0)}, it is lowest at
        ${math(sup('s', '*'), '=', '−', 'b', '/', row('2', 'a'))}. These points, one for each ${math('t')}, form a curve on the face. The
        picture shows it as a dashed line.</p>`,
      task: 'Only the bottom face is drawn. Point at places along the dashed line: jacdet is least where the ring is.',
      claims: [{ says: 'The least jacdet is −1/16, inside a face', holds: 'boundary_min = -1/16 and edge_min > 0' }],
      element: 'face-negative',
      views: 'scene face-maps',
      state: {
        openPanels: ['face-maps'],
        selectedFace: 4,
        faceDisplay: 4,
        camera: { direction: [0.25, -0.3, -1], zoom: 1.15, pan: [0, 0, 0] },
      },
    },
    {
      title: 'A quartic for the curve',
      text: `<p>Along the curve the slope of ${J}, by ${math('t')}, is ${math('P', '/', row(4, sup('a', 2)))} with</p>
        ${display('P', '=', 4, sup('a', 2), prime('c'), '−', 2, 'a', 'b', prime('b'), '+', prime('a'), sup('b', 2))}
        <p>${math('a')} is linear in ${math('t')}, and ${math('b')} and ${math('c')} are quadratic. So ${math('P')} has at most degree four: a
        quartic. Its roots give at most four candidates. A root counts if ${math('a', '>', 0)} and
        ${math(0, '<', sup('s', '*'), '<', 1)} there.</p>
        ${foldout(
          'Where P comes from',
          `<p>At ${math(sup('s', '*'))} the value is ${math('c', '−', sup('b', 2), '/', row(4, 'a'))}. Its derivative by ${math('t')} is</p>
          ${display(prime('c'), '−', frac(row('b', prime('b')), row(2, 'a')), '+', frac(row(prime('a'), sup('b', 2)), row(4, sup('a', 2))), '=', frac('P', row(4, sup('a', 2))))}
          <p>The terms of degree five cancel. On a face ${J} has no term with ${math(sup('s', 2), sup('t', 2))}, which is why ${math('a')} is
          linear.</p>`,
        )}`,
      task: 'Below the maps, in the plot of P, find its root at t\u00a0=\u00a01/2.',
      claims: [{ says: 'The least jacdet is −1/16, inside a face', holds: 'boundary_min = -1/16 and edge_min > 0' }],
      element: 'face-negative',
      views: 'scene face-maps',
      state: {
        openPanels: ['face-maps'],
        selectedFace: 4,
        camera: { direction: [0.5, -0.75, -0.6], zoom: 1, pan: [0, 0, 0] },
      },
    },
    {
      title: 'Saddles do no harm',
      text: `<p>Not every root gives a lowest point. On each of the four side faces of the same element the root gives a saddle: ${J} rises one way and
        falls the other way. There it is 1/16. Saddles need not be removed. Each candidate is a point of the boundary, so its ${J} is never below
        the least one.</p>`,
      task: 'Find the square marks on the four side faces in the map. There jacdet is 1/16, more than on some edges.',
      claims: [
        { says: 'The edges have less than 1/16', holds: 'edge_min < 1/16' },
        { says: 'The least of all is −1/16', holds: 'boundary_min = -1/16' },
      ],
      element: 'face-negative',
      views: 'scene face-maps',
      state: { openPanels: ['face-maps'], selectedFace: 2 },
    },
    {
      title: 'When P is zero',
      text: `<p>On the face ${math('ξ', '=', 1)} of the last lesson’s element ${math('J', '=', sup(of('s', '−', 't'), 2))}. It is zero all along a line. There
        ${math('a', '=', 1)}, ${math('b', '=', '−', 2, 't')} and ${math('c', '=', sup('t', 2))}, so ${math('P')} is zero for every ${math('t')}. No roots can be
        found, and none are needed. Along the curve ${J} does not change, and the curve ends on an edge. The edges have candidates already.</p>`,
      task: 'Find the line of zeros in the map: its two ends are vertices.',
      claims: [
        { says: 'The least jacdet on the faces is 0', holds: 'boundary_min = 0' },
        { says: 'and so it is on the edges', holds: 'edge_min = 0' },
      ],
      element: 'non-strict',
      views: 'scene face-maps',
      state: { openPanels: ['face-maps'], selectedFace: 1 },
    },
    {
      title: 'Most faces can be skipped',
      question: {
        asks: `<p>In Bernstein form, ${J} on a face is at every point a weighted mean of nine coefficients. So it is never below the least of them,
          ${math(sub('L', 'R'))}. Let ${math('M')} be the least value found so far. If ${math(sub('L', 'R'), '≥', 'M')}, the face is skipped.</p>
          <p>For this element vertices and edges give ${math('M', '=', 1)}. Is there a face whose quartic has to be solved?</p>`,
        answer: {
          kind: 'choice',
          choices: [
            { says: 'Yes: some coefficient is below 1', holds: 'bernstein_min < boundary_min' },
            { says: 'No: all coefficients are at least 1', holds: 'bernstein_min >= boundary_min' },
          ],
        },
        because:
          '<p>An element that is bent only a little has coefficients close to its values. So most faces of a good mesh are skipped.</p>',
        before: { views: 'scene verdict' },
      },
      text: `<p>${math(sub('L', 'R'))} costs little, and a quartic costs more. On this element ${math(sub('L', 'R'), '≥', 'M')} on all six faces, so no
        quartic is solved.</p>`,
      task: 'All six faces are skipped, and the step shown says why. Go back through the others.',
      claims: [
        { says: 'The least jacdet is 1', holds: 'boundary_min = 1' },
        { says: 'and no Bernstein coefficient is lower', holds: 'bernstein_min >= boundary_min' },
      ],
      element: bent,
      views: 'scene algorithm',
      state: { openPanels: ['algorithm'], following: { query: 'minimum', variant: 'roots-b', step: 25 } },
    },
    {
      title: 'And inside?',
      text: `<p>For a valid element this is all: by the theorem nothing inside is lower. Inside an invalid one ${J} may be lower. The lens finds that
        minimum as well. It cuts the element into smaller and smaller boxes, each with its own Bernstein bounds. The verdict does not depend on
        it.</p>
        ${foldout(
          'One vertex alone: where is it best?',
          `<p>Let one vertex move to ${math('p')}, while all others stay. At a given point ${math('q')} of the element the columns of
          ${math('D', 'F')} are</p>
          ${display('U', '=', 'u', '+', 'α', 'p')}
          ${display('V', '=', 'v', '+', 'β', 'p')}
          ${display('W', '=', 'w', '+', 'γ', 'p')}
          <p>A term of the determinant with two of the three ${math('p')} has two parallel columns, and vanishes. What is left is affine in
          ${math('p')}:</p>
          ${display(sub('J', 'q'), of('p'), '=', columns('u', 'v', 'w'))}
          ${display('+', 'α', thin, columns('p', 'v', 'w'), '+', 'β', thin, columns('u', 'p', 'w'))}
          ${display('+', 'γ', thin, columns('u', 'v', 'p'))}
          <p>So is the volume ${math(sub('V', 'c'))} of each cell ${math('c')}, its mean. Divide ${J} in each cell around the vertex by a size
          ${math(sub('s', 'c'))} that stays, and take the least:</p>
          ${display('T', of('p'), '=', thin, sub('min', row('c', ',', 'q')), thin, sub('J', 'q'), of('p'), '/', sub('s', 'c'))}
          <p>The least of affine functions is concave: it has one greatest value, and no lower top. The relative minimum divides by the volume,
          which changes, too. But it is at least ${math('r')} exactly where all</p>
          ${display(sub('J', 'q'), of('p'), '−', 'r', sub('V', 'c'), of('p'), '≥', 0)}
          <p>These are half-spaces, and what they have in common is convex, for each ${math('r')}: the least relative minimum is
          quasi-concave where volumes are positive. At the best place at most four of the half-spaces leave no room for more. The lens
          shows them under <em>Best place of a vertex</em>.</p>`,
        )}`,
      task: 'This is all that the lens does. The challenges ask you to use it.',
      claims: [
        { says: 'On the boundary the least jacdet is −1/16', holds: 'boundary_min = -1/16' },
        { says: 'Inside it is lower', holds: 'volume_min < boundary_min' },
        { says: 'below −1/10', holds: 'volume_min < -1/10' },
      ],
      element: 'face-negative',
      views: 'scene verdict',
      state: { faceDisplay: 'inside', section: { axis: 2, value: 0.5 } },
    },
  ],
}
