/** The one contract between the element and its views: they receive a frame and draw it; they emit actions, nothing else. */
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

/** Parts that can be taken away as pictures. */
export type FigureName = 'scene' | 'face-maps'

/** A part's picture as it was on the screen, layer upon layer, in CSS pixels. */
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
  /** Nobody else draws on it. */
  readonly canvas: HTMLCanvasElement
}

export interface VectorLayer extends LayerBox {
  /** An `svg` element with every style in its attributes. */
  readonly markup: string
}

/** One frame's truth. `report` belongs to `state.vertices`; it is null only while the core is loading or could not start. */
export interface Frame {
  readonly state: State
  readonly report: Report | null
  /** The surface jacdet = 0, coarser while a gesture runs; null unless the inside is shown. */
  readonly zeroSurface: Surface | null
  /** DF at `state.probe`; null where nothing is pointed at, or there is no report. */
  readonly probe: JacobianReport | null
  /** What has become of the last thing pasted, dropped or opened; null before the first, and once it is put away. */
  readonly reading: Reading | null
  /** The views last asked for, from which the reader may have turned since; null before the first, each an object of its own. */
  readonly cameras: Cameras | null
  /** To what panels ask of the core, by their names: web/panels/panel.ts reads them. Empty where there is no report. */
  readonly answers: Readonly<Record<string, unknown>>
  readonly problems: readonly Problem[]
  /** Whether it is drawn to be printed: at once, in a layout of its own. */
  readonly isForPaper: boolean
}

export type Turn = (frame: Frame) => void

export interface View {
  readonly root: HTMLElement
  /** What else brings it up to date, piece by piece: at once, but while a gesture runs it may take some frames. */
  readonly turns?: readonly Turn[]
  /** Called once per animation frame in which state, report or problems changed. */
  update(frame: Frame): void
  /** The figure of that name if it is this view's and on the page now. */
  figure?(name: FigureName): Figure | null
  /** How it looks at things now, if that is this view's; null before its first picture. */
  cameras?(): Cameras | null
  /** Whether something of it is still to be loaded. */
  readonly isLoading?: boolean
  dispose(): void
}

export interface ViewHost {
  /** The state now, which may be ahead of the last frame's: what the next action starts from. */
  state(): State
  readonly dispatch: Dispatch
  /** Raise a problem, or take it back by its code. */
  raise(problem: Problem): void
  clear(code: Problem['code']): void
  /** Ask for an update although neither state nor report changed (the camera moved, the view was resized). */
  requestFrame(): void
  /** The address that opens this very element again, vertices bit for bit. */
  permalink(): string
  /** A part's picture; null while that part is not on the page. */
  figure(name: FigureName): Figure | null
  readonly input: InputHost
}

export type CreateView = (host: ViewHost) => View
