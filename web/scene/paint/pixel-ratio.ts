/** How many device pixels a CSS pixel of the scene has. */

/** More than this are not worth their time. */
const MOST_ON_SCREEN = 2
/** Fine enough for paper, and no screen's, so that a figure is surely painted anew. */
const FOR_FIGURE = 3

export function pixelRatio(isFigure: boolean): number {
  return isFigure ? FOR_FIGURE : Math.min(devicePixelRatio, MOST_ON_SCREEN)
}

/** By a media query for the present ratio, since there is no event for another one. */
export function watchPixelRatio(onChange: () => void, signal: AbortSignal): void {
  const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`)
  const changed = () => {
    watchPixelRatio(onChange, signal)
    onChange()
  }
  query.addEventListener('change', changed, { once: true, signal })
}
