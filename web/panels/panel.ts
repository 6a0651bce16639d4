/**
 * A panel: one folder, and one line in the list of whoever composes an element. All of it is said here: where it stands, what it keeps
 * in the state, what it asks of the core, and the view that draws it.
 */
import type { Core, Report } from '../core/report'
import type { AnySlice, State } from '../model/state'
import type { KnownPanels } from '../model/state-document'
import type { CreateView, Frame } from '../views/view'

export interface Panel {
  /** In the attribute `views`, and as a CSS part. */
  readonly name: string
  /** `folds` are what is closed at first; they follow the panel, or stand beside it where there is room. */
  readonly place: 'head' | 'stage' | 'panel' | 'folds'
  readonly create: CreateView
  readonly styles: string
  /** It is slow to make, and comes after the numbers; this part of it takes a frame of its own. */
  readonly prepare?: () => void
  /** Shown whatever the attribute says. */
  readonly always?: true
  /** Shown where the panel of this name is, and not named itself. */
  readonly with?: string
  /** Left out where the element cannot be changed. */
  readonly changes?: true
  /** Closed at first: its name is in `State.openPanels` while it is open. */
  readonly opens?: true
  readonly slice?: AnySlice
  readonly question?: Question<unknown>
}

/** What a panel asks of the core beyond the report. */
export interface Question<Answer> {
  /** The panel's name. */
  readonly name: string
  /** For one element. `onNews` asks for a frame, where an answer takes long and has come further. */
  start(onNews: () => void): Inquiry<Answer>
}

export interface Inquiry<Answer> {
  /** What is known by now, null for nothing; nothing that takes long is done meanwhile. */
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
