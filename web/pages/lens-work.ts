/**
 * What a reader has made in the lens of a page, its state and its undo, kept under a name: pages,
 * steps of lessons and challenges each have their own. Kept a moment after each change that is
 * done, and when the page is hidden or left.
 */
import { HISTORY_VERSION, type HistoryDocument } from '../model/history-document'
import type { StateDocument } from '../model/state-document'
import { KEEPING_NOTES, Keeper } from './keep'
import { say } from './note'
import { onSettled } from './on-settled'
import { type PackedHistory, packed, unpacked } from './packed-history'
import { put } from './put'

interface Work {
  readonly state: StateDocument
  readonly history: PackedHistory
}

/** A lens, or what stands in its place. */
interface Lens {
  state: StateDocument
  history: HistoryDocument
}

const VERSION = 1
/** Milliseconds: a reader who goes on at once is not held up. */
const PAUSE = 800
const OF_THE_READER = ['pointerdown', 'keydown', 'wheel'] as const

/** What another version of the page or somebody else has stored is found out when it is shown. */
function readWork(value: unknown): Work | null {
  return value as Work | null
}

export class LensWork {
  readonly #lens: Lens
  readonly #keepers = new Map<string, Keeper<Work>>()
  /** The work of this page, where the browser keeps nothing. */
  readonly #here = new Map<string, Work>()
  #name: string | null = null
  /** True if the reader has done something with it since it was opened. */
  #isTouched = false
  #isPressed = false
  #pause = 0

  /**
   * The reader works in the elements. `reopen` is called when the page is shown again as it was
   * left, and others may have kept work since.
   */
  constructor(lens: Lens, elements: Iterable<Element>, reopen: () => void) {
    this.#lens = lens
    for (const element of elements) {
      for (const type of OF_THE_READER)
        element.addEventListener(type, () => this.touch(), { capture: true, passive: true })
      onSettled(element, () => {
        this.touch()
        this.#keepSoon()
      })
    }
    for (const type of ['pointerdown', 'pointerup', 'pointercancel'] as const)
      addEventListener(type, () => (this.#isPressed = type === 'pointerdown'), { capture: true, passive: true })
    addEventListener('pagehide', () => this.keep())
    addEventListener('visibilitychange', () => document.hidden && this.keep())
    addEventListener('pageshow', event => {
      if (!event.persisted) return
      this.forget()
      reopen()
    })
  }

  /**
   * Keeps what is shown and shows what was kept under the name. Without such, `first` is shown; if
   * there is none, the lens stays as it is. True if there was work.
   */
  open(name: string, first: StateDocument | null = null): boolean {
    this.close()
    this.#name = name
    this.#isTouched = false
    const work = this.#here.get(name) ?? this.#keeper.found()
    try {
      if (work === null) return this.#begin(first)
      this.#show(work.state, unpacked(work.history))
      return true
    } catch {
      return this.#begin(first)
    }
  }

  /** From now on what is shown is kept, though the reader has not done anything with it. */
  touch(): void {
    this.#isTouched = true
  }

  /** Keeps what is shown, if it is the reader's work. */
  keep(): void {
    clearTimeout(this.#pause)
    if (this.#name === null || !this.#isTouched) return
    const work = { state: this.#lens.state, history: packed(this.#lens.history) }
    this.#here.set(this.#name, work)
    const keeping = this.#keeper.keep(work)
    if (keeping !== 'kept') say(KEEPING_NOTES[keeping])
  }

  /** Keeps what is shown; what is shown from now on is not kept. */
  close(): void {
    this.keep()
    this.#name = null
  }

  /** Keeps nothing of what is shown now, nor of what this page has shown. */
  forget(): void {
    clearTimeout(this.#pause)
    this.#here.clear()
    this.#name = null
  }

  get #keeper(): Keeper<Work> {
    const name = this.#name as string
    const keeper = this.#keepers.get(name) ?? new Keeper(name, VERSION, readWork)
    this.#keepers.set(name, keeper)
    return keeper
  }

  #show(state: StateDocument, history: HistoryDocument): void {
    put(() => {
      this.#lens.history = history
      this.#lens.state = state
    })
  }

  #begin(first: StateDocument | null): false {
    if (first === null) return false
    const { vertices, preset = null, start = vertices } = first
    this.#show(first, { version: HISTORY_VERSION, elements: [{ vertices, preset, start }], present: 0 })
    return false
  }

  /** Never while a drag may be under way: it would stop for a moment. */
  #keepSoon(): void {
    clearTimeout(this.#pause)
    this.#pause = window.setTimeout(() => (this.#isPressed ? this.#keepSoon() : this.keep()), PAUSE)
  }
}
