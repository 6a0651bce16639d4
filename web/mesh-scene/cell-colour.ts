/** The colours of cells by their tone: the one map of jacdet, with a step at zero. */
import { RAMP_STEPS, type Ramp, type Rgb, type Theme } from '../scene/paint/colour-map'
import { mix } from '../scene/space/vec3'

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

/** Colours of a ramp of one sign. */
export const RAMP_COLOURS = RAMP_STEPS + 1
/** The place of the colour of cells without a relative minimum: behind those of both ramps. */
export const NO_TONE_COLOUR = 2 * RAMP_COLOURS
export const COLOURS = NO_TONE_COLOUR + 1

/** The negative ramp, the positive one, and the colour of cells without a relative minimum: three numbers each. */
export function coloursOf({ ramp, none, plain, soft }: FaceColours): Float32Array<ArrayBuffer> {
  const positive = ramp.positive.map(own => {
    const colour = plain ?? own
    return soft ? mix(soft.paper, colour, soft.share) : colour
  })
  return Float32Array.from([...ramp.negative, ...positive, none].flat())
}

export function oneColour(colour: Rgb): Float32Array<ArrayBuffer> {
  return Float32Array.from(Array.from({ length: COLOURS }, () => colour).flat())
}
