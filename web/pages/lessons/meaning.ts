/**
 * The meaning of a word of the glossary beside the word: while it is pointed at or focused, or after a tap, until Escape or until the
 * reader goes on. Screen readers have it as the word's description.
 */
import { html, render } from 'lit-html'
import { glossary, meaningId, termOf } from './glossary'

/** Pixels between the word and the box, and between the box and the window's rim. */
const GAP = 6
const RIM = 8

/** Words are in `root`; the boxes are added to `place`. */
export function showMeanings(root: HTMLElement, place: HTMLElement): void {
  const box = document.createElement('div')
  box.className = 'meaning'
  box.setAttribute('aria-hidden', 'true')
  box.hidden = true
  const descriptions = document.createElement('div')
  descriptions.hidden = true
  render(
    glossary.map(term => html`<p id=${meaningId(term)}>${term.means}</p>`),
    descriptions,
  )
  place.append(descriptions, box)
  let shown: HTMLElement | null = null

  const show = (word: HTMLElement): void => {
    const term = termOf(word.dataset.term as string)
    if (!term) return
    shown = word
    render(html`<strong>${term.name}</strong> ${term.means}`, box)
    box.hidden = false
    // The first of the word's lines, if it is broken.
    const at = word.getClientRects()[0] ?? word.getBoundingClientRect()
    const { width, height } = box.getBoundingClientRect()
    const left = Math.max(RIM, Math.min(at.left, document.documentElement.clientWidth - width - RIM))
    const below = at.bottom + GAP
    const top = below + height + RIM <= innerHeight ? below : Math.max(RIM, at.top - GAP - height)
    box.style.left = `${left}px`
    box.style.top = `${top}px`
  }
  const hide = (): void => {
    shown = null
    box.hidden = true
  }
  const wordAt = (target: EventTarget | null) =>
    target instanceof Element ? target.closest<HTMLElement>('.term') : null
  const isBoxAt = (target: EventTarget | null) => target instanceof Node && box.contains(target)

  for (const type of ['pointerover', 'focusin', 'click'])
    root.addEventListener(type, ({ target }) => {
      const word = wordAt(target)
      if (word && word !== shown) show(word)
    })
  // The pointer may go into the box, to read or to copy.
  for (const from of [root, box])
    from.addEventListener('pointerout', event => {
      const { relatedTarget, pointerType } = event as PointerEvent
      if (pointerType === 'touch' || shown === document.activeElement) return
      if (wordAt(relatedTarget) !== shown && !isBoxAt(relatedTarget)) hide()
    })
  root.addEventListener('focusout', ({ target }) => {
    if (wordAt(target) === shown) hide()
  })
  addEventListener('pointerdown', ({ target }) => {
    if (!wordAt(target) && !isBoxAt(target)) hide()
  })
  addEventListener(
    'keydown',
    event => {
      if (event.key !== 'Escape' || !shown) return
      event.stopPropagation()
      hide()
    },
    true,
  )
  addEventListener('scroll', hide, { passive: true })
}
