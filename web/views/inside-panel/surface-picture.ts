/** The surface jacdet = 0 in the reference cube, as the skin of the negative part, with the section and both minimizers. */
import type { Report } from '../../core/report'
import { pointOn } from '../../core/section'
import { type Surface, zeroSurface } from '../../core/zero-surface'
import { edgeVertices, type Vec3, vertexReference } from '../../model/hexahedron'
import type { Section } from '../../model/state'
import { cssColour, type Rgb, type Theme } from '../colour-map'
import { lowerInside } from '../inside'
import { AXIS_NAMES } from './section-map'
import { along, hiddenVertex, type Turned, turnedBy } from './turned-cube'

export interface SurfacePicture {
  readonly report: Report
  readonly section: Section
  readonly theme: Theme
  readonly isMoving: boolean
  /** Degrees about the upright axis. */
  readonly turn: number
}

const CELLS = 20
const GESTURE_CELLS = 6
/** Size of the picture, in units of which one is about a CSS pixel, and of the cube's edges in it. */
export const WIDTH = 320
export const HEIGHT = 300
const EDGE = 172
const PIXEL_RATIO = 2
const TONES = 32
/** From an edge to its name, in edges. */
const AWAY = 0.06
/** From over the reader's left shoulder: right, up, towards the eye. */
const LIGHT = [-0.35, 0.6, 0.72] as const

type Place = readonly [number, number]

interface Skin {
  readonly front: readonly string[]
  readonly back: readonly string[]
}

export class SurfaceCanvas {
  readonly canvas = Object.assign(document.createElement('canvas'), {
    width: WIDTH * PIXEL_RATIO,
    height: HEIGHT * PIXEL_RATIO,
  })
  readonly #context = this.canvas.getContext('2d')
  #mesh: { readonly report: Report; readonly cells: number; readonly surface: Surface } | null = null
  #skin: { readonly theme: Theme; readonly skin: Skin } | null = null
  #drawn: readonly unknown[] = []

  /** Whether there is a surface. */
  update({ report, section, theme, isMoving, turn }: SurfacePicture): boolean {
    const surface = this.#surfaceOf(report, isMoving)
    const drawn = [surface, report, section, theme, turn]
    if (this.#context && !drawn.every((value, i) => value === this.#drawn[i])) {
      this.#drawn = drawn
      this.#draw(this.#context, surface, report, section, theme, turnedBy(turn))
    }
    return surface.triangles.length > 0
  }

  /** Coarser while a gesture runs; what is already finer stays. */
  #surfaceOf(report: Report, isMoving: boolean): Surface {
    const cells = isMoving ? GESTURE_CELLS : CELLS
    if (this.#mesh?.report !== report || this.#mesh.cells < cells)
      this.#mesh = { report, cells, surface: zeroSurface(report.bernstein, cells) }
    return this.#mesh.surface
  }

  #draw(
    context: CanvasRenderingContext2D,
    surface: Surface,
    report: Report,
    { axis, value }: Section,
    theme: Theme,
    turned: Turned,
  ): void {
    const place = (point: Vec3): Place => [
      WIDTH / 2 + EDGE * along(turned.right, point),
      HEIGHT / 2 - EDGE * along(turned.up, point),
    ]
    if (this.#skin?.theme !== theme) this.#skin = { theme, skin: skinOf(theme) }
    const [ink, paper, muted] = [theme.ink, theme.paper, mix(theme.ink, theme.paper, 0.4)].map(cssColour) as [
      string,
      string,
      string,
    ]
    context.setTransform(PIXEL_RATIO, 0, 0, PIXEL_RATIO, 0, 0)
    context.clearRect(0, 0, WIDTH, HEIGHT)
    context.lineJoin = 'round'
    const hidden = hiddenVertex(turned)
    const edges = edgeVertices.map(ends => ends.map(v => place(vertexReference[v] as Vec3)))
    const isHidden = (edge: number) => edgeVertices[edge]?.includes(hidden)
    context.lineWidth = 1
    stroke(
      context,
      muted,
      edges.filter((_, edge) => isHidden(edge)),
    )
    drawSkin(context, surface, turned, this.#skin.skin)
    const corners = [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
      [0, 0],
    ].map(([s, t]) => place(pointOn(axis, value, s as number, t as number)))
    context.lineWidth = 4
    stroke(context, paper, [corners])
    context.lineWidth = 1.75
    stroke(context, ink, [corners])
    context.lineWidth = 1
    stroke(
      context,
      muted,
      edges.filter((_, edge) => !isHidden(edge)),
    )
    drawNames(context, turned, muted)
    const inside = lowerInside(report)
    const hue = (least: number) => cssColour(least > 0 ? theme.positive : theme.negative)
    drawRing(context, place(report.minimizer.point), hue(report.boundaryMinimum), paper, false)
    if (inside) drawRing(context, place(inside.point), hue(inside.upper), paper, true)
  }
}

/** Farthest first; each triangle is outlined in its own colour, or the paper would shine through between them. */
function drawSkin(context: CanvasRenderingContext2D, { points, triangles }: Surface, turned: Turned, skin: Skin): void {
  const count = points.length / 3
  const seen = new Float64Array(3 * count)
  for (let v = 0; v < count; v++) {
    const point = [points[3 * v], points[3 * v + 1], points[3 * v + 2]] as unknown as Vec3
    seen[3 * v] = along(turned.right, point)
    seen[3 * v + 1] = along(turned.up, point)
    seen[3 * v + 2] = along(turned.eye, point)
  }
  const normals = normalsOf(seen, triangles)
  const at = (array: ArrayLike<number>, corner: number, k: number) =>
    array[3 * (triangles[corner] as number) + k] as number
  const depths = Float64Array.from({ length: triangles.length / 3 }, (_, i) =>
    [0, 1, 2].reduce((sum, k) => sum + at(seen, 3 * i + k, 2), 0),
  )
  const order = Uint32Array.from(depths.keys()).sort((a, b) => (depths[a] as number) - (depths[b] as number))
  context.lineWidth = 0.75
  for (const i of order) {
    let [nx, ny, nz] = [0, 0, 0]
    for (let k = 0; k < 3; k++) {
      nx += at(normals, 3 * i + k, 0)
      ny += at(normals, 3 * i + k, 1)
      nz += at(normals, 3 * i + k, 2)
    }
    const side = nz >= 0 ? 1 : -1
    const light = (side * (nx * LIGHT[0] + ny * LIGHT[1] + nz * LIGHT[2])) / (Math.hypot(nx, ny, nz) || 1)
    const tones = side > 0 ? skin.front : skin.back
    const tone = tones[Math.max(0, Math.min(TONES - 1, Math.floor(light * TONES)))] as string
    context.beginPath()
    for (let k = 0; k < 3; k++) {
      context.lineTo(WIDTH / 2 + EDGE * at(seen, 3 * i + k, 0), HEIGHT / 2 - EDGE * at(seen, 3 * i + k, 1))
    }
    context.closePath()
    context.fillStyle = tone
    context.strokeStyle = tone
    context.fill()
    context.stroke()
  }
}

/** Of each vertex: the sum of its triangles' normals, each as long as its triangle is large. */
function normalsOf(points: Float64Array, triangles: Uint32Array): Float64Array {
  const normals = new Float64Array(points.length)
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * (triangles[i] as number), 3 * (triangles[i + 1] as number), 3 * (triangles[i + 2] as number)]
    const [ux, uy, uz] = [0, 1, 2].map(k => (points[b + k] as number) - (points[a + k] as number)) as [
      number,
      number,
      number,
    ]
    const [vx, vy, vz] = [0, 1, 2].map(k => (points[c + k] as number) - (points[a + k] as number)) as [
      number,
      number,
      number,
    ]
    for (const vertex of [a, b, c]) {
      normals[vertex] = (normals[vertex] as number) + uy * vz - uz * vy
      normals[vertex + 1] = (normals[vertex + 1] as number) + uz * vx - ux * vz
      normals[vertex + 2] = (normals[vertex + 2] as number) + ux * vy - uy * vx
    }
  }
  return normals
}

/** Outside it is the skin of the negative part; who looks at its inner side looks out of that part. */
function skinOf({ paper, ink, negative, neutral }: Theme): Skin {
  const dark: Rgb = sum(ink) < sum(paper) ? ink : paper
  const tones = (light: Rgb, shade: Rgb) =>
    Array.from({ length: TONES }, (_, i) => cssColour(mix(shade, light, i / (TONES - 1))))
  const outer = mix(neutral, negative, 0.5)
  const inner = mix(neutral, negative, 0.16)
  return { front: tones(outer, mix(outer, dark, 0.42)), back: tones(inner, mix(inner, dark, 0.3)) }
}

/** Below the two edges of the bottom that are in front, and beside the upright one at the left. */
function drawNames(context: CanvasRenderingContext2D, turned: Turned, colour: string): void {
  const { right, eye } = turned
  const nearer = (component: number) => (component < 0 ? -AWAY : 1 + AWAY)
  const [leftXi, leftEta] = [right[0] > 0 ? 0 : 1, right[1] > 0 ? 0 : 1]
  const places: readonly Vec3[] = [
    [0.5, nearer(eye[1]), 0],
    [nearer(eye[0]), 0.5, 0],
    [leftXi, leftEta, 0.5],
  ]
  context.fillStyle = colour
  context.font = '13px system-ui, sans-serif'
  context.textAlign = 'center'
  context.textBaseline = 'middle'
  places.forEach((point, axis) => {
    const [x, y] = [WIDTH / 2 + EDGE * along(right, point), HEIGHT / 2 - EDGE * along(turned.up, point)]
    const [aside, below] = axis === 2 ? [-12, 0] : [0, 8]
    context.fillText(AXIS_NAMES[axis] as string, x + aside, y + below)
  })
}

function drawRing(
  context: CanvasRenderingContext2D,
  [x, y]: Place,
  colour: string,
  paper: string,
  full: boolean,
): void {
  const circle = (radius: number) => {
    context.beginPath()
    context.arc(x, y, radius, 0, 2 * Math.PI)
  }
  circle(7)
  context.lineWidth = 5
  context.strokeStyle = paper
  context.stroke()
  context.fillStyle = full ? colour : paper
  context.fill()
  context.lineWidth = 2
  context.strokeStyle = colour
  context.stroke()
  circle(2.5)
  context.fillStyle = full ? paper : colour
  context.fill()
}

function stroke(context: CanvasRenderingContext2D, colour: string, lines: readonly (readonly Place[])[]): void {
  context.beginPath()
  for (const [first, ...rest] of lines) {
    if (first) context.moveTo(...first)
    for (const place of rest) context.lineTo(...place)
  }
  context.strokeStyle = colour
  context.stroke()
}

function mix(a: Rgb, b: Rgb, way: number): Rgb {
  return [a[0] + (b[0] - a[0]) * way, a[1] + (b[1] - a[1]) * way, a[2] + (b[2] - a[2]) * way]
}

function sum([r, g, b]: Rgb): number {
  return r + g + b
}
