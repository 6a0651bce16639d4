/**
 * The page: `<hex-lens>` with what it shows kept in the address, so that bookmark and link work, and beside the entry of the history,
 * so that reload, Back and Forward return to the same place. Without an element in the address it shows the reader's last one. Undo
 * goes on from there in any case.
 */
import { sameBits, type Vertices } from '../../model/hexahedron'
import { presets, presetVertices } from '../../model/presets'
import '../element'
import { historyStep } from '../../element/shortcuts'
import { pastedIn } from '../../input/pasted-input'
import { decodePermalink } from '../../model/permalink'
import { STATE_VERSION, type StateDocument } from '../../model/state-document'
import { entryAt, type HistoryEntry, keepEntry, presentKey } from '../history-entries'
import { keepLists } from '../kept-list'
import { LensWork } from '../lens-work'
import { say, unsay } from '../note'
import { onSettled } from '../on-settled'
import { put } from '../put'
import { scrollOf, scrollTo } from '../scroll'
import { showHintOnce } from './hint'
import { leadToMesh } from './to-mesh'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const work = new LensWork(lens, [lens], arrive)
showHintOnce(lens)

const FIRST = presetVertices(presets[0])
const LAST_ELEMENT = 'Your last element.'

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

/** Work that was kept comes first: what the address or the entry then changes is a step in it. */
function arrive(): void {
  const isFound = work.open('lens')
  const link = decodePermalink(location.hash)
  const isNew = entryAt(key) === null
  // A link's element is looked at as in a new lens.
  if (isFound && isNew && link.ok && !sameBits(lens.vertices, link.value))
    lens.state = { ...lens.state, camera: null, referenceCamera: null }
  openAddress()
  const { elements } = lens.history
  if (isFound && isNew && !link.ok && (elements.length > 1 || !sameBits(lens.vertices, FIRST))) {
    if (link.error.code === 'absent') history.replaceState(history.state, '', lens.permalink)
    say(LAST_ELEMENT, { label: 'Start anew', press: startAnew })
  }
  if (isFound || link.ok) work.touch()
}

function startAnew(): void {
  lens.state = { version: STATE_VERSION, vertices: FIRST, preset: presets[0].id } as StateDocument
  unsay(LAST_ELEMENT)
}

function openAddress(): void {
  const link = decodePermalink(location.hash)
  const isAbsent = !link.ok && link.error.code === 'absent'
  const kept = entryAt(key)
  if (link.ok && kept) open(kept, link.value)
  else if (link.ok) lens.vertices = link.value
  else if (isAbsent && kept) open(kept)
  else if (!isAbsent)
    lens.raise({ code: 'link-broken', message: `${link.error.message} The element shown is not the link’s.` })
  if (link.ok || isAbsent) lens.clear('link-broken')
  settle()
}

/** The address has the last word on the vertices. */
function open({ state, scroll }: HistoryEntry, linked: Vertices | null = null): void {
  try {
    put(() => {
      lens.state = linked ? { ...state, vertices: linked } : state
    })
    scrollTo(lens, scroll)
  } catch {
    if (linked) lens.vertices = linked // what another version of the page kept
  }
}

history.scrollRestoration = 'manual'
arrive()
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

onSettled(lens, () => {
  lens.clear('link-broken')
  unsay(LAST_ELEMENT)
  if (lens.preset !== null && lens.preset !== preset) {
    keepEntry(key, before)
    history.pushState(null, '', lens.permalink)
    key = presentKey()
  } else history.replaceState(history.state, '', lens.permalink)
  settle()
})

leadToMesh(lens)
keepLists(lens)

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
