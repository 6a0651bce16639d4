/** A polite live region that says the changes: at most one sentence a second, the latest one. */
import type { CreateView, Frame, View } from '../../views/view'
import { announcement } from './announcement'

const PAUSE_MS = 1000

class AnnouncerView implements View {
  readonly root = document.createElement('p')
  #said: string | null = null
  #next = ''
  #timer: ReturnType<typeof setTimeout> | undefined

  constructor() {
    this.root.className = 'announcer said'
    this.root.setAttribute('aria-live', 'polite')
  }

  update({ state, report }: Frame): void {
    if (report === null) return
    this.#next = announcement(state, report)
    if (this.#said === null) this.#said = this.#next
    if (this.#next === this.#said || this.#timer !== undefined) return
    this.#timer = setTimeout(this.#say, PAUSE_MS)
  }

  dispose(): void {
    clearTimeout(this.#timer)
    this.#timer = undefined
  }

  readonly #say = (): void => {
    this.#timer = undefined
    this.#said = this.#next
    this.root.textContent = this.#next
  }
}

export const createAnnouncer: CreateView = () => new AnnouncerView()
