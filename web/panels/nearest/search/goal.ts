/**
 * The elements that a search looks for: the valid ones, or those of them whose least jacdet is a
 * given share of the volume or more. docs/algorithm.md (N11).
 */
import { verdictOf } from '../../../core/crossing'
import { timesPowerOfTwo } from '../../../core/power-of-two'
import type { Core, Report } from '../../../core/report'
import type { Vec3, Vertices } from '../../../model/hexahedron'
import { type JacdetResponse, map3, responseAt, type ScaledElement } from './scaled-element'

export interface Goal {
  /** The relative minimum asked for, in [0,1); with 0 all valid elements will do. */
  readonly share: number
  /** True only if the element certainly has it. */
  isMet(vertices: Vertices): boolean
}

/** Of the roundings of the volume, the difference and the quotient, with room. */
const ROUNDING = 2 ** -50

export function goalOf(core: Core, share: number): Goal {
  return {
    share,
    isMet: vertices => verdictOf(core, vertices) && (share === 0 || leastShare(analyzed(core, vertices)) >= share),
  }
}

/** Never more than the relative minimum of a valid element. */
function leastShare({ boundaryMinimum, boundaryMinimumError, exponent, volume, volumeExponent }: Report): number {
  const least = timesPowerOfTwo(boundaryMinimum - boundaryMinimumError, exponent - volumeExponent)
  return (least / volume) * (1 - ROUNDING)
}

export function analyzed(core: Core, vertices: Vertices): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

/** The 2x2x2 Gauss rule is exact for jacdet, which is of degree 2 in each coordinate. */
const GAUSS = [0.5 - Math.sqrt(1 / 12), 0.5 + Math.sqrt(1 / 12)]
const GAUSS_POINTS = GAUSS.flatMap(xi => GAUSS.flatMap(eta => GAUSS.map((zeta): Vec3 => [xi, eta, zeta])))

/** jacdet less the share of the volume, as a function of the vertices, at any point of this element. */
export function excessOf(edges: ScaledElement['edges'], share: number): (point: Vec3) => JacdetResponse {
  if (share === 0) return point => responseAt(edges, point)
  const samples = GAUSS_POINTS.map(point => responseAt(edges, point))
  const part = (value: (sample: JacdetResponse) => number) =>
    (share * samples.reduce((sum, sample) => sum + value(sample), 0)) / samples.length
  const volume = part(({ jacdet }) => jacdet)
  const gradients = Array.from({ length: 8 }, (_, v) => map3(axis => part(sample => sample.gradients[v]?.[axis] ?? 0)))
  return point => {
    const own = responseAt(edges, point)
    return {
      jacdet: own.jacdet - volume,
      gradients: own.gradients.map((gradient, v) => map3(axis => gradient[axis] - (gradients[v]?.[axis] ?? 0))),
    }
  }
}
