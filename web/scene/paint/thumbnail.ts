/**
 * A small still picture of an element: its faces in flat tiles in the colours of jacdet, the negative ones hatched, its edges, its
 * minimizer. An SVG document of its own, to be shown as an image: a page holds dozens.
 */
import type { Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import { entityTitle } from '../../views/entity-name'
import { toWorld, verticesInWorld, worldOf } from '../space/world'
import { colourScaleOf, cssColour, type Ramp, rampColour, rampPosition, type Theme } from './colour-map'
import { type FlatPoint, type FlatTile, flatTiles, pathOf } from './flat-tiles'
import { seen } from './plain-view'

/** The side of the picture. */
const SIZE = 120
const MARGIN = 7
/** Tiles to a face's side. */
const SIDE = 8
const HATCH = 5

export interface Colours {
  readonly theme: Theme
  readonly ramp: Ramp
}

/** For the `src` of an image. */
export function thumbnailAddress(report: Report, colours: Colours): string {
  return `data:image/svg+xml;base64,${btoa(thumbnailMarkup(report, colours))}`
}

/** The picture in words: "Invalid, minimum −1/4 on edge 0–1". */
export function thumbnailText({ valid, boundaryMinimum, exponent, minimizer }: Report): string {
  const part = entityTitle(minimizer)
  const minimum = formatJacdet(boundaryMinimum, exponent, 'unit')
  return `${valid ? 'Valid' : 'Invalid'}, minimum ${minimum} on ${part.charAt(0).toLowerCase()}${part.slice(1)}`
}

/** In ASCII. */
export function thumbnailMarkup(report: Report, { theme, ramp }: Colours): string {
  const world = worldOf(report.vertices)
  const points = verticesInWorld(world, report.vertices)
  const toPicture = fitted(points.map(seen))
  const tiles = flatTiles(report, points, SIDE, point => toPicture(seen(point)))
  const scale = colourScaleOf(report.boundaryMinimum, report.boundaryMaximum)
  const colourOf = (value: number) => cssColour(rampColour(ramp, rampPosition(scale, value)))
  const ink = cssColour(theme.ink)
  const { x, y } = toPicture(seen(toWorld(world, report.minimizer.position)))
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE} ${SIZE}" width="${SIZE}" height="${SIZE}">`,
    `<defs><pattern id="hatch" patternUnits="userSpaceOnUse" width="${HATCH}" height="${HATCH}" patternTransform="rotate(-45)">`,
    `<path d="M0 0V${HATCH}" stroke="${ink}" stroke-opacity=".55" stroke-width="1.2"/></pattern></defs>`,
    `<g fill="currentColor" stroke="currentColor" stroke-width=".6" stroke-linejoin="round" stroke-linecap="round">`,
    ...tiles.map(tile => tileMarkup(tile, colourOf(tile.value), ink)),
    `</g><circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="3" fill="${cssColour(theme.paper)}" stroke="${ink}" stroke-width="1.5"/>`,
    `</svg>`,
  ].join('')
}

/** A stroke of the same colour, or the paper would shine through between tiles; an edge over it, so that nearer tiles hide both. */
function tileMarkup({ corners, value, borders }: FlatTile, colour: string, ink: string): string {
  const shape = `${pathOf(corners)}Z`
  const fill = `<path d="${shape}" color="${colour}"/>`
  const hatch = value < 0 ? `<path d="${shape}" fill="url(#hatch)" stroke="none"/>` : ''
  const sides = borders.map(k => pathOf([corners[k] as FlatPoint, corners[(k + 1) % 4] as FlatPoint]))
  const edges = sides.length > 0 ? `<path d="${sides.join('')}" fill="none" stroke="${ink}" stroke-width="1"/>` : ''
  return fill + hatch + edges
}

/** Maps these points to the middle of the picture, as large as it holds them. */
function fitted(points: readonly FlatPoint[]): (point: FlatPoint) => FlatPoint {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)]
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]
  const factor = (SIZE - 2 * MARGIN) / (Math.max(right - left, bottom - top) || 1)
  return ({ x, y, depth }) => ({
    x: SIZE / 2 + (x - (left + right) / 2) * factor,
    y: SIZE / 2 + (y - (top + bottom) / 2) * factor,
    depth,
  })
}
