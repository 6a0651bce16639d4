/** Which cells are listed: decided in steps, from the worst on, so that others may ask in between. */
import { filterOf, OPEN, TRUE } from '../core/filter/filter'
import { quantitiesOf } from '../core/quantities'
import type { Core } from '../core/report'
import type { MeshCheck } from '../mesh/mesh-check'
import { verticesOf } from '../mesh/vertices-of'
import { isMet, parseCondition } from '../model/condition'
import { exactly } from '../model/condition/enclosure'
import type { NumberNode } from '../model/condition/parse'
import { scaledInteger } from '../model/rational'
import type { Selected, Selection } from './survey-jobs'

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

  /** Throws a RangeError for a condition that is none: whoever offers it has parsed it. */
  constructor(check: MeshCheck, core: Core, { condition, range }: Selection) {
    this.#check = check
    this.isAll = condition === null && range === null
    const [lower, upper] = range ?? [-Infinity, Infinity]
    const relative = check.answers.relativeMinima
    const isWithin = (cell: number) => range === null || isBetween(relative[cell] as number, lower, upper)
    const holds = condition === null ? () => true : meeting(check, core, condition)
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

/** Cells that are unanswered meet no condition. */
function meeting(check: MeshCheck, core: Core, text: string): (cell: number) => boolean {
  const parsed = parseCondition(text)
  if (!parsed.ok) throw new RangeError(parsed.error.message)
  const condition = parsed.value
  const own = new Float64Array(24)
  const filter = filterOf(condition, NO_MEASURE, NOWHERE, core)
  return cell => {
    if (!check.isAnswered(cell)) return false
    const vertices = verticesOf(check.mesh, cell)
    own.set(vertices)
    const truth = isOrdinary(own) ? filter.judge(own, 0, check.answers.valid[cell] === 1) : OPEN
    if (truth !== OPEN) return truth === TRUE
    const report = core.analyze(vertices)
    return report.ok && isMet(condition, quantitiesOf(report.value, vertices))
  }
}

/** The filter's bounds are for products of three coordinates within the range of doubles. */
function isOrdinary(vertices: Float64Array): boolean {
  let greatest = 0
  for (const coordinate of vertices) greatest = Math.max(greatest, Math.abs(coordinate))
  return greatest > 2 ** -300 && greatest < 2 ** 300
}

const NO_MEASURE: NumberNode = { kind: 'constant', value: exactly(scaledInteger(0n, 0)) }
/** The place from which `moved` would count: nobody asks for it here. */
const NOWHERE: readonly number[] = new Array(24).fill(0)
