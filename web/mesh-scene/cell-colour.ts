/** The colour of a cell by its relative minimum: the one map of jacdet, with a step at zero. */
import { type Ramp, type Rgb, rampColour, type Theme } from '../scene/paint/colour-map'
import { mix } from '../scene/space/vec3'
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

/** Whether valid cells have their colour, too, or are plain. */
export type Colouring = 'all' | 'invalid'

/** A grey, so that what is invalid is all the colour there is; null where valid cells have their own. */
export function plainColour({ paper, ink }: Theme, colouring: Colouring): Rgb | null {
  return colouring === 'all' ? null : mix(paper, ink, PLAIN)
}

const PLAIN = 0.25

export interface FaceColours {
  readonly ramp: Ramp
  /** Of cells without a relative minimum. */
  readonly none: Rgb
  readonly plain: Rgb | null
  /** The paper that positive colours are mixed with, and their share; null where they are as they are. */
  readonly soft: { readonly paper: Rgb; readonly share: number } | null
}

/** The share of a positive colour on an opaque surface: most cells are valid, and lines and shading have to be seen on them. */
export const SOFT = 0.6

/** Three bytes a face, all the same. */
export function oneColour({ cells }: FaceList, colour: Rgb): Uint8Array {
  const bytes = colour.map(channel => Math.round(255 * channel))
  const colours = new Uint8Array(3 * cells.length)
  for (let at = 0; at < colours.length; at += 3) colours.set(bytes, at)
  return colours
}

/** Three bytes a face. */
export function faceColours({ relativeMinima }: FaceList, { ramp, none, plain, soft }: FaceColours): Uint8Array {
  const colours = new Uint8Array(3 * relativeMinima.length)
  for (let face = 0; face < relativeMinima.length; ++face) {
    const position = cellPosition(relativeMinima[face] as number)
    const own = position === null ? none : plain !== null && position > 0 ? plain : rampColour(ramp, position)
    const colour = soft && position !== null && position > 0 ? mix(soft.paper, own, soft.share) : own
    for (let channel = 0; channel < 3; ++channel)
      colours[3 * face + channel] = Math.round(255 * (colour[channel] as number))
  }
  return colours
}
