/** Opens meshes, each in a worker of its own. The mesh that was open stays until the other one is decided; its worker is ended then. */
import { inputName, type PastedInput } from '../../input/pasted-input'
import type { ReadingProgress } from '../../input/reading'
import { WaitingFiles } from '../../input/waiting-files'
import { OpenSurvey } from '../../survey/open-survey'
import type { Fix, Opening, Overview } from '../../survey/survey-jobs'
import { startSurveyWorker } from '../../survey/survey-worker'
import type { Example } from './examples'
import type { MeshMoves } from './mesh-moves'
import { NOTHING_SHOWN, type PageState, type PutAside } from './page-state'
import { cancelledWords, namesakeSentence, refusalWords } from './page-words'
import type { SettingsTravel } from './settings-travel'
import type { About, Showing } from './showing'

/** Milliseconds. */
const SOON = 500

export interface OpenerActions {
  readonly showing: Showing
  readonly moves: MeshMoves
  readonly travel: SettingsTravel
}

/** Where the focus goes when what had it goes: a part of the overview. */
type OpenerFocus = (selector: '.open' | '.headline') => void

export class Opener {
  readonly #state: PageState
  readonly #focus: OpenerFocus
  readonly #actions: OpenerActions
  readonly #waiting = new WaitingFiles()
  /** Another mesh, which is being read. */
  #opening: OpenSurvey | null = null
  /** A started worker for the mesh that is opened next. */
  #spare: OpenSurvey | null = null

  constructor(state: PageState, actions: OpenerActions, focus: OpenerFocus) {
    this.#state = state
    this.#focus = focus
    this.#actions = actions
  }

  async open(given: PastedInput, example: Example | null = null): Promise<void> {
    const state = this.#state
    const input = this.#waiting.completed(given)
    const name = inputName(input)
    this.#opening?.close()
    const own = this.#spare ?? new OpenSurvey(startSurveyWorker)
    this.#spare = null
    this.#opening = own
    state.set({ news: '' })
    const progress = this.#progressOf(own, name)
    const result = await own.open(input, progress.take)
    progress.end()
    if (own !== this.#opening) return own.close()
    this.#waiting.refused(input, 'refused' in result ? result.missing : [])
    if ('refused' in result) {
      this.#opening = null
      own.close()
      state.set({ progress: null, news: refusalWords(name, result.refused, this.#openName) })
      return
    }
    await this.#actions.moves.done
    if (own !== this.#opening) return own.close()
    this.#opening = null
    state.exchange(own, { aside: this.#putAside(state.shown.aside) })
    const aboutNames = 'files' in input ? namesakeSentence(input.paths) : ''
    const beside = aboutNames !== '' && (await state.asked(open => open.steps())) === null ? aboutNames : ''
    if (own === state.survey) await this.#show(result.opened, { example, beside })
  }

  /** While another mesh is there to look at, the progress of one that is soon read would only flicker. */
  #progressOf(own: OpenSurvey, name: string) {
    let latest: ReadingProgress = { step: 'reading', fraction: 0 }
    let isShown = false
    const show = () => {
      isShown = true
      if (own === this.#opening) this.#state.set({ progress: { name, ...latest } })
    }
    const isOther = this.#state.survey !== null && this.#state.shown.progress === null
    const timer = isOther ? setTimeout(show, SOON) : null
    if (timer === null) show()
    return {
      take(progress: ReadingProgress) {
        latest = progress
        if (isShown) show()
      },
      end: () => clearTimeout(timer ?? undefined),
    }
  }

  cancel(): void {
    this.#opening?.close()
    this.#opening = null
    this.#state.set({ progress: null, news: cancelledWords(this.#openName) })
    this.#focus('.open')
  }

  async bringBack(aside: PutAside): Promise<void> {
    const { survey: own, overview, ...about } = aside
    const state = this.#state
    this.#opening?.close()
    this.#opening = null
    await this.#actions.moves.done
    if (aside !== state.shown.aside) return
    state.exchange(own, { aside: this.#putAside(null), news: '' })
    await state.asked(open => open.arrange(NOTHING_SHOWN.order))
    await state.asked(open => open.select({ condition: null, range: null }, overview.hexahedra, () => {}))
    if (own !== state.survey) return
    const showing = this.#show(overview, about)
    this.#focus('.headline')
    await showing
  }

  /** The open mesh, corrected; the button goes with what it corrects. */
  async mend({ id }: Fix): Promise<void> {
    const state = this.#state
    const result = await state.asked(open => open.mend(id))
    if (!result) return
    state.set({ news: 'refused' in result ? result.refused : '' })
    if ('refused' in result) return
    this.#actions.travel.keep()
    const { example, beside, movement } = state.shown
    const showing = this.#show(result.opened, { example, beside, movement })
    this.#focus('.headline')
    await showing
  }

  /** The files of the open mesh as parts of one, in place of its steps. */
  async takeTogether(given: Opening): Promise<void> {
    this.#state.set({ news: 'refused' in given ? given.refused : '' })
    if ('opened' in given) await this.#show(given.opened, { example: null, beside: '' })
  }

  async #show(overview: Overview, about: About): Promise<void> {
    const own = this.#state.survey
    await this.#actions.showing.show(overview, about)
    if (own !== this.#state.survey || this.#spare) return
    this.#spare = new OpenSurvey(startSurveyWorker)
    this.#spare.prepare()
  }

  /** Makes room for another mesh. Returns the one with unsaved moves that stays: the open one, or the one before. */
  #putAside(before: PutAside | null): PutAside | null {
    const { survey, shown } = this.#state
    const { overview, example, beside, movement } = shown
    if (!survey) return before
    if (!overview || !this.#actions.moves.areUnsaved) {
      // Ending a worker takes as long as showing what comes in its place, which comes first.
      setTimeout(() => survey.close())
      return before
    }
    before?.survey.close()
    return { survey, overview, example, beside, movement }
  }

  get #openName(): string | null {
    const { survey, shown } = this.#state
    if (!survey) return null
    return shown.example ? 'the example' : (shown.overview?.name ?? null)
  }
}
