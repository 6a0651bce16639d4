/** How far the page and the panels beside the scene are scrolled. */
import type { Place } from './places'

type Scroll = Place['scroll']

/** Panels that take longer to load do not pull the page about any more. */
const PATIENCE_MS = 5000
const OF_THE_READER = ['wheel', 'touchstart', 'pointerdown', 'keydown'] as const

export function scrollOf(lens: HTMLElement): Scroll {
  const [page, panels] = scrollers(lens).map(scroller => scroller?.scrollTop ?? 0) as [number, number]
  return { page, panels }
}

/** As soon as there is room for it, since panels come late; unless the reader does something first. */
export function scrollTo(lens: HTMLElement, { page, panels }: Scroll): void {
  const goals = [page, panels]
  const ended = new AbortController()
  const { signal } = ended
  for (const type of OF_THE_READER)
    addEventListener(type, () => ended.abort(), { signal, capture: true, passive: true })
  const until = performance.now() + PATIENCE_MS
  const step = () => {
    if (signal.aborted) return
    const places = scrollers(lens).map((scroller, i) => {
      const goal = goals[i] as number
      if (scroller && scroller.scrollTop !== goal) scroller.scrollTop = goal
      return Math.abs((scroller?.scrollTop ?? 0) - goal) < 1
    })
    if (places.every(isThere => isThere) || performance.now() > until) ended.abort()
    else requestAnimationFrame(step)
  }
  step()
}

function scrollers(lens: HTMLElement): (Element | null)[] {
  return [document.scrollingElement, lens.shadowRoot?.querySelector('.panel') ?? null]
}
