/** Cells among which the worst of many are: those whose relative minima, known about, are not above a limit that falls as cells are decided. */

/** The relative error of what is known about relative minima at most, (L5). */
export const ABOUT = 2 ** -20

export interface Candidates {
  /** In any order. */
  readonly cells: readonly number[]
  /** About the relative minima of these; -Infinity where one may be anything. */
  readonly about: readonly number[]
}

/** A question for the `few` worst cells, of which none is above `limit`. */
export interface CandidateOptions {
  readonly few: number
  readonly limit: number
}

/** More are no gain. */
const MOST = 20_000

/** Keeps the cells among which the `few` worst are. */
export class CandidateList {
  /** Relative minima above it are of no candidates. */
  limit: number
  readonly #least: Float64Array
  #kept: { readonly cell: number; readonly about: number }[] = []
  #isTooMany = false

  constructor({ few, limit }: CandidateOptions) {
    this.limit = limit
    this.#least = new Float64Array(few).fill(Infinity)
  }

  take(cell: number, about: number): void {
    if (about > this.limit || this.#isTooMany) return
    this.#kept.push({ cell, about })
    if (about > -Infinity) this.#lower(about)
    if (this.#kept.length <= MOST) return
    this.#kept = this.#own()
    this.#isTooMany = 2 * this.#kept.length > MOST
  }

  /** Of a part of the cells, from the cell `first` on; null is one with too many. */
  takeAll(part: Candidates | null, first: number): void {
    if (!part) this.#isTooMany = true
    else for (const [i, cell] of part.cells.entries()) this.take(first + cell, part.about[i] as number)
  }

  /** Null where they are too many. */
  get candidates(): Candidates | null {
    if (this.#isTooMany) return null
    const own = this.#own()
    return { cells: own.map(({ cell }) => cell), about: own.map(({ about }) => about) }
  }

  #own() {
    return this.#kept.filter(({ about }) => about <= this.limit)
  }

  #lower(about: number): void {
    const least = this.#least
    let at = least.length - 1
    if (!(about < (least[at] as number))) return
    for (; at > 0 && (least[at - 1] as number) > about; --at) least[at] = least[at - 1] as number
    least[at] = about
    const last = least[least.length - 1] as number
    // Both numbers may be off, and a little for what is of second order.
    if (last < Infinity) this.limit = Math.min(this.limit, last + 3 * ABOUT * Math.abs(last))
  }
}
