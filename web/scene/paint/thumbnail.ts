/**
 * A small still picture of an element, as pixels: its faces in the colours of jacdet, the negative part hatched, its edges, its
 * minimizer. Four samples a pixel: each finds the nearest face, and jacdet there, from the face's nine Bernstein coefficients.
 */
import type { Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import { faces } from '../../model/hexahedron'
import { entityTitle } from '../../views/entity-name'
import { faceCorners, patchPoint } from '../space/patches'
import { toWorld, verticesInWorld, worldOf } from '../space/world'
import { colourScaleOf, type Rgb, type Theme } from './colour-map'
import type { Palette } from './face-raster'
import type { FlatPoint } from './flat-tiles'
import { seen } from './plain-view'

/** Pixels of a side: two for each CSS pixel of a picture in its place. */
export const THUMBNAIL_SIDE = 240
/** Samples of a side. */
const SAMPLES = 2 * THUMBNAIL_SIDE
/** Lengths below are in units of which the picture has so many a side. */
const UNITS = 120
const PER_UNIT = SAMPLES / UNITS
const MARGIN = 7
/** The period of the hatch, and the half width of each of its stripes. */
const HATCH = 5
const STRIPE = 0.55
/** The way across the stripes from a sample to the next. */
const ACROSS = Math.SQRT1_2 / PER_UNIT
/** The scene's, so that red stays red under them. */
const DARK_STRENGTH = 0.36
const LIGHT_STRENGTH = 0.3
/** The square of an edge's width on either of its faces, in samples. */
const EDGE_SQUARED = (0.6 * PER_UNIT) ** 2
const RING_RADIUS = 3
const RING_HALF_WIDTH = 0.75
/** The share of the ring's ink where a face hides the minimizer. */
const HIDDEN = 0.45
/** Flat pieces of a face's side. Diagonals of a bilinear face are parabolas: on a piece they rise (2 PIECES)^-2 of its twist, a sixth of a pixel. */
const PIECES = 24
/** World space has a size of 2. Faces nearer to each other than this are taken as one: the first of them is seen. */
const SAME_DEPTH = 1e-6
/** A face through the minimizer, taken at a sample near it, may be so much in front of it. */
const SEEN_DEPTH = 0.03

export interface Colours {
  readonly theme: Theme
  readonly palette: Palette
}

/** The picture in words: "Invalid, minimum −1/4 on edge 0–1". */
export function thumbnailText({ valid, boundaryMinimum, exponent, minimizer }: Report): string {
  const part = entityTitle(minimizer)
  const minimum = formatJacdet(boundaryMinimum, exponent, 'unit')
  return `${valid ? 'Valid' : 'Invalid'}, minimum ${minimum} on ${part.charAt(0).toLowerCase()}${part.slice(1)}`
}

/** RGBA, rows from the top, THUMBNAIL_SIDE² pixels. */
export function thumbnailPixels(report: Report, { theme, palette }: Colours): Uint8ClampedArray<ArrayBuffer> {
  const world = worldOf(report.vertices)
  const points = verticesInWorld(world, report.vertices)
  const toPicture = fitted(points.map(seen))
  const front = new Front()
  for (const face of faces.keys()) {
    const corners = faceCorners(points, face)
    front.layFace(face, (s, t) => toPicture(seen(patchPoint(corners, s, t))))
  }
  const pixels = painted(report, front, palette)
  drawRing(pixels, toPicture(seen(toWorld(world, report.minimizer.position))), front, theme)
  return pixels
}

/** Maps these points to the middle of the picture, as large as it holds them, in samples. */
function fitted(points: readonly FlatPoint[]): (point: FlatPoint) => FlatPoint {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)]
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]
  const factor = ((UNITS - 2 * MARGIN) * PER_UNIT) / (Math.max(right - left, bottom - top) || 1)
  return ({ x, y, depth }) => ({
    x: SAMPLES / 2 + (x - (left + right) / 2) * factor,
    y: SAMPLES / 2 + (y - (top + bottom) / 2) * factor,
    depth,
  })
}

type GridPoint = FlatPoint & { readonly s: number; readonly t: number }

/** The faces in flat triangles, and which of these is in front at each sample. */
class Front {
  /** Of each triangle: s at sample (0,0), its change by column and by row, the same of t. */
  readonly affine = new Float64Array(6 * 2 * faces.length * PIECES ** 2)
  /** Triangles by their indices plus 1; 0 where there is none. */
  readonly indices = new Uint16Array(SAMPLES ** 2)
  readonly depths = new Float64Array(SAMPLES ** 2).fill(Infinity)

  layFace(face: number, pointAt: (s: number, t: number) => FlatPoint): void {
    const across = PIECES + 1
    const grid = Array.from({ length: across ** 2 }, (_, k): GridPoint => {
      const [s, t] = [Math.floor(k / across) / PIECES, (k % across) / PIECES]
      return { ...pointAt(s, t), s, t }
    })
    for (let piece = 0; piece < PIECES ** 2; piece++) {
      const k = piece + Math.floor(piece / PIECES)
      const [a, b, c, d] = [grid[k], grid[k + across], grid[k + across + 1], grid[k + 1]] as Corners
      const index = 2 * (face * PIECES ** 2 + piece)
      this.#layTriangle(index, a, b, c)
      this.#layTriangle(index + 1, a, c, d)
    }
  }

  #layTriangle(index: number, a: GridPoint, b: GridPoint, c: GridPoint): void {
    const [bx, by, cx, cy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y]
    const doubleArea = bx * cy - cx * by
    if (doubleArea === 0) return // seen from its side
    const byColumn = (ofB: number, ofC: number) => (ofB * cy - ofC * by) / doubleArea
    const byRow = (ofB: number, ofC: number) => (ofC * bx - ofB * cx) / doubleArea
    // A sample is the middle of its square.
    const [x, y] = [a.x - 0.5, a.y - 0.5]
    for (const [k, of] of (['s', 't'] as const).entries()) {
      const [column, row] = [byColumn(b[of] - a[of], c[of] - a[of]), byRow(b[of] - a[of], c[of] - a[of])]
      this.affine.set([a[of] - column * x - row * y, column, row], 6 * index + 3 * k)
    }
    const depthByColumn = byColumn(b.depth - a.depth, c.depth - a.depth)
    const depthByRow = byRow(b.depth - a.depth, c.depth - a.depth)
    const last = Math.ceil(Math.max(a.y, b.y, c.y) - 0.5)
    for (let row = Math.ceil(Math.min(a.y, b.y, c.y) - 0.5); row < last; row++) {
      // A row's middle is between the heights of two sides' ends: the other side's crossing is NaN.
      const [ab, bc, ca] = [crossing(a, b, row + 0.5), crossing(b, c, row + 0.5), crossing(c, a, row + 0.5)]
      const [first, second] = Number.isNaN(ab) ? [bc, ca] : Number.isNaN(bc) ? [ab, ca] : [ab, bc]
      const from = Math.ceil(Math.min(first, second) - 0.5)
      const to = Math.ceil(Math.max(first, second) - 0.5)
      const depthAtRow = a.depth + depthByRow * (row - y) - depthByColumn * x
      for (let column = from; column < to; column++) {
        const depth = depthAtRow + depthByColumn * column
        const at = row * SAMPLES + column
        if (depth >= (this.depths[at] as number) - SAME_DEPTH) continue
        this.depths[at] = depth
        this.indices[at] = index + 1
      }
    }
  }
}

type Corners = [GridPoint, GridPoint, GridPoint, GridPoint]

/** The x at which the line from a to b is as high as y, else NaN. */
function crossing(a: FlatPoint, b: FlatPoint, y: number): number {
  return a.y <= y === b.y <= y ? Number.NaN : a.x + ((b.x - a.x) * (y - a.y)) / (b.y - a.y)
}

/** Each pixel the mean of its four samples. */
function painted(report: Report, { affine, indices }: Front, palette: Palette): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * THUMBNAIL_SIDE ** 2)
  const { components, dark, light, ink } = palette
  const middle = (components.length / 3 - 1) / 2
  const { greatest, negativeExtent, positiveExtent } = colourScaleOf(report.boundaryMinimum, report.boundaryMaximum)
  const beta = Float64Array.from(
    report.faces.flatMap(({ bernstein }) => bernstein),
    value => value / greatest,
  )
  let [red, green, blue, covered] = [0, 0, 0, 0]

  function add(column: number, row: number): void {
    const index = indices[row * SAMPLES + column] as number
    if (index === 0) return
    covered += 1
    const k = 6 * (index - 1)
    const sByColumn = affine[k + 1] as number
    const sByRow = affine[k + 2] as number
    const tByColumn = affine[k + 4] as number
    const tByRow = affine[k + 5] as number
    const s = inUnit((affine[k] as number) + sByColumn * column + sByRow * row)
    const t = inUnit((affine[k + 3] as number) + tByColumn * column + tByRow * row)
    const toS = Math.min(s, 1 - s)
    const toT = Math.min(t, 1 - t)
    if (
      toS * toS < EDGE_SQUARED * (sByColumn * sByColumn + sByRow * sByRow) ||
      toT * toT < EDGE_SQUARED * (tByColumn * tByColumn + tByRow * tByRow)
    ) {
      red += ink[0]
      green += ink[1]
      blue += ink[2]
      return
    }
    const value = jacdetOn(beta, 9 * Math.floor((index - 1) / (2 * PIECES ** 2)), s, t)
    const position = Math.max(-1, Math.min(1, value / (value < 0 ? negativeExtent : positiveExtent)))
    const at = 3 * Math.round(middle * (1 + position))
    const across = value < 0 ? ((column + row) * ACROSS) % HATCH : HATCH
    const over = across < 2 * STRIPE ? light : dark
    const share = across < 2 * STRIPE ? LIGHT_STRENGTH : across < 4 * STRIPE ? DARK_STRENGTH : 0
    red += (1 - share) * (components[at] as number) + share * over[0]
    green += (1 - share) * (components[at + 1] as number) + share * over[1]
    blue += (1 - share) * (components[at + 2] as number) + share * over[2]
  }

  for (let row = 0; row < THUMBNAIL_SIDE; row++)
    for (let column = 0; column < THUMBNAIL_SIDE; column++) {
      red = green = blue = covered = 0
      for (let k = 0; k < 4; k++) add(2 * column + (k & 1), 2 * row + (k >> 1))
      if (covered === 0) continue
      const at = 4 * (row * THUMBNAIL_SIDE + column)
      pixels[at] = red / covered
      pixels[at + 1] = green / covered
      pixels[at + 2] = blue / covered
      pixels[at + 3] = (255 * covered) / 4
    }
  return pixels
}

function inUnit(x: number): number {
  return Math.max(0, Math.min(1, x))
}

/** The biquadratic with the nine Bernstein coefficients from `k` on. */
function jacdetOn(beta: Float64Array, k: number, s: number, t: number): number {
  const f0 = quadratic(beta, k, t)
  return (1 - s) * ((1 - s) * f0 + 2 * s * quadratic(beta, k + 3, t)) + s * s * quadratic(beta, k + 6, t)
}

function quadratic(beta: Float64Array, k: number, t: number): number {
  return (1 - t) * ((1 - t) * (beta[k] as number) + 2 * t * (beta[k + 1] as number)) + t * t * (beta[k + 2] as number)
}

/** A ring about the minimizer: filled with paper where the minimizer is seen, faint and empty where a face hides it. */
function drawRing(pixels: Uint8ClampedArray, { x, y, depth }: FlatPoint, { depths }: Front, theme: Theme): void {
  const isHidden = depth > (depths[Math.floor(y) * SAMPLES + Math.floor(x)] ?? Infinity) + SEEN_DEPTH
  const perPixelUnit = THUMBNAIL_SIDE / UNITS
  const [centreX, centreY] = [x / 2, y / 2]
  const reach = Math.ceil((RING_RADIUS + RING_HALF_WIDTH) * perPixelUnit + 1)
  for (let row = Math.floor(centreY) - reach; row <= centreY + reach; row++)
    for (let column = Math.floor(centreX) - reach; column <= centreX + reach; column++) {
      const fromCentre = Math.hypot(column + 0.5 - centreX, row + 0.5 - centreY)
      const covered = (radius: number) => inUnit(radius * perPixelUnit - fromCentre + 0.5)
      const [inside, disc] = [covered(RING_RADIUS - RING_HALF_WIDTH), covered(RING_RADIUS + RING_HALF_WIDTH)]
      if (disc === 0) continue
      const at = 4 * (row * THUMBNAIL_SIDE + column)
      if (!isHidden) layOver(pixels, at, theme.paper, disc)
      layOver(pixels, at, theme.ink, (disc - inside) * (isHidden ? HIDDEN : 1))
    }
}

/** Lays a share of a colour over a pixel that may be transparent. */
function layOver(pixels: Uint8ClampedArray, at: number, colour: Rgb, share: number): void {
  const below = ((pixels[at + 3] as number) / 255) * (1 - share)
  const whole = share + below
  if (whole === 0) return
  for (let channel = 0; channel < 3; channel++)
    pixels[at + channel] =
      ((colour[channel] as number) * 255 * share + (pixels[at + channel] as number) * below) / whole
  pixels[at + 3] = 255 * whole
}
