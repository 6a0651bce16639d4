/** A camera with the hands and keys that turn it, and two of them that turn together. */

import { Vector3 } from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import type { Vec3 } from '../../model/hexahedron'
import { type CameraView, type State, sliceOf } from '../../model/state'
import { sceneSlice } from '../../views/scene-slices'
import { azimuthOf, DEFAULT_DIRECTION, directionAt, elevationOf, SceneCamera } from './camera'
import { at, map3 } from './vec3'

const ORBIT_STEP = Math.PI / 12
/** Nobody sees more of a picture that is thousands of pixels wide. */
const DECIMALS = 6
/** Beyond this there is next to nothing to see. */
const FAR = 1000
/** The view in which the element just fits. */
export const DEFAULT_VIEW: CameraView = { direction: rounded(DEFAULT_DIRECTION), zoom: 1, pan: [0, 0, 0] }

export interface Pose {
  readonly position: Vector3
  readonly target: Vector3
}

export class OrbitCamera {
  readonly camera = new SceneCamera()
  readonly #controls: OrbitControls

  /** `onChange` is told of every move of the camera. */
  constructor(element: HTMLElement, onChange: () => void) {
    this.#controls = new OrbitControls(this.camera.three, element)
    element.style.touchAction = '' // the style sheet decides; the controls would take the page's scroll
    this.#controls.zoomToCursor = true
    this.#controls.zoomSpeed = 1.6
    this.#controls.minDistance = 0.05
    this.#controls.maxDistance = 1000
    this.#controls.addEventListener('change', onChange)
  }

  /** The unit vector from the target of the orbit to the camera. */
  get direction(): Vec3 {
    const { x, y, z } = this.camera.three.position.clone().sub(this.#controls.target).normalize()
    return [x, y, z]
  }

  /** Keeps the distance. */
  set direction([x, y, z]: Vec3) {
    const { target } = this.#controls
    const { position } = this.camera.three
    const distance = position.distanceTo(target)
    position.set(x, y, z).multiplyScalar(distance).add(target)
    this.#controls.update()
  }

  get pose(): Pose {
    return { position: this.camera.three.position.clone(), target: this.#controls.target.clone() }
  }

  set pose({ position, target }: Pose) {
    this.camera.three.position.copy(position)
    this.#controls.target.copy(target)
    this.#controls.update()
  }

  /** Turns it in steps to the right and up, never over the pole. */
  turn(right: number, up: number): void {
    const { direction } = this
    const most = Math.PI / 2 - 0.01
    const elevation = Math.max(-most, Math.min(most, elevationOf(direction) + up * ORBIT_STEP))
    this.direction = directionAt(azimuthOf(direction) + right * ORBIT_STEP, elevation)
  }

  zoom(factor: number): void {
    const { target } = this.#controls
    this.camera.three.position.sub(target).divideScalar(factor).add(target)
    this.#controls.update()
  }

  /** Fits all points, along the same line of sight or from the given direction. */
  fit(points: readonly Vec3[], from?: Vec3): void {
    this.#controls.target.set(...this.camera.fit(points, from))
    this.#controls.update()
  }

  /** The camera relative to the fitted one, lengths by `halfExtent`, half of the element's longest side; null by default. */
  cameraView(points: readonly Vec3[], halfExtent: number): CameraView | null {
    const fitted = this.camera.fitted(points)
    const { target } = this.#controls
    const pan = target
      .clone()
      .sub(scratch.set(...fitted.target))
      .divideScalar(halfExtent)
    const zoom = fitted.distance / this.camera.three.position.distanceTo(target)
    const direction = rounded(this.direction)
    // An element far out of sight is brought back.
    if (!(zoom >= 1 / FAR && zoom <= FAR && pan.length() <= FAR)) return { ...DEFAULT_VIEW, direction }
    const view: CameraView = { direction, zoom: decimal(zoom), pan: rounded([pan.x, pan.y, pan.z]) }
    return isDefault(view) ? null : view
  }

  /** Inverse of `cameraView`. */
  look(points: readonly Vec3[], halfExtent: number, view: CameraView | null): void {
    const { position } = this.camera.three
    const { target } = this.#controls
    target.set(...this.camera.fit(points, view?.direction ?? DEFAULT_DIRECTION))
    if (view) {
      scratch.set(...map3(axis => at(view.pan, axis) * halfExtent))
      position.sub(target).divideScalar(view.zoom).add(target).add(scratch)
      target.add(scratch)
    }
    this.#controls.update()
  }

  dispose(): void {
    this.#controls.dispose()
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
