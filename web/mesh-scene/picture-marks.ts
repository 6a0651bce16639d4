/** What a picture of a mesh says beside it: the axes, and which colour means what. Drawn over the page's picture and into its PNG. */

import type { Vec3 } from '../model/hexahedron'
import { cssColour, rampColour } from '../scene/paint/colour-map'
import { mix } from '../scene/space/vec3'
import { toneOf } from '../survey/face-list'
import { type Colouring, plainColour } from './cell-colour'
import type { PictureSpace } from './mesh-picture'

/** CSS pixels. */
const AXIS = 26
const BAR = { width: 168, height: 10 }
const MARGIN = 24
/** So much is kept free for the colours. */
export const MARKS_HEIGHT = 60
const FONT = '12px system-ui, sans-serif'
const AXES: readonly (readonly [name: string, axis: Vec3])[] = [
  ['x', [1, 0, 0]],
  ['y', [0, 1, 0]],
  ['z', [0, 0, 1]],
]

type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D

/** In CSS pixels of the picture. */
export function drawMarks(context: Context, space: PictureSpace, colouring: Colouring): void {
  context.font = FONT
  context.lineWidth = 1
  drawAxes(context, space)
  drawBar(context, space, colouring)
}

function drawAxes(context: Context, { camera, theme }: PictureSpace): void {
  const [right, up] = camera.axes()
  const [x, y] = [MARGIN + AXIS, camera.height - MARGIN / 2 - AXIS]
  context.strokeStyle = cssColour(theme.ink)
  context.fillStyle = cssColour(theme.ink)
  context.textAlign = 'center'
  context.textBaseline = 'middle'
  for (const [name, axis] of AXES) {
    const along = (of: Vec3) => of[0] * axis[0] + of[1] * axis[1] + of[2] * axis[2]
    const [dx, dy] = [along(right), -along(up)]
    context.beginPath()
    context.moveTo(x, y)
    context.lineTo(x + AXIS * dx, y + AXIS * dy)
    context.stroke()
    // One that is seen from its end has its letter beside it.
    const length = Math.hypot(dx, dy)
    const off = length > 0.2 ? (AXIS * length + 8) / length : 0
    context.fillText(name, x + off * dx + (off === 0 ? 8 : 0), y + off * dy + (off === 0 ? 8 : 0))
  }
}

function drawBar(context: Context, { camera, theme, ramp, share }: PictureSpace, colouring: Colouring): void {
  const { width, height } = BAR
  const left = camera.width - MARGIN - width
  const top = MARGIN + 4
  const plain = plainColour(theme, colouring)
  for (let pixel = 0; pixel < width; ++pixel) {
    const value = (2 * (pixel + 0.5)) / width - 1
    const colour = value > 0 && plain ? plain : rampColour(ramp, toneOf(value))
    context.fillStyle = cssColour(value > 0 ? mix(theme.paper, colour, share) : colour)
    context.fillRect(left + pixel, top, 1.5, height)
  }
  context.fillStyle = cssColour(theme.ink)
  context.fillRect(left + width / 2 - 0.5, top - 2, 1, height + 4)
  context.textBaseline = 'top'
  const below = top + height + 5
  context.textAlign = 'left'
  context.fillText('≤ −1', left, below)
  context.textAlign = 'center'
  context.fillText('0', left + width / 2, below)
  context.textAlign = 'right'
  context.fillText(plain ? 'valid' : '1', left + width, below)
  context.textBaseline = 'bottom'
  context.fillText('relative minimum', left + width, top - 4)
}
