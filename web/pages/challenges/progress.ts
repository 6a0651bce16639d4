/**
 * Challenges that the reader has solved, and the best of each contest, kept in this browser. If it
 * keeps nothing, they are known until the page is left; entries of a later version of the page are
 * neither read nor lost.
 */

export interface Solved {
  /** The best number in the contest; null if there is no contest. */
  readonly best: number | null
}

interface Kept {
  readonly version: typeof VERSION
  readonly solved: Readonly<Record<string, Solved>>
}

const KEY = 'hexlens-challenges'
const VERSION = 1

export class Progress {
  #solved: ReadonlyMap<string, Solved>
  /** True if it outlives the page. */
  isKept: boolean

  constructor() {
    const { solved, isKept } = stored()
    this.#solved = solved
    this.isKept = isKept
  }

  get count(): number {
    return this.#solved.size
  }

  of(id: string): Solved | null {
    return this.#solved.get(id) ?? null
  }

  add(id: string, solved: Solved): void {
    this.#solved = new Map([...this.#solved, [id, solved]])
    if (this.isKept) this.isKept = store({ version: VERSION, solved: Object.fromEntries(this.#solved) })
  }

  forget(): void {
    this.#solved = new Map()
    try {
      localStorage.removeItem(KEY)
    } catch {
      // Nothing was kept.
    }
  }
}

function store(kept: Kept): boolean {
  try {
    localStorage.setItem(KEY, JSON.stringify(kept))
    return true
  } catch {
    return false
  }
}

function stored(): { solved: ReadonlyMap<string, Solved>; isKept: boolean } {
  const none = new Map<string, Solved>()
  try {
    const text = localStorage.getItem(KEY)
    if (text === null) return { solved: none, isKept: true }
    const kept = parsed(text)
    if (typeof kept?.version === 'number' && kept.version > VERSION) return { solved: none, isKept: false }
    return { solved: new Map(Object.entries(kept?.solved ?? {}).filter(isSolved)), isKept: true }
  } catch {
    return { solved: none, isKept: false } // storage is refused
  }
}

/** Null where somebody else has written there. */
function parsed(text: string): Partial<Kept> | null {
  try {
    return JSON.parse(text)
  } catch {
    return null
  }
}

function isSolved(entry: [string, unknown]): entry is [string, Solved] {
  const best = (entry[1] as Partial<Solved> | null)?.best
  return best === null || Number.isFinite(best)
}
