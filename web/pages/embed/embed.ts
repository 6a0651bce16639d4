/**
 * The page in somebody's iframe: `<hex-lens>` with the attributes of the query and the element of the fragment. It tells the page
 * around it how high it is: `{ type: 'hexlens-resize', height }`, in CSS pixels.
 */
import '../element'
import { decodePermalink } from '../../model/permalink'

const ATTRIBUTES = ['preset', 'views', 'controls', 'camera', 'theme', 'readonly', 'label']

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']

for (const [name, value] of new URLSearchParams(location.search)) {
  if (ATTRIBUTES.includes(name)) lens.setAttribute(name, value)
}

function openLink(): void {
  const link = decodePermalink(location.hash)
  if (link.ok) lens.vertices = link.value
  else if (link.error.code !== 'absent') lens.raise({ code: 'link-broken', message: link.error.message })
}

openLink()
addEventListener('hashchange', openLink)
new ResizeObserver(() => {
  parent.postMessage({ type: 'hexlens-resize', height: Math.ceil(lens.getBoundingClientRect().height) }, '*')
}).observe(lens)
