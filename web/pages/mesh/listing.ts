/** The list of the open mesh: its order, the condition and the range that its cells meet. */
import type { CellTable } from '../../mesh-views/cell-table'
import { parseCondition } from '../../model/condition'
import type { Arrangement, Overview, Selected } from '../../survey/survey-jobs'
import type { Range } from './histogram-range'
import type { PageState } from './page-state'

export interface ListingViews {
  readonly table: CellTable
  /** Its picture may be of the listed cells. */
  readonly picture: { refresh(): Promise<void> }
}

export class Listing {
  readonly #state: PageState
  readonly #views: ListingViews

  constructor(state: PageState, views: ListingViews) {
    this.#state = state
    this.#views = views
  }

  async arrange(order: Arrangement): Promise<void> {
    const own = this.#state.survey
    const onStep = (fraction: number) =>
      own === this.#state.survey && this.#state.set({ arranging: { order, fraction } })
    const isArranged = await this.#state.asked(open => open.arrange(order, onStep))
    if (!isArranged) return
    const { order: before } = this.#state.shown
    const isOther = order.column !== before.column || order.isDescending !== before.isDescending
    this.#state.set({ order, arranging: null })
    this.#show()
    if (isOther) this.#views.table.toStart()
  }

  cancelArranging(): void {
    this.#state.survey?.cancelArranging()
    this.#state.set({ arranging: null })
    this.#views.table.focus()
  }

  async select(condition: string, range: Range): Promise<void> {
    const { overview } = this.#state.shown
    if (!overview) return
    const own = this.#state.survey
    const complaint = complaintAbout(condition)
    const isOther = condition !== this.#state.shown.condition || range !== this.#state.shown.range
    this.#state.set({ condition, range, complaint })
    if (complaint !== null) return
    const selection = { condition: condition.trim() === '' ? null : condition, range }
    let isGrown = false
    const onStep = (selected: Selected) => {
      if (own !== this.#state.survey) return
      this.#state.set({ selected })
      this.#show(isGrown)
      isGrown = true
    }
    const selected = await this.#state.asked(open => open.select(selection, overview.hexahedra, onStep))
    if (!selected) return
    if (isOther) this.#views.table.toStart()
    await this.#views.picture.refresh()
  }

  selectWholeRange(): void {
    void this.select(this.#state.shown.condition, null)
    this.#views.table.focus()
  }

  #show(isGrown = false): void {
    const { overview, selected, order } = this.#state.shown
    this.#views.table.show(selected?.listed ?? 0, { hasBlocks: (overview?.blocks.length ?? 0) > 0, order, isGrown })
  }
}

/** What is listed without a condition and a range. */
export function allOf({ hexahedra }: Overview): Selected {
  return { listed: hexahedra, done: hexahedra }
}

const LIST_STAYS = ' The list is as it was.'

function complaintAbout(condition: string): string | null {
  if (condition.trim() === '') return null
  const parsed = parseCondition(condition)
  if (!parsed.ok) return `${parsed.error.message}${LIST_STAYS}`
  return parsed.value.names.includes('moved')
    ? `Nothing has been moved here: “moved” is for challenges.${LIST_STAYS}`
    : null
}
