/** A box to paste into, a button for files, and the formats; the outcome is said here, too. */
import { html, nothing, render } from 'lit-html'
import { formatNames } from '../../mesh/format-names'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import { statusSentence } from '../reading/reading-words'
import css from './paste.css?inline'

export const styles = css

class PasteView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'paste'
  }

  dispose(): void {}

  update({ reading }: Frame): void {
    render(
      html`<p>
          ${say(
            'Press Ctrl+V (⌘V), drop a text or files anywhere on Hexlens, or use the box. Give files that belong together at once, such as a .pvtu and its pieces.',
          )}
        </p>
        <label for="paste-text">${say('Text with eight points, or a part of a mesh file')}</label>
        <textarea id="paste-text" rows="5" spellcheck="false" autocomplete="off" autocapitalize="off"></textarea>
        <p class="actions">
          <button type="button" @click=${this.#onRead}>${say('Read it')}</button>
          <button type="button" @click=${() => this.root.querySelector('input')?.click()}>${say('Open files')}</button>
          <input type="file" multiple hidden @change=${this.#onFiles} />
        </p>
        ${reading ? html`<p class="outcome">${statusSentence(reading)}</p>` : nothing}
        <p class="known">${say('Hexlens reads {formats}, gzipped or not; code, tables and logs with eight points in them, a link or a PNG taken away from here.', { formats: formatNames.join(', ') })}</p>
        <p class="private">${say('Nothing that is pasted, dropped or typed here leaves the browser.')}</p>`,
      this.root,
    )
  }

  readonly #onRead = (): void => {
    this.#context.input.read({ text: this.root.querySelector('textarea')?.value ?? '' })
  }

  readonly #onFiles = (event: Event): void => {
    const input = event.target as HTMLInputElement
    const files = Array.from(input.files ?? [])
    input.value = ''
    if (files.length > 0) this.#context.input.read({ files })
  }
}

export const create: CreateView = context => new PasteView(context)
