/** The coloured faces without WebGL: tiles in SVG, the farthest first, in the colour of jacdet at their middle, hatched if negative. */
import type { Vec3 } from '../../model/hexahedron'
import { way } from '../space/vec3'
import { cssColour, rampColour, rampPosition } from './colour-map'
import { flatTiles, pathOf } from './flat-tiles'
import { type FacePainter, LastPicture, OPACITY, type Picture, type Viewport } from './picture'
import { lightOf, lightOn, shaded } from './shading'
import { set, show, svg } from './svg'

/** Tiles to a face's side: small enough to show where jacdet is negative, few enough for every frame of a drag. */
const SIDE = 10
/** Units between stripes. */
const HATCH = 6

let painters = 0

export class FlatPainter implements FacePainter {
  readonly root = svg('svg', { class: 'scene-flat', 'aria-hidden': 'true' })
  readonly isLost = false
  readonly #hatch = `scene-flat-hatch-${++painters}`
  readonly #stripe = svg('path', { d: `M0 0V${HATCH}` })
  readonly #shapes: { readonly fill: SVGPathElement; readonly hatch: SVGPathElement }[] = []
  readonly #last = new LastPicture()

  constructor() {
    const pattern = svg(
      'pattern',
      { id: this.#hatch, patternUnits: 'userSpaceOnUse', width: HATCH, height: HATCH, patternTransform: 'rotate(-45)' },
      this.#stripe,
    )
    this.root.append(svg('defs', {}, pattern))
  }

  isReady(): boolean {
    return true
  }

  paint(picture: Picture): boolean {
    if (this.#last.isSame(picture)) return false
    const { width, height, theme, display } = picture
    set(this.root, { viewBox: `0 0 ${width} ${height}` })
    set(this.#stripe, { stroke: cssColour(theme.ink), 'stroke-opacity': 0.5 })
    const tiles = picture.viewports.flatMap(viewport => tilesOf(viewport, picture))
    const [positive, negative] = OPACITY[display] ?? [1, 1]
    for (const [i, { path, colour, isNegative }] of tiles.entries()) {
      const { fill, hatch } = this.#shape(i)
      // A stroke of the same colour, or the paper would shine through between tiles.
      const opacity = isNegative ? negative : positive
      set(fill, { d: path, fill: colour, stroke: opacity === 1 ? colour : 'none', 'fill-opacity': opacity })
      show(fill, true)
      show(hatch, isNegative)
      if (isNegative) set(hatch, { d: path })
    }
    for (const { fill, hatch } of this.#shapes.slice(tiles.length))
      for (const shape of [fill, hatch]) show(shape, false)
    return true
  }

  dispose(): void {}

  #shape(i: number) {
    const known = this.#shapes[i]
    if (known) return known
    const shape = { fill: svg('path', { 'stroke-width': 0.75 }), hatch: svg('path', { fill: `url(#${this.#hatch})` }) }
    this.root.append(shape.fill, shape.hatch)
    this.#shapes.push(shape)
    return shape
  }
}

function tilesOf({ vertices, camera, left, top }: Viewport, { report, faces, scale, ramp }: Picture) {
  if (report === null || scale === null) return []
  const project = (point: Vec3) => {
    const { x, y, depth } = camera.project(point)
    return { x: x + left, y: y + top, depth }
  }
  const light = lightOf(camera)
  const { x, y, z } = camera.three.position
  return flatTiles(report, vertices, SIDE, project, face => faces.includes(face)).map(
    ({ corners, value, middle, normal }) => {
      const lit = lightOn(normal, way(middle, [x, y, z]), light)
      return {
        path: `${pathOf(corners)}Z`,
        colour: cssColour(shaded(rampColour(ramp, rampPosition(scale, value)), lit)),
        isNegative: value < 0,
      }
    },
  )
}
