/**
 * The challenges of the page, in the order of its list. tests/unit/challenges.test.ts checks with the core that each is solved by its solution,
 * not at its start, and not a double before the solution. Who comes upon the solution itself is not said to have solved it: it has no
 * numbers that one tries first.
 */

import { type Vec3, vertexReference } from '../../model/hexahedron'
import { CHALLENGE_VERSION, type ChallengeDocument } from './challenge'

export interface NamedChallenge extends Required<ChallengeDocument> {
  /** Part of links: it lasts for ever. */
  readonly id: string
}

const version = CHALLENGE_VERSION
const cube = vertexReference.flat()

/** The unit cube with some vertices elsewhere. */
function cubeWith(moved: Readonly<Record<number, Vec3>>): number[] {
  return vertexReference.flatMap((corner, v) => moved[v] ?? corner)
}

/** A block whose top is turned so far that two of its edges are negative. */
const turnedBlock = [
  [0, -0.5, -0.5],
  [0.5, -0.5, -0.5],
  [0.5, 0, -0.5],
  [-0.25, 0.25, 0],
  [-0.5, -0.25, 0],
  [0.25, -0.25, 0.25],
  [0.25, 0.5, 0],
  [0, 0, 0.25],
].flat()

/** A square on the ground, for a top to be turned above it. */
const centredCube = cube.map((x, i) => (i % 3 === 2 ? x : x - 0.5))

export const challenges: readonly NamedChallenge[] = [
  {
    id: 'one-vertex',
    version,
    title: 'Break it with one vertex',
    text: 'A cube is valid: its Jacobian determinant J is 1 everywhere. Make it invalid, and move only one vertex.',
    start: cube,
    goal: ['not valid', 'moved <= 1'],
    record: null,
    hint: 'At a vertex J is the volume spanned by its three edges, with a sign. Push the vertex through the plane of its three neighbours.',
    solution: cubeWith({ 6: [0.375, 0.125, 0.625] }),
  },
  {
    id: 'touch-zero',
    version,
    title: 'Touch zero exactly',
    text: 'Bring the least J on the boundary to zero: not nearly, but exactly. Such an element is invalid, because valid means more than zero.',
    start: cube,
    goal: ['boundary_min = 0'],
    record: null,
    hint: 'Put a vertex into the plane of its three neighbours. Vertex 0 is there when its three coordinates add up to 1: type them, or hold Alt for the grid.',
    solution: cubeWith({ 0: [0.375, 0.5, 0.125] }),
  },
  {
    id: 'corners-positive',
    version,
    title: 'Corners positive, yet invalid',
    text: 'Many programs look at the eight corners only. Make an element that they take for valid and that is not.',
    start: cube,
    goal: ['not valid', 'corner_min > 0'],
    record: null,
    hint: 'Along an edge J is a parabola: both of its ends may be positive while its middle is not. Take the edge from 0 to 4, and slant what leaves it: vertex 3 far to one side, vertex 5 far to another.',
    solution: cubeWith({ 3: [-1.5, 1, 0], 4: [0, 0.5, 1], 5: [1, -1.5, 1] }),
  },
  {
    id: 'edges-positive',
    version,
    title: 'Edges positive, yet invalid',
    text: 'Now all twelve edges are to be positive from end to end, and the element invalid all the same: it has to be negative in the middle of a face.',
    start: cube,
    goal: ['not valid', 'edge_min > 0'],
    record: null,
    hint: 'It takes large moves of at least two vertices. Stretch the element to and fro, look for a face whose squares, the candidates on faces, have small values, and go on there.',
    solution: cubeWith({ 0: [0.75, -0.25, 0.5], 3: [-1.5, 0, 1.25], 4: [-1.75, 3.75, 3.75] }),
  },
  {
    id: 'gauss-and-scaled',
    version,
    title: 'Past the usual tests',
    text: 'The 2×2×2 Gauss points are positive, and the scaled Jacobian, as HexaLab and Verdict compute it, is at least 0.2: most programs are content. Make such an element that is invalid.',
    start: cube,
    goal: ['not valid', 'gauss2_min > 0', 'scaled_jacobian >= 0.2'],
    record: null,
    hint: 'All nine points of the scaled Jacobian are corners or the centre, and Gauss points lie inside: what is wrong has to be on an edge or a face, between corners.',
    solution: cubeWith({ 0: [-1.5, -1, 0.75], 4: [0.25, 1, 1.25], 6: [1.5, 1.75, 2.25] }),
  },
  {
    id: 'lower-inside',
    version,
    title: 'Lower inside than outside',
    text: 'The least J of a valid element is on its boundary: that is a theorem. Invalid ones are not bound by it. Make one whose J is lower inside than anywhere on its six faces.',
    start: cubeWith({ 2: [0.5, 0.5, 0.25], 5: [0.5, 0.25, 0.5], 6: [0.75, 0.75, 0.75], 7: [0.25, 0.5, 0.5] }),
    goal: ['volume_min < boundary_min'],
    record: null,
    hint: 'Everything here is symmetric about the diagonal from vertex 0 to vertex 6. Keep it so: move vertex 6 along it.',
    solution: cubeWith({ 2: [0.5, 0.5, 0.25], 5: [0.5, 0.25, 0.5], 6: [-0.5, -0.5, -0.5], 7: [0.25, 0.5, 0.5] }),
  },
  {
    id: 'most-twisted',
    version,
    title: 'The most twisted cube',
    text: 'Turn the top of a cube against its bottom, by 150 degrees at least, and keep it valid. Only four vertices may move. How far can you go?',
    start: centredCube,
    goal: ['valid', 'moved <= 4', 'twist >= 150'],
    record: { quantity: 'twist', best: 'greatest' },
    hint: 'Cut a turned cube half way up: the cut is a square that shrinks as the top is turned, but it is not a point before 180 degrees. The top has to stay a square.',
    // Turned by the angle whose cosine is -840/841 and whose sine is 41/841: 177.2 degrees.
    solution: centredCube.map((x, i, all) => {
      if (i < 12 || i % 3 === 2) return x
      const [a, b] = [all[i - (i % 3)] as number, all[i - (i % 3) + 1] as number]
      return i % 3 === 0 ? (-840 * a - 41 * b) / 841 : (41 * a - 840 * b) / 841
    }),
  },
  {
    id: 'depth-guard',
    version,
    title: 'Valid, though subdivision gives up',
    text: 'Some programs cut an element into eight, again and again, until they can tell; after the fourth time they give up and reject it. This block is invalid. Make it valid, but so narrowly that they still reject it. Move one vertex.',
    start: turnedBlock,
    goal: ['valid', 'subdivision <= 0', 'moved <= 1'],
    record: null,
    hint: 'Move vertex 7 until the element is just valid, then back by ever smaller steps: with Ctrl (on a Mac: Alt) an arrow key takes a tenth of a step. The least J has to be away from the corners.',
    solution: turnedBlock.with(21, -0.0625).with(22, 0.0234375).with(23, 0.1875),
  },
]
