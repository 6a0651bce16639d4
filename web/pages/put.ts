/** Sets properties of elements. What one refuses is thrown and not shown: what to do then is the page's to say. */
import type { Problem } from '../views/view'

type Lens = HTMLElementTagNameMap['hex-lens']

export function put(set: () => void): void {
  const refused: Problem[] = []
  const onError = ({ target, detail }: Event & { readonly detail?: Problem }) => {
    if (!detail) return
    refused.push(detail)
    ;(target as Lens).clear(detail.code)
  }
  document.addEventListener('hex-error', onError)
  set()
  document.removeEventListener('hex-error', onError)
  if (refused[0]) throw new Error(refused[0].message)
}
