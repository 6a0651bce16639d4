/**
 * Pointing at the probe: a mouse or pen by hovering, with no button pressed; a finger by a tap, which also lets go of the chosen vertex. The probe of a mouse stays while
 * the camera is turned, and goes when the pointer leaves the faces. One line of sight is followed a frame.
 */
import type { Candidate, Report } from '../../core/report'
import type { Vec3 } from '../../model/hexahedron'
import { sliceChange } from '../../model/state'
import { controlsSlice, FREE } from '../../views/scene-slices'
import type { Point } from '../space/layout'
import { samePoint } from '../space/vec3'
import type { InputTarget } from './input-target'

/** Units that a finger may move in a tap. */
const TAP_RADIUS = 8

export class ProbeInput {
  readonly #target: InputTarget
  readonly #listening = new AbortController()
  /** The position of the pointer that waits for the next frame, since this one has followed its line of sight. */
  #next: Point | null = null
  #frameDue = false
  /** True if a hovering pointer has put the probe. */
  #hovering = false
  #tap: (Point & { readonly pointerId: number }) | null = null

  constructor(target: InputTarget) {
    this.#target = target
    const { element } = target
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
    const next = this.#next
    this.#next = null
    if (next) this.#look(next)
  }

  /** Takes back a probe of hovering. */
  clear(): void {
    this.#next = null
    if (this.#hovering) this.#point(null)
    this.#hovering = false
  }

  /** The probe is not the pointer's any more: it stays when the pointer leaves. */
  letGo(): void {
    this.#next = null
    this.#hovering = false
  }

  dispose(): void {
    this.#listening.abort()
  }

  readonly #onMove = (event: PointerEvent): void => {
    if (event.pointerType === 'touch' || event.buttons !== 0) return
    const position = this.#target.positionOf(event)
    if (this.#frameDue) this.#next = position
    else this.#look(position)
  }

  readonly #onLeave = (event: PointerEvent): void => {
    if (event.pointerType !== 'touch') this.clear()
  }

  readonly #onDown = (event: PointerEvent): void => {
    this.#next = null
    const alone = event.isTrusted && event.pointerType === 'touch' && event.isPrimary
    this.#tap = alone ? { ...this.#target.positionOf(event), pointerId: event.pointerId } : null
  }

  readonly #onUp = (event: PointerEvent): void => {
    const tap = this.#tap
    this.#tap = null
    if (tap?.pointerId !== event.pointerId) return
    const { x, y } = this.#target.positionOf(event)
    if (Math.hypot(x - tap.x, y - tap.y) >= TAP_RADIUS) return
    this.#point(this.#target.pointAt(x, y))
    this.#target.host.dispatch({ type: 'select-vertex', vertex: null })
    this.#target.host.dispatch(sliceChange(controlsSlice, { held: FREE }))
  }

  readonly #onCancel = (): void => {
    this.#tap = null
  }

  #look({ x, y }: Point): void {
    const point = this.#target.pointAt(x, y)
    if (point === null) this.clear()
    else this.#point(point)
    this.#hovering = point !== null
  }

  #point(point: Vec3 | null): void {
    const { host } = this.#target
    const before = host.state()
    host.dispatch({ type: 'probe', point })
    this.#frameDue = host.state() !== before
  }
}

/** The candidates as a key goes through them: the minimizer first, after the last the minimizer again. Points that coincide are one. */
export function nextCandidate({ minimizer, candidates }: Report, probe: Vec3 | null): Candidate {
  const all = [minimizer, ...candidates].filter(
    ({ point }, i, list) => list.findIndex(other => samePoint(other.point, point)) === i,
  )
  const at = all.findIndex(({ point }) => probe !== null && samePoint(point, probe))
  return all[(at + 1) % all.length] as Candidate
}
