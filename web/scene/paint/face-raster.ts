/**
 * One face as pixels: the biquadratic of its nine Bernstein coefficients at every pixel, coloured, hatched and contoured as
 * in the scene's shader, each line at its distance in pixels.
 */
import { type ColourScale, HATCH_PERIOD, RAMP_STEPS, type Ramp, type Rgb, rampColour, type Theme } from './colour-map'

/** The square of a pattern that a face is drawn in, and its orientation. */
export interface MapCell {
  readonly column: number
  readonly row: number
  /** s grows to the left; else to the right. */
  readonly sToLeft: boolean
  /** t grows downwards; else upwards. */
  readonly tDown: boolean
}

export interface FaceRaster {
  readonly bernstein: readonly number[]
  readonly cell: MapCell
  readonly scale: ColourScale
  readonly palette: Palette
  /** Device pixels a side, and of one CSS pixel. */
  readonly size: number
  readonly pixelRatio: number
}

/** Colours of positions on the ramps from -1 to 1, finely sampled; those under lines and hatch are made when first needed. */
export interface Palette {
  /** RGBA as one little-endian number each, signed: engines keep such numbers out of the heap. */
  readonly packed: Int32Array
  /** The same as red, green, blue in [0,255]. */
  readonly components: Float64Array
  /** True if a line on the colour has to be light. */
  readonly isDim: Uint8Array
  /** `packed` under a level's line, by the line's share in steps. */
  readonly levelled: (Int32Array | undefined)[]
  /** The negative half of `packed` under the hatch, by the coverages of both stripes in steps. */
  readonly hatched: (Int32Array | undefined)[]
  readonly ink: Rgb
  readonly light: Rgb
  readonly dark: Rgb
  readonly neutral: Rgb
}

/** Finer than a step of an 8-bit colour. */
const SAMPLES = 1024

/** Steps of the share of what lies over a colour: each is less than two steps of an 8-bit colour. */
const SHARE_STEPS = 32

/** CSS pixels: half widths of the zero line and of the neutral around it, and of a level's line. */
const ZERO = 0.95
const CASING = 2.1
const LEVEL = 0.5
const LEVEL_STRENGTH = 0.22
const DARK_STRENGTH = 0.36
const LIGHT_STRENGTH = 0.3
/** Levels nearer than the first spacing, in CSS pixels, are not drawn, and from the second on in full. */
const LEVEL_SPACING = [4, 8] as const
/** A change per CSS pixel, and a value, below these count as none, as in the scene. */
const LEAST_SLOPE = 1e-6
const LEAST_VALUE = 1e-6

export function paletteOf(ramp: Ramp, theme: Theme): Palette {
  const count = 2 * SAMPLES + 1
  const packed = new Int32Array(count)
  const components = new Float64Array(3 * count)
  const isDim = new Uint8Array(count)
  for (let i = 0; i < count; i++) {
    const colour = rampColour(ramp, (i - SAMPLES) / SAMPLES)
    const [r, g, b] = inBytes(colour)
    components.set([r, g, b], 3 * i)
    packed[i] = pack(r, g, b)
    isDim[i] = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2] < 0.325 ? 1 : 0
  }
  const [ink, paper] = [inBytes(theme.ink), inBytes(theme.paper)]
  const inkIsDark = sum(ink) < sum(paper)
  return {
    packed,
    components,
    isDim,
    levelled: [],
    hatched: [],
    ink,
    light: inkIsDark ? paper : ink,
    dark: inkIsDark ? ink : paper,
    neutral: inBytes(theme.neutral),
  }
}

/** Fills `pixels`, size² of them, rows from the top. */
export function paintFace(pixels: Int32Array, { bernstein, cell, scale, palette, size, pixelRatio }: FaceRaster): void {
  const { packed } = palette
  const perPixel = 1 / size
  const beta = bernstein.map(value => value / scale.greatest)
  const negativeSteps = -RAMP_STEPS / scale.negativeExtent
  const positiveSteps = RAMP_STEPS / scale.positiveExtent
  const casingReach = (CASING * pixelRatio + 0.5) ** 2
  const levelReach = (LEVEL * pixelRatio + 0.5) ** 2
  const steepest = (LEVEL_SPACING[0] * pixelRatio) ** -2
  const flattest = (4 * LEAST_SLOPE) ** 2 / pixelRatio ** 2
  const toSample = SAMPLES / RAMP_STEPS
  const blender = new Blender(palette, cell, size, pixelRatio)
  const { stripes } = blender
  const middle = size - 1
  const sStep = cell.sToLeft ? -perPixel : perPixel
  const sFirst = cell.sToLeft ? 1 - perPixel / 2 : perPixel / 2
  for (let y = 0; y < size; y++) {
    const t = ((cell.tDown ? y : size - 1 - y) + 0.5) * perPixel
    // f = fss s² + fs s + f0 and its derivative by t, per pixel, likewise
    const [f0, f1, f2] = [quadratic(beta, 0, t), quadratic(beta, 3, t), quadratic(beta, 6, t)]
    const [d0, d1, d2] = [slope(beta, 0, t) * perPixel, slope(beta, 3, t) * perPixel, slope(beta, 6, t) * perPixel]
    const [fs, fss] = [2 * (f1 - f0), f0 - 2 * f1 + f2]
    const [ds, dss] = [2 * (d1 - d0), d0 - 2 * d1 + d2]
    for (let x = 0; x < size; x++) {
      const s = sFirst + x * sStep
      const value = (fss * s + fs) * s + f0
      const alongS = (2 * fss * s + fs) * perPixel
      const alongT = (dss * s + ds) * s + d0
      const slopeSquared = alongS * alongS + alongT * alongT
      const steps = value < 0 ? negativeSteps : positiveSteps
      let level = value * steps
      if (level > RAMP_STEPS) level = RAMP_STEPS
      const fromZero = (level * toSample + 0.5) | 0
      const sample = value < 0 ? SAMPLES - fromZero : SAMPLES + fromZero
      const offLevel = level - ((level + 0.5) | 0)
      const levelSlope = slopeSquared * steps * steps
      const isLevel = offLevel * offLevel < levelReach * levelSlope && levelSlope < steepest
      const stripe = value < 0 ? stripes[middle + x - y] : undefined
      let colour: number
      if (slopeSquared < flattest || value * value < casingReach * slopeSquared || (isLevel && stripe))
        colour = blender.at(middle + x - y, sample, value, level, slopeSquared, steps)
      else if (isLevel) colour = blender.onLevel(sample, level, Math.sqrt(slopeSquared), steps)
      else colour = (stripe ?? packed)[sample] as number
      pixels[y * size + x] = colour
    }
  }
}

/** The colours of lines and of the hatch, over the ramp's. */
class Blender {
  readonly #palette: Palette
  readonly #ratio: number
  /** The negative colours under the hatch by size - 1 + x - y; undefined where there is no stripe. */
  readonly stripes: readonly (Int32Array | undefined)[]
  readonly #darkStripe: Float64Array
  readonly #lightStripe: Float64Array

  constructor(palette: Palette, { column, row }: MapCell, size: number, ratio: number) {
    this.#palette = palette
    this.#ratio = ratio
    this.#darkStripe = new Float64Array(2 * size - 1)
    this.#lightStripe = new Float64Array(2 * size - 1)
    for (let i = 0; i < 2 * size - 1; i++) {
      // The pattern is the net's, so that it goes on from cell to cell.
      const across = acrossStripe(((column - row) * size + i + 1 - size) / ratio)
      this.#darkStripe[i] = DARK_STRENGTH * coverage(Math.abs(across - 0.55) * ratio, 0.55 * ratio)
      this.#lightStripe[i] = LIGHT_STRENGTH * coverage(Math.abs(across + 0.55) * ratio, 0.55 * ratio)
    }
    this.stripes = Array.from(this.#darkStripe, (dark, i) => hatchedColours(palette, dark, this.#lightStripe[i] ?? 0))
  }

  /** The colour under a level's line alone. */
  onLevel(sample: number, level: number, slopePerPixel: number, steps: number): number {
    const share = this.#levelShare(level, slopePerPixel, steps)
    return levelledColours(this.#palette, (share * (SHARE_STEPS / LEVEL_STRENGTH) + 0.5) | 0)[sample] as number
  }

  #levelShare(level: number, slopePerPixel: number, steps: number): number {
    if (level < 0.5 || level > RAMP_STEPS - 0.5) return 0
    const spacing = 1 / (Math.abs(steps) * slopePerPixel)
    const distance = Math.abs(level - Math.round(level)) * spacing
    const strength = LEVEL_STRENGTH * smoothstep(LEVEL_SPACING[0], LEVEL_SPACING[1], spacing / this.#ratio)
    return strength * coverage(distance, LEVEL * this.#ratio)
  }

  /** The colour under everything: each layer takes its share of the weights of all those below it. */
  at(diagonal: number, sample: number, value: number, level: number, slopeSquared: number, steps: number): number {
    const { components, isDim, dark, light, neutral, ink } = this.#palette
    const ratio = this.#ratio
    const slopePerPixel = Math.sqrt(slopeSquared)
    const seen = smoothstep(LEAST_SLOPE, 4 * LEAST_SLOPE, slopePerPixel * ratio)
    const share = seen > 0 ? seen * this.#levelShare(level, slopePerPixel, steps) : 0
    let below = 1 - share
    let [ofDark, ofLight] = isDim[sample] === 1 ? [0, share] : [share, 0]
    if (value < 0) {
      const hatched = seen === 1 ? 1 : Math.max(seen, smoothstep(LEAST_VALUE, 4 * LEAST_VALUE, -value))
      const lightShare = hatched * (this.#lightStripe[diagonal] as number)
      const darkShare = hatched * (this.#darkStripe[diagonal] as number)
      below *= (1 - lightShare) * (1 - darkShare)
      ofLight = (ofLight * (1 - lightShare) + lightShare) * (1 - darkShare)
      ofDark = ofDark * (1 - lightShare) * (1 - darkShare) + darkShare
    }
    const zeroDistance = seen > 0 ? Math.abs(value) / slopePerPixel : Number.POSITIVE_INFINITY
    const casing = seen * coverage(zeroDistance, CASING * ratio)
    const zero = seen * coverage(zeroDistance, ZERO * ratio)
    const rest = (1 - casing) * (1 - zero)
    const ofNeutral = casing * (1 - zero)
    const base = below * rest
    const darkWeight = ofDark * rest
    const lightWeight = ofLight * rest
    const at = 3 * sample
    return pack(
      base * (components[at] as number) +
        darkWeight * dark[0] +
        lightWeight * light[0] +
        ofNeutral * neutral[0] +
        zero * ink[0],
      base * (components[at + 1] as number) +
        darkWeight * dark[1] +
        lightWeight * light[1] +
        ofNeutral * neutral[1] +
        zero * ink[1],
      base * (components[at + 2] as number) +
        darkWeight * dark[2] +
        lightWeight * light[2] +
        ofNeutral * neutral[2] +
        zero * ink[2],
    )
  }
}

function levelledColours(palette: Palette, steps: number): Int32Array {
  const known = palette.levelled[steps]
  if (known) return known
  const share = (steps / SHARE_STEPS) * LEVEL_STRENGTH
  const { packed, isDim, dark, light } = palette
  const colours = packed.map((_, sample) => mixed(palette, sample, isDim[sample] === 1 ? light : dark, share))
  palette.levelled[steps] = colours
  return colours
}

/** Undefined where both stripes are less than half a step. */
function hatchedColours(palette: Palette, darkShare: number, lightShare: number): Int32Array | undefined {
  const darkSteps = Math.round((darkShare / DARK_STRENGTH) * SHARE_STEPS)
  const lightSteps = Math.round((lightShare / LIGHT_STRENGTH) * SHARE_STEPS)
  if (darkSteps + lightSteps === 0) return undefined
  const index = darkSteps * (SHARE_STEPS + 1) + lightSteps
  const known = palette.hatched[index]
  if (known) return known
  const dark = (darkSteps / SHARE_STEPS) * DARK_STRENGTH
  const light = (lightSteps / SHARE_STEPS) * LIGHT_STRENGTH
  // Both as one colour over the ramp's: the dark stripe lies over the light one.
  const share = 1 - (1 - dark) * (1 - light)
  const over = palette.dark.map((of, k) => (of * dark + (palette.light[k] as number) * light * (1 - dark)) / share)
  const colours = palette.packed
    .subarray(0, SAMPLES + 1)
    .map((_, sample) => mixed(palette, sample, over as unknown as Rgb, share))
  palette.hatched[index] = colours
  return colours
}

/** The colour of a sample under another one, of which there is a share. */
function mixed({ components }: Palette, sample: number, over: Rgb, share: number): number {
  const [r, g, b] = over.map((of, k) => (1 - share) * (components[3 * sample + k] as number) + share * of) as [
    number,
    number,
    number,
  ]
  return pack(r, g, b)
}

function acrossStripe(along: number): number {
  const turns = (along * Math.SQRT1_2) / HATCH_PERIOD
  return (turns - Math.floor(turns) - 0.5) * HATCH_PERIOD
}

function quadratic(beta: readonly number[], i: number, t: number): number {
  const [b0, b1, b2] = [beta[i] as number, beta[i + 1] as number, beta[i + 2] as number]
  return (1 - t) * (1 - t) * b0 + 2 * t * (1 - t) * b1 + t * t * b2
}

function slope(beta: readonly number[], i: number, t: number): number {
  const [b0, b1, b2] = [beta[i] as number, beta[i + 1] as number, beta[i + 2] as number]
  return 2 * ((1 - t) * (b1 - b0) + t * (b2 - b1))
}

function coverage(distance: number, halfWidth: number): number {
  return 1 - smoothstep(halfWidth - 0.5, halfWidth + 0.5, distance)
}

function smoothstep(from: number, to: number, value: number): number {
  const way = Math.max(0, Math.min(1, (value - from) / (to - from)))
  return way * way * (3 - 2 * way)
}

function inBytes([r, g, b]: Rgb): Rgb {
  return [255 * r, 255 * g, 255 * b]
}

function sum([r, g, b]: Rgb): number {
  return r + g + b
}

function pack(r: number, g: number, b: number): number {
  return 0xff000000 | ((b + 0.5) << 16) | ((g + 0.5) << 8) | (r + 0.5)
}
