/** The scene's parts of the state, which panels show and change, too. */
import { between, described, flag, oneOf, record } from '../model/document-readers'
import { type Axis, edgeVertices, faces, VERTEX_COUNT, type Vec3, type Vertices } from '../model/hexahedron'
import { type Action, type PassingSlice, type Slice, type State, sliceChange, sliceOf } from '../model/state'
import { checkFinite, checkInCube, checkIndex, checkOrder, checkWithin } from '../model/store'

/** Faces: all opaque, see-through, hardly seen around what is inside, or one face alone (0..5). */
export type FaceDisplay = 'opaque' | 'see-through' | 'inside' | number

/** A section of the reference cube: xi, eta or zeta (axis 0, 1, 2) is `value`, in [0,1]. */
export interface Section {
  readonly axis: Axis
  readonly value: number
}

export interface SceneState {
  readonly faceDisplay: FaceDisplay
  /** True if the reference cube stands beside the element. */
  readonly referenceShown: boolean
  /** True if turning the element turns the reference cube, and the other way round. */
  readonly camerasLinked: boolean
  readonly section: Section
}

export const sceneSlice: Slice<SceneState> = {
  name: 'scene',
  first: { faceDisplay: 'opaque', referenceShown: false, camerasLinked: false, section: { axis: 2, value: 0.5 } },
  readers: {
    faceDisplay: described(
      'How the faces are drawn: all opaque, see-through, hardly seen around what is inside, or one face alone, -xi, +xi, -eta, +eta, -zeta, +zeta.',
      oneOf('opaque', 'see-through', 'inside', ...faces.keys()),
    ),
    referenceShown: described('Whether the reference cube stands beside the element.', flag),
    camerasLinked: described('Whether turning the element turns the reference cube, and the other way round.', flag),
    section: described(
      'The section of Inside: xi, eta or zeta (axis 0, 1, 2) is `value`.',
      record<Section>({ axis: oneOf(0, 1, 2), value: between(0, 1) }, {}),
    ),
  },
  check({ faceDisplay, section }) {
    if (typeof faceDisplay === 'number') checkIndex(faceDisplay, faces.length, 'face')
    checkWithin(section.value, 0, 1)
  },
}

/** Buttons of the scene that an author may leave out. */
export const CONTROLS = ['minimum', 'faces', 'reference', 'turn', 'fit', 'help'] as const
export type Control = (typeof CONTROLS)[number]

/** What drags of a vertex are held to, by keys or by chips. */
export interface DragKeys {
  readonly axis: Axis | null
  readonly depth: boolean
  readonly snap: boolean
}

export const FREE: DragKeys = { axis: null, depth: false, snap: false }

export interface ControlsState {
  /** The buttons that are there. */
  readonly controls: readonly Control[]
  /** True if the help is on the screen. */
  readonly helpShown: boolean
  /** True if the scene was last used by a finger or a pen: there may be no keys. */
  readonly byFinger: boolean
  /** What the chips hold drags to. */
  readonly held: DragKeys
}

export const controlsSlice: PassingSlice<ControlsState> = {
  name: 'controls',
  first: {
    controls: CONTROLS,
    helpShown: false,
    byFinger: globalThis.matchMedia?.('(pointer: coarse)').matches ?? false,
    held: FREE,
  },
}

/** What the chips hold a drag to now: nothing while a mouse drags. */
export function heldByChips(state: State): DragKeys {
  const { byFinger, held } = sliceOf(controlsSlice, state)
  return byFinger ? held : FREE
}

export function helpToggled(state: State): Action {
  return sliceChange(controlsSlice, { helpShown: !sliceOf(controlsSlice, state).helpShown })
}

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

const ENTITY_COUNTS: Readonly<Record<Entity['kind'], number>> = {
  vertex: VERTEX_COUNT,
  edge: edgeVertices.length,
  face: faces.length,
}

export interface MarksState {
  /** The entity that is spoken of. */
  readonly highlight: Entity | null
  /** Samples of the check that is pointed at. */
  readonly samples: Samples | null
  /** The face whose curve s*(t) is drawn: the points at which jacdet is least among those of the same t. */
  readonly curveOn: number | null
}

/** What every view is to mark; null where there is nothing. */
export const marksSlice: PassingSlice<MarksState> = {
  name: 'marks',
  first: { highlight: null, samples: null, curveOn: null },
  check({ highlight, samples, curveOn }) {
    if (highlight) checkIndex(highlight.id, ENTITY_COUNTS[highlight.kind], highlight.kind)
    samples?.points.forEach(checkInCube)
    if (curveOn !== null) checkIndex(curveOn, faces.length, 'face')
  },
}

/** A point (xi, eta, zeta) of [0,1]^3 that is spoken of. */
export interface SpokenPoint {
  readonly kind: 'point'
  readonly point: Vec3
}

export interface ScriptState {
  readonly highlights: readonly (Entity | SpokenPoint)[]
  readonly hiddenFaces: readonly number[]
}

/** What the page's script wants to be seen. Who asks for it has checked it. */
export const scriptSlice: PassingSlice<ScriptState> = {
  name: 'script',
  first: { highlights: [], hiddenFaces: [] },
}

export interface Surroundings {
  /** Other hexahedra, which are drawn as thin lines. */
  readonly hexahedra: readonly { readonly vertices: Vertices; readonly isInvalid: boolean }[]
  /** Vertices that are marked as those that stay. */
  readonly fixed: readonly number[]
}

/** What the page's script wants to be seen around the element. Who asks for it has checked it. */
export const surroundingsSlice: PassingSlice<Surroundings> = {
  name: 'surroundings',
  first: { hexahedra: [], fixed: [] },
}

/** All that is spoken of, the panel's entity last. */
export function spokenOf(state: State): ScriptState['highlights'] {
  const { highlight } = sliceOf(marksSlice, state)
  return [...sliceOf(scriptSlice, state).highlights, ...(highlight ? [highlight] : [])]
}

/** The faces that are drawn: one that the reader wants alone is, even if the page hides it. */
export function drawnFaces(display: FaceDisplay, hidden: readonly number[]): readonly number[] {
  return typeof display === 'number' ? [display] : [...faces.keys()].filter(face => !hidden.includes(face))
}

/** A change of the element that is drawn beside it: another node order, whose vertex i is the vertex `order[i]`, or other vertices. */
export type Preview =
  | { readonly order: readonly number[]; readonly move?: undefined }
  | { readonly move: Vertices; readonly order?: undefined }

export const previewSlice: PassingSlice<{ readonly preview: Preview | null }> = {
  name: 'preview',
  first: { preview: null },
  check({ preview }) {
    if (preview?.order) checkOrder(preview.order)
    if (preview?.move) checkFinite(preview.move)
  },
  endsWithVertices: true,
}
