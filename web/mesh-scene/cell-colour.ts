/** The colour of a cell by its relative minimum: the one map of jacdet, with a step at zero. */
import { type Ramp, type Rgb, rampColour } from '../scene/paint/colour-map'
import type { FaceList } from '../survey/survey-jobs'

/**
 * A cell has one colour, and one that is invalid by a hair has to be seen among thousands: what is not valid begins here on the
 * negative side. At -1 and below it ends.
 */
export const LEAST_NEGATIVE = 0.35

/** The position on the ramps, from -1 to 1; null for a cell without a relative minimum. */
export function cellPosition(relativeMinimum: number): number | null {
  if (Number.isNaN(relativeMinimum)) return null
  if (relativeMinimum > 0) return Math.min(relativeMinimum, 1)
  return -(LEAST_NEGATIVE + (1 - LEAST_NEGATIVE) * Math.min(-relativeMinimum, 1))
}

/** Three bytes a face; `none` for cells without a relative minimum. */
export function faceColours({ relativeMinima }: FaceList, ramp: Ramp, none: Rgb): Uint8Array {
  const colours = new Uint8Array(3 * relativeMinima.length)
  for (let face = 0; face < relativeMinima.length; ++face) {
    const position = cellPosition(relativeMinima[face] as number)
    const colour = position === null ? none : rampColour(ramp, position)
    for (let channel = 0; channel < 3; ++channel)
      colours[3 * face + channel] = Math.round(255 * (colour[channel] as number))
  }
  return colours
}
