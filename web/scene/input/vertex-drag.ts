/**
 * The geometry of dragging one vertex, from pointer positions to coordinates: in the plane parallel to the screen through the
 * vertex, in depth along the line of sight, or along one axis; rounded to what a pixel can tell, or to a grid.
 */
import type { Axis, Vec3 } from '../../model/hexahedron'
import type { DragKeys } from '../../views/scene-slices'
import type { SceneCamera } from '../space/camera'
import { gridStep, lengthOf, roundingStep, roundTo, type Step } from '../space/decimal-step'
import { at, dot, map3 } from '../space/vec3'
import { finite, toWorld, type World } from '../space/world'

export interface DragStart {
  readonly camera: SceneCamera
  readonly world: World
  /** Physical position of the vertex, and the longest side of the element. */
  readonly position: Vec3
  readonly extent: number
  readonly x: number
  readonly y: number
}

/** Units of the screen that change the distance from the eye by a factor of e. */
const DEPTH_PIXELS = 500
/** Squared sine of the angle between axis and line of sight below which the axis is a point on the screen. */
const END_ON = 0.02

export class VertexDrag {
  readonly #start: DragStart
  readonly #startInWorld: Vec3
  readonly #rounding: Step
  readonly #grid: Step
  /** The start of the present move in the plane or in depth. */
  #base: Vec3
  #baseX: number
  #baseY: number
  #inDepth = false
  #position: Vec3
  #x: number
  #y: number

  constructor(start: DragStart) {
    this.#start = start
    this.#startInWorld = toWorld(start.world, start.position)
    const pixel = start.camera.lengthPerPixel(start.camera.depth(this.#startInWorld))
    this.#rounding = roundingStep(pixel * start.world.size)
    this.#grid = gridStep(start.extent)
    this.#base = this.#position = this.#startInWorld
    this.#baseX = this.#x = start.x
    this.#baseY = this.#y = start.y
  }

  /** The vertex's new physical position. A coordinate that hardly changed is kept to the last bit. */
  moveTo(x: number, y: number, keys: DragKeys): Vec3 {
    if (keys.depth !== this.#inDepth) this.#rebase(keys.depth)
    this.#x = x
    this.#y = y
    if (keys.axis !== null) this.#position = this.#alongAxis(keys.axis)
    else this.#position = keys.depth ? this.#inwards() : this.#inPlane()
    const step = keys.snap ? this.#grid : this.#rounding
    return map3(axis => {
      const moved = (at(this.#position, axis) - at(this.#startInWorld, axis)) * this.#start.world.size
      const before = at(this.#start.position, axis)
      if (Math.abs(moved) < lengthOf(this.#rounding) / 2) return before
      return finite(roundTo(finite(before + moved), step))
    })
  }

  #rebase(inDepth: boolean): void {
    this.#inDepth = inDepth
    this.#base = this.#position
    this.#baseX = this.#x
    this.#baseY = this.#y
  }

  #inPlane(): Vec3 {
    const from = this.#onPlane(this.#baseX, this.#baseY)
    const to = this.#onPlane(this.#x, this.#y)
    return map3(axis => at(this.#base, axis) + at(to, axis) - at(from, axis))
  }

  /** The point of the plane parallel to the screen through the base that is seen at (x, y). */
  #onPlane(x: number, y: number): Vec3 {
    const { camera } = this.#start
    const { origin, direction } = camera.ray(x, y)
    const distance = camera.depth(this.#base) / -dot(direction, camera.axes()[2])
    return map3(axis => at(origin, axis) + at(direction, axis) * distance)
  }

  /** Up is away; never through the eye. */
  #inwards(): Vec3 {
    const eye = this.#start.camera.ray(0, 0).origin
    const factor = Math.exp((this.#baseY - this.#y) / DEPTH_PIXELS)
    return map3(axis => at(eye, axis) + (at(this.#base, axis) - at(eye, axis)) * factor)
  }

  #alongAxis(axis: Axis): Vec3 {
    const moved = this.#nearestOnAxis(axis, this.#x, this.#y) - this.#nearestOnAxis(axis, this.#start.x, this.#start.y)
    return map3(k => at(this.#startInWorld, k) + (k === axis ? moved : 0))
  }

  /**
   * The position, along the axis through the vertex, of the point nearest to the line of sight through (x, y). With w from the
   * eye to the vertex, e the axis and d the line (unit vectors): t = ((e.d)(d.w) - e.w) / (1 - (e.d)^2). An axis seen end on
   * follows the pointer upwards instead.
   */
  #nearestOnAxis(axis: Axis, x: number, y: number): number {
    const { camera } = this.#start
    const { origin, direction } = camera.ray(x, y)
    const w = map3(k => at(this.#startInWorld, k) - at(origin, k))
    const along = at(direction, axis)
    const sine2 = 1 - along * along
    if (sine2 >= END_ON) return (along * dot(direction, w) - at(w, axis)) / sine2
    return -y * camera.lengthPerPixel(camera.depth(this.#startInWorld)) * Math.sign(along)
  }
}
