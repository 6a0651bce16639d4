/**
 * Pressing a number copies all its digits (`web/views/copyable.ts` makes such numbers) and says so
 * beside it; C, or pressing the readout in the scene, copies those of the probe. If the clipboard
 * is closed, the digits stand there selected instead. In a table arrow keys go from one number to
 * the next.
 */
import { html, nothing, render } from 'lit-html'
import type { JacobianReport } from '../core/report'
import { jacdetInFull } from '../model/decimal'
import type { ReferenceCube } from '../model/state'
import { copyText } from '../views/copy-text'
import { placeIn } from '../views/place-in'
import { say } from '../words/say'

const NUMBER = 'data'
const POINT = '[data-copies="point"]'
const WAYS: Readonly<Record<string, 1 | -1>> = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }
/** CSS pixels between a number and the message about it, and to the border of the element. */
const GAP = 4

export class Copying {
  readonly #lens: HTMLElement
  readonly #point: () => string | null
  readonly #told = document.createElement('p')

  /** `lens` holds the numbers and gets the message; `point` is the text of the point pointed at. */
  constructor(lens: HTMLElement, point: () => string | null) {
    this.#lens = lens
    this.#point = point
    this.#told.className = 'copied'
    this.#told.setAttribute('role', 'status')
    lens.append(this.#told)
    lens.addEventListener('click', event => this.#onClick(event))
    lens.addEventListener('keydown', event => this.#onKeyDown(event))
    lens.addEventListener('focusout', () => this.#hide())
    lens.addEventListener('scroll', () => this.#hide(), { capture: true, passive: true })
  }

  #onClick(event: MouseEvent): void {
    const target = event.target as Element
    const number = target.closest<HTMLDataElement>(NUMBER)
    // A reader who selects some of its text wants the text itself.
    if (number && getSelection()?.type !== 'Range') void this.#copy(number.value, number)
    else if (target.closest(POINT)) this.#copyPoint(target)
  }

  #onKeyDown(event: KeyboardEvent): void {
    const { key } = event
    const target = event.target as Element
    if (key === 'Escape' && this.#told.textContent !== '') {
      this.#hide()
      event.preventDefault()
    }
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches('input, textarea, select')) return
    const number = target.closest<HTMLDataElement>(NUMBER)
    const way = WAYS[key]
    if (key === 'c' || key === 'C') {
      if (!this.#copyPoint(target)) return
    } else if (number && (key === 'Enter' || key === ' ')) void this.#copy(number.value, number)
    else if (!number || way === undefined || !goOn(number, way)) return
    event.preventDefault()
  }

  /** False if nothing is pointed at. */
  #copyPoint(at: Element): boolean {
    const text = this.#point()
    if (text !== null) void this.#copy(text, at)
    return text !== null
  }

  async #copy(text: string, at: Element): Promise<void> {
    const [copied, refused] = [say('Copied'), say('Copying is not allowed here:')]
    const isCopied = await copyText(text)
    render(html`${isCopied ? copied : refused} <span>${text}</span>`, this.#told)
    this.#place(at)
    if (!isCopied) getSelection()?.selectAllChildren(this.#told.lastElementChild as Element)
  }

  /** Puts the message under the copied number, within the element. */
  #place(at: Element): void {
    const told = this.#told
    const { clientWidth: width, clientHeight: height, scrollTop } = this.#lens
    const { left: clientX, bottom: clientY } = at.getBoundingClientRect()
    const { x, y } = placeIn(this.#lens, { clientX, clientY }) ?? { x: 0, y: 0 }
    const within = (from: number, room: number, scrolled = 0) =>
      `${Math.max(GAP, Math.min(room - GAP, from)) + scrolled}px`
    told.style.left = within(x * width, width - told.offsetWidth)
    told.style.top = within(y * height - scrollTop + GAP, height - told.offsetHeight, scrollTop)
  }

  #hide(): void {
    render(nothing, this.#told)
  }
}

/** False where there is no table to go on in. */
function goOn(number: HTMLElement, way: 1 | -1): boolean {
  const numbers = [...(number.closest('table')?.querySelectorAll<HTMLElement>(NUMBER) ?? [])]
  numbers[numbers.indexOf(number) + way]?.focus()
  return numbers.length > 0
}

/** The numbers of the probe, with all their digits. */
export function pointInFull(probe: JacobianReport | null, cube: ReferenceCube): string | null {
  if (probe === null) return null
  const { point, position } = probe
  const jacdet = jacdetInFull(probe.jacdet, probe.exponent, cube)
  return `jacdet = ${jacdet}, (xi, eta, zeta) = (${point.join(', ')}), (x, y, z) = (${position.join(', ')})`
}
