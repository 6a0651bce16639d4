/** The one contract between the element and its views: they receive a frame and draw it; they emit actions, nothing else. */
import type { NodeOrder } from '../content/node-orders'
import type { Certificate } from '../core/exact/certificate'
import type { Morph } from '../core/morph'
import type { Nearest } from '../core/nearest/nearest'
import type { JacobianReport, Report } from '../core/report'
import type { Surface } from '../core/zero-surface'
import type { InputHost, Reading } from '../input/reading'
import type { Vertices } from '../model/hexahedron'
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

/** A certificate and what it is of: while a gesture runs, the element as it was before. */
export interface Proof {
  readonly vertices: Vertices
  readonly certificate: Certificate
}

/** The same eight points in another order, which is a valid element. */
export interface HelpfulOrder {
  /** Orders that differ by a rotation only; there is at least one. */
  readonly orders: readonly NodeOrder[]
  readonly vertices: Vertices
  /** Its least jacdet, times 2^exponent. */
  readonly boundaryMinimum: number
  readonly exponent: number
}

/** What other orders make of an invalid element: while a gesture runs, of the element as it was before. */
export interface TriedOrders {
  readonly vertices: Vertices
  /** How many orders were tried, rotations of each counted once. */
  readonly count: number
  /** The one with the greatest minimum first. */
  readonly helpful: readonly HelpfulOrder[]
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
  /** Null unless `state.proofShown`, and where there is no report. */
  readonly proof: Proof | null
  /** Null unless the panel for it is open and the element is invalid. */
  readonly triedOrders: TriedOrders | null
  /** The surface jacdet = 0, coarser while a gesture runs; null unless the inside is shown. */
  readonly zeroSurface: Surface | null
  /** DF at `state.probe`; null where nothing is pointed at, or there is no report. */
  readonly probe: JacobianReport | null
  /** What has become of the last thing pasted, dropped or opened; null before the first, and once it is put away. */
  readonly reading: Reading | null
  /** The views last asked for, from which the reader may have turned since; null before the first, each an object of its own. */
  readonly cameras: Cameras | null
  /** Null unless its panel is open; while a gesture runs, the way as it was before. */
  readonly morph: Morph | null
  /** As far as it is known, and of the vertices it says. Null unless the page has added its panel and that is open. */
  readonly nearest: Nearest | null
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
