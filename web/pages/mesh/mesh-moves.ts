/** Moves of vertices on their way to the open mesh, and whether a file has them. */
import type { OpenSurvey } from '../../survey/open-survey'
import type { MovedMesh, MovementCounts, Overview } from '../../survey/survey-jobs'
import type { MovingLens } from './moving-lens'
import type { PageState } from './page-state'
import type { UntanglePanel } from './untangle-panel'

export interface MovesViews {
  readonly moving: MovingLens
  readonly untangling: UntanglePanel
}

export class MeshMoves {
  readonly #state: PageState
  readonly #views: MovesViews
  readonly #show: (own: OpenSurvey, overview: Overview) => Promise<void>
  #count = 0
  #last: Promise<unknown> = Promise.resolve()
  #saved: MovementCounts | null = null

  /** `show`: the same mesh with vertices elsewhere, once no more are on their way. */
  constructor(state: PageState, views: MovesViews, show: (own: OpenSurvey, overview: Overview) => Promise<void>) {
    this.#state = state
    this.#views = views
    this.#show = show
  }

  get areUnderWay(): boolean {
    return this.#count > 0
  }

  /** Resolves when the mesh has all moves so far. */
  get done(): Promise<unknown> {
    return this.#last
  }

  /** True if vertices have moved, and no file has them. */
  get areUnsaved(): boolean {
    const { movement } = this.#state.shown
    return movement.movedCount > 0 && movement !== this.#saved
  }

  /** The mesh as it is has been saved whole. */
  saved(): void {
    this.#saved = this.#state.shown.movement
  }

  async take(step: (own: OpenSurvey) => Promise<MovedMesh>): Promise<void> {
    const own = this.#state.survey
    this.#count++
    const answer = this.#state.asked(step)
    this.#last = answer
    const moved = await answer
    this.#count--
    if (!own || own !== this.#state.survey || moved === null) return
    this.#state.set({ movement: moved.movement })
    this.#views.moving.movement = moved.movement
    this.#views.untangling.moved(moved.opened)
    if (!this.areUnderWay) await this.#show(own, moved.opened)
  }
}
