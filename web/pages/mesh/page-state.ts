/** What the page Mesh shows, and the mesh that is open: actions change it, and each change is drawn. */
import { wordsOf } from '../../core/workers'
import type { ReadingProgress } from '../../input/reading'
import type { OpenSurvey } from '../../survey/open-survey'
import type { Arrangement, Histogram, MovementCounts, Overview, Selected } from '../../survey/survey-jobs'
import type { Arranging } from './arranging'
import type { Example } from './examples'
import type { Range } from './histogram-range'
import { NOTHING_MOVED } from './moving-lens'
import { FIRST_LISTING } from './settings-text'

/** What is being read, while the mesh before stays. */
export interface UnderWay extends ReadingProgress {
  readonly name: string
}

/** A mesh whose moved vertices are in no file, while another one is shown. */
export interface PutAside extends Pick<Shown, 'example' | 'beside' | 'movement'> {
  readonly survey: OpenSurvey
  readonly overview: Overview
}

/** Everything that the page shows; replaced, never changed. */
export interface Shown {
  readonly progress: UnderWay | null
  /** What became of the last input, if it is not what is shown. */
  readonly news: string
  readonly aside: PutAside | null
  readonly overview: Overview | null
  readonly example: Example | null
  readonly movement: MovementCounts
  /** About the files that were given. */
  readonly beside: string
  readonly histogram: Histogram | null
  readonly order: Arrangement
  /** An order that takes longer, and which part is done. */
  readonly arranging: Arranging | null
  readonly condition: string
  readonly complaint: string | null
  readonly range: Range
  readonly selected: Selected | null
  /** About the list. */
  readonly message: string
}

export const NOTHING_SHOWN: Shown = {
  progress: null,
  news: '',
  aside: null,
  overview: null,
  example: null,
  movement: NOTHING_MOVED,
  beside: '',
  histogram: null,
  ...FIRST_LISTING,
  arranging: null,
  complaint: null,
  selected: null,
  message: '',
}

export class PageState {
  /** The chosen cell, and its place in the list if it is known. */
  chosen: { readonly cell: number; readonly rank: number | null } | null = null
  #survey: OpenSurvey | null = null
  #shown = NOTHING_SHOWN
  readonly #draw: (shown: Shown) => void

  constructor(draw: (shown: Shown) => void) {
    this.#draw = draw
  }

  get shown(): Shown {
    return this.#shown
  }

  /** The mesh that is open; null if none is. */
  get survey(): OpenSurvey | null {
    return this.#survey
  }

  /** The same; throws if none is. */
  get opened(): OpenSurvey {
    if (!this.#survey) throw new Error('No mesh is open.')
    return this.#survey
  }

  /** Changes what is shown, and draws it. */
  set(changes: Partial<Shown>): void {
    this.#shown = { ...this.#shown, ...changes }
    this.#draw(this.#shown)
  }

  /** Another mesh is open from now on. What is shown of it comes by `set`: until then the page stays as it was drawn. */
  exchange(survey: OpenSurvey, changes: Partial<Shown>): void {
    this.#survey = survey
    this.#shown = { ...this.#shown, progress: null, movement: NOTHING_MOVED, ...changes }
  }

  /** The answer of the open mesh; null if another one is open by then, or if its worker has ended, which is said. */
  async asked<T>(ask: (own: OpenSurvey) => Promise<T>): Promise<T | null> {
    const own = this.#survey
    if (!own) return null
    try {
      const answer = await ask(own)
      return own === this.#survey ? answer : null
    } catch (reason) {
      if (own === this.#survey) this.set({ news: wordsOf(reason) })
      return null
    }
  }
}
