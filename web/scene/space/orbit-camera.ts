/** A camera and the hands and keys that turn it. */
import { Vector3 } from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import type { Vec3 } from '../../model/hexahedron'
import type { CameraView } from '../../model/state'
import { DEFAULT_DIRECTION, SceneCamera } from './camera'
import { at, map3 } from './world'

const ORBIT_STEP = Math.PI / 12
/** Nobody sees more of a picture that is thousands of pixels wide. */
const DECIMALS = 6
/** Beyond this there is next to nothing to see. */
const FAR = 1000
const FITTED: CameraView = { direction: rounded(DEFAULT_DIRECTION), zoom: 1, pan: [0, 0, 0] }

export interface Pose {
  readonly position: Vector3
  readonly target: Vector3
}

export class Viewpoint {
  readonly camera = new SceneCamera()
  readonly #orbit: OrbitControls

  /** `onChange` is told of every move of the camera. */
  constructor(element: HTMLElement, onChange: () => void) {
    this.#orbit = new OrbitControls(this.camera.three, element)
    element.style.touchAction = '' // the style sheet decides; the controls would take the page's scroll
    this.#orbit.zoomToCursor = true
    this.#orbit.zoomSpeed = 1.6
    this.#orbit.minDistance = 0.05
    this.#orbit.maxDistance = 1000
    this.#orbit.addEventListener('change', onChange)
  }

  /** From where the camera looks at what it turns about: a unit vector. */
  get direction(): Vec3 {
    const { x, y, z } = this.camera.three.position.clone().sub(this.#orbit.target).normalize()
    return [x, y, z]
  }

  /** Looks from there, at the same distance. */
  set direction([x, y, z]: Vec3) {
    const { target } = this.#orbit
    const { position } = this.camera.three
    const distance = position.distanceTo(target)
    position.set(x, y, z).multiplyScalar(distance).add(target)
    this.#orbit.update()
  }

  /** Where the camera is and what it turns about, to come back to. */
  get pose(): Pose {
    return { position: this.camera.three.position.clone(), target: this.#orbit.target.clone() }
  }

  set pose({ position, target }: Pose) {
    this.camera.three.position.copy(position)
    this.#orbit.target.copy(target)
    this.#orbit.update()
  }

  /** In steps to the right and up, never over the pole. */
  turn(right: number, up: number): void {
    const [x, y, z] = this.direction
    const azimuth = Math.atan2(y, x) + right * ORBIT_STEP
    const most = Math.PI / 2 - 0.01
    const elevation = clamped(Math.asin(clamped(z, 1)) + up * ORBIT_STEP, most)
    const across = Math.cos(elevation)
    this.direction = [across * Math.cos(azimuth), across * Math.sin(azimuth), Math.sin(elevation)]
  }

  zoom(factor: number): void {
    const { three } = this.camera
    three.position.sub(this.#orbit.target).divideScalar(factor).add(this.#orbit.target)
    this.#orbit.update()
  }

  /** All points in view, along the same line of sight or in the default direction. */
  aim(points: readonly Vec3[], toDefault: boolean): void {
    this.#orbit.target.set(...this.camera.fit(points, toDefault ? DEFAULT_DIRECTION : undefined))
    this.#orbit.update()
  }

  /** How the points are looked at, with half of the element's longest side as `unit`; null in the default view. */
  seen(points: readonly Vec3[], unit: number): CameraView | null {
    const fitted = this.camera.fitted(points)
    const { target } = this.#orbit
    const pan = target
      .clone()
      .sub(scratch.set(...fitted.target))
      .divideScalar(unit)
    const zoom = fitted.distance / this.camera.three.position.distanceTo(target)
    const direction = rounded(this.direction)
    // What has gone far out of sight is brought back into view.
    if (!(zoom >= 1 / FAR && zoom <= FAR && pan.length() <= FAR)) return { ...FITTED, direction }
    const view: CameraView = { direction, zoom: decimal(zoom), pan: rounded([pan.x, pan.y, pan.z]) }
    return isFitted(view) ? null : view
  }

  /** Looks at the points so. */
  look(points: readonly Vec3[], unit: number, view: CameraView | null): void {
    const { position } = this.camera.three
    const { target } = this.#orbit
    target.set(...this.camera.fit(points, view?.direction ?? DEFAULT_DIRECTION))
    if (view) {
      scratch.set(...map3(axis => at(view.pan, axis) * unit))
      position.sub(target).divideScalar(view.zoom).add(target).add(scratch)
      target.add(scratch)
    }
    this.#orbit.update()
  }

  dispose(): void {
    this.#orbit.dispose()
  }
}

function clamped(value: number, most: number): number {
  return Math.max(-most, Math.min(most, value))
}

const scratch = new Vector3()

function isFitted(view: CameraView): boolean {
  const numbers = ({ direction, zoom, pan }: CameraView) => [...direction, zoom, ...pan]
  return numbers(view).every((value, i) => value === numbers(FITTED)[i])
}

function rounded([x, y, z]: Vec3): Vec3 {
  return [decimal(x), decimal(y), decimal(z)]
}

/** Plus zero, never minus. */
function decimal(value: number): number {
  return Number(value.toFixed(DECIMALS)) + 0
}
