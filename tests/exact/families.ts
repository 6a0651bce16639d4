/** Hexahedra on which doubles decide little, as fast-check arbitraries: what meshes store as hexahedra, and exact zeros of every kind. */
import fc from 'fast-check'
import { COORDINATE_COUNT, type Vertices } from '../../web/model/hexahedron'
import { reflections, rotations } from '../../web/model/node-order'
import { borderCrossing, hexahedraOf } from '../property/border'
import { displacedBetween, families } from '../property/hexahedra'
import { moved } from '../property/ulps'

type Hexahedra = fc.Arbitrary<readonly number[]>

const integer = (min: number, max: number) => fc.noBias(fc.integer({ min, max }))

/** The vertex whose place each vertex takes. */
export const SHAPES = {
  wedge: [0, 1, 2, 3, 4, 5, 5, 4],
  pyramid: [0, 1, 2, 3, 4, 4, 4, 4],
  tetrahedron: [0, 1, 2, 2, 4, 4, 4, 4],
}

const symmetry = fc.constantFrom(...rotations, ...reflections)

/** Shapes as meshes store them: vertices coincide, in any of the cube's symmetries. */
export const shapes: Hexahedra = fc
  .tuple(displacedBetween(0.05, 0.5), fc.constantFrom(...Object.values(SHAPES)), symmetry)
  .map(([vertices, places, order]) =>
    order.flatMap(v => vertices.slice(3 * (places[v] as number), 3 * (places[v] as number) + 3)),
  )

const BITS = 50

/** Four coplanar points at a corner with all bits of the doubles in use: jacdet is 0 there, exactly, and mostly positive elsewhere. */
export const coplanarCorner: Hexahedra = fc
  .tuple(displacedBetween(0.02, 0.2), symmetry, fc.constantFrom([-1, -1], [-1, -2], [0, -1], [-1, 0]))
  .map(([displaced, order, [m, n]]) => {
    const whole = displaced.map(x => Math.round(x * 2 ** BITS))
    const at = (v: number, axis: number) => whole[3 * v + axis] as number
    // Vertex 4 is in the plane of 0, 1 and 3.
    const corner = [0, 1, 2].map(
      axis => at(0, axis) + (m as number) * (at(1, axis) - at(0, axis)) + (n as number) * (at(3, axis) - at(0, axis)),
    )
    const points = whole
      .with(12, corner[0] as number)
      .with(13, corner[1] as number)
      .with(14, corner[2] as number)
    return order.flatMap(v => points.slice(3 * v, 3 * v + 3).map(x => x * 2 ** -BITS))
  })

const powers = (least: number, most: number) => fc.array(integer(least, most), { minLength: 24, maxLength: 24 })

/** Coordinates hundreds of powers of ten apart on each axis, anyhow. */
const scattered: Hexahedra = fc
  .tuple(displacedBetween(0.02, 0.6), powers(-500, 500))
  .map(([vertices, by]) => vertices.map((x, i) => x * 2 ** (by[i] as number)))

/** Elements long on the last axis, from below 0 to above: most corners are positive. */
const piled: Hexahedra = fc
  .tuple(displacedBetween(0.02, 0.2), powers(-1000, 0))
  .map(([vertices, by]) =>
    vertices.map((x, i) => (i % 3 < 2 ? x : (i < 12 ? -1 : 1) * (0.5 + Math.abs(x)) * 2 ** (by[i] as number))),
  )

export const spanning: Hexahedra = fc.oneof(scattered, piled)

/** Another coordinate of each a few ulps further on: what was exactly zero is not, as a rule. */
function nearly(hexahedra: Hexahedra): Hexahedra {
  return fc
    .tuple(hexahedra, integer(0, COORDINATE_COUNT - 1), integer(-3, 3))
    .map(([vertices, i, ulps]) => vertices.with(i, moved(vertices[i] as number, ulps)))
}

export interface Family {
  readonly name: string
  readonly hexahedra: fc.Arbitrary<readonly Vertices[]>
  /** The share of all hexahedra, and the number drawn at once. */
  readonly share: number
  readonly each: number
}

const alone = (hexahedra: Hexahedra) => hexahedra.map(vertices => [vertices])

/** Half of them within a few ulps of the border. */
export const FAMILIES: readonly Family[] = [
  {
    name: 'at the border',
    hexahedra: borderCrossing('all', 'vertex', 'coordinate').map(hexahedraOf),
    share: 0.5,
    each: 16,
  },
  { name: 'wedges, pyramids, tetrahedra', hexahedra: alone(shapes), share: 0.1, each: 1 },
  { name: 'nearly these', hexahedra: alone(nearly(shapes)), share: 0.05, each: 1 },
  { name: 'coplanar at a corner', hexahedra: alone(coplanarCorner), share: 0.08, each: 1 },
  { name: 'nearly coplanar at a corner', hexahedra: alone(nearly(coplanarCorner)), share: 0.05, each: 1 },
  { name: 'small integers', hexahedra: alone(families['small-integers']), share: 0.05, each: 1 },
  { name: 'flat, thin, with repeated vertices', hexahedra: alone(families.degenerate), share: 0.05, each: 1 },
  { name: 'touching zero', hexahedra: alone(families.touched), share: 0.05, each: 1 },
  { name: 'displaced', hexahedra: alone(families.displaced), share: 0.045, each: 1 },
  { name: 'axes of every size', hexahedra: alone(families.scaled), share: 0.02, each: 1 },
  { name: 'hundreds of powers of ten', hexahedra: alone(spanning), share: 0.005, each: 1 },
]
