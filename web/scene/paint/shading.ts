/**
 * The shading that tells faces apart, so faint that the order of jacdet's colours stays: it takes less of a colour's lightness than
 * there is from one level of jacdet to the next (`tests/unit/scene-colours.test.ts`). Figures have it, the flat face maps do not.
 */
import type { Vec3 } from '../../model/hexahedron'
import type { SceneCamera } from '../space/camera'
import { at, dot, map3, mix } from '../space/vec3'
import type { Rgb } from './colour-map'

/** To the right, up, and towards the eye: from over the reader's left shoulder, so that the sides of a cube differ. Of length 1. */
export const LIGHT: Vec3 = [-0.45, 0.68, 0.58]

/** Lightness in OKLab that a face in the dark loses. */
export const SHADE = 0.05

/** The direction in world space from which the light comes. */
export function lightOf(camera: SceneCamera): Vec3 {
  const [right, up, back] = camera.axes()
  return map3(axis => LIGHT[0] * at(right, axis) + LIGHT[1] * at(up, axis) + LIGHT[2] * at(back, axis))
}

/** The light from 0 to 1 on the side of a face that is seen, with a normal of any length, and the eye in this direction from it. */
export function lightOn(normal: Vec3, toEye: Vec3, light: Vec3): number {
  const lit = (dot(normal, light) * Math.sign(dot(normal, toEye))) / Math.sqrt(dot(normal, normal))
  return lit > 0 ? lit : 0
}

/** A colour in that light. Lightness is near the cubic root of luminance, and that near the mean of the components' squares. */
export function shaded(colour: Rgb, lit: number): Rgb {
  const lightness = Math.cbrt(0.2126 * colour[0] ** 2 + 0.7152 * colour[1] ** 2 + 0.0722 * colour[2] ** 2)
  return mix([0, 0, 0], colour, 1 - (SHADE * (1 - lit)) / lightness)
}
