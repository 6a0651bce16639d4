/**
 * Pointing at a point: a mouse or pen by hovering, with no button pressed; a finger by a tap. What a mouse pointed at stays while
 * the view is turned, and goes when the pointer leaves the faces. One line of sight is followed a frame.
 */
import type { Vec3 } from '../../model/hexahedron'
import type { Stage } from './input-target'

/** CSS pixels that a finger may move in a tap. */
const TAP_RADIUS = 8

interface Place {
  readonly x: number
  readonly y: number
}

export class ProbeInput {
  readonly #stage: Stage
  readonly #listening = new AbortController()
  /** Where the pointer is that has not been looked at, since this frame has had its look. */
  #next: Place | null = null
  #frameDue = false
  /** Whether the probe is where a hovering pointer put it. */
  #hovering = false
  #tap: (Place & { readonly pointerId: number }) | null = null

  constructor(stage: Stage) {
    this.#stage = stage
    const { element } = stage
    const { signal } = this.#listening
    element.addEventListener('pointermove', this.#onMove, { signal })
    element.addEventListener('pointerleave', this.#onLeave, { signal })
    element.addEventListener('pointerdown', this.#onDown, { signal })
    element.addEventListener('pointerup', this.#onUp, { signal })
    element.addEventListener('pointercancel', this.#onCancel, { signal })
  }

  /** Called once a frame. */
  update(): void {
    this.#frameDue = false
    const place = this.#next
    this.#next = null
    if (place) this.#look(place)
  }

  /** Takes back what hovering marked. */
  clear(): void {
    this.#next = null
    if (this.#hovering) this.#point(null)
    this.#hovering = false
  }

  /** What is marked now is not the pointer's: it stays when the pointer leaves. */
  letGo(): void {
    this.#next = null
    this.#hovering = false
  }

  dispose(): void {
    this.#listening.abort()
  }

  readonly #onMove = (event: PointerEvent): void => {
    if (event.pointerType === 'touch' || event.buttons !== 0) return
    const place = this.#stage.placeOf(event)
    if (this.#frameDue) this.#next = place
    else this.#look(place)
  }

  readonly #onLeave = (event: PointerEvent): void => {
    if (event.pointerType !== 'touch') this.clear()
  }

  readonly #onDown = (event: PointerEvent): void => {
    this.#next = null
    const alone = event.pointerType === 'touch' && event.isPrimary
    this.#tap = alone ? { ...this.#stage.placeOf(event), pointerId: event.pointerId } : null
  }

  readonly #onUp = (event: PointerEvent): void => {
    const tap = this.#tap
    this.#tap = null
    if (tap?.pointerId !== event.pointerId) return
    const { x, y } = this.#stage.placeOf(event)
    if (Math.hypot(x - tap.x, y - tap.y) < TAP_RADIUS) this.#point(this.#stage.pointAt(x, y))
  }

  readonly #onCancel = (): void => {
    this.#tap = null
  }

  #look({ x, y }: Place): void {
    const point = this.#stage.pointAt(x, y)
    if (point === null) this.clear()
    else this.#point(point)
    this.#hovering = point !== null
  }

  #point(point: Vec3 | null): void {
    const { host } = this.#stage
    const before = host.state()
    host.dispatch({ type: 'probe', point })
    this.#frameDue = host.state() !== before
  }
}
