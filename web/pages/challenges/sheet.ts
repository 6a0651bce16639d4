/**
 * The one side to print of a challenge or a series: texts, conditions in words, pictures and
 * coordinates of the elements to start from, the link and its QR code. It is on the page before it is
 * printed, so that its text can be made as large as one side holds.
 */
import { html, render, svg, type TemplateResult } from 'lit-html'
import { fractionOf } from '../../model/decimal'
import { COORDINATE_COUNT, type Vertices } from '../../model/hexahedron'
import { MOST_BYTES, type QrCode, qrCode } from './qr-code'
import type { Member } from './series'
import { conditionInWords, contestInWords } from './words'

/** Sizes of text in points: the largest that fits is taken. */
const SIZES = { most: 11, least: 5.5, step: 0.25 }
/** Millimetres of a module, so that a telephone's camera resolves it on paper. */
const MODULE = 0.4
/** Millimetres of a QR code's side. */
const QR_SIDE = { least: 30, most: 76 }

export class Sheet {
  readonly #element = document.createElement('section')

  constructor() {
    this.#element.className = 'sheet'
    this.#element.setAttribute('aria-label', 'The side to print')
  }

  /** Nothing but the page is printed from now on. */
  clear(): void {
    this.#element.remove()
  }

  /** Makes the side and has it printed. Resolves to sentences for the reader. */
  async print(members: readonly Member[], link: string): Promise<string> {
    const [code, pictures] = await Promise.all([
      qrCode(link),
      picturesOf(members.map(({ challenge }) => challenge.start)),
    ])
    render(sheet(members, link, code, pictures), this.#element)
    document.querySelector('main')?.before(this.#element)
    const images = [...this.#element.querySelectorAll('img')]
    await Promise.all(images.map(image => image.decode().catch(() => {}))) // it is left white then
    const fits = this.#fit()
    const sentences = [
      fits
        ? 'The side is ready to be printed.'
        : 'It is too much for one side: print a shorter series or shorter texts.',
      ...(code === null ? [tooLong(link)] : []),
    ]
    print()
    return sentences.join(' ')
  }

  #fit(): boolean {
    for (let size = SIZES.most; size >= SIZES.least; size -= SIZES.step) {
      this.#element.style.fontSize = `${size}pt`
      if (this.#element.scrollHeight <= this.#element.clientHeight) return true
    }
    return false
  }
}

function tooLong(link: string): string {
  return `The link is too long for a QR code: it has ${link.length} bytes, and ${MOST_BYTES} are the most.`
}

/** The scene of each element as an address for an image, drawn by an element that nobody sees, in the colours of paper. */
async function picturesOf(elements: readonly Vertices[]): Promise<readonly (string | null)[]> {
  const lens = document.createElement('hex-lens') as HTMLElementTagNameMap['hex-lens']
  lens.className = 'for-sheet'
  lens.setAttribute('views', 'scene')
  lens.setAttribute('theme', 'light')
  lens.setAttribute('aria-hidden', 'true')
  lens.inert = true
  document.body.append(lens)
  const pictures: (string | null)[] = []
  try {
    for (const vertices of elements) {
      lens.vertices = [...vertices]
      // Without a picture the coordinates say what the element is.
      const picture = await lens.toSVG().catch(() => null)
      pictures.push(picture && `data:image/svg+xml,${encodeURIComponent(picture)}`)
    }
  } finally {
    lens.remove()
  }
  return pictures
}

function sheet(
  members: readonly Member[],
  link: string,
  code: QrCode | null,
  pictures: readonly (string | null)[],
): TemplateResult {
  const isSeries = members.length > 1
  return html`<header>
      <div>
        <p class="sheet-kind">Hexlens</p>
        ${isSeries ? html`<h1>${members.length} challenges</h1>` : ''}
        <p>
          Open the link, drag the vertices of the element or type their coordinates, and meet every condition. The page judges at once,
          exactly; “Copy link to hand in” makes the link to send back.
        </p>
        <p class="sheet-link">${link}</p>
        ${code === null ? html`<p>${tooLong(link)}</p>` : ''}
      </div>
      ${code === null ? '' : qrPicture(code)}
    </header>
    ${members.map((member, i) => challengeOnSheet(member, isSeries ? i + 1 : null, pictures[i] ?? null))}`
}

function qrPicture({ side, path }: QrCode): TemplateResult {
  const millimetres = Math.min(QR_SIDE.most, Math.max(QR_SIDE.least, side * MODULE))
  return html`<svg
    class="qr-code"
    role="img"
    aria-label="QR code of the link"
    width=${`${millimetres}mm`}
    height=${`${millimetres}mm`}
    viewBox=${`0 0 ${side} ${side}`}
    shape-rendering="crispEdges"
  >
    ${svg`<rect width=${side} height=${side} fill="#fff" /><path d=${path} fill="#000" />`}
  </svg>`
}

function challengeOnSheet({ challenge }: Member, number: number | null, picture: string | null): TemplateResult {
  const { title, text, goal, start, record } = challenge
  return html`<article>
    ${picture === null ? '' : html`<img alt="The element to start from" src=${picture} />`}
    <div>
      <h2>${number === null ? '' : `${number}. `}${title}</h2>
      <p class="as-written">${text}</p>
      <ul>
        ${goal.map(condition => html`<li>${conditionInWords(condition)}</li>`)}
        ${record === null ? '' : html`<li>${contestInWords(record)}</li>`}
      </ul>
    </div>
    <table>
      <caption>
        Start
      </caption>
      <thead>
        <tr>
          <th scope="col">vertex</th>
          <th scope="col">x</th>
          <th scope="col">y</th>
          <th scope="col">z</th>
        </tr>
      </thead>
      <tbody>
        ${Array.from(
          { length: COORDINATE_COUNT / 3 },
          (_, v) => html`<tr>
            <th scope="row">${v}</th>
            ${start.slice(3 * v, 3 * v + 3).map(value => html`<td>${exactCoordinate(value)}</td>`)}
          </tr>`,
        )}
      </tbody>
    </table>
  </article>`
}

/** The double itself, as a fraction where that is short. */
function exactCoordinate(value: number): string {
  return fractionOf(value) ?? (Object.is(value, -0) ? '−0' : String(value).replace('-', '−'))
}
