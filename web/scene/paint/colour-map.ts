/**
 * The one colour map of jacdet: diverging, neutral pinned at 0, each sign scaled by its own extreme. The same stops feed the
 * fragment shader and the colour bar; between stops both interpolate linearly in encoded sRGB, and nothing alters the result.
 */
import { lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'

/** Encoded sRGB, components in [0,1]. */
export type Rgb = readonly [number, number, number]

export interface Theme {
  readonly paper: Rgb
  readonly ink: Rgb
  readonly negative: Rgb
  readonly positive: Rgb
  readonly neutral: Rgb
}

/** Colours at positions 0, 1/8, .., 1 of each sign; both begin with the neutral. */
export interface Ramp {
  readonly negative: readonly Rgb[]
  readonly positive: readonly Rgb[]
}

export const RAMP_STEPS = 8

/** CSS pixels from stripe to stripe on the negative side. */
export const HATCH_PERIOD = 8

/** The position of the theme's own hue on its side; beyond it the ramp goes on to a deeper tone. */
const HUE_AT = 7 / RAMP_STEPS

/**
 * The values that the colours are for, those of a report (times 2^exponent, which cancels here). `greatest` is the largest
 * magnitude; the extents are relative to it, so a shader in single precision sees numbers of size 1 only.
 */
export interface ColourScale {
  readonly greatest: number
  readonly negativeExtent: number
  readonly positiveExtent: number
}

/**
 * A sign whose extreme is below 2^-16 of the other's is not stretched further: single precision evaluates the face
 * polynomials to about 2^-22 of `greatest`, and its noise must stay below one step of an 8-bit colour.
 */
const LEAST_EXTENT = 2 ** -16

export function colourScaleOf(minimum: number, maximum: number): ColourScale {
  const greatest = Math.max(Math.abs(minimum), Math.abs(maximum)) || 1
  return {
    greatest,
    negativeExtent: Math.max(-minimum / greatest, LEAST_EXTENT),
    positiveExtent: Math.max(maximum / greatest, LEAST_EXTENT),
  }
}

/** Colours down to the least jacdet of the whole element. */
export function colourScaleInside(report: Report): ColourScale {
  return colourScaleOf(lowerInside(report)?.upper ?? report.boundaryMinimum, report.boundaryMaximum)
}

/** The position of a value on the ramps: [-1,0] negative, [0,1] positive. */
export function rampPosition(scale: ColourScale, value: number): number {
  const relative = value / scale.greatest
  const position = relative < 0 ? relative / scale.negativeExtent : relative / scale.positiveExtent
  return Math.max(-1, Math.min(1, position))
}

/** Inverse of rampPosition. */
export function rampValue({ greatest, negativeExtent, positiveExtent }: ColourScale, position: number): number {
  return position * greatest * (position < 0 ? negativeExtent : positiveExtent)
}

export function rampColour(ramp: Ramp, position: number): Rgb {
  const side = position < 0 ? ramp.negative : ramp.positive
  const along = Math.min(Math.abs(position), 1) * RAMP_STEPS
  const step = Math.min(Math.floor(along), RAMP_STEPS - 1)
  return mix(side[step] as Rgb, side[step + 1] as Rgb, along - step)
}

export function rampOf(theme: Theme): Ramp {
  return { negative: sideOf(theme.neutral, theme.negative), positive: sideOf(theme.neutral, theme.positive) }
}

/**
 * One side in OKLCH: lightness falls (on dark paper: rises) evenly from the neutral to the hue and a little beyond; chroma
 * rises ahead of it; pale tones (not dark ones) lean towards orange or cyan, as in ColorBrewer's RdBu, away from grey.
 */
function sideOf(neutral: Rgb, hue: Rgb): Rgb[] {
  const from = oklch(neutral)
  const to = oklch(hue)
  const lean = from.lightness > to.lightness ? leanOf(to.hue) : 0
  return Array.from({ length: RAMP_STEPS + 1 }, (_, step) => {
    const position = step / RAMP_STEPS
    if (step === 0) return neutral
    if (position === HUE_AT) return hue
    const way = position / HUE_AT
    const lightness = from.lightness + (to.lightness - from.lightness) * Math.min(way, 1 + (way - 1) * 0.7)
    const chroma = way <= 1 ? to.chroma * way ** 0.85 : to.chroma * (1 - 0.3 * (way - 1))
    return fromOklch({ lightness, chroma, hue: to.hue + lean * Math.max(0, 1 - way) })
  })
}

const ORANGE = (48 * Math.PI) / 180
const CYAN = (229 * Math.PI) / 180
const MOST_LEAN = (36 * Math.PI) / 180

function leanOf(hue: number): number {
  const leans = [ORANGE, CYAN].map(goal => Math.atan2(Math.sin(goal - hue), Math.cos(goal - hue)))
  const nearest = leans.reduce((a, b) => (Math.abs(a) <= Math.abs(b) ? a : b))
  return Math.max(-MOST_LEAN, Math.min(MOST_LEAN, nearest))
}

interface Oklch {
  readonly lightness: number
  readonly chroma: number
  readonly hue: number
}

/** B. Ottosson, "A perceptual color space for image processing" (2020): the published matrices. */
function oklch([r, g, b]: Rgb): Oklch {
  const [lr, lg, lb] = [decode(r), decode(g), decode(b)]
  const l = Math.cbrt(0.4122214708 * lr + 0.5363325363 * lg + 0.0514459929 * lb)
  const m = Math.cbrt(0.2119034982 * lr + 0.6806995451 * lg + 0.1073969566 * lb)
  const s = Math.cbrt(0.0883024619 * lr + 0.2817188376 * lg + 0.6299787005 * lb)
  const a = 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s
  const c = 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s
  return {
    lightness: 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    chroma: Math.hypot(a, c),
    hue: Math.atan2(c, a),
  }
}

function fromOklch({ lightness, chroma, hue }: Oklch): Rgb {
  const a = chroma * Math.cos(hue)
  const b = chroma * Math.sin(hue)
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3
  return [
    encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    encode(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ]
}

function decode(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4
}

function encode(value: number): number {
  const inGamut = Math.max(0, Math.min(1, value))
  return inGamut <= 0.0031308 ? inGamut * 12.92 : 1.055 * inGamut ** (1 / 2.4) - 0.055
}

function mix(a: Rgb, b: Rgb, way: number): Rgb {
  return [a[0] + (b[0] - a[0]) * way, a[1] + (b[1] - a[1]) * way, a[2] + (b[2] - a[2]) * way]
}

/** WCAG relative luminance. */
export function luminance([r, g, b]: Rgb): number {
  return 0.2126 * decode(r) + 0.7152 * decode(g) + 0.0722 * decode(b)
}

export function cssColour([r, g, b]: Rgb): string {
  return `rgb(${Math.round(r * 255)} ${Math.round(g * 255)} ${Math.round(b * 255)})`
}
