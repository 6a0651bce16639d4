/** Draws the coloured faces: one mesh, one draw call a region. It knows three.js and the uniforms. */
import { type BufferAttribute, LinearSRGBColorSpace, Mesh, Scene, Vector3, WebGLRenderer } from 'three'
import type { Report } from '../../core/report'
import { sectionBernstein } from '../../core/section'
import type { Surface } from '../../core/zero-surface'
import { faces, VERTEX_COUNT, type Vec3 } from '../../model/hexahedron'
import type { FaceDisplay, Section } from '../../model/state'
import type { ColourScale, Ramp, Theme } from '../colour-map'
import type { SceneCamera } from './camera'
import { type Corners, faceCorners, facePoint, patchPoint, sectionCorners } from './face-point'
import {
  createFacesGeometry,
  createSectionGeometry,
  faceOfTile,
  quadsPerTileFor,
  SECTION,
  TILE_COUNT,
  tileMiddle,
  tilesOfFaces,
  writeIndices,
} from './faces-geometry'
import { createFacesMaterial, createFacesUniforms, writeRamp } from './faces-material'
import { at, map3 } from './view-frame'
import { ZeroSurfaceMesh } from './zero-surface-mesh'

/** Part of the canvas, in CSS pixels from its top left, and what is drawn there: the vertices are in the view frame. */
export interface Region {
  readonly left: number
  readonly top: number
  readonly vertices: readonly Vec3[]
  /** It knows the region's width and height. */
  readonly camera: SceneCamera
}

/** One picture: the same colours in every region. */
export interface Picture {
  readonly report: Report | null
  readonly scale: ColourScale | null
  readonly ramp: Ramp
  readonly theme: Theme
  readonly display: FaceDisplay
  /** What is shown inside, where `display` says so. */
  readonly section: Section
  readonly zeroSurface: Surface | null
  readonly regions: readonly Region[]
  readonly width: number
  readonly height: number
  readonly pixelRatio: number
}

/** Of faces where positive, where negative, and of lines on them, in the displays that one can look through. */
export const OPACITY: Readonly<Record<string, Vec3>> = { 'see-through': [0.3, 0.82, 1], inside: [0.08, 0.2, 0.45] }
const OPAQUE: Vec3 = [1, 1, 1]

/** Of which FaceRenderer is the only user. */
export function rendererOf(
  canvas: OffscreenCanvas | HTMLCanvasElement,
  context: WebGL2RenderingContext,
): WebGLRenderer {
  const renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true })
  renderer.outputColorSpace = LinearSRGBColorSpace
  renderer.setClearColor(0, 0)
  renderer.autoClear = false
  renderer.sortObjects = false // they are added in the order in which they are drawn
  renderer.info.autoReset = false
  return renderer
}

export class FaceRenderer {
  readonly #renderer: WebGLRenderer
  readonly #uniforms = createFacesUniforms()
  readonly #material = createFacesMaterial(this.#uniforms)
  readonly #geometry = createFacesGeometry()
  readonly #sectionMaterial = createFacesMaterial(this.#uniforms)
  readonly #section = new Mesh(createSectionGeometry(), this.#sectionMaterial)
  readonly #zeroSurface = new ZeroSurfaceMesh(this.#uniforms)
  readonly #scene = new Scene()
  /** Of which the indices are: how fine, and the faces in order; null where tiles are in order of their own. */
  #tiling: string | null = null
  #ramp: Ramp | null = null
  #size = ''

  constructor(renderer: WebGLRenderer) {
    this.#renderer = renderer
    const mesh = new Mesh(this.#geometry, this.#material)
    mesh.frustumCulled = false
    this.#section.frustumCulled = false
    this.#scene.add(this.#section, this.#zeroSurface.mesh, mesh)
  }

  /** On the canvas, which then has the picture's size in pixels. Returns the number of draw calls. */
  draw(picture: Picture): number {
    this.resize(picture)
    this.#writeRamp(picture)
    this.#renderer.info.reset()
    this.#renderer.clear()
    for (const region of picture.regions) this.#drawRegion(region, picture)
    return this.#renderer.info.render.calls
  }

  #drawRegion(region: Region, { display, section, height }: Picture): void {
    const { left, top, camera } = region
    this.#renderer.setViewport(left, height - top - camera.height, camera.width, camera.height)
    this.#placeVertices(region.vertices)
    if (display === 'inside') {
      const corners = sectionCorners(region.vertices, section)
      this.#placeVertices(corners, VERTEX_COUNT)
      this.#zeroSurface.cut(section, sideSeen(region, corners, section))
    }
    this.#uniforms.eye.value.copy(camera.three.position)
    this.#chooseFaces(region, display)
    this.#renderer.render(this.#scene, camera.three)
  }

  #placeVertices(vertices: readonly Vec3[], first = 0): void {
    vertices.forEach((vertex, v) => {
      this.#uniforms.vertices.value[first + v]?.set(...vertex)
    })
  }

  /** Begins to make the programs for such a picture, without waiting for them. */
  compile({ regions: [region] }: Picture): void {
    if (region) this.#renderer.compile(this.#scene, region.camera.three)
  }

  /** What lies in the context is made anew when it is next drawn. */
  release(): void {
    this.#geometry.dispose()
    this.#material.dispose()
    this.#section.geometry.dispose()
    this.#sectionMaterial.dispose()
    this.#zeroSurface.dispose()
  }

  resize({ width, height, pixelRatio }: Pick<Picture, 'width' | 'height' | 'pixelRatio'>): void {
    const size = `${width} ${height} ${pixelRatio}`
    if (size === this.#size) return
    this.#size = size
    if (pixelRatio !== this.#renderer.getPixelRatio()) this.#renderer.setPixelRatio(pixelRatio)
    this.#renderer.setSize(width, height, false)
  }

  #writeRamp({ report, scale, ramp, theme, pixelRatio, display, section, zeroSurface }: Picture): void {
    const uniforms = this.#uniforms
    uniforms.bernstein.value.fill(0)
    if (report && scale) {
      const write = (face: number, bernstein: readonly number[]) =>
        bernstein.forEach((value, k) => {
          uniforms.bernstein.value[9 * face + k] = value / scale.unit
        })
      for (const { id, bernstein } of report.faces) write(id, bernstein)
      write(SECTION, sectionBernstein(report.bernstein, section.axis, section.value))
      uniforms.negativeExtent.value = scale.negativeExtent
      uniforms.positiveExtent.value = scale.positiveExtent
    }
    if (ramp !== this.#ramp) {
      this.#ramp = ramp
      writeRamp(uniforms, ramp)
      uniforms.ink.value.fromArray(theme.ink)
      uniforms.paper.value.fromArray(theme.paper)
      this.#zeroSurface.colour(theme)
    }
    uniforms.pixelRatio.value = pixelRatio
    uniforms.opacity.value.set(...(OPACITY[display] ?? OPAQUE))
    this.#section.visible = display === 'inside'
    this.#zeroSurface.update(display === 'inside' ? zeroSurface : null)
  }

  #chooseFaces(region: Region, display: FaceDisplay): void {
    const isVeil = display in OPACITY
    this.#material.transparent = isVeil
    this.#material.depthWrite = !isVeil
    const quadsPerTile = quadsPerTileFor(greatestTwist(region))
    const order = display === 'see-through' ? null : facesInOrder(region, display)
    const tiling = order && `${quadsPerTile} ${order}`
    if (tiling !== null && tiling === this.#tiling) return
    this.#tiling = tiling
    const tiles = order ? tilesOfFaces(order) : farthestTilesFirst(region)
    const index = this.#geometry.index as BufferAttribute
    this.#geometry.setDrawRange(0, writeIndices(index.array as Uint16Array, tiles, quadsPerTile))
    index.needsUpdate = true
  }
}

/** The nearest first, which spares what they hide; or one alone. */
function facesInOrder({ vertices, camera }: Region, display: FaceDisplay): readonly number[] {
  if (typeof display === 'number') return [display]
  const depths = faces.map((_, face) => camera.depth(facePoint(vertices, face, 0.5, 0.5)))
  return [...depths.keys()].sort((a, b) => (depths[a] as number) - (depths[b] as number))
}

/** Of all faces, in pixels, where they are nearest to the eye. */
function greatestTwist({ vertices, camera }: Region): number {
  const nearest = Math.min(...vertices.map(vertex => camera.depth(vertex)))
  const twists = faces.map((_, face) => {
    const [a, b, c, d] = faceCorners(vertices, face)
    return Math.hypot(...map3(axis => at(a, axis) - at(b, axis) - at(c, axis) + at(d, axis)))
  })
  return Math.max(...twists) / camera.lengthPerPixel(Math.max(nearest, camera.three.near))
}

/** On which side of the section the eye is. */
function sideSeen({ vertices, camera }: Region, corners: Corners, { axis }: Section): 'above' | 'below' {
  const [a, b, c] = corners.map(corner => new Vector3(...corner)) as [Vector3, Vector3, Vector3]
  const normal = b.sub(a).cross(c.sub(a))
  const [below, above] = [0, 1].map(side => patchPoint(faceCorners(vertices, 2 * axis + side), 0.5, 0.5)) as [
    Vec3,
    Vec3,
  ]
  const up = new Vector3(...above).sub(new Vector3(...below))
  const toEye = camera.three.position.clone().sub(a)
  return normal.dot(up) * normal.dot(toEye) >= 0 ? 'above' : 'below'
}

function farthestTilesFirst({ vertices, camera }: Region): Uint16Array {
  const depths = new Float64Array(TILE_COUNT)
  for (let tile = 0; tile < TILE_COUNT; tile++)
    depths[tile] = camera.depth(facePoint(vertices, faceOfTile(tile), ...tileMiddle(tile)))
  return Uint16Array.from(depths.keys()).sort((a, b) => (depths[b] as number) - (depths[a] as number))
}
