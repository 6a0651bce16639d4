/** Scroll positions of the page and of the panels beside the scene. */
import type { HistoryEntry } from './history-entries'

type Lens = HTMLElementTagNameMap['hex-lens']
type Scroll = HistoryEntry['scroll']

const OF_THE_READER = ['wheel', 'touchstart', 'pointerdown', 'keydown'] as const

export function scrollOf(lens: Lens): Scroll {
  return [document.scrollingElement?.scrollTop ?? 0, ...lens.scrollPositions]
}

/** Scrolls until all that was on the page is there again, or until the reader acts. */
export function scrollTo(lens: Lens, goals: Scroll): void {
  const ended = new AbortController()
  const { signal } = ended
  for (const type of OF_THE_READER)
    addEventListener(type, () => ended.abort(), { signal, capture: true, passive: true })
  let wasComplete = false
  const step = () => {
    if (signal.aborted) return
    const [page = 0, ...positions] = goals
    if (document.scrollingElement) document.scrollingElement.scrollTop = page
    lens.scrollPositions = positions
    // A view that has just been drawn may ask for another frame when it learns its size.
    if (lens.complete && wasComplete) ended.abort()
    wasComplete = lens.complete
    requestAnimationFrame(step)
  }
  step()
}

/** The lens as it is seen first, whatever the reader scrolled in it. */
export function scrollToTop(lens: Lens): void {
  lens.scrollPositions = []
}
