/**
 * The list that was read last in this tab, as it was given: a text or files. IndexedDB holds it, since
 * it may be large; the tab knows its key. The lists of tabs that are closed go when others come.
 */
import type { PastedInput } from '../input/pasted-input'
import { Keeper, TAB_ALONE } from './keep'
import { say, unsay } from './note'

const DATABASE = 'hexlens'
const STORE = 'lists'
const MOST_MEGABYTES = 16
/** Of all tabs. */
const MOST_LISTS = 4

const key = new Keeper<number>('list', 1, value => (typeof value === 'number' ? value : null), TAB_ALONE)

/** Keeps each list that is read in the lens, and reads the one that was kept again. */
export function keepLists(lens: HTMLElementTagNameMap['hex-lens']): void {
  let list: PastedInput | null = null
  let note = ''

  async function onList(input: PastedInput | null): Promise<void> {
    if (input && list && isSame(input, list)) return // the one that was kept
    list = input
    unsay(note)
    const told = await keepList(input)
    if (list !== input) return
    note = told
    if (note !== '') say(note)
  }

  lens.addEventListener('hex-list', event => void onList((event as CustomEvent<PastedInput | null>).detail))
  void keptList().then(kept => {
    if (kept === null || list !== null) return
    list = kept
    lens.offer('text' in kept ? kept.text : kept.files, true)
  })
}

function isSame(a: PastedInput, b: PastedInput): boolean {
  if ('text' in a || 'text' in b) return 'text' in a && 'text' in b && a.text === b.text
  return a.files.length === b.files.length && a.files.every((file, i) => file === b.files[i])
}

/** Resolves to what the reader is told if it is not kept; to nothing if it is. Null is no list. */
async function keepList(input: PastedInput | null): Promise<string> {
  key.forget()
  if (input === null) return ''
  const bytes = 'text' in input ? 2 * input.text.length : input.files.reduce((sum, { size }) => sum + size, 0)
  if (bytes > MOST_MEGABYTES * 1e6)
    return `The list is gone when you leave this page: up to ${MOST_MEGABYTES} MB are kept.`
  try {
    const added = await inStore('readwrite', async store => {
      const keys = await done(store.getAllKeys())
      for (const old of keys.slice(0, Math.max(0, keys.length + 1 - MOST_LISTS))) store.delete(old)
      return done(store.add(input))
    })
    if (key.keep(added as number) === 'kept') return ''
  } catch {
    // No room, or refused.
  }
  return 'The list is gone when you leave this page: this browser does not keep it.'
}

/** Null if there is none. */
async function keptList(): Promise<PastedInput | null> {
  const own = key.own()
  if (own === null) return null
  const input = await inStore('readonly', store => done(store.get(own))).catch(() => null)
  return (input as PastedInput | null | undefined) ?? null
}

export function forgetLists(): void {
  try {
    indexedDB.deleteDatabase(DATABASE)
  } catch {
    // Nothing is stored there.
  }
}

/** A connection is closed at once: while it is open, the page could not be shown again as it was left. */
async function inStore<T>(mode: IDBTransactionMode, run: (store: IDBObjectStore) => Promise<T>): Promise<T> {
  const opening = indexedDB.open(DATABASE, 1)
  opening.onupgradeneeded = () => opening.result.createObjectStore(STORE, { autoIncrement: true })
  const database = await done(opening)
  try {
    const transaction = database.transaction(STORE, mode)
    const result = await run(transaction.objectStore(STORE))
    if (mode === 'readwrite') await committed(transaction)
    return result
  } finally {
    database.close()
  }
}

function done<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result)
    request.onerror = () => reject(request.error)
  })
}

function committed(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve()
    transaction.onabort = () => reject(transaction.error)
  })
}
