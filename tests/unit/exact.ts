/** jacdet of tests/property/integer-jacdet.ts at points that are doubles. */
import { edgeVertices, type Vec3, type Vertices, vertexReference } from '../../web/model/hexahedron'
import { dyadicOf, type Fraction, integerHexahedron, jacdetAt } from '../property/integer-jacdet'
import { entry } from './core-fixtures'

/** The finest double is 2^-FINEST. */
const FINEST = 1074

function fraction(value: number): Fraction {
  const { integer, exponent } = dyadicOf(value)
  return [integer << BigInt(exponent + FINEST), 1n << BigInt(FINEST)]
}

/** jacdet at a point, times a power of two that is the same for all hexahedra and points. */
export function exactJacdet(vertices: Vertices, point: Vec3): bigint {
  const hexahedron = integerHexahedron(vertices)
  return jacdetAt(hexahedron, point.map(fraction)) << BigInt(hexahedron.exponent + 3 * FINEST)
}

export function verticesArePositive(vertices: Vertices): boolean {
  return vertexReference.every(point => exactJacdet(vertices, point) > 0n)
}

/** On an edge jacdet is a quadratic of ends q0, q2, middle value m, so q1 = (4m - q0 - q2) / 2. */
export function edgesArePositive(vertices: Vertices): boolean {
  return edgeVertices.every(ends => {
    const [from, to] = ends.map(v => entry(vertexReference, v)) as [Vec3, Vec3]
    const middle = from.map((x, axis) => (x + entry(to, axis)) / 2) as unknown as Vec3
    const [q0, m, q2] = [from, middle, to].map(point => exactJacdet(vertices, point)) as [bigint, bigint, bigint]
    const twiceQ1 = 4n * m - q0 - q2
    return q0 > 0n && q2 > 0n && (twiceQ1 >= 0n || twiceQ1 * twiceQ1 < 4n * q0 * q2)
  })
}
