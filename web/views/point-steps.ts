/**
 * Keys with which an arrow makes a large or a small step: Shift, and Ctrl. On a Mac, where Ctrl and
 * an arrow change the desktop, it is Alt. Elsewhere Alt and an arrow go back in the browser.
 */
const isMac = /^(Mac|iP)/.test(globalThis.navigator?.platform ?? '')

type Held = Pick<KeyboardEvent, 'key' | 'altKey' | 'ctrlKey' | 'metaKey'>

export function isSmallStep({ key, altKey, ctrlKey }: Held): boolean {
  if (key.startsWith('Arrow') && !isMac) return ctrlKey && !altKey
  return altKey && !ctrlKey && /^(Arrow|Page)/.test(key)
}

/** True if Ctrl, Cmd or Alt makes the key the browser's or the page's. */
export function isForeign(event: Held): boolean {
  return event.metaKey || ((event.ctrlKey || event.altKey) && !isSmallStep(event))
}

/** The step, in [0,1], by which an arrow key moves a point. */
export function pointStep(event: KeyboardEvent): number {
  return event.shiftKey ? 1 / 4 : isSmallStep(event) ? 1 / 64 : 1 / 16
}

export function inUnit(value: number): number {
  return Math.max(0, Math.min(1, value))
}
