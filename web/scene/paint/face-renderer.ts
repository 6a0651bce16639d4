/** Draws the coloured faces: one mesh, one draw call a viewport. It knows three.js and the uniforms. */
import { type BufferAttribute, LinearSRGBColorSpace, Mesh, Scene, Vector3, WebGLRenderer } from 'three'
import { sectionBernstein } from '../../core/section'
import { faces, VERTEX_COUNT, type Vec3 } from '../../model/hexahedron'
import type { FaceDisplay, Section } from '../../views/scene-slices'
import { type Corners, faceCorners, facePoint, patchPoint, sectionCorners } from '../space/patches'
import { at, map3 } from '../space/vec3'
import type { Ramp } from './colour-map'
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
import { OPACITY, type Picture, type Viewport } from './picture'
import { lightOf } from './shading'
import { ZeroSurfaceMesh } from './zero-surface-mesh'

const OPAQUE: Vec3 = [1, 1, 1]

/** The renderer that FaceRenderer draws with. */
export function rendererOf(
  canvas: OffscreenCanvas | HTMLCanvasElement,
  context: WebGL2RenderingContext,
): WebGLRenderer {
  const renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true })
  renderer.outputColorSpace = LinearSRGBColorSpace
  renderer.setClearColor(0, 0)
  renderer.autoClear = false
  renderer.sortObjects = false // they are added in the order in which they are drawn
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
  /** The tiles that the indices are of: how fine, and the faces in order; null if tiles are sorted one by one. */
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

  /** On the canvas, which then has the picture's size in pixels. */
  draw(picture: Picture): void {
    this.resize(picture)
    this.#writeColours(picture)
    this.#renderer.clear()
    for (const viewport of picture.viewports) this.#drawViewport(viewport, picture)
  }

  #drawViewport(viewport: Viewport, { display, faces, section, height }: Picture): void {
    const { left, top, camera } = viewport
    this.#renderer.setViewport(left, height - top - camera.height, camera.width, camera.height)
    this.#writeVertices(viewport.vertices)
    if (display === 'inside') {
      const corners = sectionCorners(viewport.vertices, section)
      this.#writeVertices(corners, VERTEX_COUNT)
      this.#zeroSurface.cut(section, sideSeen(viewport, corners, section))
    }
    this.#uniforms.eye.value.copy(camera.three.position)
    this.#uniforms.toLight.value.set(...lightOf(camera))
    this.#chooseFaces(viewport, display, faces)
    this.#renderer.render(this.#scene, camera.three)
  }

  #writeVertices(vertices: readonly Vec3[], first = 0): void {
    vertices.forEach((vertex, v) => {
      this.#uniforms.vertices.value[first + v]?.set(...vertex)
    })
  }

  /** Begins to make the programs for such a picture, without waiting for them. */
  compile({ viewports: [viewport] }: Picture): void {
    if (viewport) this.#renderer.compile(this.#scene, viewport.camera.three)
  }

  /** Releases everything in the context; three makes it anew for the next picture. */
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

  #writeColours({ report, scale, ramp, theme, pixelRatio, display, section, zeroSurface }: Picture): void {
    const uniforms = this.#uniforms
    uniforms.bernstein.value.fill(0)
    if (report && scale) {
      const write = (face: number, bernstein: readonly number[]) =>
        bernstein.forEach((value, k) => {
          uniforms.bernstein.value[9 * face + k] = value / scale.greatest
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

  #chooseFaces(viewport: Viewport, display: FaceDisplay, drawn: readonly number[]): void {
    const isTransparent = display in OPACITY
    this.#material.transparent = isTransparent
    this.#material.depthWrite = !isTransparent
    const quadsPerTile = quadsPerTileFor(greatestTwist(viewport))
    const order = display === 'see-through' ? null : facesInOrder(viewport, drawn)
    const tiling = order && `${quadsPerTile} ${order}`
    if (tiling !== null && tiling === this.#tiling) return
    this.#tiling = tiling
    const tiles = order ? tilesOfFaces(order) : farthestTilesFirst(viewport, drawn)
    const index = this.#geometry.index as BufferAttribute
    this.#geometry.setDrawRange(0, writeIndices(index.array as Uint16Array, tiles, quadsPerTile))
    index.needsUpdate = true
  }
}

/** The nearest first, which spares those that they hide. */
function facesInOrder({ vertices, camera }: Viewport, drawn: readonly number[]): readonly number[] {
  const depths = faces.map((_, face) => camera.depth(facePoint(vertices, face, 0.5, 0.5)))
  return drawn.toSorted((a, b) => (depths[a] as number) - (depths[b] as number))
}

/** The greatest twist of a face, in units of the screen where the element is nearest to the eye. */
function greatestTwist({ vertices, camera }: Viewport): number {
  const nearest = Math.min(...vertices.map(vertex => camera.depth(vertex)))
  const twists = faces.map((_, face) => {
    const [a, b, c, d] = faceCorners(vertices, face)
    return Math.hypot(...map3(axis => at(a, axis) - at(b, axis) - at(c, axis) + at(d, axis)))
  })
  return Math.max(...twists) / camera.lengthPerPixel(Math.max(nearest, camera.three.near))
}

/** The side of the section that the eye is on. */
function sideSeen({ vertices, camera }: Viewport, corners: Corners, { axis }: Section): 'above' | 'below' {
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

function farthestTilesFirst({ vertices, camera }: Viewport, drawn: readonly number[]): Uint16Array {
  const depths = new Float64Array(TILE_COUNT)
  for (let tile = 0; tile < TILE_COUNT; tile++)
    depths[tile] = camera.depth(facePoint(vertices, faceOfTile(tile), ...tileMiddle(tile)))
  const tiles = [...depths.keys()].filter(tile => drawn.includes(faceOfTile(tile)))
  return Uint16Array.from(tiles).sort((a, b) => (depths[b] as number) - (depths[a] as number))
}
