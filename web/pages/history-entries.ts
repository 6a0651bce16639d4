/**
 * The state and scroll position at each entry of this tab's history, for Back, Forward and reload.
 * The address has the vertices; this has the rest, in the session's storage, where the browser
 * gives one: without it the rest is as in a new page.
 */
import type { StateDocument } from '../model/state-document'

export interface HistoryEntry {
  readonly state: StateDocument
  /** Pixels: scroll positions of the page and of the panels; in the lessons, of the step. */
  readonly scroll: readonly number[]
}

const KEY = 'hexlens-entries'
/** Browsers keep fewer entries. */
const MOST = 100

/** The key of the present entry, which is given one if it has none. */
export function presentKey(): string {
  const state = history.state as { readonly entry?: unknown } | null
  if (typeof state?.entry === 'string') return state.entry
  const entry = `${Date.now()}-${Math.random()}`
  history.replaceState({ entry }, '')
  return entry
}

export function entryAt(key: string): HistoryEntry | null {
  return stored().get(key) ?? null
}

export function keepEntry(key: string, entry: HistoryEntry): void {
  const entries = stored()
  entries.delete(key) // the latest last
  entries.set(key, entry)
  try {
    sessionStorage.setItem(KEY, JSON.stringify([...entries].slice(-MOST)))
  } catch {
    // Nothing can be kept.
  }
}

function stored(): Map<string, HistoryEntry> {
  try {
    return new Map(JSON.parse(sessionStorage.getItem(KEY) ?? '[]'))
  } catch {
    return new Map()
  }
}
