/** What the page is about, as plain data, and every way it can change. No DOM, no three.js, no wasm. */
import type { Vec3, Vertices } from './hexahedron'

/** jacdet of the map from [0,1]^3, or from [-1,1]^3 as finite element codes use it (an eighth). */
export type ReferenceCube = 'unit' | 'biunit'

/** How the faces are drawn: all opaque, see-through, or one face alone (0..5). */
export type FaceDisplay = 'opaque' | 'see-through' | number

/** Panels below the first screen's; each is closed, and not even loaded, until it is asked for. */
export const PANELS = ['face-maps', 'algorithm', 'inside', 'node-order', 'morph', 'paste', 'take-away'] as const
export type PanelId = (typeof PANELS)[number]

/** A part of the element: vertex 0..7, edge 0..11 or face 0..5, by `kind`. */
export interface ElementPart {
  readonly kind: 'vertex' | 'edge' | 'face'
  readonly id: number
}

export interface State {
  readonly vertices: Vertices
  /** The preset the element started from, by id; null when it came from elsewhere. */
  readonly preset: string | null
  /** What Reset goes back to. */
  readonly start: Vertices
  readonly selectedVertex: number
  /** Vertices as they were when the running gesture began; null between gestures. */
  readonly gestureStart: Vertices | null
  readonly referenceCube: ReferenceCube
  readonly faceDisplay: FaceDisplay
  /** Whether the proof of the verdict is wanted. */
  readonly proofShown: boolean
  readonly openPanels: readonly PanelId[]
  /** Whether the reference cube stands beside the element. */
  readonly referenceShown: boolean
  /** Whether turning the element turns the reference cube, and the other way round. */
  readonly camerasLinked: boolean
  /** A point (xi, eta, zeta) of [0,1]^3 that is pointed at, for every view to mark; null when none is. */
  readonly probe: Vec3 | null
  /** The face 0..5 that is looked at closely. */
  readonly selectedFace: number
  /** The part that is spoken of, for every view to mark; null when none is. */
  readonly highlight: ElementPart | null
  /** Another node order of these very vertices that is looked at: its vertex i is their vertex `previewedOrder[i]`. */
  readonly previewedOrder: readonly number[] | null
  /** Ends of a way between two elements, where they were kept: else it goes from `start` to `vertices`. */
  readonly morphA: Vertices | null
  readonly morphB: Vertices | null
  /** Whether the sheet of keys is on the screen. */
  readonly helpShown: boolean
  readonly canUndo: boolean
  readonly canRedo: boolean
}

export type Action =
  /** One vertex to a place. Inside a gesture it adds to that gesture's one undo step, outside it is a step of its own. */
  | { readonly type: 'move-vertex'; readonly vertex: number; readonly to: Vec3 }
  /** One coordinate, `index` = 3 * vertex + axis, likewise; the vertex's other two stay as they are by then. */
  | { readonly type: 'move-coordinate'; readonly index: number; readonly to: number }
  /** All vertices, likewise; preset and start stay. */
  | { readonly type: 'move-all'; readonly vertices: Vertices }
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
  | { readonly type: 'show-proof'; readonly proofShown: boolean }
  | { readonly type: 'open-panel'; readonly panel: PanelId; readonly isOpen: boolean }
  | { readonly type: 'show-reference'; readonly referenceShown: boolean }
  | { readonly type: 'link-cameras'; readonly camerasLinked: boolean }
  | { readonly type: 'probe'; readonly point: Vec3 | null }
  | { readonly type: 'show-help'; readonly helpShown: boolean }
  | { readonly type: 'select-face'; readonly face: number }
  | { readonly type: 'highlight'; readonly part: ElementPart | null }
  /** Looked at until the vertices change. */
  | { readonly type: 'preview-order'; readonly order: readonly number[] | null }
  /** Null lets the end follow the element again. */
  | { readonly type: 'keep-morph-end'; readonly end: 'morphA' | 'morphB'; readonly vertices: Vertices | null }

export type Dispatch = (action: Action) => void
