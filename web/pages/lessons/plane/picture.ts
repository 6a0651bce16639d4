/** The quadrilateral and its square as SVG: bands of equal jacdet, the line of zeros, grid, corners, and the little square. */
import { nothing, svg, type TemplateResult } from 'lit-html'
import type { ColourScale, Ramp } from '../../../scene/paint/colour-map'
import {
  cssColour,
  HATCH_PERIOD,
  RAMP_STEPS,
  rampColour,
  rampPosition,
  rampValue,
} from '../../../scene/paint/colour-map'
import { below, imagePath, written, zeroLine } from './bands'
import {
  CORNER_COUNT,
  columnsAt,
  cornerJacdets,
  cornerReference,
  jacdetAt,
  pointAt,
  type Quadrilateral,
  type Vec2,
} from './quadrilateral'
import type { PlaneView } from './view'

export interface Colouring {
  readonly scale: ColourScale
  readonly ramp: Ramp
}

export interface PanePicture {
  /** Part of ids. */
  readonly name: 'element' | 'square'
  /** The map that is drawn: the element's, or for the square the identity. */
  readonly map: Quadrilateral
  readonly view: PlaneView
  /** The element's corners, on which jacdet depends. */
  readonly quadrilateral: Quadrilateral
  /** Null as long as the colours are hidden. */
  readonly colouring: Colouring | null
  /** A point of the square. */
  readonly probe: Vec2 | null
  /** The corner with the least jacdet, and that jacdet; null as long as it is hidden or not known. */
  readonly least: { readonly corner: number; readonly text: string; readonly isNegative: boolean } | null
  readonly selected: number | null
  /** Where a drag began. */
  readonly ghost: Quadrilateral | null
}

/** Bands to each sign: from one to the next a colour changes by less than four of 255. */
const BANDS = 64
/** The grid's lines each way. */
const LINES = 8
/** The side of the little square. */
export const LITTLE = 0.2
const HANDLE = 7

/** A letter in the little square, whose mirror image is another. */
const LETTER: readonly (readonly Vec2[])[] = [
  [
    [0.32, 0.18],
    [0.32, 0.82],
    [0.72, 0.82],
  ],
  [
    [0.32, 0.5],
    [0.62, 0.5],
  ],
]

export function panePicture(picture: PanePicture): TemplateResult {
  const { name, map, view, quadrilateral, colouring, ghost } = picture
  const corners = map.map(view.toScreen)
  const outline = `M${corners.map(written).join('L')}Z`
  return svg`
    <defs>
      <pattern id="${name}-hatch" patternUnits="userSpaceOnUse" width=${HATCH_PERIOD} height=${HATCH_PERIOD} patternTransform="rotate(-45)">
        <path class="stripe" d="M0 0V${HATCH_PERIOD}" />
      </pattern>
    </defs>
    ${colouring ? painted(picture, colouring) : nothing}
    <path class="grid" d=${gridPath(map, view)} />
    ${colouring ? zeros(map, quadrilateral, view) : nothing}
    ${ghost ? svg`<path class="ghost" d=${`M${ghost.map(corner => written(view.toScreen(corner))).join('L')}Z`} />` : nothing}
    <path class="edges" d=${outline} />
    ${little(picture)}
    ${leastMark(picture, corners)}
    ${corners.map((at, i) => cornerMark(picture, at, i))}`
}

function painted(picture: PanePicture, colouring: Colouring): TemplateResult {
  const { name, map, view, quadrilateral } = picture
  const isNegative = Math.min(...cornerJacdets(quadrilateral)) < 0
  const negative = isNegative ? imagePath(map, below(quadrilateral, 0), view.toScreen) : ''
  return svg`
    ${name === 'square' ? blended(picture, colouring) : bands(picture, colouring)}
    <path fill="url(#${name}-hatch)" d=${negative} />`
}

/**
 * On the square jacdet is affine, and between the ramp's stops its colours are, too: a gradient along the direction in which jacdet grows
 * has the colour of every point.
 */
function blended({ view, quadrilateral }: PanePicture, { scale, ramp }: Colouring): TemplateResult {
  const outline = `M${cornerReference.map(corner => written(view.toScreen(corner))).join('L')}Z`
  const [j0, j1, , j3] = cornerJacdets(quadrilateral) as [number, number, number, number]
  const growth: Vec2 = [j1 - j0, j3 - j0]
  const steepness = growth[0] ** 2 + growth[1] ** 2
  if (!(steepness > 0)) return svg`<path fill=${cssColour(rampColour(ramp, rampPosition(scale, j0)))} d=${outline} />`
  const pointWith = (jacdet: number): Vec2 =>
    view.toScreen([(growth[0] * (jacdet - j0)) / steepness, (growth[1] * (jacdet - j0)) / steepness])
  const [least, greatest] = [rampValue(scale, -1), rampValue(scale, 1)]
  const [[x1, y1], [x2, y2]] = [pointWith(least), pointWith(greatest)]
  const stops = Array.from({ length: 2 * RAMP_STEPS + 1 }, (_, i) => i / RAMP_STEPS - 1).map(position => ({
    offset: (rampValue(scale, position) - least) / (greatest - least),
    colour: cssColour(rampColour(ramp, position)),
  }))
  return svg`
    <linearGradient id="jacdet" gradientUnits="userSpaceOnUse" x1=${x1} y1=${y1} x2=${x2} y2=${y2}>
      ${stops.map(({ offset, colour }) => svg`<stop offset=${offset} stop-color=${colour} />`)}
    </linearGradient>
    <path fill="url(#jacdet)" d=${outline} />`
}

/**
 * The part below each value in its colour, from the highest value to the lowest, so that no seam shows between them. Where the map folds
 * over, what is negative lies on top.
 */
function bands({ map, view, quadrilateral }: PanePicture, { scale, ramp }: Colouring): TemplateResult[] {
  return Array.from({ length: 2 * BANDS }, (_, i) => {
    const position = 1 - i / BANDS
    // The end of the scale is computed: the greatest jacdet may be a little beyond.
    const region = below(quadrilateral, i === 0 ? Infinity : rampValue(scale, position))
    if (region.length < 3) return svg``
    const colour = cssColour(rampColour(ramp, position - 1 / (2 * BANDS)))
    return svg`<path fill=${colour} d=${imagePath(map, region, view.toScreen)} />`
  })
}

function zeros(map: Quadrilateral, quadrilateral: Quadrilateral, view: PlaneView): TemplateResult | typeof nothing {
  const line = zeroLine(quadrilateral)
  return line ? svg`<path class="zeros" d=${imagePath(map, line, view.toScreen)} />` : nothing
}

function gridPath(map: Quadrilateral, { toScreen }: PlaneView): string {
  const line = (from: Vec2, to: Vec2) => `M${[from, to].map(point => written(toScreen(pointAt(map, point)))).join('L')}`
  return Array.from({ length: LINES - 1 }, (_, i) => (i + 1) / LINES)
    .map(k => line([k, 0], [k, 1]) + line([0, k], [1, k]))
    .join('')
}

/** The little square at the probe, or its image by the columns there. */
function little({ name, map, view, quadrilateral, probe }: PanePicture): TemplateResult | typeof nothing {
  if (!probe) return nothing
  const middle = pointAt(map, probe)
  const [u, v] = columnsAt(map, probe)
  const place = ([s, t]: Vec2): string =>
    written(
      view.toScreen([
        middle[0] + LITTLE * ((s - 0.5) * u[0] + (t - 0.5) * v[0]),
        middle[1] + LITTLE * ((s - 0.5) * u[1] + (t - 0.5) * v[1]),
      ]),
    )
  const isNegative = jacdetAt(quadrilateral, probe) < 0 && name === 'element'
  const [x, y] = view.toScreen(middle)
  return svg`<g class=${isNegative ? 'little negative' : 'little'}>
    <path class="halo" d=${`M${cornerReference.map(place).join('L')}Z`} />
    <path class="tile" d=${`M${cornerReference.map(place).join('L')}Z`} />
    <path class="letter" d=${LETTER.map(line => `M${line.map(place).join('L')}`).join('')} />
    <circle class="point" cx=${x} cy=${y} r="2.5" />
  </g>`
}

function leastMark({ least }: PanePicture, corners: readonly Vec2[]): TemplateResult | typeof nothing {
  if (!least) return nothing
  const [x, y] = corners[least.corner] as Vec2
  return svg`<g class=${least.isNegative ? 'least negative' : 'least'}>
    <circle class="rim" cx=${x} cy=${y} r=${HANDLE + 5} />
    <circle class="ring" cx=${x} cy=${y} r=${HANDLE + 5} />
  </g>`
}

function cornerMark({ name, map, least, selected }: PanePicture, [x, y]: Vec2, corner: number): TemplateResult {
  const [dx, dy] = outwards(map, corner)
  const value = name === 'element' && least?.corner === corner ? least : null
  const anchor = !value ? 'middle' : dx < 0 ? 'end' : 'start'
  // Outside of the corner's own number.
  const jacdet = value
    ? svg`<tspan class=${value.isNegative ? 'value negative' : 'value'}>${value.text}</tspan>`
    : nothing
  return svg`<g class=${corner === selected ? 'corner selected' : 'corner'}>
    ${
      name === 'element'
        ? svg`<circle class="rim" cx=${x} cy=${y} r=${HANDLE + 2.5} /><circle class="dot" cx=${x} cy=${y} r=${HANDLE} />`
        : nothing
    }
    <text x=${x + dx * 20} y=${y - dy * 20 + 5} text-anchor=${anchor}>
      ${anchor === 'end' ? [jacdet, ' ', corner] : [corner, ' ', jacdet]}
    </text>
  </g>`
}

/** From the middle towards the corner, of length 1. */
function outwards(map: Quadrilateral, corner: number): Vec2 {
  const [x, y] = map[corner] as Vec2
  const mean = (i: 0 | 1) => map.reduce((sum, point) => sum + point[i] / CORNER_COUNT, 0)
  const [dx, dy] = [x - mean(0), y - mean(1)]
  const length = Math.hypot(dx, dy)
  return length > 0 ? [dx / length, dy / length] : [0, 1]
}
