/**
 * `element.history`: undo and redo as plain data to keep as JSON, and its reader. docs/history.schema.json is written from it.
 * Version 1 is read for ever, as that of a state.
 */
import {
  COORDINATES_SCHEMA,
  type Coordinate,
  coordinates,
  described,
  indexBelow,
  list,
  orNull,
  reader,
  readVersion,
  record,
  type Schema,
  text,
} from './document-readers'
import { type CodedError, Refusal, type Result } from './result'
import type { History, Snapshot } from './state'
import { HISTORY_LIMIT } from './store'

export const HISTORY_VERSION = 1

export interface HistoryDocument {
  readonly version: typeof HISTORY_VERSION
  readonly elements: readonly HistoryElement[]
  readonly present: number
}

export interface HistoryElement extends Omit<Snapshot, 'vertices' | 'start'> {
  readonly vertices: readonly Coordinate[]
  readonly start: readonly Coordinate[]
}

export type HistoryErrorCode = 'malformed-history' | 'unknown-version'

export function historyDocument(history: History): HistoryDocument {
  return { version: HISTORY_VERSION, ...(historyReader.write(history) as Omit<HistoryDocument, 'version'>) }
}

/** Reads what `historyDocument` wrote, or what JSON.parse made of it. */
export function readHistory(given: unknown): Result<History, CodedError<HistoryErrorCode>> {
  return readVersion('history', 'malformed-history', HISTORY_VERSION, given, () => {
    const history = historyReader(given, 'history')
    if (history.present >= history.elements.length)
      throw new Refusal(`history.present is ${history.present}, which none of its elements is.`)
    return history
  })
}

/** JSON Schema of all that a document has. */
export function historySchema(): Schema {
  const { required, properties } = historyReader.schema as { required: string[]; properties: object }
  return {
    type: 'object',
    required: ['version', ...required],
    properties: { version: { const: HISTORY_VERSION }, ...properties },
    $defs: { vertices: COORDINATES_SCHEMA },
  }
}

const MOST = HISTORY_LIMIT + 1

const element = record<Snapshot>({ vertices: coordinates, preset: orNull(text), start: coordinates }, {})

const elements = reader<readonly Snapshot[]>(
  { type: 'array', minItems: 1, maxItems: MOST, items: element.schema },
  (value, path) => {
    const given = list(value, path)
    if (given.length > MOST) throw new Refusal(`${path} has ${given.length} entries; ${MOST} are the most.`)
    return given.map((each, i) => element(each, `${path}[${i}]`))
  },
  given => given.map(element.write),
)

const historyReader = record<History>(
  {
    elements: described('All that undo and redo lead to, in order; each as in a state.', elements),
    present: described('The index of the one that is shown.', indexBelow(MOST)),
  },
  {},
)
