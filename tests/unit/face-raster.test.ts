import { describe, expect, it } from 'vitest'
import type { Report } from '../../web/core/report'
import { faces, vertexReference } from '../../web/model/hexahedron'
import { netCells, pointInCell } from '../../web/panels/face-maps/net'
import {
  colourScaleOf,
  HATCH_PERIOD,
  type Rgb,
  rampColour,
  rampOf,
  rampPosition,
  type Theme,
} from '../../web/scene/paint/colour-map'
import { paintFace, paletteOf } from '../../web/scene/paint/face-raster'
import { core, randomHexahedron, randomSource } from './core-fixtures'

const hex = (text: string): Rgb =>
  [1, 3, 5].map(at => Number.parseInt(text.slice(at, at + 2), 16) / 255) as unknown as Rgb

const theme: Theme = {
  paper: hex('#fcfcfb'),
  ink: hex('#1c1e21'),
  negative: hex('#b2182b'),
  positive: hex('#2166ac'),
  neutral: hex('#eeeeeb'),
}
const ramp = rampOf(theme)
const palette = paletteOf(ramp, theme)
const SIZE = 65

function analyzed(vertices: readonly number[]): Report {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function jacdetAt(report: Report, point: readonly [number, number, number]): number {
  const result = core.jacobian(report.vertices, point)
  if (!result.ok) throw new Error(result.error.message)
  return result.value.jacdet
}

function painted(report: Report, face: number, pixelRatio = 1): Int32Array {
  const pixels = new Int32Array(SIZE * SIZE)
  paintFace(pixels, {
    bernstein: report.faces[face]?.bernstein ?? [],
    cell: netCells[face] as (typeof netCells)[number],
    scale: colourScaleOf(report.boundaryMinimum, report.boundaryMaximum),
    palette,
    size: SIZE,
    pixelRatio,
  })
  return pixels
}

const componentsOf = (pixel: number) => [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255]
const distance = (pixel: number, colour: Rgb) =>
  Math.max(...componentsOf(pixel).map((value, i) => Math.abs(value - 255 * (colour[i] as number))))

/** Asymmetric: no two vertices, edges or faces have the same jacdets. */
const random = randomSource(11)
const positive = analyzed(randomHexahedron(random, 0.12))
const mixed = analyzed(randomHexahedron(random, 0.45))

describe('the map of a face', () => {
  it('has at its corners the colours of jacdet at the vertices there', () => {
    expect(positive.valid).toBe(true)
    const scale = colourScaleOf(positive.boundaryMinimum, positive.boundaryMaximum)
    faces.forEach((_, face) => {
      const pixels = painted(positive, face)
      for (const [x, y] of [
        [0, 0],
        [1, 0],
        [0, 1],
        [1, 1],
      ] as const) {
        const vertex = vertexReference.findIndex(point => point.join() === pointInCell(face, x, y).join())
        const value = positive.candidates.find(({ kind, id }) => kind === 'vertex' && id === vertex)?.value as number
        const pixel = pixels[y * (SIZE - 1) * SIZE + x * (SIZE - 1)] as number
        // The middle of the pixel is half a pixel inside; levels are drawn over the colours at 22 %.
        expect(distance(pixel, rampColour(ramp, rampPosition(scale, value)))).toBeLessThan(12)
      }
    })
  })

  it('has the scene’s colours of jacdet itself, but for its lines', () => {
    for (const report of [positive, mixed]) {
      const scale = colourScaleOf(report.boundaryMinimum, report.boundaryMaximum)
      faces.forEach((_, face) => {
        const pixels = painted(report, face)
        let [seen, agreeing] = [0, 0]
        for (let y = 0; y < SIZE; y += 4) {
          for (let x = 0; x < SIZE; x += 4) {
            const value = jacdetAt(report, pointInCell(face, (x + 0.5) / SIZE, (y + 0.5) / SIZE))
            if (value < 0) continue
            seen++
            const colour = rampColour(ramp, rampPosition(scale, value))
            if (distance(pixels[y * SIZE + x] as number, colour) < 2) agreeing++
          }
        }
        expect(agreeing).toBeGreaterThanOrEqual(0.6 * seen)
      })
    }
  })

  it('is hatched where jacdet is negative and has a heavy line in ink at zero', () => {
    expect(mixed.valid).toBe(false)
    const scale = colourScaleOf(mixed.boundaryMinimum, mixed.boundaryMaximum)
    let [hatched, negative, lined] = [0, 0, 0]
    faces.forEach((_, face) => {
      const pixels = painted(mixed, face)
      for (let y = 0; y < SIZE; y++) {
        for (let x = 0; x < SIZE; x++) {
          const pixel = pixels[y * SIZE + x] as number
          const value = jacdetAt(mixed, pointInCell(face, (x + 0.5) / SIZE, (y + 0.5) / SIZE))
          if (distance(pixel, theme.ink) < 3) {
            lined++
            expect(Math.abs(rampPosition(scale, value))).toBeLessThan(0.4)
          } else if (value < 0) {
            negative++
            if (distance(pixel, rampColour(ramp, rampPosition(scale, value))) > 8) hatched++
          }
        }
      }
    })
    expect(lined).toBeGreaterThan(50)
    expect(hatched / negative).toBeGreaterThan(2 / HATCH_PERIOD)
    expect(hatched / negative).toBeLessThan(0.9)
  })

  it('is the same for an element of any size', () => {
    const grown = analyzed(mixed.vertices.map(value => value * 2 ** 300))
    faces.forEach((_, face) => {
      expect(painted(grown, face)).toEqual(painted(mixed, face))
    })
  })

  it('is neutral where jacdet is zero everywhere, without lines', () => {
    const flat = analyzed(Array(24).fill(0))
    expect(new Set(painted(flat, 0))).toEqual(new Set([painted(flat, 0)[0]]))
    expect(distance(painted(flat, 0)[0] as number, theme.neutral)).toBeLessThan(1)
  })
})
