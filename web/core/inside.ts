/** The least jacdet inside, if it is below the boundary's. */
import type { Report, VolumeMinimum } from './report'

/** The volume minimum if certainly below the boundary's: only of an invalid element. */
export function lowerInside(report: Report): VolumeMinimum | null {
  const { boundaryMinimum, boundaryMinimumError, volumeMinimum } = report
  return volumeMinimum.upper < boundaryMinimum - boundaryMinimumError ? volumeMinimum : null
}

/** A number and how far the exact one may be from it, both times the report's 2^exponent. */
export interface Approximation {
  readonly value: number
  readonly error: number
}

/** Powers of two that fractions on the page have; see fractionOf. On [-1,1]^3 there are three more. */
const FRACTION_BITS = 9

/** The shortest binary fraction of the bracket, else its middle: the exact minimum is within `error` of it. */
export function approximation({ lower, upper }: Pick<VolumeMinimum, 'lower' | 'upper'>): Approximation {
  const middle = lower / 2 + upper / 2
  const fractions = Array.from({ length: FRACTION_BITS + 1 }, (_, bits) => Math.round(middle * 2 ** bits) / 2 ** bits)
  const value = fractions.find(fraction => lower <= fraction && fraction <= upper) ?? middle
  return { value, error: roundedUp(Math.max(upper - value, value - lower)) }
}

/** A double not below the sum or difference of two doubles whose rounded result is given. */
export function roundedUp(difference: number): number {
  return difference + Math.abs(difference) * 2 ** -51
}
