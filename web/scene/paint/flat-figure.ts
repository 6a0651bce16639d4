/**
 * A still drawing of an element as SVG markup, for documents without scripts: the tiles of its faces, its edges and vertices, its
 * minimizer. Colours are classes, which `flatFigureStyles` has for a theme, so that one drawing is right on light and on dark paper.
 */
import type { Report } from '../../core/report'
import { edgeVertices, type Vec3 } from '../../model/hexahedron'
import { faceCorners, facePoint } from '../space/patches'
import { hitsOf, seenPatch } from '../space/sight'
import { dot, map3, mix, way } from '../space/vec3'
import { toWorld, verticesInWorld, worldOf } from '../space/world'
import { colourScaleOf, type Ramp, type Rgb, rampColour, rampOf, rampPosition, type Theme } from './colour-map'
import { type FlatPoint, type FlatTile, flatTiles, pathOf } from './flat-tiles'
import { RIGHT, seen, TOWARDS, UP } from './plain-view'
import { LIGHT, lightOn, shaded } from './shading'
import { px } from './svg'

/** Units of the drawing's sides; what is around the element has room for vertices' names. */
const SIDE = 220
const MARGIN = 18
/** Tiles to a face's side. */
const TILES = 12
/** Colours of a sign, and levels of the light: so many classes are enough to look smooth. */
const STEPS = 12
const LIGHTS = 4
/** Pieces of an edge, each seen or hidden. */
const PIECES = 32
/** Units from stripe to stripe. */
const HATCH = 6
/** World space has a size of 2. The eye is so far away that lines of sight are parallel to a unit of the drawing. */
const EYE = map3(axis => 1000 * TOWARDS[axis])
/** A face hides what is behind it by more than this. */
const BEHIND = 0.02

const LIGHT_FROM = map3(axis => dot(LIGHT, [RIGHT[axis], UP[axis], TOWARDS[axis]]))

/** The pattern of what is negative: once in a document. */
export const flatFigureHatch = `<svg class="hex-defs" width="0" height="0" aria-hidden="true"><defs><pattern id="hex-hatch" patternUnits="userSpaceOnUse" width="${HATCH}" height="${HATCH}" patternTransform="rotate(-45)"><path class="hex-stripe" d="M0 0V${HATCH}"/></pattern></defs></svg>`

/** The drawing, named by a text without markup. */
export function flatFigure(report: Report, name: string): string {
  const world = worldOf(report.vertices)
  const points = verticesInWorld(world, report.vertices)
  const project = fitted(points.map(seen))
  const place = (point: Vec3) => project(seen(point))
  const patches = report.faces.map((_, face) => seenPatch(EYE, faceCorners(points, face)))
  const isHidden = (point: Vec3) => {
    const direction = way(EYE, point)
    const nearest = 1 - BEHIND / Math.sqrt(dot(direction, direction))
    return patches.some(patch => hitsOf(patch, direction).some(({ distance }) => distance < nearest))
  }
  const tiles = flatTiles(report, points, TILES, place).filter(tile => isTileSeen(tile, points, isHidden))
  const minimizer = toWorld(world, report.minimizer.position)
  return [
    `<svg class="hex" viewBox="0 0 ${SIDE} ${SIDE}" role="img" aria-label="${name}">`,
    ...tilesMarkup(report, tiles),
    ...edgesMarkup(points, place, isHidden),
    ringMarkup(place(minimizer), isHidden(minimizer)),
    ...points.map((point, vertex) => vertexMarkup(place(point), vertex, isHidden(point))),
    '</svg>',
  ].join('')
}

/** Maps these points to the middle of the drawing, as large as it holds them. */
function fitted(points: readonly FlatPoint[]): (point: FlatPoint) => FlatPoint {
  const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)]
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)]
  const factor = (SIDE - 2 * MARGIN) / (Math.max(right - left, bottom - top) || 1)
  return ({ x, y, depth }) => ({
    x: SIDE / 2 + (x - (left + right) / 2) * factor,
    y: SIDE / 2 + (y - (top + bottom) / 2) * factor,
    depth,
  })
}

/** Neighbours in the order of depth that have the same class are one path. */
function tilesMarkup({ boundaryMinimum, boundaryMaximum }: Report, tiles: readonly FlatTile[]): string[] {
  const scale = colourScaleOf(boundaryMinimum, boundaryMaximum)
  const shapes = tiles.map(({ corners, value, normal }) => {
    const step = Math.round(Math.abs(rampPosition(scale, value)) * STEPS)
    const light = Math.round(lightOn(normal, TOWARDS, LIGHT_FROM) * (LIGHTS - 1))
    return { path: `${pathOf(corners)}Z`, name: tileClass(value < 0, step, light), isNegative: value < 0 }
  })
  const paths: string[] = []
  let [fill, hatched] = ['', '']
  for (const [i, { path, name, isNegative }] of shapes.entries()) {
    fill += path
    if (isNegative) hatched += path
    const next = shapes[i + 1]
    if (next?.name !== name) {
      paths.push(`<path class="${name}" d="${fill}"/>`)
      fill = ''
    }
    if (hatched !== '' && next?.isNegative !== true) {
      paths.push(`<path class="hex-hatched" d="${hatched}"/>`)
      hatched = ''
    }
  }
  return paths
}

/** False for a tile whose middle and corners are all hidden. */
function isTileSeen({ face, s, t }: FlatTile, points: readonly Vec3[], isHidden: (point: Vec3) => boolean): boolean {
  const half = 0.5 / TILES
  const places = [[0, 0], ...[-half, half].flatMap(ds => [-half, half].map(dt => [ds, dt]))] as [number, number][]
  return places.some(([ds, dt]) => !isHidden(facePoint(points, face, s + ds, t + dt)))
}

function tileClass(isNegative: boolean, step: number, light: number): string {
  return `hex-${isNegative ? 'n' : 'p'}${step}-${light}`
}

function edgesMarkup(points: readonly Vec3[], place: (point: Vec3) => FlatPoint, isHidden: (point: Vec3) => boolean) {
  const paths = { hidden: '', seen: '' }
  for (const [from, to] of edgeVertices) {
    const at = (share: number) => mix(points[from] as Vec3, points[to] as Vec3, share)
    const areHidden = Array.from({ length: PIECES }, (_, i) => isHidden(at((i + 0.5) / PIECES)))
    for (let i = 0, end = 0; i < PIECES; i = end) {
      while (end < PIECES && areHidden[end] === areHidden[i]) end++
      paths[areHidden[i] ? 'hidden' : 'seen'] += pathOf([place(at(i / PIECES)), place(at(end / PIECES))])
    }
  }
  return Object.entries(paths).map(([name, path]) => `<path class="hex-edge hex-${name}" d="${path}"/>`)
}

function ringMarkup({ x, y }: FlatPoint, isHidden: boolean): string {
  return `<circle class="hex-ring hex-${isHidden ? 'hidden' : 'seen'}" cx="${px(x)}" cy="${px(y)}" r="4.5"/>`
}

/** The name stands outside, away from the middle. */
function vertexMarkup({ x, y }: FlatPoint, vertex: number, isHidden: boolean): string {
  const [right, down] = [x - SIDE / 2, y - SIDE / 2]
  const length = Math.hypot(right, down) || 1
  const [atX, atY] = [x + (11 * right) / length, y + (11 * down) / length + 3.5]
  return `<text class="hex-${isHidden ? 'hidden' : 'seen'}" x="${px(atX)}" y="${px(atY)}">${vertex}</text>`
}

/** Rules for all drawings of a document in these colours. */
export function flatFigureStyles(theme: Theme): string {
  const ramp = rampOf(theme)
  const steps = Array.from({ length: STEPS + 1 }, (_, step) => step)
  const lights = Array.from({ length: LIGHTS }, (_, light) => light)
  const tiles = [false, true].flatMap(isNegative =>
    steps.flatMap(step =>
      lights.map(light => `.${tileClass(isNegative, step, light)}{${fillOf(ramp, isNegative, step, light)}}`),
    ),
  )
  const [ink, paper] = [hex(theme.ink), hex(theme.paper)]
  return [
    ...tiles,
    `.hex-stripe{stroke:${ink};stroke-opacity:.5}.hex-hatched{fill:url(#hex-hatch)}`,
    `.hex-edge{fill:none;stroke:${ink};stroke-linecap:round}.hex-edge.hex-hidden{stroke-opacity:.35;stroke-dasharray:2 3}`,
    `.hex-ring{fill:${paper};stroke:${ink};stroke-width:2}.hex-ring.hex-hidden{fill:none;stroke-dasharray:2 2}`,
    `.hex text{fill:${ink};stroke:${paper};stroke-width:3;stroke-linejoin:round;paint-order:stroke;font-size:11px;text-anchor:middle}`,
    '.hex text.hex-hidden{fill-opacity:.6}',
  ].join('\n')
}

/** A stroke of the same colour, or the paper would shine through between tiles. */
function fillOf(ramp: Ramp, isNegative: boolean, step: number, light: number): string {
  const colour = hex(shaded(rampColour(ramp, ((isNegative ? -1 : 1) * step) / STEPS), light / (LIGHTS - 1)))
  return `fill:${colour};stroke:${colour};stroke-width:.75`
}

export function hex(colour: Rgb): string {
  return `#${colour
    .map(part =>
      Math.round(255 * part)
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`
}
