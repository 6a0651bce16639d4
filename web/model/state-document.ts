/**
 * `element.state`: what the page is about as plain data to keep as JSON, and its reader. The schema, docs/state.schema.json,
 * says what each key means. Version 1 is read for ever: keys may be added to it, and a reader ignores those that it does not know;
 * where one is missing, it is as in a new element.
 *
 * Numbers are JSON's, so every double comes back bit for bit, except that -0 is written as "-0": JSON.stringify loses its sign.
 */
import { COORDINATE_COUNT, faces, VERTEX_COUNT, type Vec3, type Vertices } from './hexahedron'
import { type Cameras, type CameraView, type LastingState, PANELS, type PanelId, STEP_COUNT, type State } from './state'
import { SHOWN_FIRST } from './store'

export const STATE_VERSION = 1

export type Coordinate = number | '-0'

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

/** Of a value, called by its path in the state; throws Refused with a sentence. */
type Reader<T> = (value: unknown, path: string) => T
type Readers<T> = { readonly [Key in keyof T]: Reader<T[Key]> }

class Refused extends Error {}

const flag: Reader<boolean> = (value, path) => {
  if (typeof value !== 'boolean') throw new Refused(`${path} has to be true or false.`)
  return value
}

const text: Reader<string> = (value, path) => {
  if (typeof value !== 'string') throw new Refused(`${path} has to be a text.`)
  return value
}

function oneOf<const Choices extends readonly unknown[]>(...choices: Choices): Reader<Choices[number]> {
  return (value, path) => {
    if (!choices.includes(value)) throw new Refused(`${path} has to be one of ${choices.join(', ')}.`)
    return value
  }
}

function between(least: number, greatest: number): Reader<number> {
  return (value, path) => {
    if (typeof value !== 'number' || !(value >= least && value <= greatest))
      throw new Refused(`${path} has to be a number from ${least} to ${greatest}.`)
    return value
  }
}

function indexBelow(count: number): Reader<number> {
  return (value, path) => {
    if (!Number.isInteger(between(0, count - 1)(value, path))) throw new Refused(`${path} has to be a whole number.`)
    return value as number
  }
}

function orNull<T>(reader: Reader<T>): Reader<T | null> {
  return (value, path) => (value === null ? null : reader(value, path))
}

/** Other keys are ignored; the value of one that is missing is its default, or it is refused. */
function record<T>(readers: Readers<T>, defaults: Partial<T>): Reader<T> {
  return (value, path) => {
    const given = object(value, path)
    const keys = Object.keys(readers) as (keyof T & string)[]
    return Object.fromEntries(
      keys.map(key => {
        if (given[key] === undefined && key in defaults) return [key, defaults[key]]
        return [key, readers[key](given[key], `${path}.${key}`)]
      }),
    ) as T
  }
}

function object(value: unknown, path: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    throw new Refused(`${path} has to be an object.`)
  return value as Record<string, unknown>
}

function list(value: unknown, path: string, length?: number): readonly unknown[] {
  if (!Array.isArray(value) || (length !== undefined && value.length !== length))
    throw new Refused(`${path} has to be a list${length === undefined ? '' : ` of ${length}`}.`)
  return value
}

const coordinates: Reader<Vertices> = (value, path) =>
  list(value, path, COORDINATE_COUNT).map((coordinate, i) => {
    if (coordinate === '-0') return -0
    if (!Number.isFinite(coordinate)) throw new Refused(`${path}[${i}] has to be a finite number, or "-0".`)
    return coordinate as number
  })

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

function written(vertices: Vertices): Coordinate[] {
  return vertices.map(value => (Object.is(value, -0) ? '-0' : value))
}

function refusal(code: StateError['code'], message: string): StateResult {
  return { ok: false, error: { code, message } }
}
