/** Nothing but the release of a lock that it holds tells a page of a worker that was ended from outside. */

/** A lock that this worker holds while it lives: its name, or null if there are no locks. */
export function heldLock(prefix: string): Promise<string | null> {
  return new Promise(resolve => {
    if (!navigator.locks) return resolve(null)
    const name = `${prefix}-${crypto.randomUUID()}`
    const held = () => {
      resolve(name)
      return new Promise<never>(() => {})
    }
    navigator.locks.request(name, held).catch(() => resolve(null))
  })
}

/** The page is called back when the worker is no more. */
export function whenReleased(lock: string, call: () => void): void {
  navigator.locks.request(lock, call).catch(() => {}) // a page that is being left has no more locks
}
