import type { Lesson } from './lessons'
import { display, frac, math, of, prime, row, sub, sup } from './mathml'

const J = math('J')
const q = (i: number) => sub('q', i)
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
      text: `<p>The least ${J} on the boundary is at a vertex, or inside an edge, or inside a face. Each case is a small calculation that leaves a
        few points. Eight vertices, twelve edges, six faces: 26 steps, and the least of all candidates is the least of all.</p>`,
      task: 'Step through Algorithm 1 with its buttons: each vertex, edge and face lights up in its turn.',
      claims: [
        { says: 'The vertices alone would say 3/64', holds: 'corner_min = 3/64' },
        { says: 'The edges take it below zero', holds: 'edge_min < 0' },
        { says: 'No face goes lower', holds: 'boundary_min = edge_min' },
      ],
      element: 'looks-fine',
      views: 'scene algorithm',
      state: { openPanels: ['algorithm'], following: { query: 'minimum', variant: 'roots-b', step: 8 } },
    },
    {
      title: 'An edge: a parabola',
      text: `<p>With the three numbers of an edge, the parabola’s lowest point is strictly inside exactly if ${math(q(1))} is below
        ${math(q(0))} and ${math(q(2))}. It lies at</p>
        ${display('r', '=', frac(row(q(0), '−', q(1)), row(q(0), '−', 2, q(1), '+', q(2))))}
        <p>Otherwise an end is lowest, and the ends have been looked at already.</p>`,
      task: 'On this edge it is at 7/12 of the way, and −1/48 there. Drag vertex 4 and watch it move.',
      claims: [{ says: 'The least jacdet is −1/48, on an edge', holds: 'boundary_min = -1/48 and edge_min = -1/48' }],
      figure: { kind: 'edge', edge: 8 },
      element: 'edge-negative',
      views: 'scene verdict',
      state: { selectedVertex: 4, camera: { direction: [-0.6, -0.75, 0.35], zoom: 1, pan: [0, 0, 0] } },
    },
    {
      title: 'A face: a parabola for each t',
      text: `<p>On a face with coordinates ${math('s')} and ${math('t')}</p>
        ${display('J', '=', at('a'), sup('s', 2), '+', at('b'), 's', '+', at('c'))}
        <p>For each ${math('t')} this is a parabola in ${math('s')}. If it opens upwards, ${math('a', '>', 0)}, it is lowest at
        ${math(sup('s', '*'), '=', '−', 'b', '/', row('2', 'a'))}. As ${math('t')} moves, that point draws a curve on the face; follow it downhill.</p>`,
      task: 'The red ring in the map of the bottom face is where that curve is lowest.',
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
      title: 'Downhill ends at a quartic',
      text: `<p>Along the curve the slope of ${J} is ${math('P', '/', row(4, sup('a', 2)))} with</p>
        ${display('P', '=', 4, sup('a', 2), prime('c'), '−', 2, 'a', 'b', prime('b'), '+', prime('a'), sup('b', 2))}
        <p>${math('a')} is linear in ${math('t')}, ${math('b')} and ${math('c')} are quadratic, so ${math('P')} has degree four at most: four roots, four
        candidates. A root counts if ${math('a', '>', 0)} and ${math(0, '<', sup('s', '*'), '<', 1)} there.</p>`,
      task: 'Below the maps find the root of P, at t = 1/2, in its plot.',
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
      text: `<p>Not every root is a lowest point. On each of the four side faces of the same element the root gives a saddle: ${J} rises one way and
        falls the other, and is 1/16 there. Nothing has to be sorted out. Each candidate is a point of the element, so its ${J} is never below the
        least one.</p>`,
      task: 'Find the squares on the four side faces of the map: 1/16, more than on some edges.',
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
      text: `<p>On the face ${math('ξ', '=', 1)} of the last lesson’s element ${math('J', '=', sup(of('s', '−', 't'), 2))}, lowest all along a line. There
        ${math('a', '=', 1)}, ${math('b', '=', '−', 2, 't')}, ${math('c', '=', sup('t', 2))}, and ${math('P')} vanishes for every ${math('t')}: there are no roots to
        find. Nor are any needed. Along the curve ${J} does not change, and the curve leads to an edge, which has been looked at.</p>`,
      task: 'See the line of zeros in the map: its two ends are vertices.',
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
      text: `<p>Written in Bernstein form, ${J} on a face is at every point a weighted mean of nine coefficients. So it is never below the least of
        them, ${math(sub('L', 'R'))}. If ${math(sub('L', 'R'), '≥', 'M')}, the least value found so far, the face cannot win: no quartic.</p>`,
      task: 'Here all six faces are skipped; the step shown says why. Go back through the others.',
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
      text: `<p>For a valid element the work is done: by the theorem nothing inside is lower. For an invalid one it may be. The lens looks for that as
        well, by cutting the element into ever smaller boxes with Bernstein bounds of their own; but the verdict does not wait for it.</p>`,
      task: 'Now you know all that the lens does. The challenges ask you to use it.',
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
