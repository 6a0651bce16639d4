import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { spreadLabels } from '../../web/scene/overlay/colour-bar'
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

const hex = (text: string): Rgb =>
  [1, 3, 5].map(at => Number.parseInt(text.slice(at, at + 2), 16) / 255) as unknown as Rgb

const light: Theme = {
  paper: hex('#fcfcfb'),
  ink: hex('#1c1e21'),
  negative: hex('#b2182b'),
  positive: hex('#2166ac'),
  neutral: hex('#f6f6f4'),
}
const dark: Theme = {
  paper: hex('#17181a'),
  ink: hex('#e9e9e6'),
  negative: hex('#f4787a'),
  positive: hex('#74b3f0'),
  neutral: hex('#26282b'),
}

const contrast = (a: Rgb, b: Rgb) => {
  const [less, more] = [luminance(a), luminance(b)].sort((x, y) => x - y) as [number, number]
  return (more + 0.05) / (less + 0.05)
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
})
