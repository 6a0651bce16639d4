/** The page's state as plain data, and its actions. No DOM, no three.js, no wasm. */
import type { Readers } from './document-readers'
import type { Vec3, Vertices } from './hexahedron'

/** jacdet of the map from [0,1]^3, or from [-1,1]^3 as finite element codes use it (an eighth). */
export type ReferenceCube = 'unit' | 'biunit'

/** A camera, whatever the picture's size on the screen. */
export interface CameraView {
  /** The direction from the centre of the view to the eye; of any length. */
  readonly direction: Vec3
  /** The eye's nearness: 1 if everything just fits in. */
  readonly zoom: number
  /** The shift of the view's centre from the centre of all, in halves of the longest side. */
  readonly pan: Vec3
}

/** Views of the element and of the reference cube; null is the default view. */
export interface Cameras {
  readonly camera: CameraView | null
  readonly referenceCamera: CameraView | null
}

/** Vertices set before the first frame are where the element starts; later each change is a step. */
export type Phase = 'starting' | 'begun'

/** What a step changes. */
export interface Snapshot {
  readonly vertices: Vertices
  /** The preset that the element started from, by id; null when it came from elsewhere. */
  readonly preset: string | null
  /** Reset returns to these. */
  readonly start: Vertices
}

/** The elements that undo and redo go through, in order; undo goes back from the present one. */
export interface History {
  readonly elements: readonly Snapshot[]
  /** Index of the present one. */
  readonly present: number
}

export interface State extends Snapshot {
  readonly phase: Phase
  /** Vertices as they were when the running gesture began; null between gestures. */
  readonly gestureStart: Vertices | null
  readonly canUndo: boolean
  readonly canRedo: boolean
  /** The vertex that keys move. */
  readonly selectedVertex: number
  /** False until the reader, or a page, chooses a vertex: no view then shows one as chosen. */
  readonly isVertexChosen: boolean
  readonly referenceCube: ReferenceCube
  /** The cameras last asked for, not as the reader turned them since; a new object each time, null before. */
  readonly cameras: Cameras | null
  /** A point (xi, eta, zeta) of [0,1]^3 that is pointed at, for every view to mark; null when none is. */
  readonly probe: Vec3 | null
  /** Names of panels. */
  readonly openPanels: readonly string[]
  /** True if the reader may only look. */
  readonly isReadonly: boolean
  /** State of panels and of the scene by their names; one without an entry is as in a new element. */
  readonly slices: Readonly<Record<string, object>>
}

/** State that outlives the page: no gestures, history, author's limits, and slices with readers alone. */
export type LastingState = Omit<
  State,
  'phase' | 'gestureStart' | 'canUndo' | 'canRedo' | 'isVertexChosen' | 'probe' | 'isReadonly'
>

/** The reader's means of a gesture: a panel's own, such as a slider, if it is none of the others. */
export type GestureSource = 'pointer' | 'keyboard' | 'field' | 'panel'

/**
 * Whose a change of the vertices is. `history`: undo, redo and reset; `preset`: chosen from the menu;
 * `paste`: read from what was pasted, dropped or opened; `panel`: another panel's; `program`: set by
 * the page.
 */
export type ChangeSource = GestureSource | 'history' | 'preset' | 'paste' | 'program'

export type Action =
  /** One vertex to a place. Inside a gesture it adds to that gesture's one undo step, outside it is a step of its own. */
  | { readonly type: 'move-vertex'; readonly vertex: number; readonly to: Vec3 }
  /** One coordinate, `index` = 3 * vertex + axis, likewise; the vertex's other two stay as they are by then. */
  | { readonly type: 'move-coordinate'; readonly index: number; readonly to: number }
  /** All vertices, likewise; preset and start stay. */
  | { readonly type: 'move-all'; readonly vertices: Vertices }
  /** The whole element replaced: a preset, a link, the `vertices` property. Reset returns to `start`, by default to these vertices. */
  | {
      readonly type: 'set-vertices'
      readonly vertices: Vertices
      /** The preset's id if it is one. */
      readonly preset: string | null
      readonly start?: Vertices
    }
  /** The first frame is there: from now on changes are steps. */
  | { readonly type: 'begin' }
  /** A gesture is one undo step by intent: begin, any number of moves, then commit, or cancel to restore. */
  | { readonly type: 'begin-gesture'; readonly by?: GestureSource }
  | { readonly type: 'commit-gesture' }
  | { readonly type: 'cancel-gesture' }
  | { readonly type: 'undo' }
  | { readonly type: 'redo' }
  | { readonly type: 'reset' }
  /** Null: none is chosen any more; keys still move the one that was. */
  | { readonly type: 'select-vertex'; readonly vertex: number | null }
  | { readonly type: 'show-reference-cube'; readonly referenceCube: ReferenceCube }
  | { readonly type: 'open-panel'; readonly panel: string; readonly isOpen: boolean }
  | { readonly type: 'look'; readonly cameras: Cameras | null }
  | { readonly type: 'probe'; readonly point: Vec3 | null }
  | { readonly type: 'change-slice'; readonly slice: AnyPassingSlice; readonly change: object }
  | { readonly type: 'set-readonly'; readonly isReadonly: boolean }
  /** Everything but the history at once; what this changes of the element is one step to undo. */
  | { readonly type: 'restore'; readonly state: LastingState }
  /** Its present element and its steps take the place of all that there are. */
  | { readonly type: 'take-history'; readonly history: History }

export type Dispatch = (action: Action) => void

/** A part of the state that a panel or the scene owns. It ends with the page, and is no part of the history. */
export interface PassingSlice<T extends object> {
  /** The owner's. */
  readonly name: string
  /** The state in a new element. */
  readonly first: T
  /** Throws RangeError for what no caller may send. */
  readonly check?: (value: T) => void
  /** True if it also ends when the vertices change. */
  readonly endsWithVertices?: true
}

/** A part that outlives the page. */
export interface Slice<T extends object> extends PassingSlice<T> {
  /** Keys in the state's document, beside those of the element and of other slices. */
  readonly readers: Readers<T>
}

// biome-ignore lint/suspicious/noExplicitAny: a list holds slices of all types, and each is used with its own values alone.
export type AnySlice = Slice<any>
// biome-ignore lint/suspicious/noExplicitAny: likewise.
type AnyPassingSlice = PassingSlice<any>

export function sliceOf<T extends object>({ name, first }: PassingSlice<T>, { slices }: Pick<State, 'slices'>): T {
  return (slices[name] as T | undefined) ?? first
}

export function sliceChange<T extends object>(slice: PassingSlice<T>, change: Partial<T>): Action {
  return { type: 'change-slice', slice, change }
}
