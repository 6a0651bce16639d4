/** What stands around the lens: which cell is in it, and the buttons that go through the invalid ones. */
import { html, nothing, render } from 'lit-html'
import { encodePermalink } from '../../model/permalink'
import type { CellDetail, Overview, Row } from '../../survey/survey-jobs'
import { acceptedSentence } from './page-words'

export class ChosenView {
  readonly #root: HTMLElement
  readonly #which: HTMLElement
  readonly #accepted: HTMLElement
  readonly #through: HTMLElement
  readonly #lens: HTMLElement
  readonly #goToNext: (step: 1 | -1) => void

  constructor(root: HTMLElement, goToNext: (step: 1 | -1) => void) {
    const part = (selector: string) => root.querySelector(selector) as HTMLElement
    this.#root = root
    this.#which = part('.which')
    this.#accepted = part('.accepted')
    this.#through = part('.through')
    this.#lens = part('hex-lens')
    this.#goToNext = goToNext
  }

  draw(overview: Overview | null): void {
    const hasInvalid = overview !== null && overview.counts.invalid > 0
    render(
      hasInvalid
        ? html`<button type="button" title="Previous invalid cell (P)" aria-label="Previous invalid cell" @click=${() => this.#goToNext(-1)}>Previous</button>
    <button type="button" title="Next invalid cell (N)" aria-label="Next invalid cell" @click=${() => this.#goToNext(1)}>Next</button>`
        : nothing,
      this.#through,
    )
    this.#root.hidden = overview === null
  }

  show({ row, vertices }: CellDetail): void {
    render(
      html`Cell ${row.id}${row.block === null ? '' : `, block ${row.block}`}${
        vertices === null
          ? html`: ${row.why}`
          : html`. <a href=${`./#${encodePermalink(vertices)}`} title="To move its vertices, and for the proof">Open in the lens</a>`
      }`,
      this.#which,
    )
    this.showAccepted(row)
    this.#lens.hidden = vertices === null
  }

  /** Which checks accept it. */
  showAccepted(row: Row): void {
    this.#accepted.textContent = acceptedSentence(row)
  }

  showNone(): void {
    render(html`The chosen cell is not in this step.`, this.#which)
    this.#accepted.textContent = ''
    this.#lens.hidden = true
  }

  scrollTo(): void {
    this.#root.scrollIntoView({ block: 'nearest' })
  }
}
