/** A camera and the hands and keys that turn it. */

import type { Vector3 } from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import type { Vec3 } from '../../model/hexahedron'
import { DEFAULT_DIRECTION, SceneCamera } from './camera'

const ORBIT_STEP = Math.PI / 12

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

  dispose(): void {
    this.#orbit.dispose()
  }
}

function clamped(value: number, most: number): number {
  return Math.max(-most, Math.min(most, value))
}
