/**
 * Elements to start from, in the order of the list on the page. The first is the page's first screen. Each note is a claim
 * that tests/unit/presets.test.ts checks in exact arithmetic.
 */

import type { PlainWord } from '../words/say'
import { type Vec3, type Vertices, vertexReference } from './hexahedron'

export interface Preset {
  readonly id: string
  readonly title: PlainWord
  /** One plain sentence: what it shows. */
  readonly note: PlainWord
  /** Null where chance decides. */
  readonly valid: boolean | null
  /** Eight points, or how to draw new ones each time from random numbers in [0,1). */
  readonly points: readonly Vec3[] | ((random: () => number) => readonly Vec3[])
}

export const presets: readonly [Preset, ...Preset[]] = [
  {
    id: 'looks-fine',
    title: 'Looks fine, is not',
    note: 'A block like any other, and all eight vertices are positive; yet along two edges of its top jacdet is negative.',
    valid: false,
    points: [
      [0, -0.5, -0.5],
      [0.5, -0.5, -0.5],
      [0.5, 0, -0.5],
      [-0.25, 0.25, 0],
      [-0.5, -0.25, 0],
      [0.25, -0.25, 0.25],
      [0.25, 0.5, 0],
      [0, 0, 0.25],
    ],
  },
  {
    id: 'cube',
    title: 'Unit cube',
    note: 'jacdet is 1 everywhere.',
    valid: true,
    points: [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
      [0, 0, 1],
      [1, 0, 1],
      [1, 1, 1],
      [0, 1, 1],
    ],
  },
  {
    id: 'non-strict',
    title: 'Zero on the faces, negative inside',
    note: 'The paper’s counterexample: on the boundary jacdet is never below zero, at the centre it is −1/4. Positive has to mean more than zero.',
    valid: false,
    points: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
      [0, 0, 0],
      [-1, -1, -1],
      [0, 0, 0],
    ],
  },
  {
    id: 'edge-negative',
    title: 'Vertices fine, an edge is not',
    note: 'All eight vertices are positive; on an edge between two of them jacdet is negative.',
    valid: false,
    points: [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [-1.5, 1, 0],
      [0, 0.5, 1],
      [1, -1.5, 1],
      [1, 1, 1],
      [0, 1, 1],
    ],
  },
  {
    id: 'face-negative',
    title: 'Edges fine, a face is not',
    note: 'All eight vertices and all twelve edges are positive; in the middle of two faces jacdet is negative.',
    valid: false,
    points: [
      [0.5, 0.25, 0.25],
      [1, 0, 1],
      [0.5, 0.75, 0.25],
      [0, 1, 1],
      [0, 0, 0],
      [0.75, 0.5, 0.75],
      [1, 1, 0],
      [0.25, 0.5, 0.75],
    ],
  },
  {
    id: 'touching',
    title: 'Touches zero on a face',
    note: 'The minimum is exactly zero, in the middle of a face. A valid element needs more than zero.',
    valid: false,
    points: [
      [0.25, 0, 0.25],
      [1, 0, 0.5],
      [0.75, 1, 0.25],
      [0, 1, 0.5],
      [0, 0, 0.25],
      [1, 0.25, 0.5],
      [1, 1, 0.25],
      [0, 0.75, 0.5],
    ],
  },
  {
    id: 'twisted-before',
    title: 'Twisted by 143°, just valid',
    note: 'The top is stretched and turned; at 143.13° (cosine −4/5) jacdet reaches zero.',
    valid: true,
    points: [
      [-0.5, -0.5, 0],
      [0.5, -0.5, 0],
      [0.5, 0.5, 0],
      [-0.5, 0.5, 0],
      [0.949, -0.402, 1],
      [-0.648, 0.801, 1],
      [-0.949, 0.402, 1],
      [0.648, -0.801, 1],
    ],
  },
  {
    id: 'twisted-after',
    title: 'Twisted by 143.3°, just not',
    note: 'Turned 0.3° further: jacdet is negative on the upright edges.',
    valid: false,
    points: [
      [-0.5, -0.5, 0],
      [0.5, -0.5, 0],
      [0.5, 0.5, 0],
      [-0.5, 0.5, 0],
      [0.951, -0.397, 1],
      [-0.652, 0.798, 1],
      [-0.951, 0.397, 1],
      [0.652, -0.798, 1],
    ],
  },
  {
    id: 'depth-guard',
    title: 'Valid, though subdivision gives up',
    note: 'Valid; a recursive subdivision that gives up past depth 4 rejects it.',
    valid: true,
    points: [
      [1.8969496233803413, -1.7669085919026646, -1.114796423902499],
      [3.9660978915433196, 0.9941288044550751, 0.9658472806579895],
      [0.043435666995569, -0.12324646071093626, 1.524408777185414],
      [1.83497892949218, 4.764986397593189, 1.292393768207913],
      [-0.09456216179334609, -1.636321610495878, 0.6668138480861839],
      [-0.3892421926717491, -2.364388446196918, 3.881731647822864],
      [-0.5029497209387261, 0.7704229690521118, 0.04129386218126074],
      [0.010258151621061617, -0.565401455945743, -0.538861764424899],
    ],
  },
  {
    id: 'inverted',
    title: 'Cube inside out',
    note: 'Bottom and top are exchanged: jacdet is −1 everywhere. The usual cause is another order of the nodes.',
    valid: false,
    points: [
      [0, 0, 1],
      [1, 0, 1],
      [1, 1, 1],
      [0, 1, 1],
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
    ],
  },
  {
    id: 'wrong-order',
    title: 'Wrong node order',
    note: 'A good block with its points in deal.II’s order instead of this page’s: jacdet is negative at four vertices until Node order puts them right.',
    valid: false,
    points: [
      [0, 0, 0],
      [1.25, 0, 0.125],
      [0, 1, 0],
      [1, 1.125, 0],
      [0.125, 0, 1],
      [1.25, 0.125, 1.25],
      [0, 1.125, 1],
      [1.125, 1, 1],
    ],
  },
  {
    id: 'wedge',
    title: 'Collapsed to a wedge',
    note: 'One edge of the top lies on the bottom: jacdet is zero along the sharp edge.',
    valid: false,
    points: [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
      [0, 0, 1],
      [1, 0, 1],
      [1, 1, 0],
      [0, 1, 0],
    ],
  },
  {
    id: 'random',
    title: 'Random',
    note: 'The unit cube with every coordinate moved by chance (normally, deviation 0.3): about half of these are valid.',
    valid: null,
    points: random =>
      vertexReference.map(([x, y, z]) => [moved(x, random), moved(y, random), moved(z, random)] as const),
  },
]

/** Normally distributed about x, to three decimals, never -0; Box and Muller's method, in which 1 - random() is never 0. */
function moved(x: number, random: () => number): number {
  const normal = Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random())
  return Math.round(1000 * (x + 0.3 * normal)) / 1000 + 0
}

export function presetVertices({ points }: Preset, random: () => number = Math.random): Vertices {
  return (typeof points === 'function' ? points(random) : points).flat()
}

/** The id of the preset that is these very numbers. */
export function presetOf(vertices: Vertices): string | null {
  const isThis = (known: Vertices) => known.every((value, i) => Object.is(value, vertices[i]))
  return presets.find(preset => preset.valid !== null && isThis(presetVertices(preset)))?.id ?? null
}
