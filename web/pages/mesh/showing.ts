/** An open mesh becomes what the page shows. What comes first is said first: the sentence and the list, then the picture. */
import type { CellTable } from '../../mesh-views/cell-table'
import type { OpenSurvey } from '../../survey/open-survey'
import type { Overview } from '../../survey/survey-jobs'
import type { Choosing } from './choosing'
import { allOf, type Listing } from './listing'
import type { MovingLens } from './moving-lens'
import { NOTHING_SHOWN, type PageState, type Shown } from './page-state'
import { NOT_IN_STEPS } from './page-words'
import type { PictureControls } from './picture-controls'
import { blockOf } from './picture-settings'
import type { Travelling } from './settings-text'
import type { SettingsTravel } from './settings-travel'
import type { StepsView } from './steps-view'
import type { UntanglePanel } from './untangle-panel'

/** What is known of a mesh beside its overview. */
export type About = Pick<Shown, 'example' | 'beside'> & Partial<Pick<Shown, 'movement'>>

export interface ShowingViews {
  readonly table: CellTable
  readonly picture: PictureControls
  readonly moving: MovingLens
  readonly steps: StepsView
  readonly untangling: UntanglePanel
}

export interface ShowingActions {
  readonly listing: Listing
  readonly choosing: Choosing
  readonly travel: SettingsTravel
}

export class Showing {
  readonly #state: PageState
  readonly #views: ShowingViews
  readonly #actions: ShowingActions

  constructor(state: PageState, views: ShowingViews, actions: ShowingActions) {
    this.#state = state
    this.#views = views
    this.#actions = actions
  }

  /** The mesh that has just been opened. */
  async show(overview: Overview, about: About): Promise<void> {
    const { table, picture, moving, steps, untangling } = this.#views
    const { choosing, travel } = this.#actions
    const state = this.#state
    const own = state.survey as OpenSurvey
    // Another mesh may be on its way by now.
    const { progress, news, aside } = state.shown
    state.set({ ...NOTHING_SHOWN, ...about, progress, news, aside, overview, selected: allOf(overview) })
    const { order } = state.shown
    table.show(overview.hexahedra, { hasBlocks: overview.blocks.length > 0, order }, overview.worst)
    const arriving = travel.arrivingIn(overview, about.example !== null)
    picture.open(overview, arriving?.picture, arriving?.camera)
    picture.say(travel.takeNotice())
    moving.movement = state.shown.movement
    await steps.open(own)
    if (own !== state.survey) return
    untangling.open(overview, steps.hasSteps ? NOT_IN_STEPS : '')
    const [worst] = overview.worst
    if (worst) await choosing.choose(worst.cell, 0)
    if (arriving && own === state.survey) await this.#list(arriving)
    const histogram = await state.asked(open => open.histogram())
    if (histogram === null) return
    state.set({ histogram })
    if ((await state.asked(open => open.join(part => own === state.survey && picture.joining(part)))) === null) return
    await picture.show()
    if (state.chosen && own === state.survey) await choosing.choose(state.chosen.cell, null)
    if (own === state.survey) await steps.readAll()
  }

  /** The same cells with other points. Order, selection and view stay; `cell` is chosen. */
  async showAnew(own: OpenSurvey, overview: Overview, cell: number | null): Promise<void> {
    const { picture } = this.#views
    const { listing, choosing } = this.#actions
    const state = this.#state
    if (own !== state.survey) return
    const { order, condition, range } = state.shown
    await state.asked(open => open.arrange(order))
    if (own !== state.survey) return
    state.set({ overview, selected: allOf(overview) })
    picture.step(overview)
    if (cell === null) choosing.chooseNone()
    else await choosing.choose(cell, null)
    await listing.select(condition, range)
    const both = await state.asked(open => Promise.all([open.histogram(), open.join(() => {})]))
    if (both === null) return
    state.set({ histogram: both[0] })
    await picture.show()
    if (cell === null) return
    const place = await state.asked(open => open.placeOf(cell))
    if (place && state.chosen?.cell === cell) await choosing.choose(cell, place.rank)
  }

  /** Settings that have come, for the open mesh. */
  async use(fitting: Travelling): Promise<void> {
    this.#views.picture.use(fitting.picture, fitting.camera)
    await this.#list(fitting)
  }

  async #list({ listing: { condition, range, order }, chosen: cell }: Travelling): Promise<void> {
    const { listing, choosing } = this.#actions
    const own = this.#state.survey
    await listing.arrange(order)
    if (own === this.#state.survey) await listing.select(condition, range)
    const wanted = cell ?? this.#state.shown.overview?.worst[0]?.cell
    if (own === this.#state.survey && wanted !== undefined) await choosing.chooseAnywhere(wanted)
  }

  /** All that travels; null while no mesh is open. */
  get travelling(): Travelling | null {
    const { overview, condition, complaint, range, order } = this.#state.shown
    const { picture } = this.#views
    const { survey, chosen } = this.#state
    if (!overview || !survey) return null
    const block = blockOf(picture.settings.set)
    return {
      of: overview.hexahedra,
      picture: picture.settings,
      block: block === null ? null : (overview.blocks[block]?.name ?? null),
      camera: picture.camera,
      chosen: chosen?.cell === overview.worst[0]?.cell ? null : (chosen?.cell ?? null),
      listing: { condition: complaint === null ? condition : '', range, order },
    }
  }
}
