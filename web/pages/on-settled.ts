/** A change of the element that is done, the reader's or the page's own. */
import type { ChangeDetail } from '../element/changes'

export function onSettled(lens: EventTarget, call: () => void): void {
  lens.addEventListener('hex-change', call)
  lens.addEventListener('hex-input', event => {
    if ((event as CustomEvent<ChangeDetail | null>).detail?.source === 'program') call()
  })
}
