/**
 * Pointers that look from elsewhere. One turns the view; with Ctrl, Cmd or Shift, or by the right button, it moves it; the middle
 * button and the wheel zoom to where the pointer is. Two fingers move and zoom.
 */
import type { Point } from '../space/layout'
import type { OrbitCamera } from '../space/orbit-camera'

type Orbit = Pick<OrbitCamera, 'camera' | 'turnBy' | 'pan' | 'zoom'>
type Way = 'turn' | 'move' | 'zoom'

const BUTTONS: readonly (readonly [alone: Way, withKey: Way])[] = [
  ['turn', 'move'],
  ['zoom', 'zoom'],
  ['move', 'turn'],
]
/** The distance from the target to itself after a hundred pixels of the wheel. */
const WHEEL_ZOOM = 0.95 ** 1.6
/** The power of the fingers' way apart by which they zoom. */
const PINCH_POWER = 1.6
/** Pixels of a line and of a page, in which some wheels count. */
const WHEEL_PIXELS = [1, 16, 100] as const
/** A touchpad tells a pinch as a slow wheel with Ctrl. */
const PINCH_SPEED = 10

export class OrbitInput {
  readonly #orbit: Orbit
  readonly #pointers = new Map<number, Point>()
  #way: Way = 'turn'
  #start: Point = { x: 0, y: 0 }
  #isControlHeld = false

  constructor(orbit: Orbit, signal: AbortSignal) {
    this.#orbit = orbit
    const onKey = ({ key, type }: KeyboardEvent) => {
      if (key === 'Control') this.#isControlHeld = type === 'keydown'
    }
    for (const type of ['keydown', 'keyup'] as const) document.addEventListener(type, onKey, { capture: true, signal })
  }

  get isIdle(): boolean {
    return this.#pointers.size === 0
  }

  get isByMany(): boolean {
    return this.#pointers.size > 1
  }

  /** A pointer that is down already begins anew. */
  begin({ pointerId, button, ctrlKey, metaKey, shiftKey }: PointerEvent, at: Point): void {
    if (this.isIdle) {
      this.#way = (BUTTONS[button] ?? BUTTONS[0])?.[ctrlKey || metaKey || shiftKey ? 1 : 0] as Way
      this.#start = at
    }
    this.#pointers.set(pointerId, at)
  }

  move({ pointerId }: PointerEvent, to: Point): void {
    const from = this.#pointers.get(pointerId)
    if (!from) return
    this.#pointers.set(pointerId, to)
    const other = [...this.#pointers].find(([id]) => id !== pointerId)?.[1]
    const [right, down] = [to.x - from.x, to.y - from.y]
    if (other) {
      const apart = ({ x, y }: Point) => Math.hypot(x - other.x, y - other.y)
      this.#orbit.pan(right / 2, down / 2)
      const middle = { x: (to.x + other.x) / 2, y: (to.y + other.y) / 2 }
      if (apart(from) > 0 && apart(to) > 0) this.#orbit.zoom((apart(to) / apart(from)) ** PINCH_POWER, middle)
    } else if (this.#way === 'move') this.#orbit.pan(right, down)
    else if (this.#way === 'zoom') this.#orbit.zoom(WHEEL_ZOOM ** (down / 100), this.#start)
    else {
      const angle = (2 * Math.PI) / this.#orbit.camera.height
      this.#orbit.turnBy(-right * angle, down * angle)
    }
  }

  /** Returns whether the pointer was down. */
  end(pointerId: number): boolean {
    return this.#pointers.delete(pointerId)
  }

  wheel(event: WheelEvent, at: Point): void {
    event.preventDefault()
    if (!this.isIdle) return
    const speed = event.ctrlKey && !this.#isControlHeld ? PINCH_SPEED : 1
    const pixels = event.deltaY * (WHEEL_PIXELS[event.deltaMode] ?? 1) * speed
    this.#orbit.zoom(WHEEL_ZOOM ** (pixels / 100), at)
  }
}
