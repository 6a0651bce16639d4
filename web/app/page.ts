/** The page: `<hex-lens>` with what it shows kept in the address, so that reload, bookmark, Back and a pasted link all work. */
import { presets, presetVertices } from '../content/presets'
import '../element/hex-lens'
import { onPaste } from '../element/offers'
import { historyStep } from '../element/shortcuts'
import { decodePermalink } from '../model/permalink'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']

/** The preset that the address is about: another one is another page to go back from. */
let preset: string | null = null

function openLink(): void {
  const link = decodePermalink(location.hash)
  const vertices = link.ok ? link.value : link.error.code === 'absent' ? presetVertices(presets[0]) : null
  if (vertices) {
    lens.vertices = vertices
    lens.clear('link-broken')
  } else if (!link.ok) {
    lens.raise({ code: 'link-broken', message: `${link.error.message} The element shown is not the link’s.` })
  }
  preset = lens.preset
}

openLink()
addEventListener('hashchange', openLink)
lens.addEventListener('hex-change', () => {
  lens.clear('link-broken')
  if (lens.preset !== null && lens.preset !== preset) history.pushState(null, '', lens.permalink)
  else history.replaceState(history.state, '', lens.permalink)
  preset = lens.preset
})

// With the focus nowhere, undo, redo and paste can only mean the element. (A lone character must not mean anything there: WCAG 2.1.4.)
addEventListener('keydown', event => {
  const step = event.target === document.body ? historyStep(event) : null
  if (step === null) return
  event.preventDefault()
  lens[step]()
})
addEventListener('paste', event => {
  if (event.target === document.body) onPaste(event, offer => lens.offer(offer))
})
