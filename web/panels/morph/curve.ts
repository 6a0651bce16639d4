/** The boundary minimum along a way as heights in [0,1], zero among them. */
import type { Morph } from './morph-answer'

export interface CurvePoint {
  readonly tau: number
  readonly height: number
}

export interface Curve {
  readonly points: readonly CurvePoint[]
  /** The height of jacdet = 0. */
  readonly zero: number
}

/** A sample's sign is that of its verdict: what rounds to the other side of zero lies on it. */
export function curveOf({ samples }: Pick<Morph, 'samples'>): Curve {
  const greatest = Math.max(...samples.map(({ exponent }) => exponent))
  const values = samples.map(({ minimum, exponent, valid }) => {
    const value = minimum * 2 ** (exponent - greatest)
    return valid ? Math.max(0, value) : Math.min(0, value)
  })
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)]
  const span = high / 2 - low / 2 || 1
  const height = (value: number) => (value / 2 - low / 2) / span
  return { points: samples.map(({ tau }, i) => ({ tau, height: height(values[i] as number) })), zero: height(0) }
}

/** The curve is a line between neighbouring points. */
export function heightOf({ points }: Curve, tau: number): number {
  const after = points.findIndex(point => point.tau >= tau)
  const [from, to] = [points[Math.max(0, after - 1)], points[after]] as [CurvePoint, CurvePoint]
  const way = to.tau > from.tau ? (tau - from.tau) / (to.tau - from.tau) : 1
  return from.height + way * (to.height - from.height)
}
