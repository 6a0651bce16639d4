/**
 * A challenge: an element to start from and conditions that all have to hold. Written as JSON by this project or by a teacher;
 * docs/challenge.schema.json says what each key means. Version 1 is read for ever, and a reader ignores keys that it does not know.
 */
import { type Condition, parseCondition, type Quantities, truthOf } from '../../model/condition'
import { NUMBERS, type NumberName } from '../../model/condition/names'
import {
  COORDINATES_SCHEMA,
  type Coordinate,
  coordinates,
  described,
  list,
  object,
  oneOf,
  orNull,
  type Reader,
  reader,
  record,
  type Schema,
} from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import { type CodedError, Refusal, type Result, refused } from '../../model/result'

export const CHALLENGE_VERSION = 1

/** The longest JSON: a longer link is hardly one any more. */
export const MOST_CHARACTERS = 8000
/** The most characters of each text, and the most conditions. */
export const LIMITS = { title: 80, text: 1200, hint: 800, condition: 200, goal: 8 }

export interface ChallengeDocument {
  readonly version: typeof CHALLENGE_VERSION
  readonly title: string
  /** The task as plain text. */
  readonly text: string
  readonly start: readonly Coordinate[]
  /** Conditions, as web/model/condition.ts reads them. */
  readonly goal: readonly string[]
  readonly record?: Contest | null
  readonly hint?: string | null
  readonly solution?: readonly Coordinate[] | null
}

/** A number to better once the goal is reached. */
export interface Contest {
  readonly quantity: NumberName
  readonly best: 'greatest' | 'least'
}

export interface Challenge {
  readonly title: string
  readonly text: string
  readonly start: Vertices
  readonly goal: readonly Condition[]
  readonly record: Contest | null
  readonly hint: string | null
  readonly solution: Vertices | null
}

type ErrorCode = 'not-json' | 'too-large' | 'unknown-version' | 'malformed' | 'bad-condition' | 'markup'

export type ChallengeResult = Result<Challenge, CodedError<ErrorCode>>

/** Reads JSON. */
export function readChallengeText(json: string): ChallengeResult {
  if (json.length > MOST_CHARACTERS)
    return refused(
      'too-large',
      `The challenge is ${json.length} characters long; ${MOST_CHARACTERS} are the most that is read.`,
    )
  let given: unknown
  try {
    given = JSON.parse(json)
  } catch (reason) {
    return refused('not-json', `The challenge is not JSON: ${(reason as Error).message}.`)
  }
  return readChallenge(given)
}

/** Reads what JSON.parse made of it. */
export function readChallenge(given: unknown): ChallengeResult {
  try {
    return { ok: true, value: challengeReader(given, 'challenge') }
  } catch (reason) {
    if (reason instanceof CodedRefusal) return refused(reason.code, reason.message)
    if (reason instanceof Refusal) return refused('malformed', reason.message)
    throw reason
  }
}

class CodedRefusal extends Refusal {
  readonly code: ErrorCode

  constructor(code: ErrorCode, message: string) {
    super(message)
    this.code = code
  }
}

/** The beginning of a tag, a comment or an entity in HTML. */
const MARKUP = /<[a-z!/?]|&(#\d+|#x[\da-f]+|[a-z]+\d*);/i

/** Plain text: shown as it is, so what looks like markup is a mistake. */
export function plainText(most: number): Reader<string> {
  return reader({ type: 'string', minLength: 1, maxLength: most }, (value, path) => {
    if (typeof value !== 'string') throw new Refusal(`${path} has to be a text.`)
    if (value.trim() === '') throw new Refusal(`${path} is empty.`)
    if (value.length > most)
      throw new CodedRefusal('too-large', `${path} is ${value.length} characters long; ${most} are the most.`)
    const [markup] = MARKUP.exec(value) ?? []
    if (markup !== undefined)
      throw new CodedRefusal('markup', `${path} is plain text, but it holds “${markup}”, which looks like HTML.`)
    return value
  })
}

const conditionText = plainText(LIMITS.condition)

const condition: Reader<Condition> = reader(conditionText.schema, (value, path) => {
  const text = conditionText(value, path)
  const result = parseCondition(text)
  if (!result.ok)
    throw new CodedRefusal(
      'bad-condition',
      `${path}, “${text}”, is not understood at character ${result.error.at + 1}: ${result.error.message}`,
    )
  return result.value
})

const goal = reader<readonly Condition[]>(
  { type: 'array', minItems: 1, maxItems: LIMITS.goal, items: condition.schema },
  (value, path) => {
    const conditions = list(value, path)
    if (conditions.length === 0) throw new Refusal(`${path} needs at least one condition.`)
    if (conditions.length > LIMITS.goal)
      throw new CodedRefusal('too-large', `${path} has ${conditions.length} conditions; ${LIMITS.goal} are the most.`)
    return conditions.map((each, i) => condition(each, `${path}[${i}]`))
  },
)

const readDocument: Reader<Challenge> = record<Challenge>(
  {
    title: plainText(LIMITS.title),
    text: described('What it is about.', plainText(LIMITS.text)),
    start: described('The element to begin with; `moved` counts from it.', coordinates),
    goal: described(
      'Conditions, all of which have to hold: comparisons < <= > >= = != of sums, products and numbers such as 0.2 and 1/3, joined by and, or, not. They speak of `valid` and of the quantities that `record` lists. An example: ["not valid", "corner_min > 0"].',
      goal,
    ),
    record: described(
      'What to do as well as one can once the goal is reached.',
      orNull(record<Contest>({ quantity: oneOf(...NUMBERS), best: oneOf('greatest', 'least') }, {})),
    ),
    hint: orNull(plainText(LIMITS.hint)),
    solution: described('An element that reaches the goal, shown on request.', orNull(coordinates)),
  },
  { record: null, hint: null, solution: null },
)

const { required, properties, ...others } = readDocument.schema

/** A document with its version. */
export const challengeReader: Reader<Challenge> = reader(
  {
    ...others,
    required: ['version', ...(required as string[])],
    properties: { version: { const: CHALLENGE_VERSION }, ...(properties as object) },
  },
  (given, path) => {
    const { version } = object(given, path)
    if (typeof version === 'number' && version > CHALLENGE_VERSION)
      throw new CodedRefusal('unknown-version', `The challenge is of version ${version}, which is not known here.`)
    if (version !== CHALLENGE_VERSION) throw new Refusal(`The challenge’s version has to be ${CHALLENGE_VERSION}.`)
    return readDocument(given, path)
  },
)

export const challengeSchema: Schema = { ...challengeReader.schema, $defs: { vertices: COORDINATES_SCHEMA } }

/** The state of the conditions: null is one that even exact arithmetic leaves open. */
export interface Judgement {
  readonly truths: readonly (boolean | null)[]
  readonly isSolved: boolean
}

export function judged(challenge: Challenge, quantities: Quantities): Judgement {
  const truths = challenge.goal.map(each => truthOf(each, quantities))
  return { truths, isSolved: truths.every(truth => truth === true) }
}
