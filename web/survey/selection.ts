/** Which cells are listed: decided in steps, from the worst on, so that others may ask in between. */
import type { Core } from '../core/report'
import type { MeshCheck } from '../mesh/mesh-check'
import type { Selected, Selection } from './survey-jobs'

/** Which cells meet a condition, in its text. Throws a RangeError if that is none: whoever offers it has parsed it. */
export type Meeting = (check: MeshCheck, core: Core, condition: string) => (cell: number) => boolean

export interface Conditioned {
  readonly core: Core
  /** Null in a build whose meshes are never asked for a condition. */
  readonly meeting: Meeting | null
}

/** Cells between two looks at the clock. */
const CELLS_AT_ONCE = 64

export class SelectionRun {
  /** True if every cell is listed. */
  readonly isAll: boolean
  readonly #check: MeshCheck
  readonly #isMeant: (cell: number) => boolean
  readonly #mask: Uint8Array
  #done = 0
  #listed = 0

  /** Throws as `meeting` does. */
  constructor(check: MeshCheck, { core, meeting }: Conditioned, { condition, range }: Selection) {
    this.#check = check
    this.isAll = condition === null && range === null
    const [lower, upper] = range ?? [-Infinity, Infinity]
    const relative = check.answers.relativeMinima
    const isWithin = (cell: number) => range === null || isBetween(relative[cell] as number, lower, upper)
    if (condition !== null && meeting === null) throw new RangeError('This build knows no conditions.')
    const holds = condition === null || meeting === null ? () => true : meeting(check, core, condition)
    this.#isMeant = cell => isWithin(cell) && holds(cell)
    this.#mask = new Uint8Array(this.isAll ? 0 : check.hexahedra)
    if (this.isAll) {
      this.#done = check.worst.length
      this.#listed = this.#done
    }
  }

  isListed(cell: number): boolean {
    return this.isAll || this.#mask[cell] === 1
  }

  run(milliseconds: number): Selected {
    const { worst } = this.#check
    const end = performance.now() + milliseconds
    while (this.#done < worst.length && performance.now() < end) {
      const last = Math.min(this.#done + CELLS_AT_ONCE, worst.length)
      for (; this.#done < last; ++this.#done) {
        const cell = worst[this.#done] as number
        if (!this.#isMeant(cell)) continue
        this.#mask[cell] = 1
        this.#listed++
      }
    }
    return { listed: this.#listed, done: this.#done }
  }
}

function isBetween(value: number, lower: number, upper: number): boolean {
  return value >= lower && value <= upper
}
