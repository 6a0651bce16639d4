/** Thin lines over the picture of a mesh: edges as they would be. */
import type { Vec3 } from '../model/hexahedron'
import { cssColour } from '../scene/paint/colour-map'
import type { PictureSpace } from './mesh-picture'

/** `ends` are two points a line, six numbers. In CSS pixels of the picture. */
export function drawGhostLines(
  context: CanvasRenderingContext2D,
  { camera, scale, origin, theme }: PictureSpace,
  ends: Float64Array,
): void {
  const at = (i: number) =>
    camera.project(
      [0, 1, 2].map(axis => ((ends[i + axis] as number) - (origin[axis] as number)) * scale) as unknown as Vec3,
    )
  context.beginPath()
  for (let i = 0; i < ends.length; i += 6) {
    const [from, to] = [at(i), at(i + 3)]
    if (from.depth <= 0 || to.depth <= 0) continue
    context.moveTo(from.x, from.y)
    context.lineTo(to.x, to.y)
  }
  context.lineWidth = 1
  context.strokeStyle = cssColour(theme.ink)
  context.stroke()
}
