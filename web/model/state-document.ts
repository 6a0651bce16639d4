/**
 * `element.state`: what the page is about as plain data to keep as JSON, and its reader. docs/state.schema.json, written from these
 * readers, says what each key means. Version 1 is read for ever: keys may be added to it, and a reader ignores those that it does not know;
 * where one is missing, it is as in a new element.
 */
import {
  between,
  COORDINATES_SCHEMA,
  type Coordinate,
  coordinates,
  described,
  indexBelow,
  list,
  oneOf,
  orNull,
  type Reader,
  reader,
  readVersion,
  record,
  type Schema,
  text,
  texts,
} from './document-readers'
import { VERTEX_COUNT, type Vec3, type Vertices } from './hexahedron'
import { type CodedError, Refusal, type Result } from './result'
import { type AnySlice, type Cameras, type CameraView, type LastingState, sliceOf } from './state'
import { SHOWN_FIRST } from './store'

export const STATE_VERSION = 1

/** The element's own keys. */
export interface ElementDocument extends Omit<LastingState, 'vertices' | 'start' | 'cameras' | 'slices'>, Cameras {
  readonly version: typeof STATE_VERSION
  readonly vertices: readonly Coordinate[]
  readonly start: readonly Coordinate[]
}

/** The element's keys and those of its panels. */
export type StateDocument = ElementDocument & Readonly<Record<string, unknown>>

/** The panels that there are: their names and their slices. */
export interface KnownPanels {
  readonly names: readonly string[]
  readonly slices: readonly AnySlice[]
}

export type StateErrorCode = 'malformed-state' | 'unknown-version'

export type StateResult = Result<LastingState, CodedError<StateErrorCode>>

const DEFAULT_CAMERAS: Cameras = { camera: null, referenceCamera: null }

export function stateDocument(state: LastingState, { names, slices }: KnownPanels): StateDocument {
  const own = elementReader(names).write({ ...state, ...(state.cameras ?? DEFAULT_CAMERAS) })
  const kept = slices.map(slice => sliceReader(slice).write(sliceOf(slice, state)))
  return Object.assign({ version: STATE_VERSION }, own, ...kept)
}

/** Reads what `stateDocument` or a person wrote, or what JSON.parse made of it. */
export function readState(given: unknown, { names, slices }: KnownPanels): StateResult {
  return readVersion('state', 'malformed-state', STATE_VERSION, given, () => {
    const { camera, referenceCamera, start, ...shown } = elementReader(names)(given, 'state')
    const kept = slices.map(slice => [slice.name, sliceReader(slice)(given, 'state')])
    return {
      ...shown,
      start: (start as Vertices | undefined) ?? shown.vertices,
      cameras: { camera, referenceCamera },
      slices: Object.fromEntries(kept),
    }
  })
}

/** JSON Schema of all that a document has. */
export function stateSchema({ names, slices }: KnownPanels): Schema {
  const records = [elementReader(names), ...slices.map(sliceReader)].map(({ schema }) => schema)
  const properties = Object.assign({ version: { const: STATE_VERSION } }, ...records.map(each => each.properties))
  return {
    type: 'object',
    required: ['version', ...records.flatMap(each => each.required)],
    properties,
    $defs: { vertices: COORDINATES_SCHEMA, camera: cameraSchema },
  }
}

const sliceReader = ({ readers, first }: AnySlice) => record(readers, first)

/** Panels of a later program are left out. */
function panelNames(known: readonly string[]): Reader<readonly string[]> {
  return reader<readonly string[]>(texts.schema, (value, path) =>
    [...new Set(texts(value, path))].filter(name => known.includes(name)),
  )
}

const vector = { type: 'array', minItems: 3, maxItems: 3, items: { type: 'number', minimum: -1000, maximum: 1000 } }

const pan: Reader<Vec3> = reader(
  vector,
  (value, path) => list(value, path, 3).map((x, i) => between(-1000, 1000)(x, `${path}[${i}]`)) as unknown as Vec3,
)

const direction: Reader<Vec3> = reader(
  { ...vector, contains: { anyOf: [{ minimum: 1e-6 }, { maximum: -1e-6 }] } },
  (value, path) => {
    const given = pan(value, path)
    if (given.every(x => Math.abs(x) < 1e-6)) throw new Refusal(`${path} has to point somewhere.`)
    return given
  },
)

const cameraRecord = record<CameraView>(
  {
    direction: described('From what is looked at to the eye, of any length, z up.', direction),
    zoom: described('How many times nearer the eye is than where the element just fits in.', between(0.001, 1000)),
    pan: described(
      'What the view turns about, away from where it is when the element just fits in, along x, y and z, in halves of the longest side of its bounding box.',
      pan,
    ),
  },
  { zoom: 1, pan: [0, 0, 0] },
)
const cameraSchema = cameraRecord.schema
export const camera = reader({ $ref: '#/$defs/camera' }, cameraRecord)

type Read = Omit<LastingState, 'cameras' | 'slices'> & Cameras

const elementReader = (panels: readonly string[]) =>
  record<Read>(
    {
      vertices: described('The element, in VTK_HEXAHEDRON order.', coordinates),
      preset: described(
        'The preset that the element started from, by its id; null if it came from elsewhere.',
        orNull(text),
      ),
      start: described('What Reset goes back to; the same as `vertices` where it is missing.', coordinates),
      selectedVertex: indexBelow(VERTEX_COUNT),
      referenceCube: described(
        'The units of jacdet: of the map from [0,1]^3, or from [-1,1]^3.',
        oneOf('unit', 'biunit'),
      ),
      openPanels: described(`The panels that are open, of ${panels.join(', ')}.`, panelNames(panels)),
      camera: described('How the element is looked at; null is the default view.', orNull(camera)),
      referenceCamera: described('How the reference cube is looked at.', orNull(camera)),
    },
    { ...SHOWN_FIRST, preset: null, ...DEFAULT_CAMERAS },
    ['start'],
  )
