/**
 * The reader's work on a page, kept by the browser. A tab has its own: links, Back, Forward and
 * reload find it again, and no other tab changes it. A new tab begins with the latest of all tabs.
 * The first is the session's storage, which belongs to one tab and is copied with it; the second is
 * the browser's. Both answer at once, so that work can be kept when a page is left.
 */

/** `full`: no room was left. `refused`: the browser stores nothing for this page. */
export type Keeping = 'kept' | 'full' | 'refused'

/** What the reader is told where work lasts only as long as the page; empty while it is kept. */
export const KEEPING_NOTES: Readonly<Record<Keeping, string>> = {
  kept: '',
  full: 'This browser has no room left for this page. What you do here is gone when you leave it.',
  refused: 'This browser stores nothing for this page. What you do here is gone when you leave it.',
}

type Shelf = Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>

/** Each may throw: a browser can refuse to hand its storages out. */
export interface Shelves {
  readonly tab: () => Shelf
  /** Null if a new tab begins with nothing. */
  readonly latest: (() => Shelf) | null
}

/** What is of no use to another tab. */
export const TAB_ALONE: Shelves = { tab: () => sessionStorage, latest: null }
const BROWSER: Shelves = { ...TAB_ALONE, latest: () => localStorage }

const PREFIX = 'hexlens-'

/** Forgets all that this browser keeps for Hexlens, but for other tabs' own work. */
export function forgetAll(shelves: readonly (() => Storage)[] = [() => sessionStorage, () => localStorage]): void {
  for (const shelf of shelves)
    try {
      const storage = shelf()
      const keys = Array.from({ length: storage.length }, (_, i) => storage.key(i))
      for (const key of keys) if (key?.startsWith(PREFIX)) storage.removeItem(key)
    } catch {
      // Nothing is stored there.
    }
}

export class Keeper<Work> {
  readonly #key: string
  readonly #read: (value: unknown) => Work | null
  readonly #shelves: Shelves
  #keeping: Keeping = 'kept'

  /**
   * `version` is raised when `Work` changes its form; work of other versions is neither read nor
   * lost. `read` checks what comes back from the storage: null if it is not such work.
   */
  constructor(name: string, version: number, read: (value: unknown) => Work | null, shelves = BROWSER) {
    this.#key = `${PREFIX}${name}-${version}`
    this.#read = read
    this.#shelves = shelves
  }

  /** How the last `keep` ended. */
  get keeping(): Keeping {
    return this.#keeping
  }

  /** This tab's work; null if it has none. */
  own(): Work | null {
    return this.#from(this.#shelves.tab)
  }

  /** This tab's work or, in a tab that has none, the latest of all tabs. */
  found(): Work | null {
    const { latest } = this.#shelves
    return this.own() ?? (latest && this.#from(latest))
  }

  /** Takes the place of this tab's work. Work is JSON, and its numbers come back bit for bit. */
  keep(work: Work): Keeping {
    const text = written(work)
    this.#keeping = this.#put(this.#shelves.tab, text)
    // Older work must not come back as the tab's own.
    if (this.#keeping === 'full') this.#remove(this.#shelves.tab)
    if (this.#shelves.latest) this.#put(this.#shelves.latest, text)
    return this.#keeping
  }

  /** Forgets this tab's work; the latest of all tabs only if it is this one. */
  forget(): void {
    const { tab, latest } = this.#shelves
    const text = this.#text(tab)
    if (latest && text !== null && text === this.#text(latest)) this.#remove(latest)
    this.#remove(tab)
  }

  #from(shelf: () => Shelf): Work | null {
    const text = this.#text(shelf)
    if (text === null) return null
    try {
      return this.#read(JSON.parse(text, revived))
    } catch {
      return null // somebody else has written there
    }
  }

  #text(shelf: () => Shelf): string | null {
    try {
      return shelf().getItem(this.#key)
    } catch {
      return null
    }
  }

  #put(shelf: () => Shelf, text: string): Keeping {
    try {
      shelf().setItem(this.#key, text)
      return 'kept'
    } catch (reason) {
      return (reason as Partial<DOMException> | null)?.name === 'QuotaExceededError' ? 'full' : 'refused'
    }
  }

  #remove(shelf: () => Shelf): void {
    try {
      shelf().removeItem(this.#key)
    } catch {
      // Nothing is stored there.
    }
  }
}

/** JSON has no names for these numbers, and makes 0 or null of them. */
const UNNAMED = { '-0': -0, NaN: Number.NaN, Infinity: Infinity, '-Infinity': -Infinity } as const
const MARK = '#number'

function written(work: unknown): string {
  return JSON.stringify(work, (_, value) => {
    if (typeof value !== 'number' || (Number.isFinite(value) && !Object.is(value, -0))) return value
    return { [MARK]: Object.is(value, -0) ? '-0' : String(value) }
  })
}

function revived(_: string, value: unknown): unknown {
  if (typeof value !== 'object' || value === null || !Object.hasOwn(value, MARK)) return value
  return UNNAMED[(value as Record<typeof MARK, keyof typeof UNNAMED>)[MARK]]
}
