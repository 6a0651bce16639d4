/** Pointer, keys and probe of one pane. Keys are the pointer's while it drags. */
import { sliceChange } from '../../model/state'
import { controlsSlice } from '../../views/scene-slices'
import type { InputTarget } from './input-target'
import { KeyboardInput } from './keyboard-input'
import { PointerInput } from './pointer-input'
import { ProbeInput } from './probe-input'

export class Inputs {
  readonly probe: ProbeInput
  readonly #target: InputTarget
  readonly #element: HTMLElement
  readonly #keyboard: KeyboardInput
  readonly #pointer: PointerInput
  readonly #listening = new AbortController()

  constructor(target: InputTarget) {
    this.#target = target
    this.#element = target.element
    this.#keyboard = new KeyboardInput(target)
    this.#pointer = new PointerInput(target, () => this.#keyboard.commit())
    this.probe = new ProbeInput(target)
    const { signal } = this.#listening
    this.#element.addEventListener('keydown', this.#onKey, { signal })
    this.#element.addEventListener('keyup', this.#onKey, { signal })
    this.#element.addEventListener('focus', this.#onFocus, { signal })
    this.#element.addEventListener('blur', this.#onBlur, { signal })
  }

  get isDragging(): boolean {
    return this.#pointer.isDragging
  }

  dispose(): void {
    this.#listening.abort()
    this.#keyboard.commit()
    this.#pointer.dispose()
    this.probe.dispose()
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    if (this.#pointer.isDragging) this.#pointer.onKey(event)
    else if (event.type === 'keydown') {
      delete this.#element.dataset.pointed
      this.#keyboard.onKeyDown(event)
    } else this.#keyboard.onKeyUp(event)
  }

  /** Who comes with keys sees the vertex that they move, and needs no chips. */
  readonly #onFocus = (): void => {
    const { host, movesVertices } = this.#target
    if (this.#element.dataset.pointed !== undefined) return
    host.dispatch(sliceChange(controlsSlice, { byFinger: false }))
    if (movesVertices) host.dispatch({ type: 'select-vertex', vertex: host.state().selectedVertex })
  }

  readonly #onBlur = (): void => {
    delete this.#element.dataset.pointed
    this.#keyboard.commit()
  }
}
