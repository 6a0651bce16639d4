/**
 * Hexahedra for the property tests, as fast-check arbitraries: whatever they draw is replayed by seed and path. Families are
 * named for what is hard about them.
 */
import fc from 'fast-check'
import { COORDINATE_COUNT, type Vertices } from '../../web/model/hexahedron'
import { cases, caseVertices, unitCube } from '../unit/core-fixtures'
import { moved } from './ulps'

type Hexahedra = fc.Arbitrary<readonly number[]>

export const FAMILIES = ['displaced', 'raw', 'scaled', 'small-integers', 'degenerate', 'touched'] as const
export type Family = (typeof FAMILIES)[number]

const word = fc.noBias(fc.integer({ min: 0, max: 2 ** 32 - 1 }))
const words = (count: number) => fc.array(word, { minLength: count, maxLength: count })
const integersBetween = (min: number, max: number, count = COORDINATE_COUNT) =>
  fc.array(fc.noBias(fc.integer({ min, max })), { minLength: count, maxLength: count })

/** 24 independent standard normal numbers (Box-Muller); words of 0, to which fast-check shrinks, give 0. */
const normals = words(2 * COORDINATE_COUNT).map(drawn =>
  unitCube.map((_, i) => {
    const [radius, angle] = [drawn[2 * i] as number, drawn[2 * i + 1] as number].map(x => x / 2 ** 32) as [
      number,
      number,
    ]
    return Math.sqrt(-2 * Math.log(1 - radius)) * Math.cos(2 * Math.PI * angle)
  }),
)

/** The unit cube with normal displacements. */
export function displacedBetween(least: number, most: number): Hexahedra {
  return fc
    .tuple(normals, fc.noBias(fc.double({ min: least, max: most, noNaN: true })))
    .map(([by, sigma]) => unitCube.map((x, i) => x + sigma * (by[i] as number)))
}

export const displaced = displacedBetween(0.1, 2)

const bits = new BigUint64Array(1)
const double = new Float64Array(bits.buffer)

/** A double from two words; where they say infinity or NaN the exponent is halved. */
function finite(high: number, low: number): number {
  bits[0] = (BigInt(high) << 32n) | BigInt(low)
  if (Number.isFinite(double[0])) return double[0] as number
  bits[0] &= ~(1n << 62n)
  return double[0] as number
}

/** All exponents there are. */
export const rawBits: Hexahedra = words(2 * COORDINATE_COUNT).map(drawn =>
  unitCube.map((_, i) => finite(drawn[2 * i] as number, drawn[2 * i + 1] as number)),
)

/** Raw significands, but the signs of a cube about the origin and an exponent for each axis with two binades around it. */
const rawCube = fc.tuple(words(2 * COORDINATE_COUNT), integersBetween(1, 2043, 3)).map(([drawn, exponents]) =>
  unitCube.map((x, i) => {
    const [high, low] = [drawn[2 * i] as number, drawn[2 * i + 1] as number]
    const exponent = (exponents[i % 3] as number) + (high >>> 30)
    const size = finite((exponent << 20) | (high & 0xfffff), low)
    return x === 1 ? size : -size
  }),
)

/** Each axis with a power of two of its own; `uneven` also shrinks each displacement by one. */
const scaled = fc
  .tuple(
    normals,
    integersBetween(-60, 60, 3),
    integersBetween(0, 60),
    fc.boolean(),
    fc.noBias(fc.double({ min: 0.05, max: 1, noNaN: true })),
  )
  .map(([by, axes, shrinks, isUneven, sigma]) =>
    unitCube.map((x, i) => {
      const displacement = sigma * (by[i] as number) * (isUneven ? 2 ** -(shrinks[i] as number) : 1)
      return (x + displacement) * 2 ** (axes[i % 3] as number)
    }),
  )

/** Exact zeros at corners, on edges, on whole faces. */
export const smallIntegers: Hexahedra = fc
  .tuple(fc.integer({ min: 1, max: 4 }), fc.integer({ min: 0, max: 2 }))
  .chain(([size, reach]) =>
    integersBetween(-reach, reach).map(by => unitCube.map((x, i) => size * x + (by[i] as number))),
  )

const TOUCHING = cases.filter(({ family }) => /^touch_(edge|face)$/.test(family)).map(({ vertices }) => vertices.flat())

/** Near fixtures whose least jacdet is zero, or nearly, inside an edge or a face: random hexahedra seldom are like that. */
export const touching: Hexahedra = fc
  .tuple(fc.constantFrom(...TOUCHING), normals, integersBetween(4, 40, 1))
  .map(([vertices, by, [power]]) => vertices.map((x, i) => x + 2 ** -(power as number) * (by[i] as number)))

const ZEROS = [
  'touch_corner/0_zero',
  'touch_edge/0_zero',
  'touch_face/0_zero',
  'degenerate/twist_180',
  'nonstrict/paper',
]

/**
 * Fixtures whose least jacdet is exactly zero, inside a face or an edge or at a vertex, under affine maps of small integers,
 * which keep it so: the fixtures' coordinates have few bits. Every other one then has a coordinate moved by ulps.
 */
const touched = fc
  .tuple(
    fc.constantFrom(...ZEROS.map(name => caseVertices(`pub/${name}`))),
    integersBetween(-3, 3, 9),
    integersBetween(-1000, 1000, 3),
    integersBetween(-60, 60, 3),
    fc.noBias(fc.integer({ min: 0, max: COORDINATE_COUNT - 1 })),
    fc.constantFrom(0, 0, 0, 0, -2, -1, 1, 2),
  )
  .map(([vertices, matrix, offset, axes, coordinate, ulps]) => {
    const mapped = vertices.map((_, i) => {
      const [row, first] = [i % 3, i - (i % 3)]
      const sum = [0, 1, 2].reduce(
        (all, axis) => all + (matrix[3 * row + axis] as number) * (vertices[first + axis] as number),
        offset[row] as number,
      )
      return sum * 2 ** (axes[row] as number)
    })
    return mapped.with(coordinate, moved(mapped[coordinate] as number, ulps))
  })

function withRepeated(vertices: Vertices, pairs: readonly number[]): number[] {
  const result = [...vertices]
  for (let n = 0; n + 1 < pairs.length; n += 2)
    for (const axis of [0, 1, 2])
      result[3 * (pairs[n] as number) + axis] = vertices[3 * (pairs[n + 1] as number) + axis] as number
  return result
}

const repeatedVertices = fc
  .tuple(displaced, integersBetween(0, 7, 4))
  .map(([vertices, pairs]) => withRepeated(vertices, pairs))

/** Vertices on a plane, exactly so if its slopes and the coordinates are integers. */
const planar = fc
  .oneof(fc.tuple(integersBetween(-8, 8), integersBetween(-3, 3, 2)), fc.tuple(displaced, fc.constant([0.3, 0.7])))
  .map(([vertices, [m, n]]) =>
    vertices.map((x, i) =>
      i % 3 === 2 ? (m as number) * (vertices[i - 2] as number) + (n as number) * (vertices[i - 1] as number) : x,
    ),
  )

/** One axis a few ulps thick. */
const thin = fc
  .tuple(
    displacedBetween(0.05, 0.3),
    integersBetween(0, 2),
    fc.integer({ min: 0, max: 2 }),
    fc.integer({ min: 1, max: 4 }),
  )
  .map(([vertices, by, axis, thickness]) =>
    vertices.map((x, i) =>
      i % 3 === axis ? 1 + (thickness * (unitCube[i] as number) + (by[i] as number)) * 2 ** -52 : x,
    ),
  )

export const families: Readonly<Record<Family, Hexahedra>> = {
  displaced,
  // Exponents apart by thousands make integers of thousands of digits, so of those fewer.
  raw: fc.oneof({ arbitrary: rawBits, weight: 1 }, { arbitrary: rawCube, weight: 100 }),
  scaled,
  'small-integers': smallIntegers,
  degenerate: fc.oneof(repeatedVertices, planar, thin, thin),
  touched,
}
