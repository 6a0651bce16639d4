/**
 * What the reader has made of each challenge of a series, kept in this browser: what solves it, or
 * else the latest. Without a storage it is known until the page is left.
 */
import { type Coordinate, coordinates, written } from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'

export interface Made {
  readonly vertices: Vertices
  readonly isSolved: boolean
}

interface Kept {
  readonly version: typeof VERSION
  /** By the code of the series, the latest last. */
  readonly series: readonly (readonly [string, readonly (KeptElement | null)[]])[]
}

interface KeptElement {
  readonly vertices: readonly Coordinate[]
  readonly isSolved: boolean
}

const KEY = 'hexlens-series'
const VERSION = 1
/** Older ones are forgotten: a storage is small. */
const MOST_SERIES = 20

export class MadeInSeries {
  #series = new Map<string, readonly (Made | null)[]>()

  constructor() {
    this.#read()
  }

  get isEmpty(): boolean {
    return this.#series.size === 0
  }

  /** By the index of the challenge; null or nothing where there is none. */
  of(code: string): readonly (Made | null)[] {
    return this.#series.get(code) ?? []
  }

  /** What solves a challenge is only replaced by what solves it, too. */
  add(code: string, at: number, made: Made): void {
    this.#read() // another tab may have written
    const all = [...this.of(code)]
    while (all.length <= at) all.push(null)
    if (all[at]?.isSolved && !made.isSolved) return
    this.#series.delete(code)
    this.#series.set(code, all.with(at, made))
    this.#store()
  }

  forget(): void {
    this.#series = new Map()
    try {
      localStorage.removeItem(KEY)
    } catch {
      // Nothing was kept.
    }
  }

  #store(): void {
    const series = [...this.#series]
      .slice(-MOST_SERIES)
      .map(([code, all]) => [code, all.map(made => made && { ...made, vertices: written(made.vertices) })] as const)
    try {
      localStorage.setItem(KEY, JSON.stringify({ version: VERSION, series } satisfies Kept))
    } catch {
      // It is known until the page is left.
    }
  }

  #read(): void {
    try {
      const { version, series } = JSON.parse(localStorage.getItem(KEY) ?? '{}') as Partial<Kept>
      if (version === VERSION) this.#series = new Map(series?.map(([code, all]) => [String(code), all.map(madeOf)]))
    } catch {
      // There is no storage, or somebody else has written there.
    }
  }
}

function madeOf(kept: KeptElement | null): Made | null {
  return kept && { vertices: coordinates(kept.vertices, 'vertices'), isSolved: kept.isSolved === true }
}
