/** The hint in the scene, which a browser shows until its reader has moved a vertex once; then where the red may be. */
import { say, unsay } from '../note'

const BEHIND = 'The red may lie behind.'

const KEY = 'hexlens-hint-done'

export function showHintOnce(lens: HTMLElementTagNameMap['hex-lens']): void {
  const hint = lens.querySelector('.hint') as HTMLElement
  if (isDone()) {
    hint.remove()
    return
  }
  const ended = new AbortController()
  // The element lets go of the hint in the first gesture.
  const end = () => {
    if (hint.assignedSlot !== null) return
    ended.abort()
    hint.remove()
    keepDone()
    lens.addEventListener('hex-change', () => sayWhereRedIs(lens), { once: true })
  }
  for (const type of ['hex-input', 'hex-change']) lens.addEventListener(type, end, { signal: ended.signal })
}

/** Most elements hide what was made negative by pushing a vertex inwards. */
function sayWhereRedIs(lens: HTMLElementTagNameMap['hex-lens']): void {
  if (lens.report?.valid !== false) return
  const show = () => {
    unsay(BEHIND)
    lens.showMinimum()
  }
  say(BEHIND, { label: 'Show the minimum', press: show })
  lens.addEventListener('hex-change', () => unsay(BEHIND), { once: true })
}

function isDone(): boolean {
  try {
    return localStorage.getItem(KEY) !== null
  } catch {
    return false
  }
}

function keepDone(): void {
  try {
    localStorage.setItem(KEY, '')
  } catch {
    // It is shown again.
  }
}
