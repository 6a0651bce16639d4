/** The page's state as plain data, and its actions. No DOM, no three.js, no wasm. */
import type { Readers } from './document-readers'
import type { Axis, Vec3, Vertices } from './hexahedron'

/** jacdet of the map from [0,1]^3, or from [-1,1]^3 as finite element codes use it (an eighth). */
export type ReferenceCube = 'unit' | 'biunit'

/** Faces: all opaque, see-through, hardly seen around what is inside, or one face alone (0..5). */
export type FaceDisplay = 'opaque' | 'see-through' | 'inside' | number

/** Vertex 0..7, edge 0..11 or face 0..5 of the element, by `kind`. */
export interface Entity {
  readonly kind: 'vertex' | 'edge' | 'face'
  readonly id: number
}

/** Points (xi, eta, zeta) of [0,1]^3, or the twelve edges, on which a check evaluates jacdet. */
export interface Samples {
  readonly points: readonly Vec3[]
  readonly edges: boolean
}

/** A change of the element that is drawn beside it: another node order, whose vertex i is the vertex `order[i]`, or other vertices. */
export type Preview =
  | { readonly order: readonly number[]; readonly move?: undefined }
  | { readonly move: Vertices; readonly order?: undefined }

/** A section of the reference cube: xi, eta or zeta (axis 0, 1, 2) is `value`, in [0,1]. */
export interface Section {
  readonly axis: Axis
  readonly value: number
}

/** Buttons of the scene that an author may leave out. */
export const CONTROLS = ['faces', 'reference', 'turn', 'fit', 'help'] as const
export type Control = (typeof CONTROLS)[number]

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

export interface State {
  readonly vertices: Vertices
  /** The preset the element started from, by id; null when it came from elsewhere. */
  readonly preset: string | null
  /** Reset returns to these. */
  readonly start: Vertices
  readonly selectedVertex: number
  /** Vertices as they were when the running gesture began; null between gestures. */
  readonly gestureStart: Vertices | null
  readonly referenceCube: ReferenceCube
  readonly faceDisplay: FaceDisplay
  /** Names of panels. */
  readonly openPanels: readonly string[]
  /** True if the reference cube stands beside the element. */
  readonly referenceShown: boolean
  /** True if turning the element turns the reference cube, and the other way round. */
  readonly camerasLinked: boolean
  /** A point (xi, eta, zeta) of [0,1]^3 that is pointed at, for every view to mark; null when none is. */
  readonly probe: Vec3 | null
  /** The entity that is spoken of, for every view to mark; null when none is. */
  readonly highlight: Entity | null
  /** Samples of the check that is pointed at, for the scene to mark; null if none is. */
  readonly samples: Samples | null
  /** Ends when the vertices change. */
  readonly preview: Preview | null
  readonly section: Section
  /** True if the sheet of keys is on the screen. */
  readonly helpShown: boolean
  /** True if the reader may only look. */
  readonly isReadonly: boolean
  readonly controls: readonly Control[]
  readonly canUndo: boolean
  readonly canRedo: boolean
  /** State of panels by their names; a panel without an entry is as in a new element. */
  readonly slices: Readonly<Record<string, object>>
}

/** State that outlives the page: no gestures, previews, highlights, history, author's limits. */
export type LastingState = Omit<
  State,
  | 'gestureStart'
  | 'probe'
  | 'highlight'
  | 'samples'
  | 'preview'
  | 'helpShown'
  | 'isReadonly'
  | 'controls'
  | 'canUndo'
  | 'canRedo'
>

export type Action =
  /** One vertex to a place. Inside a gesture it adds to that gesture's one undo step, outside it is a step of its own. */
  | { readonly type: 'move-vertex'; readonly vertex: number; readonly to: Vec3 }
  /** One coordinate, `index` = 3 * vertex + axis, likewise; the vertex's other two stay as they are by then. */
  | { readonly type: 'move-coordinate'; readonly index: number; readonly to: number }
  /** All vertices, likewise; preset and start stay. */
  | { readonly type: 'move-all'; readonly vertices: Vertices }
  /** The element's beginning, without a history; Reset returns to `start`. */
  | {
      readonly type: 'initialize'
      readonly vertices: Vertices
      readonly preset: string | null
      readonly start: Vertices
    }
  /** The whole element replaced: a preset, a link, the `vertices` property. `preset` is the preset's id if it is one. */
  | { readonly type: 'set-vertices'; readonly vertices: Vertices; readonly preset: string | null }
  /** A gesture is one undo step by intent: begin, any number of moves, then commit, or cancel to restore. */
  | { readonly type: 'begin-gesture' }
  | { readonly type: 'commit-gesture' }
  | { readonly type: 'cancel-gesture' }
  | { readonly type: 'undo' }
  | { readonly type: 'redo' }
  | { readonly type: 'reset' }
  | { readonly type: 'select-vertex'; readonly vertex: number }
  | { readonly type: 'show-reference-cube'; readonly referenceCube: ReferenceCube }
  | { readonly type: 'show-faces'; readonly faceDisplay: FaceDisplay }
  /** Opening `inside` shows the inside in the scene, closing it the faces again. */
  | { readonly type: 'open-panel'; readonly panel: string; readonly isOpen: boolean }
  | { readonly type: 'show-reference'; readonly referenceShown: boolean }
  | { readonly type: 'link-cameras'; readonly camerasLinked: boolean }
  | { readonly type: 'probe'; readonly point: Vec3 | null }
  | { readonly type: 'show-help'; readonly helpShown: boolean }
  | { readonly type: 'highlight'; readonly entity: Entity | null }
  | { readonly type: 'show-samples'; readonly samples: Samples | null }
  | { readonly type: 'preview'; readonly preview: Preview | null }
  | { readonly type: 'show-section'; readonly section: Section }
  | { readonly type: 'change-slice'; readonly slice: AnySlice; readonly change: object }
  | { readonly type: 'set-readonly'; readonly isReadonly: boolean }
  | { readonly type: 'show-controls'; readonly controls: readonly Control[] }
  /** Everything at once; what this changes of the element is one step to undo. */
  | { readonly type: 'restore'; readonly state: LastingState }

export type Dispatch = (action: Action) => void
/** A panel's own part of the state. It outlives the page, and is no part of the history. */
export interface Slice<T extends object> {
  /** The panel's. */
  readonly name: string
  /** The state in a new element. */
  readonly first: T
  /** Keys in the state's document, beside those of the element and of other panels. */
  readonly readers: Readers<T>
  /** Throws RangeError for what no caller may send. */
  readonly check?: (value: T) => void
}

// biome-ignore lint/suspicious/noExplicitAny: a list holds slices of all types, and each is used with its own values alone.
export type AnySlice = Slice<any>

export function sliceOf<T extends object>({ name, first }: Slice<T>, { slices }: Pick<State, 'slices'>): T {
  return (slices[name] as T | undefined) ?? first
}

export function sliceChange<T extends object>(slice: Slice<T>, change: Partial<T>): Action {
  return { type: 'change-slice', slice, change }
}
