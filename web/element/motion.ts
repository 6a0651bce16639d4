/** Motions that a page's script asks for: at once where the reader wants no motion, and over when the reader's hand comes. */
import type { CameraView } from '../model/state'
import { directionBetween } from '../scene/space/showing'
import { map3, mix } from '../scene/space/vec3'

/** Signs of the reader's hand. */
const HAND = ['pointerdown', 'wheel', 'keydown']

export interface MotionOptions {
  /** Ends the motion where it is. */
  readonly signal?: AbortSignal | undefined
}

export class Motion {
  readonly #element: HTMLElement
  #finish: (isThere: boolean) => void = () => {}

  constructor(element: HTMLElement) {
    this.#element = element
  }

  /**
   * Calls `place` with shares of the way, 1 at last, until it returns false; then `end`, in any case once. A new motion ends
   * the one before. Resolves to whether it came to its end.
   */
  play(
    seconds: number,
    { signal }: MotionOptions,
    place: (share: number) => boolean,
    end: () => void = () => {},
  ): Promise<boolean> {
    this.#finish(false)
    const isAtOnce = seconds === 0 || matchMedia('(prefers-reduced-motion: reduce)').matches
    return new Promise(resolve => {
      const over = new AbortController()
      const finish = (isThere: boolean) => {
        if (over.signal.aborted) return
        over.abort()
        end()
        resolve(isThere)
      }
      this.#finish = finish
      const stop = () => finish(false)
      for (const name of HAND)
        this.#element.addEventListener(name, stop, { capture: true, passive: true, signal: over.signal })
      signal?.addEventListener('abort', stop, { signal: over.signal })
      let start: number | null = null
      const step = (time: number) => {
        if (over.signal.aborted) return
        start ??= time
        const share = isAtOnce ? 1 : Math.min((time - start) / (1000 * seconds), 1)
        if (signal?.aborted || !place(share)) stop()
        else if (share === 1) finish(true)
        else requestAnimationFrame(step)
      }
      if (isAtOnce) step(0)
      else requestAnimationFrame(step)
    })
  }
}

/** The camera a share of the way from one to another, slow at both ends; the eye comes nearer by the same factor in the same time. */
export function cameraBetween(from: CameraView, to: CameraView, share: number): CameraView {
  if (share === 1) return to
  const eased = share * share * (3 - 2 * share)
  return {
    direction: directionBetween(unit(from.direction), unit(to.direction), eased),
    zoom: from.zoom * (to.zoom / from.zoom) ** eased,
    pan: mix(from.pan, to.pan, eased),
  }
}

function unit(direction: CameraView['direction']): CameraView['direction'] {
  const length = Math.hypot(...direction)
  return map3(axis => (direction[axis] as number) / length)
}
