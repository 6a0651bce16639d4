/**
 * The page: `<hex-lens>` with what it shows kept in the address, so that bookmark and link work, and in the session beside the
 * entry of the history, so that reload, Back and Forward return to the same place.
 */
import { presets, presetVertices } from '../../model/presets'
import '../element'
import { historyStep } from '../../element/shortcuts'
import { pastedIn } from '../../input/pasted-input'
import { decodePermalink } from '../../model/permalink'
import { entryAt, type HistoryEntry, keepEntry, presentKey } from '../history-entries'
import { scrollOf, scrollTo } from '../scroll'
import { showHintOnce } from './hint'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
showHintOnce(lens)

let key = presentKey()
/** The preset that the address is about: another one is another page to go back from. */
let preset: string | null = null
/** The entry before the reader's present action. */
let before: HistoryEntry

function present(): HistoryEntry {
  return { state: lens.state, scroll: scrollOf(lens) }
}

function settle(): void {
  preset = lens.preset
  before = present()
}

function openAddress(): void {
  const link = decodePermalink(location.hash)
  const vertices = link.ok ? link.value : link.error.code === 'absent' ? presetVertices(presets[0]) : null
  const kept = entryAt(key)
  if (vertices) {
    if (kept) open(kept, vertices)
    else lens.vertices = vertices
    lens.clear('link-broken')
  } else if (!link.ok) {
    lens.raise({ code: 'link-broken', message: `${link.error.message} The element shown is not the link’s.` })
  }
  settle()
}

/** The address has the last word on the vertices. */
function open({ state, scroll }: HistoryEntry, vertices: readonly number[]): void {
  try {
    lens.state = { ...state, vertices }
    scrollTo(lens, scroll)
  } catch {
    lens.vertices = vertices // what another version of the page kept
  }
}

history.scrollRestoration = 'manual'
openAddress()
addEventListener('popstate', () => {
  keepEntry(key, present())
  key = presentKey()
  openAddress()
})
addEventListener('pagehide', () => keepEntry(key, present()))
for (const type of ['pointerdown', 'keydown'] as const)
  addEventListener(
    type,
    () => {
      before = present()
    },
    { capture: true, passive: true },
  )

lens.addEventListener('hex-change', () => {
  lens.clear('link-broken')
  if (lens.preset !== null && lens.preset !== preset) {
    keepEntry(key, before)
    history.pushState(null, '', lens.permalink)
    key = presentKey()
  } else history.replaceState(history.state, '', lens.permalink)
  settle()
})

// While nothing has the focus, undo, redo and paste can only mean the element.
addEventListener('keydown', event => {
  const step = event.target === document.body ? historyStep(event) : null
  if (step === null) return
  event.preventDefault()
  lens[step]()
})
addEventListener('paste', event => {
  const input = event.target === document.body ? pastedIn(event) : null
  if (input !== null) lens.offer('text' in input ? input.text : input.files)
})
