/** A browser's storage in place of the one that there is not. */
import { vi } from 'vitest'

/** It holds these entries, and throws where it is to refuse. */
export function storage(entries: Readonly<Record<string, string>> = {}, refuses: readonly string[] = []) {
  const kept = new Map(Object.entries(entries))
  const unlessRefused = <T>(what: string, run: () => T): T => {
    if (refuses.includes(what)) throw new DOMException('The operation is insecure.', 'SecurityError')
    return run()
  }
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => unlessRefused('getItem', () => kept.get(key) ?? null),
    setItem: (key: string, value: string) => unlessRefused('setItem', () => kept.set(key, value)),
    removeItem: (key: string) => unlessRefused('removeItem', () => kept.delete(key)),
  })
  return kept
}
