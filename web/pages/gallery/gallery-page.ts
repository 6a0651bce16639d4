/** The page Gallery: small pictures with what each shows; the one that is chosen is in the lens, and in the address. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import { type GalleryElement, type GalleryRoom, gallery } from './gallery'
import { elementVertices } from './gallery-vertices'
import '../element'
import { sameBits } from '../../model/hexahedron'
import { encodePermalink } from '../../model/permalink'
import { LensWork } from '../lens-work'
import { onSettled } from '../on-settled'
import { BLANK, Pictures } from '../pictures'
import '../skip'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const root = document.querySelector('.gallery') as HTMLElement

const elements = gallery.flatMap(room => room.elements)
const pictures = new Pictures(lens, root, () => schedule())
const work = new LensWork(lens, [lens], arrive)

let chosen: GalleryElement | null = null
let redraw = 0

function schedule(): void {
  if (redraw === 0) redraw = requestAnimationFrame(draw)
}

function draw(): void {
  redraw = 0
  pictures.begin(elements.map(elementVertices))
  render(html`<p class="complaint" role="status">${complaint()}</p>${gallery.map(roomTemplate)}`, root)
  if (pictures.isBehind) schedule()
}

function roomTemplate({ title, elements }: GalleryRoom, room: number): TemplateResult {
  return html`<section aria-labelledby=${`room-${room}`}>
    <h2 id=${`room-${room}`}>${title}</h2>
    <ul>
      ${elements.map(elementTemplate)}
    </ul>
  </section>`
}

function elementTemplate(element: GalleryElement): TemplateResult {
  const { id, title, note, source, lesson, challenge } = element
  const vertices = elementVertices(element)
  const picture = pictures.of(vertices)
  const image = html`<img src=${picture?.address ?? BLANK} alt=${picture ? `${picture.text}.` : ''} width="120" height="120" />`
  return html`<li id=${id}>
    <button
      type="button"
      class="picture"
      aria-current=${element === chosen ? 'true' : nothing}
      aria-describedby=${`${id}-note`}
      @click=${() => choose(element)}
    >
      <span>${title}</span>${image}
    </button>
    <p id=${`${id}-note`}>${note}</p>
    <p class="quiet">${source.charAt(0).toUpperCase()}${source.slice(1)}.</p>
    <p class="quiet links">
      <a href=${`./#${encodePermalink(vertices)}`} aria-label=${`${title} on the page Lens`}>Lens</a>
      ${lesson ? html`<a href=${`./lessons.html#${lesson}`} aria-label=${`The lesson about ${title}`}>Lesson</a>` : nothing}
      ${
        challenge
          ? html`<a href=${`./challenges.html#challenge=${challenge}`} aria-label=${`The challenge to make one like ${title}`}
              >Challenge</a
            >`
          : nothing
      }
    </p>
  </li>`
}

function choose(element: GalleryElement): void {
  history.replaceState(history.state, '', `#${element.id}`)
  show(element)
}

function show(element: GalleryElement): void {
  chosen = element
  if (typeof element.element === 'string') lens.preset = element.element
  else lens.vertices = elementVertices(element)
  draw()
}

/** The mistake in the address, if any. */
function complaint(): string | null {
  const id = location.hash.slice(1)
  return id === '' || elements.some(element => element.id === id)
    ? null
    : `There is no “${id.slice(0, 40)}” in the gallery.`
}

/** The address's element is a step after the one that was there. */
function openAddress(): void {
  const named = elements.find(({ id }) => `#${id}` === location.hash)
  chosen = named ?? elements.find(isInLens) ?? null
  if (named && !isInLens(named)) show(named)
  else draw()
}

function isInLens(element: GalleryElement): boolean {
  return sameBits(elementVertices(element), lens.vertices)
}

function arrive(): void {
  work.open('gallery')
  openAddress()
}

addEventListener('hashchange', openAddress)
// An element that the reader has changed is another one.
onSettled(lens, () => {
  if (chosen && isInLens(chosen)) return
  chosen = elements.find(isInLens) ?? null
  history.replaceState(history.state, '', chosen ? `#${chosen.id}` : location.pathname + location.search)
  schedule()
})
arrive()
if (location.hash) document.getElementById(location.hash.slice(1))?.scrollIntoView({ block: 'center' })
