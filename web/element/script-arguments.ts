/** What a page's script says to the element, as plain values: read here, or refused with a sentence. */
import {
  between,
  coordinates,
  flag,
  indexBelow,
  list,
  object,
  orNull,
  type Reader,
  reader,
  record,
  text,
} from '../model/document-readers'
import { edgeVertices, faces, VERTEX_COUNT, type Vec3 } from '../model/hexahedron'
import { Refusal } from '../model/result'
import type { CameraView } from '../model/state'
import { camera } from '../model/state-document'
import type { PlaceMarks, PlacePoint } from '../views/place-marks'
import type { ScriptState, Surroundings } from '../views/scene-slices'
import { HexLensError } from './hex-lens-error'

/** Parts of the element, by their numbers or as one number, and a point (xi, eta, zeta) of [0,1]^3. */
export interface HighlightedParts {
  /** 0..7, in VTK_HEXAHEDRON order. */
  readonly vertices?: number | readonly number[] | undefined
  /** 0..11, in the order of VTK_HEXAHEDRON. */
  readonly edges?: number | readonly number[] | undefined
  /** 0..5: -xi, +xi, -eta, +eta, -zeta, +zeta. */
  readonly faces?: number | readonly number[] | undefined
  readonly point?: readonly [number, number, number] | null | undefined
}

/** Hexahedra around the element, and vertices that stay. */
export interface SurroundingParts {
  readonly hexahedra?: readonly { readonly vertices: readonly number[]; readonly isInvalid?: boolean }[] | undefined
  /** 0..7, in VTK_HEXAHEDRON order. */
  readonly fixed?: number | readonly number[] | undefined
}

/** A place of a vertex, and points that are labelled: positions are x, y, z. */
export interface PlaceParts {
  /** 0..7, in VTK_HEXAHEDRON order. */
  readonly vertex: number
  readonly position?: readonly [number, number, number] | null | undefined
  readonly points?:
    | readonly {
        readonly position: readonly [number, number, number]
        /** (xi, eta, zeta) where it is one of the element’s. */
        readonly point?: readonly [number, number, number] | null | undefined
        readonly label: string
        /** From 0 to 1. */
        readonly weight?: number | null | undefined
      }[]
    | undefined
}

/** A camera to move to: what is missing is as in the view in which the element just fits. */
export type CameraGoal = Pick<CameraView, 'direction'> & Partial<CameraView>

interface Parts {
  readonly vertices: readonly number[]
  readonly edges: readonly number[]
  readonly faces: readonly number[]
  readonly point: Vec3 | null
}

const indices = (count: number): Reader<readonly number[]> =>
  reader<readonly number[]>({}, (value, path) => [value].flat().map(index => indexBelow(count)(index, path)))

const inCube: Reader<Vec3> = reader(
  {},
  (value, path) => list(value, path, 3).map(x => between(0, 1)(x, path)) as unknown as Vec3,
)

const parts: { readonly [Key in keyof Parts]: Reader<Parts[Key]> } = {
  vertices: indices(VERTEX_COUNT),
  edges: indices(edgeVertices.length),
  faces: indices(faces.length),
  point: orNull(inCube),
}
const partsReader = record<Parts>(parts, { vertices: [], edges: [], faces: [], point: null })

/** Throws HexLensError, as all of these do. */
export function readHighlights(given: unknown): ScriptState['highlights'] {
  return understood(() => {
    const wanted = object(given ?? {}, 'highlight')
    const other = Object.keys(wanted).find(key => !(key in parts))
    if (other !== undefined) throw new Refusal(`highlight takes ${Object.keys(parts).join(', ')}, not ${other}.`)
    const { point, ...ids } = partsReader(wanted, 'highlight')
    const of = (kind: 'vertex' | 'edge' | 'face', all: readonly number[]) => all.map(id => ({ kind, id }))
    return [
      ...of('face', ids.faces),
      ...of('edge', ids.edges),
      ...of('vertex', ids.vertices),
      ...(point ? [{ kind: 'point', point } as const] : []),
    ]
  })
}

const surroundings = record<Surroundings>(
  {
    hexahedra: reader<Surroundings['hexahedra']>({}, (value, path) =>
      list(value, path).map((one, i) =>
        record<Surroundings['hexahedra'][number]>({ vertices: coordinates, isInvalid: flag }, { isInvalid: false })(
          one,
          `${path}[${i}]`,
        ),
      ),
    ),
    fixed: indices(VERTEX_COUNT),
  },
  { hexahedra: [], fixed: [] },
)

export function readSurroundings(given: unknown): Surroundings {
  return understood(() => surroundings(given ?? {}, 'surround'))
}

const inSpace: Reader<Vec3> = reader(
  {},
  (value, path) =>
    list(value, path, 3).map(x => between(-Number.MAX_VALUE, Number.MAX_VALUE)(x, path)) as unknown as Vec3,
)

const placePoint = record<PlacePoint>(
  { position: inSpace, point: orNull(inCube), label: text, weight: orNull(between(0, 1)) },
  { point: null, weight: null },
)

const place = record<PlaceMarks>(
  {
    vertex: indexBelow(VERTEX_COUNT),
    position: orNull(inSpace),
    points: reader<readonly PlacePoint[]>({}, (value, path) =>
      list(value, path).map((one, i) => placePoint(one, `${path}[${i}]`)),
    ),
  },
  { position: null, points: [] },
)

export function readPlace(given: unknown): PlaceMarks | null {
  return understood(() => (given === null ? null : place(given, 'markPlace')))
}

export function readCameraView(given: unknown): CameraView {
  return understood(() => camera(given, 'camera'))
}

/** An hour at most. */
export function readSeconds(given: unknown): number {
  return understood(() => between(0, 3600)(given, 'seconds'))
}

function understood<T>(read: () => T): T {
  try {
    return read()
  } catch (reason) {
    if (reason instanceof Refusal) throw new HexLensError('bad-argument', reason.message)
    throw reason
  }
}
