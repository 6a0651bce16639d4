/**
 * Challenges in one link, in order, and what a student hands in of them. A challenge of this page is
 * named by its id, a teacher's is there whole. docs/series.schema.json says what each key means.
 * Version 1 is read for ever, and a reader ignores keys that it does not know.
 */
import {
  COORDINATES_SCHEMA,
  type Coordinate,
  coordinates,
  described,
  list,
  object,
  orNull,
  type Reader,
  reader,
  record,
  type Schema,
} from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import { Refusal, type Result } from '../../model/result'
import { type Challenge, type ChallengeDocument, challengeReader, LIMITS, plainText } from './challenge'
import { challenges as ofThisPage } from './challenges'

export const SERIES_VERSION = 1
export const MOST_CHALLENGES = 12

export interface SeriesDocument {
  readonly version: typeof SERIES_VERSION
  readonly challenges: readonly (string | ChallengeDocument)[]
  readonly handedIn?: HandedInDocument | null
}

interface HandedInDocument {
  readonly name?: string | null
  readonly elements: readonly (readonly Coordinate[] | null)[]
}

/** A challenge of a series. */
export interface Member {
  /** Null of a teacher's. */
  readonly id: string | null
  readonly challenge: Challenge
  /** As it was read. */
  readonly document: string | ChallengeDocument
}

export interface HandedIn {
  readonly name: string | null
  /** One for each challenge; null where nothing was made. */
  readonly elements: readonly (Vertices | null)[]
}

export interface Series {
  readonly members: readonly Member[]
  readonly handedIn: HandedIn | null
}

/** Reads what JSON.parse made of it. */
export function readSeries(given: unknown): Result<Series, string> {
  try {
    const { version } = object(given, 'series')
    if (typeof version === 'number' && version > SERIES_VERSION)
      throw new Refusal(`The series is of version ${version}, which is not known here.`)
    if (version !== SERIES_VERSION) throw new Refusal(`The series’ version has to be ${SERIES_VERSION}.`)
    const { challenges, handedIn } = readDocument(given, 'series')
    if (handedIn && handedIn.elements.length !== challenges.length)
      throw new Refusal('series.handedIn.elements needs an element or null for each challenge.')
    return { ok: true, value: { members: challenges, handedIn } }
  } catch (reason) {
    if (reason instanceof Refusal) return { ok: false, error: reason.message }
    throw reason
  }
}

/** An member from its document. Throws Refusal. */
export const memberReader: Reader<Member> = reader<Member>(
  { anyOf: [{ enum: ofThisPage.map(({ id }) => id) }, { $ref: '#/$defs/challenge' }] },
  (value, path) => {
    if (typeof value !== 'string')
      return { id: null, challenge: challengeReader(value, path), document: value as ChallengeDocument }
    const named = ofThisPage.find(({ id }) => id === value)
    if (named === undefined) throw new Refusal(`There is no challenge “${value.slice(0, 40)}”.`)
    return { id: named.id, challenge: challengeReader(named, path), document: value }
  },
)

function listOf<T>(each: Reader<T>, atLeast: number): Reader<readonly T[]> {
  return reader<readonly T[]>(
    { type: 'array', minItems: atLeast, maxItems: MOST_CHALLENGES, items: each.schema },
    (value, path) => {
      const items = list(value, path)
      if (items.length < atLeast) throw new Refusal(`${path} is empty.`)
      if (items.length > MOST_CHALLENGES)
        throw new Refusal(`${path} has ${items.length} challenges; ${MOST_CHALLENGES} are the most.`)
      return items.map((item, i) => each(item, `${path}[${i}]`))
    },
  )
}

const readDocument = record<{ readonly challenges: readonly Member[]; readonly handedIn: HandedIn | null }>(
  {
    challenges: described('The challenges in order: ids of this page’s own, or whole ones.', listOf(memberReader, 1)),
    handedIn: described(
      'What a student has made: it is judged anew when it is opened.',
      orNull(
        record<HandedIn>(
          {
            name: described('The student’s name, if there is one.', orNull(plainText(LIMITS.title))),
            elements: described('For each challenge an element, or null.', listOf(orNull(coordinates), 1)),
          },
          { name: null },
        ),
      ),
    ),
  },
  { handedIn: null },
)

const { required, properties, ...others } = readDocument.schema
export const seriesSchema: Schema = {
  ...others,
  required: ['version', ...(required as string[])],
  properties: { version: { const: SERIES_VERSION }, ...(properties as object) },
  $defs: { vertices: COORDINATES_SCHEMA, challenge: challengeReader.schema },
}
