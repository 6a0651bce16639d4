/** The element for other documentation: lines to copy for each kind of site, and their preview. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { Vertices } from '../../model/hexahedron'
import { type State, sliceChange, sliceOf } from '../../model/state'
import { copyText } from '../../views/copy-text'
import { NumberField } from '../../views/number-field'
import { saveFile } from '../../views/save-file'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { type PlainWord, say } from '../../words/say'
import { type Choice, choiceSlice, HEIGHTS, THEMES } from './choice'
import css from './embed.css?inline'
import { appOf, cameraText, type Embed, embeddableViews, verticesText } from './embed-lines'
import { hosts, type Snippet } from './hosts'

export const styles = css

const PICTURE = 'hexlens.png'
const HEIGHT_STEP = 20
const THEME_WORDS = { auto: 'as the page’s', light: 'light', dark: 'dark' } as const
/** The preview's events are not those of the element around it. */
const EVENTS = ['hex-input', 'hex-change', 'hex-verdict', 'hex-ready', 'hex-error']

class EmbedView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  readonly #preview = document.createElement('hex-lens')
  readonly #height = new NumberField({
    name: say('Height'),
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
    // Of the page around it the preview has no layout.
    for (const name of ['--hl-stage-height', '--hl-split-stage-height'])
      this.#preview.style.setProperty(name, 'initial')
    this.#preview.style.setProperty('--hl-aspect-ratio', 'auto')
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
    const said =
      this.#valid === null
        ? say('A hexahedron')
        : this.#valid
          ? say('A valid hexahedron')
          : say('An invalid hexahedron')
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
      label: say('Preview: {label}', { label: embed.label }),
      readonly: embed.readonly ? '' : null,
      camera: embed.camera,
      app: appOf(embed),
    }
    for (const [name, value] of Object.entries(attributes)) {
      if (value === this.#preview.getAttribute(name)) continue
      if (value === null) this.#preview.removeAttribute(name)
      else this.#preview.setAttribute(name, value)
    }
    this.#preview.style.minHeight = `${embed.height}px`
  }

  #template(embed: Embed): TemplateResult {
    const { theme, readonly, camera } = this.#choice
    const host = hosts.find(({ id }) => id === this.#choice.host) ?? hosts[0]
    return html`
      <div class="choices">
        <label>${say('For')}
          <select @change=${(event: Event) => this.#choose({ host: hosts[selected(event).selectedIndex]?.id ?? '' })}>
            ${hosts.map(each => html`<option ?selected=${each === host}>${each.title}</option>`)}
          </select>
        </label>
        <label>${say('Height')} ${this.#height.input} px</label>
        <label>${say('Colours')}
          <select @change=${(event: Event) => this.#choose({ theme: THEMES[selected(event).selectedIndex] ?? 'auto' })}>
            ${THEMES.map(each => html`<option ?selected=${each === theme}>${say(THEME_WORDS[each])}</option>`)}
          </select>
        </label>
        <label><input type="checkbox" .checked=${readonly} @change=${(event: Event) => this.#choose({ readonly: isChecked(event) })}> ${say('Cannot be changed by readers')}</label>
      </div>
      <p id="embed-refusal" aria-live="polite">${this.#height.refusal}</p>
      <fieldset>
        <legend>${say('Shown')}</legend>
        ${embeddableViews.map(({ name, title }) => this.#viewChoice(name, title))}
      </fieldset>
      <label class="description">${say('Description, for screen readers and in the picture’s place')}
        <input type="text" .value=${embed.label} placeholder=${embed.label}
          @change=${(event: Event) => this.#choose({ label: (event.target as HTMLInputElement).value.trim() || null })}>
      </label>
      ${host.untested ? html`<p>${say('Not tested in {host} itself.', { host: host.title })}</p>` : nothing}
      ${[...host.setup, host.snippet(embed)].map(snippet => this.#snippet(snippet))}
      <p class="actions">
        <button type="button" @click=${() => this.#savePicture()}>${say('Download {file}', { file: PICTURE })}</button>
        <span>${say('the preview as a picture, for readers without JavaScript. Put it beside the page.')}</span>
      </p>
      <p aria-live="polite" class="told">${this.#said}</p>
      <h3>${say('Preview')}</h3>
      <div class="preview">${this.#preview}</div>
      <p class="actions">
        <button type="button" @click=${() => this.#choose({ camera: this.#previewCamera })}>${say('Keep this view')}</button>
        ${camera === null ? html`<span>${say('turned and zoomed as in the preview')}</span>` : html`<button type="button" @click=${() => this.#choose({ camera: null })}>${say('Forget it')}</button>`}
      </p>`
  }

  #viewChoice(name: string, title: PlainWord): TemplateResult {
    const { views } = this.#choice
    const choose = (event: Event) => {
      const chosen = isChecked(event) ? [...views, name] : views.filter(view => view !== name)
      this.#choose({ views: known(chosen) })
    }
    return html`<label><input type="checkbox" .checked=${views.includes(name)} @change=${choose}> ${say(title)}</label>`
  }

  #snippet({ place, text }: Snippet): TemplateResult {
    const where = say(place)
    const title = place.includes('.') ? where : `${where[0]?.toUpperCase()}${where.slice(1)}`
    return html`<div class="snippet">
      <p><span>${title}</span><button type="button" aria-label=${say('Copy: {what}', { what: where })} @click=${() => this.#copy(where, text)}>${say('Copy')}</button></p>
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
    const [copied, refused] = [say('Copied: {what}.', { what: place }), say('The browser does not allow copying here.')]
    this.#tell((await copyText(text)) ? copied : refused)
  }

  async #savePicture(): Promise<void> {
    try {
      saveFile(PICTURE, await this.#preview.toPNG(), 'image/png')
      this.#tell(say('Saved as {file}.', { file: PICTURE }))
    } catch (reason) {
      const why = reason instanceof Error ? reason.message : String(reason)
      this.#tell(say('This could not be drawn ({why}).', { why }))
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
