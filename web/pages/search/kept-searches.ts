/**
 * The reader's searches, for the tab's next page and for a new tab: the form, the element in the
 * lens, and of the latest searches the finds and where each ended, so that it goes on from there.
 * The version is that of the stream of elements, too: after a change of it no search could go on.
 */
import { COORDINATE_COUNT, type Vertices } from '../../model/hexahedron'
import { Keeper, type Shelves } from '../keep'
import { parseQuery, type Query } from './engine/query'
import type { Find, Order } from './engine/ranking'
import { Tally, type TallyDocument } from './engine/tally'

/** A search under way or stopped. */
export interface SearchRecord {
  /** The id of its kind. */
  readonly find: string
  readonly tally: Tally
  /** Milliseconds that it has run. */
  readonly ran: number
}

export interface SearchWork {
  /** As the address has it. */
  readonly form: string
  readonly vertices: Vertices
  readonly order: Order
  /** The latest first. */
  readonly searches: readonly SearchRecord[]
}

/** The finds of one search take 50 kB. */
export const MOST_SEARCHES = 8

const VERSION = 1

type RecordDocument = Omit<SearchRecord, 'tally'> & { readonly tally: TallyDocument }
type WorkDocument = Omit<SearchWork, 'searches'> & { readonly searches: readonly RecordDocument[] }

export class SearchKeeper {
  readonly #keeper: Keeper<WorkDocument>

  constructor(shelves?: Shelves) {
    this.#keeper = new Keeper('searches', VERSION, readDocument, shelves)
  }

  get keeping() {
    return this.#keeper.keeping
  }

  found(): SearchWork | null {
    const work = this.#keeper.found()
    return work && { ...work, searches: work.searches.map(record => ({ ...record, tally: Tally.from(record.tally) })) }
  }

  keep(work: SearchWork): void {
    const searches = work.searches.map(record => ({ ...record, tally: record.tally.document }))
    this.#keeper.keep({ ...work, searches })
  }
}

/** The search of the same query, if there is one. */
export function searchOf(searches: readonly SearchRecord[], query: Query): SearchRecord | undefined {
  return searches.find(({ tally }) => isSameQuery(tally.query, query))
}

/** The record in front, in the place of an earlier one of its query. */
export function withSearch(searches: readonly SearchRecord[], record: SearchRecord): readonly SearchRecord[] {
  const others = searches.filter(({ tally }) => !isSameQuery(tally.query, record.tally.query))
  return [record, ...others].slice(0, MOST_SEARCHES)
}

/** Both are made by one function, their keys in one order. */
function isSameQuery(one: Query, other: Query): boolean {
  return JSON.stringify(one) === JSON.stringify(other)
}

function readDocument(value: unknown): WorkDocument | null {
  const { form, vertices, order, searches } = (value ?? {}) as Partial<WorkDocument>
  if (typeof form !== 'string' || !isElement(vertices) || !Array.isArray(searches)) return null
  if (order !== 'simplicity' && order !== 'extremeness') return null
  return { form, vertices, order, searches: searches.filter(isRecord) }
}

function isRecord(value: unknown): value is RecordDocument {
  const { find, tally, ran } = (value ?? {}) as Partial<RecordDocument>
  const { query, blocks, found, finds } = (tally ?? {}) as Partial<TallyDocument>
  return (
    typeof find === 'string' &&
    typeof ran === 'number' &&
    isCount(blocks) &&
    isCount(found) &&
    Array.isArray(finds) &&
    finds.every(isFind) &&
    isQuery(query)
  )
}

function isQuery(query: Query | undefined): boolean {
  try {
    return query !== undefined && parseQuery(query).ok
  } catch {
    return false // of another form
  }
}

function isFind(value: unknown): value is Find {
  const { index, vertices, complexity, extremeness } = (value ?? {}) as Partial<Find>
  return isCount(index) && isElement(vertices) && typeof complexity === 'number' && typeof extremeness === 'number'
}

function isCount(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0
}

function isElement(value: unknown): value is Vertices {
  return Array.isArray(value) && value.length === COORDINATE_COUNT && value.every(Number.isFinite)
}
