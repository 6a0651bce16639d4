/**
 * `element.state`: what the page is about as plain data to keep as JSON, and its reader. The schema, docs/state.schema.json,
 * says what each key means. Version 1 is read for ever: keys may be added to it, and a reader ignores those that it does not know;
 * where one is missing, it is as in a new element.
 */
import {
  between,
  type Coordinate,
  coordinates,
  flag,
  indexBelow,
  list,
  object,
  oneOf,
  orNull,
  type Reader,
  Refused,
  record,
  text,
  written,
} from './document-readers'
import { faces, VERTEX_COUNT, type Vec3, type Vertices } from './hexahedron'
import { type Cameras, type CameraView, type LastingState, PANELS, type PanelId, STEP_COUNT, type State } from './state'
import { SHOWN_FIRST } from './store'

export const STATE_VERSION = 1

type VerticesKey = 'vertices' | 'start' | 'morphA' | 'morphB'

export interface StateDocument extends Omit<LastingState, VerticesKey>, Cameras {
  readonly version: typeof STATE_VERSION
  readonly vertices: readonly Coordinate[]
  readonly start: readonly Coordinate[]
  readonly morphA: readonly Coordinate[] | null
  readonly morphB: readonly Coordinate[] | null
}

export interface StateError {
  readonly code: 'malformed-state' | 'unknown-version'
  /** One sentence for people. */
  readonly message: string
}

export type StateResult =
  | { readonly ok: true; readonly value: { readonly state: LastingState; readonly cameras: Cameras } }
  | { readonly ok: false; readonly error: StateError }

export function stateDocument(state: State, { camera, referenceCamera }: Cameras): StateDocument {
  const {
    gestureStart,
    probe,
    highlight,
    previewedOrder,
    previewedMove,
    helpShown,
    isReadonly,
    controls,
    canUndo,
    canRedo,
    ...lasting
  } = state
  return {
    version: STATE_VERSION,
    ...lasting,
    vertices: written(state.vertices),
    start: written(state.start),
    morphA: state.morphA && written(state.morphA),
    morphB: state.morphB && written(state.morphB),
    camera,
    referenceCamera,
  }
}

/** Reads what `stateDocument` or a person wrote, or what JSON.parse made of it. */
export function readState(given: unknown): StateResult {
  try {
    const { version } = object(given, 'state')
    if (typeof version === 'number' && version > STATE_VERSION)
      return refusal('unknown-version', `The state is of version ${version}, which is not known here.`)
    if (version !== STATE_VERSION) throw new Refused(`The state’s version has to be ${STATE_VERSION}.`)
    const { camera, referenceCamera, start, ...others } = readDocument(given, 'state')
    const state = { ...others, start: start ?? others.vertices }
    return { ok: true, value: { state, cameras: { camera, referenceCamera } } }
  } catch (reason) {
    if (reason instanceof Refused) return refusal('malformed-state', reason.message)
    throw reason
  }
}

/** Panels of a later program are left out. */
const panels: Reader<readonly PanelId[]> = (value, path) => {
  const names = new Set(list(value, path).map((name, i) => text(name, `${path}[${i}]`)))
  return [...names].filter((name): name is PanelId => PANELS.some(panel => panel === name))
}

const pan: Reader<Vec3> = (value, path) =>
  list(value, path, 3).map((x, i) => between(-1000, 1000)(x, `${path}[${i}]`)) as unknown as Vec3

const direction: Reader<Vec3> = (value, path) => {
  const vector = pan(value, path)
  if (vector.every(x => Math.abs(x) < 1e-6)) throw new Refused(`${path} has to point somewhere.`)
  return vector
}

const cameraView: Reader<CameraView> = record<CameraView>(
  { direction, zoom: between(0.001, 1000), pan },
  { zoom: 1, pan: [0, 0, 0] },
)

type Read = Omit<LastingState, 'start'> & Cameras & { readonly start: Vertices | null }

const readDocument: Reader<Read> = record<Read>(
  {
    vertices: coordinates,
    preset: orNull(text),
    start: coordinates,
    selectedVertex: indexBelow(VERTEX_COUNT),
    referenceCube: oneOf('unit', 'biunit'),
    faceDisplay: oneOf('opaque', 'see-through', 'inside', ...faces.keys()),
    proofShown: flag,
    openPanels: panels,
    referenceShown: flag,
    camerasLinked: flag,
    selectedFace: indexBelow(faces.length),
    morphA: orNull(coordinates),
    morphB: orNull(coordinates),
    section: record({ axis: oneOf(0, 1, 2), value: between(0, 1) }, {}),
    following: record(
      { query: oneOf('minimum', 'validity'), variant: oneOf('roots', 'roots-b'), step: indexBelow(STEP_COUNT) },
      SHOWN_FIRST.following,
    ),
    camera: orNull(cameraView),
    referenceCamera: orNull(cameraView),
  },
  { ...SHOWN_FIRST, preset: null, start: null, camera: null, referenceCamera: null },
)

function refusal(code: StateError['code'], message: string): StateResult {
  return { ok: false, error: { code, message } }
}
