/**
 * A plane through the picture, to be moved by a pointer: its outline in the bounds of the mesh, a handle in its middle that slides it
 * along its normal, and one at the tip of the normal that turns it.
 */
import type { Vec3 } from '../model/hexahedron'
import type { Ray, SceneCamera } from '../scene/space/camera'
import type { Point } from '../scene/space/layout'
import { cross, dot, map3 } from '../scene/space/vec3'
import type { PictureSpace } from './mesh-picture'

/** Points of `normal`, of length 1, times the point equal to `offset`, in units of the mesh less its origin. */
export interface Plane {
  readonly normal: Vec3
  readonly offset: number
}

export interface PlaneHost {
  /** The plane is to be here. */
  move(plane: Plane): void
  rayOf(event: PointerEvent): Ray
}

/** CSS pixels of the normal's arrow, where it is seen from the side. */
const ARROW = 64
/** CSS pixels about a handle that take hold of it. */
const REACH = 22
const SVG = 'http://www.w3.org/2000/svg'

interface Drag {
  readonly pointer: number
  readonly which: 'slide' | 'turn'
  readonly plane: Plane
  /** Along the normal, in world space, when it began. */
  readonly along: number
  /** In world space. */
  readonly middle: Vec3
  readonly isFacing: boolean
}

export class PlaneHandle {
  readonly root = document.createElementNS(SVG, 'svg')
  readonly #host: PlaneHost
  readonly #outline = document.createElementNS(SVG, 'path')
  readonly #arrow = document.createElementNS(SVG, 'path')
  readonly #handles = { slide: handle('slide'), turn: handle('turn') }
  #plane: Plane | null = null
  #space: PictureSpace | null = null
  #drag: Drag | null = null

  constructor(host: PlaneHost) {
    this.#host = host
    this.root.classList.add('plane')
    this.root.setAttribute('aria-hidden', 'true')
    this.#outline.setAttribute('class', 'outline')
    this.#arrow.setAttribute('class', 'arrow')
    const { slide, turn } = this.#handles
    this.root.append(this.#outline, this.#arrow, slide, turn)
    for (const which of ['slide', 'turn'] as const) this.#listen(which, this.#handles[which])
  }

  /** Null hides it. The picture need not be drawn anew for it. */
  set plane(plane: Plane | null) {
    this.#plane = plane
    if (this.#space) this.draw(this.#space)
  }

  draw(space: PictureSpace): void {
    this.#space = space
    const { camera, scale, corners } = space
    // Until a mesh is open the picture has no bounds.
    const plane = corners.length > 0 ? this.#plane : null
    this.root.style.display = plane ? '' : 'none'
    if (!plane) return
    this.root.setAttribute('viewBox', `0 0 ${camera.width} ${camera.height}`)
    const outline = outlineOf(corners, plane.normal, plane.offset * scale)
    const middle = this.#drag?.which === 'turn' ? this.#drag.middle : middleOf(outline, corners, plane, scale)
    const tip = tipOf(camera, middle, plane.normal)
    const [from, to] = [camera.project(middle), camera.project(tip)]
    this.#outline.setAttribute('d', pathOf(outline.map(point => camera.project(point))))
    this.#arrow.setAttribute('d', `M${from.x.toFixed(1)} ${from.y.toFixed(1)}L${to.x.toFixed(1)} ${to.y.toFixed(1)}`)
    place(this.#handles.slide, from)
    place(this.#handles.turn, to)
  }

  #listen(which: Drag['which'], element: SVGElement): void {
    element.addEventListener('pointerdown', event => {
      const { button, pointerId } = event
      if (button !== 0 || this.#drag || !this.#plane || !this.#space) return
      event.stopPropagation()
      element.setPointerCapture(pointerId)
      const { camera, scale, corners } = this.#space
      const plane = this.#plane
      const middle = middleOf(outlineOf(corners, plane.normal, plane.offset * scale), corners, plane, scale)
      this.#drag = {
        pointer: pointerId,
        which,
        plane,
        along: alongOf(this.#host.rayOf(event), middle, plane.normal, camera),
        middle,
        isFacing: dot(camera.axes()[2], plane.normal) >= 0,
      }
    })
    element.addEventListener('pointermove', event => {
      const drag = this.#drag
      if (drag?.pointer !== event.pointerId || !this.#space) return
      event.stopPropagation()
      const { camera, scale } = this.#space
      const ray = this.#host.rayOf(event)
      if (drag.which === 'slide') {
        const moved = alongOf(ray, drag.middle, drag.plane.normal, camera) - drag.along
        this.#host.move({ normal: drag.plane.normal, offset: drag.plane.offset + moved / scale })
      } else {
        const normal = turnedTo(ray, drag.middle, drag.isFacing, camera)
        this.#host.move({ normal, offset: dot(normal, drag.middle) / scale })
      }
    })
    for (const type of ['pointerup', 'pointercancel'] as const)
      element.addEventListener(type, event => {
        const drag = this.#drag
        if (drag?.pointer !== event.pointerId) return
        event.stopPropagation()
        this.#drag = null
        if (type === 'pointercancel') this.#host.move(drag.plane)
      })
  }
}

/** Where the plane meets the edges of the box, in order around it. */
export function outlineOf(corners: readonly Vec3[], normal: Vec3, offset: number): Vec3[] {
  const heights = corners.map(corner => dot(corner, normal) - offset)
  const points: Vec3[] = []
  for (const [a, b] of BOX_EDGES) {
    const [from, to] = [heights[a], heights[b]]
    if (from === undefined || to === undefined || from < 0 === to < 0) continue
    const way = from / (from - to)
    points.push(
      map3(axis => (corners[a] as Vec3)[axis] + way * ((corners[b] as Vec3)[axis] - (corners[a] as Vec3)[axis])),
    )
  }
  if (points.length < 3) return []
  const middle = meanOf(points)
  const right = normalized(cross(normal, Math.abs(normal[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]))
  const up = cross(normal, right)
  const angle = (point: Vec3) => {
    const off = map3(axis => point[axis] - middle[axis])
    return Math.atan2(dot(off, up), dot(off, right))
  }
  return points.sort((a, b) => angle(a) - angle(b))
}

/** Corners as MeshPicture has them: z changes first, x last. */
const BOX_EDGES = [1, 2, 4].flatMap(step =>
  Array.from({ length: 8 }, (_, corner) => corner)
    .filter(corner => (corner & step) === 0)
    .map(corner => [corner, corner + step] as const),
)

/**
 * The normal whose tip is under the pointer. In the disc of the arrow's length about the middle it is that of the ball there, on the
 * side where it was; outwards from its rim it goes on to the other side, by as much as it would have inwards.
 */
export function turnedTo(ray: Ray, middle: Vec3, isFacing: boolean, camera: SceneCamera): Vec3 {
  const [right, up, back] = camera.axes()
  const depth = camera.depth(middle)
  const length = camera.lengthPerPixel(depth)
  // The pointer at the depth of the middle, in pixels to the right and up from it.
  const way = depth / -dot(ray.direction, back)
  const off = map3(axis => ray.origin[axis] + way * ray.direction[axis] - middle[axis])
  const [x, y] = [dot(off, right) / length, dot(off, up) / length]
  const distance = Math.hypot(x, y)
  const inside = Math.min(distance / ARROW, 1)
  const beyond = Math.min(Math.max(distance / ARROW - 1, 0), 1)
  const tilt = Math.asin(inside) + (beyond * Math.PI) / 2
  const [sine, cosine] = [Math.sin(tilt), (isFacing ? 1 : -1) * Math.cos(tilt)]
  const [u, v] = distance > 0 ? [x / distance, y / distance] : [0, 0]
  return normalized(map3(axis => sine * (u * right[axis] + v * up[axis]) + cosine * back[axis]))
}

/**
 * The place on the line through the middle along the normal that is nearest to the ray: with w from the middle to the ray's origin it is
 * (n.w - (n.d)(d.w)) / (1 - (n.d)^2). Where the line is seen from its end, a pixel upwards is a pixel along it.
 */
function alongOf({ origin, direction }: Ray, middle: Vec3, normal: Vec3, camera: SceneCamera): number {
  const off = map3(axis => origin[axis] - middle[axis])
  const turned = dot(normal, direction)
  const square = 1 - turned * turned
  if (square > END_ON) return (dot(normal, off) - turned * dot(direction, off)) / square
  const [, up, back] = camera.axes()
  const way = camera.depth(middle) / -dot(direction, back)
  return dot(
    map3(axis => off[axis] + way * direction[axis]),
    up,
  )
}

/** Squared sine of 10 degrees. */
const END_ON = 0.03

function tipOf(camera: SceneCamera, middle: Vec3, normal: Vec3): Vec3 {
  const length = ARROW * camera.lengthPerPixel(camera.depth(middle))
  return map3(axis => middle[axis] + length * normal[axis])
}

/** The middle of the outline; beside the box, the point of the plane that is nearest to the middle of that. */
function middleOf(outline: readonly Vec3[], corners: readonly Vec3[], { normal, offset }: Plane, scale: number): Vec3 {
  const middle = meanOf(outline.length > 0 ? outline : corners)
  const off = offset * scale - dot(normal, middle)
  return map3(axis => middle[axis] + off * normal[axis])
}

function meanOf(points: readonly Vec3[]): Vec3 {
  return map3(axis => points.reduce((sum, point) => sum + point[axis], 0) / points.length)
}

function normalized(vector: Vec3): Vec3 {
  const length = Math.sqrt(dot(vector, vector))
  return map3(axis => vector[axis] / length)
}

function pathOf(points: readonly (Point & { readonly depth: number })[]): string {
  if (points.length === 0 || points.some(({ depth }) => depth <= 0)) return ''
  return `M${points.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}Z`
}

function handle(which: Drag['which']): SVGElement {
  const group = document.createElementNS(SVG, 'g')
  group.setAttribute('class', which)
  for (const [name, radius] of [
    ['reach', REACH],
    ['knob', 6],
  ] as const) {
    const circle = document.createElementNS(SVG, 'circle')
    circle.setAttribute('class', name)
    circle.setAttribute('r', String(radius))
    group.append(circle)
  }
  return group
}

function place(element: SVGElement, { x, y }: Point): void {
  element.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})`)
}
