/** The way to forget all that this browser keeps for Hexlens. It asks once more, in its place. */
import { html, type TemplateResult } from 'lit-html'
import { forgetHanded } from './handed-input'
import { forgetAll } from './keep'
import { forgetLists } from './kept-list'

export class Forget {
  readonly #onChange: () => void
  readonly #onForget: () => void
  #step: 'offered' | 'asked' | 'done' = 'offered'

  /** `onForget` is called when nothing is kept any more, for what the page has in its memory. */
  constructor(onChange: () => void, onForget: () => void) {
    this.#onChange = onChange
    this.#onForget = onForget
  }

  template(): TemplateResult {
    return html`<div class="forget quiet" role="status">
      <p>
        What you make on the pages of Hexlens is kept in this browser alone, to be there when you come back: elements with
        their undo, drafts, finds of searches, progress.
      </p>
      ${this.#step === 'offered' ? html`<p>${this.#button('Forget what is kept here', 'asked')}</p>` : ''}
      ${
        this.#step === 'asked'
          ? html`<p>All of it, on every page?</p>
              <p class="actions">${this.#button('Forget it all', 'done')} ${this.#button('Keep it', 'offered')}</p>`
          : ''
      }
      ${this.#step === 'done' ? html`<p>Nothing is kept any more. Another tab keeps its own until you close it.</p>` : ''}
    </div>`
  }

  #button(label: string, next: 'offered' | 'asked' | 'done'): TemplateResult {
    return html`<button type="button" @click=${(event: Event) => this.#go(next, event)}>${label}</button>`
  }

  #go(next: 'offered' | 'asked' | 'done', event: Event): void {
    this.#step = next
    const place = (event.target as Element).closest<HTMLElement>('.forget')
    if (next === 'done') {
      forgetAll()
      forgetLists()
      forgetHanded()
      this.#onForget()
    }
    this.#onChange()
    // The focus goes on to what has come: forgetting is never what Enter does twice.
    const buttons = place?.querySelectorAll('button') ?? []
    buttons[buttons.length - 1]?.focus()
  }
}
