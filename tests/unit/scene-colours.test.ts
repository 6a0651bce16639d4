import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { extremesApart, spreadLabels } from '../../web/scene/overlay/colour-bar'
import {
  colourScaleOf,
  luminance,
  RAMP_STEPS,
  type Rgb,
  rampColour,
  rampOf,
  rampPosition,
  type Theme,
} from '../../web/scene/paint/colour-map'
import { lightOf, lightOn, shaded } from '../../web/scene/paint/shading'
import { SceneCamera } from '../../web/scene/space/camera'

const hex = (text: string): Rgb =>
  [1, 3, 5].map(at => Number.parseInt(text.slice(at, at + 2), 16) / 255) as unknown as Rgb

const light: Theme = {
  paper: hex('#fcfcfb'),
  ink: hex('#1c1e21'),
  negative: hex('#b2182b'),
  positive: hex('#2166ac'),
  neutral: hex('#eeeeeb'),
}
const dark: Theme = {
  paper: hex('#17181a'),
  ink: hex('#e9e9e6'),
  negative: hex('#f4787a'),
  positive: hex('#74b3f0'),
  neutral: hex('#373a3f'),
}

const contrast = (a: Rgb, b: Rgb) => {
  const [less, more] = [luminance(a), luminance(b)].sort((x, y) => x - y) as [number, number]
  return (more + 0.05) / (less + 0.05)
}

/** Lightness in OKLab, of encoded sRGB. */
const lightness = (colour: Rgb) => {
  const [r, g, b] = colour.map(x => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4)) as [
    number,
    number,
    number,
  ]
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b)
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b)
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b)
  return 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s
}

describe.each([
  ['light', light, -1],
  ['dark', dark, 1],
] as const)('the %s ramp', (_, theme, way) => {
  const ramp = rampOf(theme)

  it('is the neutral at zero and the theme’s hues on their sides', () => {
    expect(rampColour(ramp, 0)).toEqual(theme.neutral)
    expect(ramp.negative).toContain(theme.negative)
    expect(ramp.positive).toContain(theme.positive)
  })

  it('goes from the neutral away from the paper without turning back', () => {
    for (const side of [ramp.negative, ramp.positive]) {
      expect(side).toHaveLength(RAMP_STEPS + 1)
      for (let i = 1; i <= RAMP_STEPS; i++) {
        expect(way * luminance(side[i] as Rgb)).toBeGreaterThan(way * luminance(side[i - 1] as Rgb))
      }
    }
  })

  it('begins with a neutral that is told from the paper, also in the shade', () => {
    // Two differences that are just noticed, each 0.02 in OKLab (CSS Color 4).
    expect(Math.abs(lightness(theme.neutral) - lightness(theme.paper))).toBeGreaterThan(0.04)
    expect(Math.abs(lightness(shaded(theme.neutral, 0)) - lightness(theme.paper))).toBeGreaterThan(0.04)
  })

  it('loses less in the shade than there is from level to level, up to the theme’s own hue', () => {
    for (const side of [ramp.negative, ramp.positive]) {
      const levels = side.slice(0, RAMP_STEPS).map(lightness)
      const steps = levels.slice(1).map((level, i) => Math.abs(level - (levels[i] as number)))
      for (const colour of side.map((_, i) => rampColour(ramp, (side === ramp.negative ? -1 : 1) * (i / RAMP_STEPS)))) {
        const loss = lightness(shaded(colour, 1)) - lightness(shaded(colour, 0))
        expect(loss).toBeGreaterThan(0.03)
        expect(loss).toBeLessThan(Math.min(...steps))
      }
    }
  })

  it('stays in the gamut', () => {
    for (const colour of [...ramp.negative, ...ramp.positive]) {
      for (const component of colour) {
        expect(component).toBeGreaterThanOrEqual(0)
        expect(component).toBeLessThanOrEqual(1)
      }
    }
  })

  it('lets the zero line, which lies in a neutral casing, stand out on both sides', () => {
    expect(contrast(theme.ink, theme.neutral)).toBeGreaterThan(3)
    for (const position of [-0.1, 0.1]) expect(contrast(theme.ink, rampColour(ramp, position))).toBeGreaterThan(3)
  })
})

describe('the light', () => {
  it('falls unlike on the three sides of a cube that are seen at first, and alike on either side of a face', () => {
    const camera = new SceneCamera()
    const { x, y, z } = camera.three.position
    const on = (normal: readonly [number, number, number]) => lightOn(normal, [x, y, z], lightOf(camera))
    const [top, front, right] = [on([0, 0, 1]), on([0, -1, 0]), on([1, 0, 0])]
    expect(top - front).toBeGreaterThan(0.3)
    expect(front - right).toBeGreaterThan(0.3)
    expect(on([0, 0, -3])).toBeCloseTo(top)
    expect(on([0, 0, 0])).toBe(0)
  })
})

describe('the colour scale', () => {
  it('gives each sign its own extreme', () => {
    const scale = colourScaleOf(-1 / 16, 1 / 2)
    expect(rampPosition(scale, -1 / 16)).toBe(-1)
    expect(rampPosition(scale, 1 / 2)).toBe(1)
    expect(rampPosition(scale, 0)).toBe(0)
    expect(rampPosition(scale, 1 / 4)).toBe(0.5)
  })

  it('is the same for an element of any size', () => {
    fc.assert(
      fc.property(fc.double({ min: -1, max: 0 }), fc.integer({ min: -900, max: 900 }), (least, exponent) => {
        const size = 2 ** exponent
        const value = least / 3
        const position = rampPosition(colourScaleOf(least, 1), value)
        fc.pre(Math.abs(value) > 1e-9)
        expect(rampPosition(colourScaleOf(least * size, size), value * size)).toBeCloseTo(position, 12)
      }),
    )
  })

  it('does not stretch a sign that is nothing but rounding', () => {
    expect(Math.abs(rampPosition(colourScaleOf(-1e-17, 1), -1e-17))).toBeLessThan(1 / 255)
  })

  it('is defined where jacdet is zero everywhere', () => {
    expect(rampPosition(colourScaleOf(0, 0), 0)).toBe(0)
  })
})

describe('labels of the colour bar', () => {
  it('stay at their values where there is room', () => {
    expect(spreadLabels([0, 100, 200], [15, 15, 15], 1)).toEqual([0, 100, 200])
  })

  it('move away from the zero where they would touch', () => {
    expect(spreadLabels([98, 99, 100], [15, 15, 15], 1)).toEqual([84, 99, 114])
    expect(spreadLabels([195, 199, 200], [15, 15, 15], 2)).toEqual([170, 185, 200])
  })

  it('does not let the end of a lying bar push one extreme over the other, and leaves zero where it is', () => {
    expect(extremesApart([40, 60, 200], [80, 80, 10], 2)).toEqual([40, 120, 200])
    expect(extremesApart([0, 140, 160], [10, 80, 80], 0)).toEqual([0, 80, 160])
    expect(extremesApart([40, 150, 200], [80, 80, 10], 2)).toEqual([40, 150, 200])
    expect(extremesApart([40, 100, 160], [80, 10, 80], 1)).toEqual([40, 100, 160])
  })
})
