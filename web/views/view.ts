/** The contract between the element and its views: they draw a frame, and dispatch actions. */
import type { JacobianReport, Report } from '../core/report'
import type { Surface } from '../core/zero-surface'
import type { InputHost, Reading } from '../input/reading'
import type { Cameras, Dispatch, State } from '../model/state'

/** Something that keeps the page from its full work, as a sentence for people. */
export interface Problem {
  readonly code:
    | 'core-failed'
    | 'no-webgl'
    | 'context-lost'
    | 'link-broken'
    | 'input-refused'
    | 'not-read'
    | `bad-${string}`
  readonly message: string
}

/** Pictures that can be taken away. */
export type FigureName = 'scene' | 'face-maps'

/** A picture as it was on the screen, layer upon layer, in CSS pixels. */
export interface Figure {
  readonly width: number
  readonly height: number
  /** CSS colour of what lies under the layers. */
  readonly background: string
  readonly layers: readonly (PixelLayer | VectorLayer)[]
}

interface LayerBox {
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

export interface PixelLayer extends LayerBox {
  /** The layer's own canvas, on which nobody else draws. */
  readonly canvas: HTMLCanvasElement
}

export interface VectorLayer extends LayerBox {
  /** An `svg` element with every style in its attributes. */
  readonly markup: string
}

/** All that views draw in one frame. `report` is null only without a core. */
export interface Frame {
  readonly state: State
  readonly report: Report | null
  /** The surface jacdet = 0, coarser while a gesture runs; null unless the inside is shown. */
  readonly zeroSurface: Surface | null
  /** DF at `state.probe`; null if nothing is pointed at, or there is no report. */
  readonly probe: JacobianReport | null
  /** The state of the last input; null before the first, and once it is closed. */
  readonly reading: Reading | null
  /** Answers to the panels' questions by their names (`answerTo`). Empty without a report. */
  readonly answers: Readonly<Record<string, unknown>>
  readonly problems: readonly Problem[]
  /** True if it is drawn to be printed: at once, in a layout of its own. */
  readonly isForPaper: boolean
}

export type Update = (frame: Frame) => void

export interface View {
  readonly root: HTMLElement
  /** Further steps that bring it up to date. While a gesture runs they may take some frames. */
  readonly updates?: readonly Update[]
  /** Called once per animation frame in which state, report or problems changed. */
  update(frame: Frame): void
  /** The figure of that name, if this view has it on the page now. */
  figure?(name: FigureName): Figure | null
  /** The cameras as they are now, if they are this view's; null before its first picture, and until it looks as was asked for last. */
  cameras?(): Cameras | null
  /** Shows where the minimum is, if that is this view's to show. */
  showMinimum?(): void
  /** True if something of it is still to be loaded. */
  readonly isLoading?: boolean
  dispose(): void
}

export interface ViewContext {
  /** The state now, which may be ahead of the last frame's: what the next action starts from. */
  state(): State
  readonly dispatch: Dispatch
  /** Raises a problem, or takes it back by its code. */
  raise(problem: Problem): void
  clear(code: Problem['code']): void
  /** Asks for an update although neither state nor report changed (a resize, for one). */
  requestFrame(): void
  /** The camera has moved: likewise, and it may be news for the page. */
  turned(): void
  /** The address that opens this very element again, vertices bit for bit; null if there is no such page. */
  permalink(): string | null
  /** A picture; null if it is not on the page. */
  figure(name: FigureName): Figure | null
  readonly input: InputHost
}

export type CreateView = (context: ViewContext) => View
