/** Which cell is chosen: in the list, in the picture, by its id, or the next invalid one. All views show the same one. */
import type { CellTable } from '../../mesh-views/cell-table'
import type { Place } from '../../survey/survey-jobs'
import type { ChosenView } from './chosen-view'
import type { MeshMoves } from './mesh-moves'
import type { MovingLens } from './moving-lens'
import type { PageState } from './page-state'
import type { PictureControls } from './picture-controls'
import type { PlaceFold } from './place-fold'
import type { StepsView } from './steps-view'

export interface ChoosingViews {
  readonly table: CellTable
  readonly picture: PictureControls
  readonly chosen: ChosenView
  readonly moving: MovingLens
  readonly place: PlaceFold
  readonly steps: StepsView
}

/** As in mesh.css. */
const PHONE = '(max-width: 43.99rem)'

export class Choosing {
  readonly #state: PageState
  readonly #views: ChoosingViews
  readonly #moves: MeshMoves

  constructor(state: PageState, views: ChoosingViews, moves: MeshMoves) {
    this.#state = state
    this.#views = views
    this.#moves = moves
  }

  async choose(cell: number, rank: number | null): Promise<void> {
    const { table, picture, chosen, moving, place, steps } = this.#views
    this.#state.chosen = { cell, rank }
    table.choose(cell, rank)
    const answers = await this.#state.asked(open => Promise.all([open.detail(cell), open.around(cell)]))
    if (!answers || this.#state.chosen?.cell !== cell || this.#moves.areUnderWay) return
    const [detail, around] = answers
    const { row, vertices, neighbours } = detail
    chosen.show(detail)
    if (vertices) moving.show(cell, vertices, around, { hasSteps: steps.hasSteps })
    else moving.showNone()
    place.show(vertices && { id: row.id, cell, around })
    picture.choose(cell, vertices, neighbours)
  }

  /** The cell that was chosen is not there any more. */
  chooseNone(): void {
    const { table, picture, chosen, moving, place } = this.#views
    this.#state.chosen = null
    moving.showNone()
    place.show(null)
    table.choose(null, null)
    chosen.showNone()
    picture.choose(null, null, [])
  }

  /** On a phone the lens lies below the list. */
  async chooseInList(cell: number, rank: number): Promise<void> {
    await this.choose(cell, rank)
    if (matchMedia(PHONE).matches) this.#views.chosen.scrollTo()
  }

  /** In the list it is where it is found. */
  async chooseAnywhere(cell: number): Promise<void> {
    await this.#chooseAt(await this.#state.asked(open => open.placeOf(cell)))
  }

  async flyTo(cell: number): Promise<void> {
    await this.#flyThere(await this.#state.asked(open => open.placeOf(cell)))
  }

  async goToNext(step: 1 | -1): Promise<void> {
    const rank = this.#state.chosen?.rank ?? (step > 0 ? -1 : 0)
    const own = this.#state.survey
    const place = await this.#state.asked(open => open.nextInvalid(rank, step))
    if (own !== this.#state.survey) return
    this.#state.set({ message: place ? '' : 'No invalid cell is in the list.' })
    await this.#flyThere(place)
  }

  async goTo(id: string): Promise<void> {
    const own = this.#state.survey
    const place = await this.#state.asked(open => open.find(id, this.#state.chosen?.rank ?? -1))
    if (own !== this.#state.survey) return
    this.#state.set({ message: place ? '' : `There is no cell ${id} in the list.` })
    await this.#flyThere(place)
  }

  async #chooseAt(place: Place | null): Promise<void> {
    if (place) await this.choose(place.cell, place.rank)
  }

  async #flyThere(place: Place | null): Promise<void> {
    await this.#chooseAt(place)
    if (place) this.#views.picture.flyToChosen()
  }
}
