/** A picture of the coloured faces: everything that it depends on, and what paints it. */
import type { Report } from '../../core/report'
import type { Surface } from '../../core/zero-surface'
import type { Vec3 } from '../../model/hexahedron'
import type { FaceDisplay, Section } from '../../views/scene-slices'
import type { SceneCamera } from '../space/camera'
import type { ColourScale, Ramp, Theme } from './colour-map'

/** A rectangle of the canvas, in units from its top left, as large as its camera says, and the element in it. */
export interface Viewport {
  readonly left: number
  readonly top: number
  /** In world space. */
  readonly vertices: readonly Vec3[]
  readonly camera: SceneCamera
}

/** The same colours in every viewport. */
export interface Picture {
  readonly report: Report | null
  readonly scale: ColourScale | null
  readonly ramp: Ramp
  readonly theme: Theme
  readonly display: FaceDisplay
  /** Those that are drawn. */
  readonly faces: readonly number[]
  /** Shown if `display` is 'inside', like the surface jacdet = 0. */
  readonly section: Section
  readonly zeroSurface: Surface | null
  readonly viewports: readonly Viewport[]
  readonly width: number
  readonly height: number
  readonly pixelRatio: number
}

export interface FacePainter {
  readonly root: HTMLCanvasElement | SVGSVGElement
  /** True if the context is lost at present: nothing can be painted. */
  readonly isLost: boolean
  /** False while there are steps to the first picture, of which each call takes one: it wants another call in the next frame. */
  isReady(picture: Picture): boolean
  /** False if the last picture was the same, which is not painted again. */
  paint(picture: Picture): boolean
  dispose(): void
}

/** Opacities of faces where positive, where negative, and of lines on them, in the displays that one can look through. */
export const OPACITY: Readonly<Record<string, Vec3>> = { 'see-through': [0.3, 0.82, 1], inside: [0.08, 0.2, 0.45] }

/** True if a picture is the same as the one noted before it. */
export class LastPicture {
  #values: readonly unknown[] = []

  /** Notes the picture. */
  isSame(picture: Picture): boolean {
    const [values, before] = [valuesOf(picture), this.#values]
    this.#values = values
    return values.length === before.length && values.every((value, i) => Object.is(value, before[i]))
  }

  forget(): void {
    this.#values = []
  }
}

/** Every value that a picture depends on. The scale is the report's. */
function valuesOf(picture: Picture): unknown[] {
  const { report, ramp, theme, display, faces, section, zeroSurface, viewports, width, height, pixelRatio } = picture
  const inside = display === 'inside' ? [section.axis, section.value, zeroSurface] : []
  const values: unknown[] = [report, ramp, theme, display, String(faces), ...inside, width, height, pixelRatio]
  for (const { left, top, vertices, camera } of viewports) {
    const { projectionMatrix, matrixWorld } = camera.three
    values.push(left, top, camera.width, camera.height, ...vertices.flat())
    values.push(...projectionMatrix.elements, ...matrixWorld.elements)
  }
  return values
}
