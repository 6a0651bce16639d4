/**
 * What was on the screen at each entry of this tab's history, for Back, Forward and reload. The address has the vertices; this
 * has the rest, in the session's storage, where the browser gives one: without it the rest is as in a new page.
 */
import type { StateDocument } from '../model/state-document'

export interface Place {
  readonly state: StateDocument
  /** In pixels: how far the page is scrolled, and what scrolls by itself beside the scene; in the lessons where the step is in the window. */
  readonly scroll: readonly number[]
}

const KEY = 'hexlens-places'
/** Browsers keep fewer entries. */
const MOST = 100

/** The key of the present entry, which is given one if it has none. */
export function presentEntry(): string {
  const state = history.state as { readonly entry?: unknown } | null
  if (typeof state?.entry === 'string') return state.entry
  const entry = `${Date.now()}-${Math.random()}`
  history.replaceState({ entry }, '')
  return entry
}

export function placeAt(entry: string): Place | null {
  return stored().get(entry) ?? null
}

export function keepPlace(entry: string, place: Place): void {
  const places = stored()
  places.delete(entry) // the latest last
  places.set(entry, place)
  try {
    sessionStorage.setItem(KEY, JSON.stringify([...places].slice(-MOST)))
  } catch {
    // Nothing can be kept.
  }
}

function stored(): Map<string, Place> {
  try {
    return new Map(JSON.parse(sessionStorage.getItem(KEY) ?? '[]'))
  } catch {
    return new Map()
  }
}
