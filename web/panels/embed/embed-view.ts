/** The element for other documentation: lines to copy for each kind of site, and their preview. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { Vertices } from '../../model/hexahedron'
import { type State, sliceChange, sliceOf } from '../../model/state'
import { copyText } from '../../views/copy-text'
import { NumberField } from '../../views/number-field'
import { saveFile } from '../../views/save-file'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { type Choice, choiceSlice, HEIGHTS, THEMES } from './choice'
import css from './embed.css?inline'
import { appOf, cameraText, type Embed, embeddableViews, verticesText } from './embed-lines'
import { hosts, type Snippet } from './hosts'

export const styles = css

const PICTURE = 'hexlens.png'
const HEIGHT_STEP = 20
/** The preview's events are not those of the element around it. */
const EVENTS = ['hex-input', 'hex-change', 'hex-verdict', 'hex-ready', 'hex-error']

class EmbedView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  readonly #preview = document.createElement('hex-lens')
  readonly #height = new NumberField({
    name: 'Height',
    refusalId: 'embed-refusal',
    onRefusal: () => this.#render(),
    limits: HEIGHTS,
    step: HEIGHT_STEP,
    commit: height => this.#choose({ height }),
  })
  #choice: Choice
  #vertices: Vertices
  #valid: boolean | null = null
  #said = ''

  constructor(context: ViewContext) {
    this.#context = context
    this.#vertices = context.state().vertices
    this.#choice = choiceIn(context.state())
    this.root.className = 'embed'
    this.#height.show(this.#choice.height)
    for (const name of EVENTS) this.#preview.addEventListener(name, event => event.stopPropagation())
    this.#render()
  }

  update({ state, report }: Frame): void {
    const valid = report?.valid ?? null
    const choice = choiceIn(state)
    const isSame = state.vertices === this.#vertices && valid === this.#valid && choice === this.#choice
    if (state.gestureStart !== null || isSame) return
    this.#choice = choice
    this.#height.show(choice.height)
    this.#vertices = state.vertices
    this.#valid = valid
    this.#said = ''
    this.#render()
  }

  dispose(): void {
    this.#preview.remove()
  }

  get #embed(): Embed {
    const { host: _, label, views, ...choice } = this.#choice
    const said = this.#valid === null ? 'A hexahedron' : `${this.#valid ? 'A valid' : 'An invalid'} hexahedron`
    return {
      ...choice,
      views: known(views),
      vertices: this.#vertices,
      label: label ?? said,
      link: this.#context.permalink() ?? '', // the panel is not there without one
      poster: PICTURE,
    }
  }

  #choose(change: Partial<Choice>): void {
    this.#choice = { ...this.#choice, ...change }
    this.#context.dispatch(sliceChange(choiceSlice, { embedding: this.#choice }))
    this.#said = ''
    this.#render()
  }

  #render(): void {
    const embed = this.#embed
    this.#showPreview(embed)
    render(this.#template(embed), this.root)
  }

  #showPreview(embed: Embed): void {
    const attributes: Readonly<Record<string, string | null>> = {
      vertices: verticesText(embed.vertices),
      views: embed.views.join(' ') || 'none',
      theme: embed.theme,
      label: `Preview: ${embed.label}`,
      readonly: embed.readonly ? '' : null,
      camera: embed.camera,
      app: appOf(embed),
    }
    for (const [name, value] of Object.entries(attributes)) {
      if (value === this.#preview.getAttribute(name)) continue
      if (value === null) this.#preview.removeAttribute(name)
      else this.#preview.setAttribute(name, value)
    }
    this.#preview.style.width = '100%'
    this.#preview.style.height = `${embed.height}px`
  }

  #template(embed: Embed): TemplateResult {
    const { theme, readonly, camera } = this.#choice
    const host = hosts.find(({ id }) => id === this.#choice.host) ?? hosts[0]
    return html`
      <div class="choices">
        <label>For
          <select @change=${(event: Event) => this.#choose({ host: hosts[selected(event).selectedIndex]?.id ?? '' })}>
            ${hosts.map(each => html`<option ?selected=${each === host}>${each.title}</option>`)}
          </select>
        </label>
        <label>Height ${this.#height.input} px</label>
        <label>Colours
          <select @change=${(event: Event) => this.#choose({ theme: THEMES[selected(event).selectedIndex] ?? 'auto' })}>
            ${THEMES.map(each => html`<option ?selected=${each === theme}>${each === 'auto' ? 'as the reader’s' : each}</option>`)}
          </select>
        </label>
        <label><input type="checkbox" .checked=${readonly} @change=${(event: Event) => this.#choose({ readonly: isChecked(event) })}> Cannot be changed by readers</label>
      </div>
      <p id="embed-refusal" aria-live="polite">${this.#height.refusal}</p>
      <fieldset>
        <legend>Shown</legend>
        ${embeddableViews.map(({ name, title }) => this.#viewChoice(name, title))}
      </fieldset>
      <label class="description">Description, for screen readers and in the picture’s place
        <input type="text" .value=${embed.label} placeholder=${embed.label}
          @change=${(event: Event) => this.#choose({ label: (event.target as HTMLInputElement).value.trim() || null })}>
      </label>
      ${host.untested ? html`<p>Not tested in ${host.title} itself.</p>` : nothing}
      ${[...host.setup, host.snippet(embed)].map(snippet => this.#snippet(snippet))}
      <p class="actions">
        <button type="button" @click=${() => this.#savePicture()}>Download ${PICTURE}</button>
        <span>the preview as a picture, for readers without JavaScript. Put it beside the page.</span>
      </p>
      <p aria-live="polite" class="told">${this.#said}</p>
      <h3>Preview</h3>
      <div class="preview">${this.#preview}</div>
      <p class="actions">
        <button type="button" @click=${() => this.#choose({ camera: this.#previewCamera })}>Keep this view</button>
        ${camera === null ? html`<span>turned and zoomed as in the preview</span>` : html`<button type="button" @click=${() => this.#choose({ camera: null })}>Forget it</button>`}
      </p>`
  }

  #viewChoice(name: string, title: string): TemplateResult {
    const { views } = this.#choice
    const choose = (event: Event) => {
      const chosen = isChecked(event) ? [...views, name] : views.filter(view => view !== name)
      this.#choose({ views: known(chosen) })
    }
    return html`<label><input type="checkbox" .checked=${views.includes(name)} @change=${choose}> ${title}</label>`
  }

  #snippet({ place, text }: Snippet): TemplateResult {
    const title = place.includes('.') ? place : `${place[0]?.toUpperCase()}${place.slice(1)}`
    return html`<div class="snippet">
      <p><span>${title}</span><button type="button" aria-label=${`Copy: ${place}`} @click=${() => this.#copy(place, text)}>Copy</button></p>
      <pre tabindex="0" aria-label=${title}><code>${text}</code></pre>
    </div>`
  }

  get #previewCamera(): string | null {
    const { camera } = this.#preview.state
    return camera && cameraText(camera)
  }

  #tell(sentence: string): void {
    this.#said = sentence
    this.#render()
  }

  async #copy(place: string, text: string): Promise<void> {
    this.#tell((await copyText(text)) ? `Copied: ${place}.` : 'The browser does not allow copying here.')
  }

  async #savePicture(): Promise<void> {
    try {
      saveFile(PICTURE, await this.#preview.toPNG(), 'image/png')
      this.#tell(`Saved as ${PICTURE}.`)
    } catch (reason) {
      this.#tell(`This could not be drawn (${reason instanceof Error ? reason.message : reason}).`)
    }
  }
}

function selected(event: Event): HTMLSelectElement {
  return event.target as HTMLSelectElement
}

function isChecked(event: Event): boolean {
  return (event.target as HTMLInputElement).checked
}

/** In their order; those of a later program are left out. */
function known(views: readonly string[]): readonly string[] {
  return embeddableViews.map(({ name }) => name).filter(name => views.includes(name))
}

const choiceIn = (state: State) => sliceOf(choiceSlice, state).embedding

export const create: CreateView = context => new EmbedView(context)
