/**
 * A camera in world space, perspective with z up, and the projections between points and the screen that the overlay, picking
 * and dragging share. `three` renders with it; nothing here needs WebGL.
 */
import { PerspectiveCamera, Vector3 } from 'three'
import type { Vec3 } from '../../model/hexahedron'
import type { Insets, Point } from './layout'
import { at, dot, map3 } from './vec3'

/** Units from the top left of the camera's viewport; depth is the distance along the line of sight, positive in front. */
export interface ScreenPoint extends Point {
  readonly depth: number
}

export interface Ray {
  readonly origin: Vec3
  /** Unit length. */
  readonly direction: Vec3
}

/** The direction from the element to the camera by default: front, right of the middle, above. */
export const DEFAULT_DIRECTION: Vec3 = directionAt((-58 * Math.PI) / 180, (24 * Math.PI) / 180)

const FIELD_OF_VIEW = 28

/** The unit vector at these angles. */
export function directionAt(azimuth: number, elevation: number): Vec3 {
  return [Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation)]
}

export function azimuthOf([x, y]: Vec3): number {
  return Math.atan2(y, x)
}

/** Of a unit vector. */
export function elevationOf([, , z]: Vec3): number {
  return Math.asin(Math.max(-1, Math.min(1, z)))
}

export class SceneCamera {
  readonly three = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100)
  #width = 1
  #height = 1
  #insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 }

  constructor() {
    this.three.up.set(0, 0, 1)
    this.three.position.set(...map3(axis => 5 * at(DEFAULT_DIRECTION, axis)))
    this.three.lookAt(0, 0, 0)
    this.three.updateMatrixWorld()
  }

  get width(): number {
    return this.#width
  }

  get height(): number {
    return this.#height
  }

  /** The optical axis goes through the middle of the viewport without its insets. */
  resize(width: number, height: number, insets: Insets): void {
    this.#width = width
    this.#height = height
    this.#insets = insets
    this.three.aspect = width / height
    const x = (insets.right - insets.left) / 2
    const y = (insets.bottom - insets.top) / 2
    this.three.setViewOffset(width, height, x, y, width, height)
  }

  /** Near and far planes as tight as the points allow, for the depth buffer's sake. */
  enclose(points: readonly Vec3[]): void {
    this.three.updateMatrixWorld()
    const depths = points.map(point => this.depth(point))
    const farthest = Math.max(...depths, 1e-3)
    const nearest = Math.min(...depths)
    this.three.near = Math.max(nearest * 0.95, farthest * 1e-3)
    this.three.far = farthest * 1.05
    this.three.updateProjectionMatrix()
  }

  project([x, y, z]: Vec3): ScreenPoint {
    const v = scratch.set(x, y, z).applyMatrix4(this.three.matrixWorldInverse)
    const depth = -v.z
    v.applyMatrix4(this.three.projectionMatrix)
    return { x: ((v.x + 1) / 2) * this.#width, y: ((1 - v.y) / 2) * this.#height, depth }
  }

  depth([x, y, z]: Vec3): number {
    const e = this.three.matrixWorldInverse.elements
    return -((e[2] as number) * x + (e[6] as number) * y + (e[10] as number) * z + (e[14] as number))
  }

  /** The line of sight through a point of the screen. */
  ray(x: number, y: number): Ray {
    const origin = this.three.position
    scratch
      .set((2 * x) / this.#width - 1, 1 - (2 * y) / this.#height, 0.5)
      .unproject(this.three)
      .sub(origin)
      .normalize()
    return { origin: [origin.x, origin.y, origin.z], direction: [scratch.x, scratch.y, scratch.z] }
  }

  /** Unit vectors to the right, up, and towards the eye. */
  axes(): readonly [Vec3, Vec3, Vec3] {
    const e = this.three.matrixWorld.elements
    const column = (k: number): Vec3 => [e[4 * k] as number, e[4 * k + 1] as number, e[4 * k + 2] as number]
    return [column(0), column(1), column(2)]
  }

  /** Length in world space of one unit of the screen at a depth. */
  lengthPerPixel(depth: number): number {
    return (2 * depth * Math.tan((FIELD_OF_VIEW * Math.PI) / 360)) / this.#height
  }

  /**
   * The position of the camera from which all points, seen along the same line, just fill the viewport without its insets; the
   * point to orbit about, and its distance.
   *
   * With x right, y up, z towards the eye and tan_x the half-width of the picture at distance 1, a point is within the right
   * border iff x + z tan_x <= eye_x + eye_z tan_x, and within the left one iff -x + z tan_x <= -eye_x + eye_z tan_x. The
   * greatest left-hand sides R and L give the least eye_z = (R + L) / (2 tan_x) and eye_x = (R - L) / 2.
   */
  fitted(points: readonly Vec3[]): { readonly eye: Vec3; readonly target: Vec3; readonly distance: number } {
    this.three.updateMatrixWorld()
    const [right, up, back] = this.axes()
    const { top, right: insetRight, bottom, left } = this.#insets
    const half = Math.tan((FIELD_OF_VIEW * Math.PI) / 360)
    const tanX = (half * Math.max(this.#width - left - insetRight, 40)) / this.#height
    const tanY = (half * Math.max(this.#height - top - bottom, 40)) / this.#height
    const along = (axis: Vec3, sign: number, tan: number) =>
      Math.max(...points.map(point => sign * dot(point, axis) + tan * dot(point, back)))
    const [r, l] = [along(right, 1, tanX), along(right, -1, tanX)]
    const [u, d] = [along(up, 1, tanY), along(up, -1, tanY)]
    const nearest = Math.max(...points.map(point => dot(point, back)))
    const farthest = Math.min(...points.map(point => dot(point, back)))
    const eyeZ = Math.max((r + l) / (2 * tanX), (u + d) / (2 * tanY), nearest + 0.05)
    const eye = map3(axis => at(right, axis) * ((r - l) / 2) + at(up, axis) * ((u - d) / 2) + at(back, axis) * eyeZ)
    const distance = eyeZ - (nearest + farthest) / 2
    return { eye, target: map3(axis => at(eye, axis) - at(back, axis) * distance), distance }
  }

  /** Fits all points, looking along the same line or from the given direction. Returns the point to orbit about. */
  fit(points: readonly Vec3[], from?: Vec3): Vec3 {
    const { three } = this
    if (from) {
      three.position.set(...from)
      three.lookAt(0, 0, 0)
    }
    const { eye, target } = this.fitted(points)
    three.position.set(...eye)
    three.updateMatrixWorld()
    return target
  }
}

const scratch = new Vector3()
