/**
 * A panel: one folder, and one line in the list of whoever composes an element. All of it is said
 * here: its region, what it keeps in the state, what it asks of the core, and the view that draws
 * it.
 */
import type { Core, Report } from '../core/report'
import type { AnySlice, State } from '../model/state'
import type { KnownPanels } from '../model/state-document'
import type { CreateView, Frame } from '../views/view'

export interface Panel {
  /** Its word in the attribute `views`, and its CSS part. */
  readonly name: string
  /** `folds` holds panels closed at first; it follows `panel`, or is beside it if there is room. */
  readonly region: 'head' | 'stage' | 'panel' | 'folds'
  readonly create: CreateView
  readonly styles: string
  /** A slow view comes after the numbers; this step before it takes a frame of its own. */
  readonly prepare?: () => void
  /** True if it is shown whatever the attribute says. */
  readonly always?: true
  /** The panel with which it is shown, and not named itself. */
  readonly with?: string
  /** True if it is left out of a read-only element. */
  readonly changes?: true
  /** True if it is left out of an element that has no page to link to. */
  readonly links?: true
  /** True if it is closed at first: its name is in `State.openPanels` while it is open. */
  readonly opens?: true
  readonly slice?: AnySlice
  readonly question?: Question<unknown>
}

/** A panel's question to the core, beyond the report. */
export interface Question<Answer> {
  /** The panel's name. */
  readonly name: string
  /** Starts for one element. `onNews` asks for a frame when a slow answer has come further. */
  start(onNews: () => void): Inquiry<Answer>
}

export interface Inquiry<Answer> {
  /** The answer so far, null if there is none. Returns quickly. */
  answer(core: Core, state: State, report: Report): Answer | null
  stop?(): void
}

export function knownPanels(panels: readonly Panel[]): KnownPanels {
  return {
    names: panels.filter(({ opens }) => opens).map(({ name }) => name),
    slices: panels.flatMap(({ slice }) => slice ?? []),
  }
}

export function answerTo<Answer>({ name }: Question<Answer>, { answers }: Pick<Frame, 'answers'>): Answer | null {
  return (answers[name] as Answer | undefined) ?? null
}
