/** The form with which a teacher writes a challenge: what it makes is a link, and what cannot be read is said in a sentence. */
import { html, type TemplateResult } from 'lit-html'
import { claims, numbers } from '../../core/quantities'
import { written } from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import { copyText } from '../../views/copy-text'
import { CHALLENGE_VERSION, type ChallengeDocument, LIMITS, readChallengeText } from './challenge'
import { challengeFragment } from './challenge-link'

export class WriteForm {
  readonly #vertices: () => Vertices
  readonly #onChange: () => void
  #title = ''
  #text = ''
  #goal = 'not valid\ncorner_min > 0'
  #hint = ''
  #start: Vertices | null = null
  #solution: Vertices | null = null
  #link: string | null = null
  #said = ''
  #complaint = ''

  /** `vertices` are those of the element on the page. */
  constructor(vertices: () => Vertices, onChange: () => void) {
    this.#vertices = vertices
    this.#onChange = onChange
  }

  column(): TemplateResult {
    return html`<p class="quiet"><a href="#">All challenges</a></p>
      <h2 tabindex="-1" class="title">Write a challenge</h2>
      <p>
        It is kept nowhere but in its link. What each part may be is described in
        <code>docs/challenge.schema.json</code>.
      </p>
      ${field('Title', html`<input maxlength=${LIMITS.title} .value=${this.#title} @input=${this.#to(value => (this.#title = value))} />`)}
      ${field(
        'What it is about, as plain text',
        html`<textarea rows="3" maxlength=${LIMITS.text} .value=${this.#text} @input=${this.#to(value => (this.#text = value))}></textarea>`,
      )}
      ${field(
        'Goal: conditions that all have to hold, one a line',
        html`<textarea
          rows="3"
          class="code"
          spellcheck="false"
          autocapitalize="off"
          .value=${this.#goal}
          @input=${this.#to(value => (this.#goal = value))}
        ></textarea>`,
      )}
      <details class="quiet">
        <summary>What conditions can say</summary>
        <p>
          Comparisons with &lt;, &lt;=, &gt;, &gt;=, = and != of sums, products and numbers such as 0.2 and 1/3, joined by and, or, not. They
          speak of:
        </p>
        <dl class="meanings">
          ${Object.entries({ ...claims, ...numbers }).map(
            ([name, { sentence }]) => html`<dt><code>${name}</code></dt>
              <dd>${sentence}</dd>`,
          )}
        </dl>
      </details>
      ${field(
        'Hint, if you like',
        html`<textarea rows="2" maxlength=${LIMITS.hint} .value=${this.#hint} @input=${this.#to(value => (this.#hint = value))}></textarea>`,
      )}
      <p class="actions">
        <button type="button" @click=${() => this.#take('start')}>Take the element as the start</button>
        <button type="button" @click=${() => this.#take('solution')}>Take the element as a solution</button>
      </p>
      <p class="quiet">
        ${this.#start ? 'The start is taken.' : 'Until one is taken, the start is the element as it is.'}
        ${this.#solution ? 'A solution is taken.' : 'Without a solution there is none to show.'}
      </p>
      <p class="actions"><button type="button" @click=${() => this.#make()}>Make the link</button></p>
      <p class="complaint" role="alert">${this.#complaint}</p>
      <p role="status" class="quiet">${this.#said}</p>
      ${
        this.#link === null
          ? ''
          : html`<p><input class="link" readonly aria-label="Link to the challenge" .value=${this.#link} /></p>
              <p><a href=${this.#link}>Open it</a></p>`
      }`
  }

  #to(set: (value: string) => void) {
    return (event: Event) => set((event.target as HTMLInputElement).value)
  }

  #take(what: 'start' | 'solution'): void {
    if (what === 'start') this.#start = this.#vertices()
    else this.#solution = this.#vertices()
    this.#onChange()
  }

  async #make(): Promise<void> {
    const json = JSON.stringify(this.#document())
    const result = readChallengeText(json)
    this.#complaint = result.ok ? '' : asInTheForm(result.error.message)
    this.#link = null
    this.#said = ''
    if (result.ok) {
      const address = new URL(location.href)
      address.hash = challengeFragment({ kind: 'own', json, vertices: null })
      this.#link = address.href
      this.#said = (await copyText(address.href))
        ? 'The link is copied.'
        : 'Copying is not allowed here; this is the link:'
    }
    this.#onChange()
  }

  #document(): ChallengeDocument {
    return {
      version: CHALLENGE_VERSION,
      title: this.#title,
      text: this.#text,
      start: written(this.#start ?? this.#vertices()),
      goal: this.#goal
        .split('\n')
        .map(line => line.trim())
        .filter(line => line !== ''),
      ...(this.#hint.trim() === '' ? {} : { hint: this.#hint }),
      ...(this.#solution ? { solution: written(this.#solution) } : {}),
    }
  }
}

/** The reader speaks of keys; here they are fields and lines. */
function asInTheForm(message: string): string {
  return message
    .replace(/^challenge\.goal\[(\d+)\]/, (_, i) => `Condition ${Number(i) + 1}`)
    .replace(/^challenge\.(\w+)/, 'The $1')
}

function field(label: string, control: TemplateResult): TemplateResult {
  return html`<label class="field"><span>${label}</span>${control}</label>`
}
