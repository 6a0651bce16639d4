/** The line above everything: presets, undo and redo, paste, and the link. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { Vertices } from '../../model/hexahedron'
import { type Preset, presets, presetVertices } from '../../model/presets'
import type { State } from '../../model/state'
import { copyText } from '../../views/copy-text'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import css from './toolbar.css?inline'

export const toolbarStyles = css

/** The link last copied, or not; reported for as long as it is the link to these vertices. */
interface CopyOutcome {
  readonly copied: boolean
  readonly link: string
  readonly vertices: Vertices
}

class ToolbarView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  #outcome: CopyOutcome | null = null
  /** The element for which the button may not paste: as long as it is this one, the toolbar says how to. */
  #hinted: Vertices | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'toolbar'
  }

  update({ state }: Frame): void {
    if (this.#outcome?.vertices !== state.vertices) this.#outcome = null
    if (state.vertices !== this.#hinted) this.#hinted = null
    const shown = shownPreset(state)
    render(
      html`<span class="brand">Hexlens</span>
        <label class="preset">
          <span>${say('Preset')}</span>
          <select class="on-paper" ?disabled=${state.isReadonly} @change=${this.#onPreset}>
            <option value="" hidden .selected=${shown === undefined}>${say('Custom')}</option>
            ${presets.map(
              preset => html`<option value=${preset.id} .selected=${shown === preset}>${say(preset.title)}</option>`,
            )}
          </select>
        </label>
        ${shown?.valid === null && !state.isReadonly ? this.#another(shown) : nothing}
        <p class="note" ?hidden=${state.preset === null}>${noteOf(state, shown)}</p>
        <p class="outcome" aria-live="polite">${this.#outcome?.copied ? say('Link copied') : this.#hinted ? say('Press Ctrl+V (⌘V), or use the box.') : ''}</p>
        <div class="actions">
          <button type="button" ?disabled=${!state.canUndo || state.isReadonly} @click=${() => this.#context.dispatch({ type: 'undo' })}>
            ${say('Undo')}
          </button>
          <button type="button" ?disabled=${!state.canRedo || state.isReadonly} @click=${() => this.#context.dispatch({ type: 'redo' })}>
            ${say('Redo')}
          </button>
          <button type="button" ?disabled=${state.isReadonly} @click=${() => this.#context.dispatch({ type: 'reset' })}>${say('Reset')}</button>
          ${this.#context.input.isWelcome() ? html`<button type="button" @click=${this.#paste}>${say('Paste')}</button>` : nothing}
          ${this.#context.permalink() === null ? nothing : html`<button type="button" @click=${this.#copyLink}>${say('Copy link')}</button>`}
        </div>
        ${
          this.#outcome?.copied === false
            ? html`<div class="link" role="alert">
                <label for="link">${say('The browser did not let the link be copied. Here it is:')}</label>
                <input id="link" readonly .value=${this.#outcome.link} @focus=${selectAll} />
              </div>`
            : nothing
        }`,
      this.root,
    )
  }

  dispose(): void {}

  #another(preset: Preset): TemplateResult {
    return html`<button type="button" @click=${() => this.#open(preset)}>${say('Another')}</button>`
  }

  readonly #onPreset = (event: Event): void => {
    const preset = presets.find(({ id }) => id === (event.target as HTMLSelectElement).value)
    if (preset) this.#open(preset)
  }

  #open(preset: Preset): void {
    this.#context.dispatch({ type: 'set-vertices', vertices: presetVertices(preset), preset: preset.id })
  }

  /** Browsers may ask first, or forbid it; then the panel has a box to paste into. */
  readonly #paste = async (): Promise<void> => {
    try {
      this.#context.input.read({ text: await navigator.clipboard.readText() })
    } catch {
      this.#hinted = this.#context.state().vertices
      this.#context.dispatch({ type: 'open-panel', panel: 'paste', isOpen: true })
      this.#context.requestFrame()
    }
  }

  readonly #copyLink = async (): Promise<void> => {
    const link = this.#context.permalink()
    if (link === null) return
    const { vertices } = this.#context.state()
    this.#outcome = { copied: await copyText(link), link, vertices }
    this.#context.requestFrame()
  }
}

function selectAll(event: FocusEvent): void {
  ;(event.target as HTMLInputElement).select()
}

/** The preset as long as the element is still what it started from. */
function shownPreset({ preset, vertices, start }: State): Preset | undefined {
  const isStart = vertices.every((value, index) => Object.is(value, start[index]))
  return isStart ? presets.find(({ id }) => id === preset) : undefined
}

/** The preset's note, or the name of the one that this was. */
function noteOf({ preset }: State, shown: Preset | undefined): string {
  const from = presets.find(({ id }) => id === preset)
  if (shown) return say(shown.note)
  return from ? say('Changed from “{preset}”.', { preset: say(from.title) }) : ''
}

export const createToolbar: CreateView = context => new ToolbarView(context)
