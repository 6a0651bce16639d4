/** Scroll positions of the page and of the panels beside the scene. */
import type { HistoryEntry } from './history-entries'

type Lens = HTMLElementTagNameMap['hex-lens']
type Scroll = HistoryEntry['scroll']

const OF_THE_READER = ['wheel', 'touchstart', 'pointerdown', 'keydown'] as const

export function scrollOf(lens: Lens): Scroll {
  return scrollers(lens).map(scroller => scroller?.scrollTop ?? 0)
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
    for (const [i, scroller] of scrollers(lens).entries()) {
      if (scroller) scroller.scrollTop = goals[i] ?? 0
    }
    // A view that has just been drawn may ask for another frame when it learns its size.
    if (lens.complete && wasComplete) ended.abort()
    wasComplete = lens.complete
    requestAnimationFrame(step)
  }
  step()
}

/** The lens as it is seen first, whatever the reader scrolled in it. */
export function scrollToTop(lens: Lens): void {
  for (const scroller of scrollersIn(lens)) if (scroller) scroller.scrollTop = 0
}

function scrollers(lens: Lens): (Element | null)[] {
  return [document.scrollingElement, ...scrollersIn(lens)]
}

function scrollersIn(lens: Lens): (Element | null)[] {
  return ['.side', '.panel', '.folds', '.lens'].map(selector => lens.shadowRoot?.querySelector(selector) ?? null)
}
