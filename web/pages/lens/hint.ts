/** The hint in the scene, which a browser shows until its reader has moved a vertex once. */

const KEY = 'hexlens-hint-done'

export function showHintOnce(lens: HTMLElement): void {
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
  }
  for (const type of ['hex-input', 'hex-change']) lens.addEventListener(type, end, { signal: ended.signal })
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
