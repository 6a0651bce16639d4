/** jacdet in exact arithmetic: doubles are integers over a power of two, and so is everything made of them. */
import { edgeVertices, type Vec3, type Vertices, vertexReference } from '../../web/model/hexahedron'
import { entry } from './core-fixtures'

/** Coordinates down to 2^-SHIFT are kept; finer ones are refused. */
const SHIFT = 60

/** value * 2^SHIFT, exactly. */
function integer(value: number): bigint {
  const scaled = value * 2 ** SHIFT
  if (!Number.isInteger(scaled)) throw new Error(`${value} is finer than 2^-${SHIFT}.`)
  return BigInt(scaled)
}

type Column = readonly [bigint, bigint, bigint]

function determinant([a, b, c]: readonly [Column, Column, Column]): bigint {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/** jacdet at a point, times a positive power of two, from the definition: its sign is the exact one. */
export function exactJacdet(vertices: Vertices, point: Vec3): bigint {
  const one = integer(1)
  const columns = [0, 1, 2].map(direction =>
    [0, 1, 2].map(component =>
      vertexReference.reduce((sum, reference, v) => {
        const factors = [0, 1, 2].map(axis => {
          const far = entry(reference, axis) === 1
          if (axis === direction) return far ? 1n : -1n
          const x = integer(entry(point, axis))
          return far ? x : one - x
        })
        return sum + factors.reduce((product, factor) => product * factor, integer(entry(vertices, 3 * v + component)))
      }, 0n),
    ),
  )
  return determinant(columns as unknown as [Column, Column, Column])
}

export function verticesArePositive(vertices: Vertices): boolean {
  return vertexReference.every(point => exactJacdet(vertices, point) > 0n)
}

/** On an edge jacdet is a quadratic; from its ends q0, q2 and its middle value m follows q1 = (4m - q0 - q2) / 2. */
export function edgesArePositive(vertices: Vertices): boolean {
  return edgeVertices.every(ends => {
    const [from, to] = ends.map(v => entry(vertexReference, v)) as [Vec3, Vec3]
    const middle = from.map((x, axis) => (x + entry(to, axis)) / 2) as unknown as Vec3
    const [q0, m, q2] = [from, middle, to].map(point => exactJacdet(vertices, point)) as [bigint, bigint, bigint]
    const twiceQ1 = 4n * m - q0 - q2
    return q0 > 0n && q2 > 0n && (twiceQ1 >= 0n || twiceQ1 * twiceQ1 < 4n * q0 * q2)
  })
}
