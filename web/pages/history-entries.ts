/**
 * The state and scroll position at each entry of this tab's history, for Back, Forward and reload.
 * The address has the vertices; this has the rest. Where the browser keeps nothing, the rest is as
 * in a new page.
 */
import type { StateDocument } from '../model/state-document'
import { Keeper, TAB_ALONE } from './keep'

export interface ScrollEntry {
  /** Pixels: scroll positions of the page and of the panels; in the lessons, of the step. */
  readonly scroll: readonly number[]
}

export interface HistoryEntry extends ScrollEntry {
  readonly state: StateDocument
}

type Entries = readonly (readonly [string, ScrollEntry])[]

/** Browsers keep fewer entries. */
const MOST = 100

const keeper = new Keeper<Entries>('entries', 1, value => (Array.isArray(value) ? value : null), TAB_ALONE)

/** The key of the present entry, which is given one if it has none. */
export function presentKey(): string {
  const state = history.state as { readonly entry?: unknown } | null
  if (typeof state?.entry === 'string') return state.entry
  const entry = `${Date.now()}-${Math.random()}`
  history.replaceState({ entry }, '')
  return entry
}

/** An entry belongs to one page, which keeps one kind. */
export function entryAt<Entry extends ScrollEntry = HistoryEntry>(key: string): Entry | null {
  return (entries().get(key) as Entry | undefined) ?? null
}

export function keepEntry(key: string, entry: ScrollEntry | HistoryEntry): void {
  const all = entries()
  all.delete(key) // the latest last
  all.set(key, entry)
  keeper.keep([...all].slice(-MOST))
}

function entries(): Map<string, ScrollEntry> {
  try {
    return new Map(keeper.own())
  } catch {
    return new Map() // somebody else has written there
  }
}
