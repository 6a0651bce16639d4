/** Inputs that the browser keeps for its pages, texts or files, in IndexedDB, since they may be large. The oldest go when others come. */
import type { PastedInput } from '../input/pasted-input'

const STORE = 'lists'

export class InputStore {
  readonly #database: string
  /** Of all tabs. */
  readonly #most: number

  constructor(database: string, most: number) {
    this.#database = database
    this.#most = most
  }

  /** Resolves to its key; rejects if there is no room, or if the browser refuses. */
  add(input: PastedInput): Promise<number> {
    return this.#in('readwrite', async store => {
      const keys = await done(store.getAllKeys())
      for (const old of keys.slice(0, Math.max(0, keys.length + 1 - this.#most))) store.delete(old)
      return done(store.add(input)) as Promise<number>
    })
  }

  /** Null if it is not there. */
  async get(key: number): Promise<PastedInput | null> {
    const input = await this.#in('readonly', store => done(store.get(key))).catch(() => null)
    return (input as PastedInput | null | undefined) ?? null
  }

  async remove(key: number): Promise<void> {
    await this.#in('readwrite', store => done(store.delete(key)))
  }

  forget(): void {
    try {
      indexedDB.deleteDatabase(this.#database)
    } catch {
      // Nothing is stored there.
    }
  }

  /** A connection is closed at once: while it is open, the page could not be shown again as it was left. */
  async #in<T>(mode: IDBTransactionMode, run: (store: IDBObjectStore) => Promise<T>): Promise<T> {
    const opening = indexedDB.open(this.#database, 1)
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
