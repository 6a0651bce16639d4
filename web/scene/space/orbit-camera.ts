/** A camera that is turned, moved and zoomed about a point, and two of them that turn together. */

import { Vector3 } from 'three'
import type { Vec3 } from '../../model/hexahedron'
import { type CameraView, type State, sliceOf } from '../../model/state'
import { sceneSlice } from '../../views/scene-slices'
import { azimuthOf, DEFAULT_DIRECTION, directionAt, elevationOf, SceneCamera } from './camera'
import type { Point } from './layout'
import { at, map3 } from './vec3'

const ORBIT_STEP = Math.PI / 12
/** Nobody sees more of a picture that is thousands of pixels wide. */
const DECIMALS = 6
/** Beyond this there is next to nothing to see. */
const FAR = 1000
const DISTANCE = { least: 0.05, most: 1000 }
/** Right above the target the camera would have no upper side. */
const MOST_ELEVATION = Math.PI / 2 - 1e-6
/** The view in which the element just fits. */
export const DEFAULT_VIEW: CameraView = { direction: rounded(DEFAULT_DIRECTION), zoom: 1, pan: [0, 0, 0] }

export interface Pose {
  readonly position: Vector3
  readonly target: Vector3
}

export class OrbitCamera {
  readonly camera = new SceneCamera()
  readonly #target = new Vector3()
  readonly #onChange: () => void
  #told: Pose = this.pose

  /** `onChange` is told of every move of the camera. */
  constructor(onChange: () => void) {
    this.#onChange = onChange
  }

  /** The unit vector from the target of the orbit to the camera. */
  get direction(): Vec3 {
    const { x, y, z } = this.camera.three.position.clone().sub(this.#target).normalize()
    return [x, y, z]
  }

  /** Keeps the distance. */
  set direction(direction: Vec3) {
    this.#place(direction, this.#distance)
    this.#settle()
  }

  get pose(): Pose {
    return { position: this.camera.three.position.clone(), target: this.#target.clone() }
  }

  set pose({ position, target }: Pose) {
    this.camera.three.position.copy(position)
    this.#target.copy(target)
    this.#settle()
  }

  get #distance(): number {
    return this.camera.three.position.distanceTo(this.#target)
  }

  /** Turns it in steps to the right and up, never over the pole. */
  turn(right: number, up: number): void {
    this.turnBy(right * ORBIT_STEP, up * ORBIT_STEP)
  }

  /** Turns it by angles to the right and up. */
  turnBy(right: number, up: number): void {
    const { direction } = this
    this.direction = directionAt(azimuthOf(direction) + right, safe(elevationOf(direction) + up))
  }

  /** Moves what is seen at the depth of the target, in units of the screen. */
  pan(x: number, y: number): void {
    const [right, up] = this.camera.axes()
    const length = this.camera.lengthPerPixel(this.#distance)
    const { position } = this.camera.three
    for (const point of [position, this.#target])
      point.add(scratch.set(...map3(axis => (at(up, axis) * y - at(right, axis) * x) * length)))
    this.#settle()
  }

  /** What is seen at a point of the screen, by default that of the target, stays there. */
  zoom(factor: number, seen?: Point): void {
    const { position } = this.camera.three
    const { direction } = this
    const before = this.#distance
    const after = inReach(before / factor)
    const towards = seen ? this.camera.ray(seen.x, seen.y).direction : map3(axis => -at(direction, axis))
    position.addScaledVector(scratch.set(...towards), before - after)
    this.#target.copy(position).addScaledVector(scratch.set(...direction), -after)
    this.#settle()
  }

  /** Fits all points, along the same line of sight or from the given direction. */
  fit(points: readonly Vec3[], from?: Vec3): void {
    this.#target.set(...this.camera.fit(points, from))
    this.#settle()
  }

  /** The camera relative to the fitted one, lengths by `halfExtent`, half of the element's longest side; null by default. */
  cameraView(points: readonly Vec3[], halfExtent: number): CameraView | null {
    const fitted = this.camera.fitted(points)
    const pan = this.#target
      .clone()
      .sub(scratch.set(...fitted.target))
      .divideScalar(halfExtent)
    const zoom = fitted.distance / this.#distance
    const direction = rounded(this.direction)
    // An element far out of sight is brought back.
    if (!(zoom >= 1 / FAR && zoom <= FAR && pan.length() <= FAR)) return { ...DEFAULT_VIEW, direction }
    const view: CameraView = { direction, zoom: decimal(zoom), pan: rounded([pan.x, pan.y, pan.z]) }
    return isDefault(view) ? null : view
  }

  /** Inverse of `cameraView`. */
  look(points: readonly Vec3[], halfExtent: number, view: CameraView | null): void {
    const { position } = this.camera.three
    const target = this.#target
    target.set(...this.camera.fit(points, view?.direction ?? DEFAULT_DIRECTION))
    if (view) {
      scratch.set(...map3(axis => at(view.pan, axis) * halfExtent))
      position.sub(target).divideScalar(view.zoom).add(target).add(scratch)
      target.add(scratch)
    }
    this.#settle()
  }

  #place(direction: Vec3, distance: number): void {
    this.camera.three.position
      .set(...direction)
      .multiplyScalar(distance)
      .add(this.#target)
  }

  /** Looks at the target, not from right above and not from out of reach. */
  #settle(): void {
    const { direction } = this
    const [elevation, distance] = [elevationOf(direction), this.#distance]
    const [safeElevation, safeDistance] = [safe(elevation), inReach(distance)]
    if (elevation !== safeElevation || distance !== safeDistance)
      this.#place(directionAt(azimuthOf(direction), safeElevation), safeDistance)
    const { three } = this.camera
    three.lookAt(this.#target)
    three.updateMatrixWorld()
    if (three.position.equals(this.#told.position) && this.#target.equals(this.#told.target)) return
    this.#told = this.pose
    this.#onChange()
  }
}

/** The element's camera and the reference cube's, which look along one line while they are linked. */
export class LinkedCameras {
  /** The reference cube's; null before it is first shown. */
  other: OrbitCamera | null = null
  readonly #own: OrbitCamera
  readonly #state: () => State
  #isFollowing = false

  constructor(own: OrbitCamera, state: () => State) {
    this.#own = own
    this.#state = state
  }

  /** Turns the other one as `from` was turned. */
  follow(from: OrbitCamera): void {
    const to = from === this.#own ? this.other : this.#own
    if (!to || !areLinked(this.#state()) || this.#isFollowing) return
    this.#isFollowing = true
    to.direction = from.direction
    this.#isFollowing = false
  }

  /** A cube that has just been shown or linked is seen along the element's line. */
  join(state: State, before: State | null): void {
    if (areLinked(state) && !(before && areLinked(before))) this.follow(this.#own)
  }
}

function areLinked(state: State): boolean {
  const { referenceShown, camerasLinked } = sliceOf(sceneSlice, state)
  return referenceShown && camerasLinked
}

const scratch = new Vector3()

function safe(elevation: number): number {
  return Math.max(-MOST_ELEVATION, Math.min(MOST_ELEVATION, elevation))
}

function inReach(distance: number): number {
  return Math.max(DISTANCE.least, Math.min(DISTANCE.most, distance))
}

function isDefault(view: CameraView): boolean {
  const numbers = ({ direction, zoom, pan }: CameraView) => [...direction, zoom, ...pan]
  return numbers(view).every((value, i) => value === numbers(DEFAULT_VIEW)[i])
}

function rounded([x, y, z]: Vec3): Vec3 {
  return [decimal(x), decimal(y), decimal(z)]
}

/** Plus zero, never minus. */
function decimal(value: number): number {
  return Number(value.toFixed(DECIMALS)) + 0
}
