/** The other checks' numbers from the integer coefficients, each rounded once. */
import { edgesAlong, edgeVertices, vertexReference } from '../../model/hexahedron'
import type { CheckId } from '../report'
import { type ExactJacdet, exactVertex, type IntegerVector, sixteenths } from './exact-jacdet'
import { rounded } from './rounding'

/** mantissa * 2^exponent. */
export interface ScaledNumber {
  readonly mantissa: number
  readonly exponent: number
}

export interface ExactChecks {
  /** jacdets, of the exact sign. */
  readonly jacdets: Readonly<Partial<Record<CheckId, ScaledNumber>>>
  /** The least scaled Jacobian at the vertices and the centre, of the exact sign however small; 0 where a column is 0. */
  readonly scaledJacobian: number
}

/** The abscissae of the Gauss rules on [0,1] as doubles, (1 -+ 1/sqrt(3))/2 and (1 -+ sqrt(3/5))/2, are integers over 2^56. */
const GAUSS_BITS = 56
const GAUSS_2 = [(1 - 1 / Math.sqrt(3)) / 2, (1 + 1 / Math.sqrt(3)) / 2]
const GAUSS_3 = [(1 - Math.sqrt(0.6)) / 2, 0.5, (1 + Math.sqrt(0.6)) / 2]

/** Smaller scaled Jacobians are shown as this power of two. */
const LEAST_POWER = -960

export function exactChecks(jacdet: ExactJacdet): ExactChecks {
  const coefficients = sixteenths(jacdet)
  const inTrueUnits = (value: bigint, bits: number) =>
    rounded({ numerator: value, denominator: 1n }, jacdet.exponent - 4 - 6 * bits)
  const gauss = (points: readonly number[]) => {
    const numerators = points.map(point => BigInt(point * 2 ** GAUSS_BITS))
    return inTrueUnits(least(valuesOnGrid(coefficients, numerators, GAUSS_BITS)), GAUSS_BITS)
  }
  const centre = valuesOnGrid(coefficients, [1n], 1)[0] as bigint
  return {
    jacdets: { 'gauss-2': gauss(GAUSS_2), 'gauss-3': gauss(GAUSS_3), bernstein: inTrueUnits(least(coefficients), 0) },
    scaledJacobian: leastScaledJacobian(jacdet, inTrueUnits(centre, 1)),
  }
}

function least(values: readonly bigint[]): bigint {
  return values.reduce((a, b) => (b < a ? b : a))
}

/** jacdet at all points whose three coordinates are among numerators / 2^bits, over 2^(6 bits). */
function valuesOnGrid(coefficients: readonly bigint[], numerators: readonly bigint[], bits: number): bigint[] {
  const basis = numerators.map(n => {
    const rest = (1n << BigInt(bits)) - n
    return [rest * rest, 2n * n * rest, n * n] as const
  })
  // The last axis first; what is left of it then comes in front, so that three turns serve all axes.
  let values = [...coefficients]
  for (let axis = 0; axis < 3; ++axis) {
    const rows = Array.from({ length: values.length / 3 }, (_, row) => values.slice(3 * row, 3 * row + 3))
    values = basis.flatMap(([w0, w1, w2]) =>
      rows.map(row => w0 * (row[0] as bigint) + w1 * (row[1] as bigint) + w2 * (row[2] as bigint)),
    )
  }
  return values
}

function leastScaledJacobian(jacdet: ExactJacdet, atCentre: ScaledNumber): number {
  const { edges, axisExponents } = jacdet
  const lengths = edges.map(edge => lengthOf(edge, axisExponents))
  const length = (edge: number | undefined) => lengths[edge as number] as ScaledNumber
  const centreLengths = edgesAlong.map(parallel => {
    const sum = [0, 1, 2].map(r => parallel.reduce((all, edge) => all + (edges[edge]?.[r] as bigint), 0n))
    const { mantissa, exponent } = lengthOf(sum as unknown as IntegerVector, axisExponents)
    return { mantissa, exponent: exponent - 2 }
  })
  const values = EDGES_AT_VERTEX.map((at, vertex) =>
    ratio(
      rounded({ numerator: exactVertex(jacdet, vertex), denominator: 1n }, jacdet.exponent - 2),
      at.map(edge => length(edge)),
    ),
  )
  return Math.min(...values, ratio(atCentre, centreLengths))
}

/** The one along xi, the one along eta, the one along zeta. */
const EDGES_AT_VERTEX = vertexReference.map((_, vertex) =>
  edgesAlong.map(edges => edges.find(edge => edgeVertices[edge]?.includes(vertex)) as number),
)

/** The length of a vector of integers over powers of two, one for each axis. */
function lengthOf(vector: IntegerVector, axisExponents: readonly number[]): ScaledNumber {
  const components = vector.map((numerator, r) =>
    normalized(rounded({ numerator, denominator: 1n }, axisExponents[r] as number)),
  )
  const exponent = Math.max(...components.map(component => component.exponent))
  if (exponent === Number.NEGATIVE_INFINITY) return { mantissa: 0, exponent: 0 }
  // A component that underflows is nothing beside the largest.
  return {
    mantissa: Math.hypot(...components.map(component => component.mantissa * 2 ** (component.exponent - exponent))),
    exponent,
  }
}

function ratio(jacdet: ScaledNumber, lengths: readonly ScaledNumber[]): number {
  const product = lengths.reduce((all, { mantissa }) => all * mantissa, 1)
  if (jacdet.mantissa === 0 || product === 0) return 0
  const { mantissa, exponent } = normalized(jacdet)
  const power = lengths.reduce((all, length) => all - length.exponent, exponent)
  return (mantissa / product) * 2 ** Math.max(power, LEAST_POWER)
}

/** The mantissa's magnitude is 1 to 2, but for the logarithm's rounding; 0 is 0 * 2^-Infinity. */
function normalized({ mantissa, exponent }: ScaledNumber): ScaledNumber {
  if (mantissa === 0) return { mantissa, exponent: Number.NEGATIVE_INFINITY }
  const power = Math.floor(Math.log2(Math.abs(mantissa)))
  return { mantissa: mantissa * 2 ** -power, exponent: exponent + power }
}
