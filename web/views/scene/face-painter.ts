/**
 * The WebGL part of the scene: one canvas, one mesh, one draw call a region, and none for a picture that is already there. It
 * knows uniforms and the life of the context; what is shown is decided elsewhere.
 */
import { type BufferAttribute, LinearSRGBColorSpace, Mesh, Scene, Vector3, WebGLRenderer } from 'three'
import type { Report } from '../../core/report'
import { sectionBernstein } from '../../core/section'
import type { Surface } from '../../core/zero-surface'
import type { Vec3 } from '../../model/hexahedron'
import type { FaceDisplay, Section } from '../../model/state'
import { type ColourScale, RAMP_STEPS, type Ramp, type Theme } from '../colour-map'
import type { SceneCamera } from './camera'
import { type Corners, faceCorners, facePoint, patchPoint, sectionCorners } from './face-point'
import {
  createFacesGeometry,
  createSectionGeometry,
  FACE_INDICES,
  FACE_TILES,
  SECTION,
  TILE_COUNT,
  TILE_INDICES,
  tiledIndices,
  tileMiddle,
} from './faces-geometry'
import { createFacesMaterial, createFacesUniforms } from './faces-material'
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

export interface FacePainter {
  readonly canvas: HTMLCanvasElement
  /** False where nothing was to be drawn: the last picture was the same. */
  paint(picture: Picture): boolean
  /** Draw calls of the last picture. */
  readonly drawCalls: number
  dispose(): void
}

export interface ContextWatcher {
  lost(): void
  restored(): void
}

/** Of faces where positive, where negative, and of lines on them, in the displays that one can look through. */
const OPACITY: Readonly<Record<string, Vec3>> = { 'see-through': [0.3, 0.82, 1], inside: [0.08, 0.2, 0.45] }
const OPAQUE: Vec3 = [1, 1, 1]

/** Null where the browser gives no WebGL2 context. */
export function createFacePainter(watcher: ContextWatcher): FacePainter | null {
  const canvas = document.createElement('canvas')
  // Asked for here rather than by three, which would write to the console when there is none.
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true, premultipliedAlpha: true })
  if (context === null) return null
  return new WebGLFacePainter(canvas, context, watcher)
}

class WebGLFacePainter implements FacePainter {
  readonly canvas: HTMLCanvasElement
  readonly #renderer: WebGLRenderer
  readonly #watcher: ContextWatcher
  readonly #uniforms = createFacesUniforms()
  readonly #material = createFacesMaterial(this.#uniforms)
  readonly #geometry = createFacesGeometry()
  readonly #sectionMaterial = createFacesMaterial(this.#uniforms)
  readonly #section = new Mesh(createSectionGeometry(), this.#sectionMaterial)
  readonly #zeroSurface = new ZeroSurfaceMesh(this.#uniforms)
  readonly #scene = new Scene()
  readonly #inOrder = tiledIndices()
  #sorted = false
  #ramp: Ramp | null = null
  #size = ''
  #painted: readonly unknown[] = []

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, watcher: ContextWatcher) {
    this.canvas = canvas
    this.#watcher = watcher
    this.#renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true })
    this.#renderer.outputColorSpace = LinearSRGBColorSpace
    this.#renderer.setClearColor(0, 0)
    this.#renderer.autoClear = false
    this.#renderer.info.autoReset = false
    const mesh = new Mesh(this.#geometry, this.#material)
    mesh.frustumCulled = false
    this.#section.frustumCulled = false
    this.#scene.add(this.#section, this.#zeroSurface.mesh, mesh)
    canvas.addEventListener('webglcontextlost', this.#onLost)
    canvas.addEventListener('webglcontextrestored', this.#onRestored)
  }

  get drawCalls(): number {
    return this.#renderer.info.render.calls
  }

  paint(picture: Picture): boolean {
    const contents = contentsOf(picture)
    const painted = this.#painted
    if (contents.length === painted.length && contents.every((value, i) => Object.is(value, painted[i]))) return false
    this.#painted = contents
    this.#resize(picture)
    this.#writeColours(picture)
    this.#renderer.info.reset()
    this.#renderer.clear()
    for (const region of picture.regions) this.#paintRegion(region, picture)
    return true
  }

  #paintRegion(region: Region, { display, section, height }: Picture): void {
    const { left, top, camera } = region
    const corners = sectionCorners(region.vertices, section)
    this.#renderer.setViewport(left, height - top - camera.height, camera.width, camera.height)
    ;[...region.vertices, ...corners].forEach((vertex, v) => {
      this.#uniforms.vertices.value[v]?.set(...vertex)
    })
    this.#uniforms.eye.value.copy(camera.three.position)
    this.#zeroSurface.cut(section, sideSeen(region, corners, section))
    this.#chooseFaces(region, display)
    this.#renderer.render(this.#scene, camera.three)
  }

  dispose(): void {
    this.canvas.removeEventListener('webglcontextlost', this.#onLost)
    this.canvas.removeEventListener('webglcontextrestored', this.#onRestored)
    this.#release()
    this.#renderer.dispose()
    this.#renderer.forceContextLoss()
  }

  readonly #onLost = (event: Event): void => {
    event.preventDefault() // or it would never be restored
    this.#painted = []
    this.#release()
    this.#watcher.lost()
  }

  /** What lay in the context is made anew when it is next drawn. */
  #release(): void {
    this.#geometry.dispose()
    this.#material.dispose()
    this.#section.geometry.dispose()
    this.#sectionMaterial.dispose()
    this.#zeroSurface.dispose()
  }

  readonly #onRestored = (): void => this.#watcher.restored()

  #resize({ width, height, pixelRatio }: Picture): void {
    const size = `${width} ${height} ${pixelRatio}`
    if (size === this.#size) return
    this.#size = size
    this.#renderer.setPixelRatio(pixelRatio)
    this.#renderer.setSize(width, height, false)
  }

  #writeColours({ report, scale, ramp, theme, pixelRatio, display, section, zeroSurface }: Picture): void {
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
      for (let i = 0; i <= RAMP_STEPS; i++) {
        uniforms.negativeStops.value[i]?.fromArray(ramp.negative[i] as Vec3)
        uniforms.positiveStops.value[i]?.fromArray(ramp.positive[i] as Vec3)
      }
      uniforms.ink.value.fromArray(theme.ink)
      uniforms.paper.value.fromArray(theme.paper)
      this.#zeroSurface.colour(theme)
    }
    uniforms.pixelRatio.value = pixelRatio
    uniforms.opacity.value.set(...(OPACITY[display] ?? OPAQUE))
    this.#section.visible = display === 'inside'
    this.#zeroSurface.update(display === 'inside' ? zeroSurface : null)
  }

  /** All faces, the farthest tiles first when they are see-through, or one alone. */
  #chooseFaces({ vertices, camera }: Region, display: FaceDisplay): void {
    const isVeil = display in OPACITY
    // Where faces are hardly seen their order is not.
    const seeThrough = display === 'see-through'
    this.#material.transparent = isVeil
    this.#material.depthWrite = !isVeil
    if (typeof display === 'number') this.#geometry.setDrawRange(display * FACE_INDICES, FACE_INDICES)
    else this.#geometry.setDrawRange(0, Infinity)
    if (!seeThrough && !this.#sorted) return
    this.#sorted = seeThrough
    const index = this.#geometry.index as BufferAttribute
    const indices = index.array as Uint16Array
    if (seeThrough) {
      farthestFirst(vertices, camera).forEach((tile, place) => {
        indices.set(this.#inOrder.subarray(tile * TILE_INDICES, (tile + 1) * TILE_INDICES), place * TILE_INDICES)
      })
    } else {
      indices.set(this.#inOrder)
    }
    index.needsUpdate = true
  }
}

/** Everything that a picture depends on. The scale is the report's. */
function contentsOf(picture: Picture): unknown[] {
  const { report, ramp, theme, display, section, zeroSurface, regions, width, height, pixelRatio } = picture
  const inside = display === 'inside' ? [section.axis, section.value, zeroSurface] : []
  const contents: unknown[] = [report, ramp, theme, display, ...inside, width, height, pixelRatio]
  for (const { left, top, vertices, camera } of regions) {
    const { projectionMatrix, matrixWorld } = camera.three
    contents.push(left, top, camera.width, camera.height, ...vertices.flat())
    contents.push(...projectionMatrix.elements, ...matrixWorld.elements)
  }
  return contents
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

function farthestFirst(vertices: readonly Vec3[], camera: SceneCamera): Uint16Array {
  const perFace = FACE_TILES * FACE_TILES
  const depths = new Float64Array(TILE_COUNT)
  for (let tile = 0; tile < TILE_COUNT; tile++) {
    const [s, t] = tileMiddle(tile % perFace)
    depths[tile] = camera.depth(facePoint(vertices, Math.floor(tile / perFace), s, t))
  }
  return Uint16Array.from(depths.keys()).sort((a, b) => (depths[b] as number) - (depths[a] as number))
}
