/** The form with which a teacher writes a challenge: what it makes is a link, and what cannot be read is said in a sentence. */
import { html, type TemplateResult } from 'lit-html'
import { claims, numbers } from '../../core/quantities'
import { written } from '../../model/document-readers'
import { COORDINATE_COUNT, type Vertices } from '../../model/hexahedron'
import { copyText } from '../../views/copy-text'
import { KEEPING_NOTES, Keeper } from '../keep'
import { CHALLENGE_VERSION, type ChallengeDocument, LIMITS, readChallengeText } from './challenge'
import { challengeFragment } from './challenge-link'

interface Draft {
  readonly title: string
  readonly text: string
  readonly goal: string
  readonly hint: string
  /** Null until it is taken: then it is the element as it is. */
  readonly start: Vertices | null
  readonly solution: Vertices | null
}

const EMPTY: Draft = { title: '', text: '', goal: 'not valid\ncorner_min > 0', hint: '', start: null, solution: null }

/** Null if it is no draft. */
function readDraft(value: unknown): Draft | null {
  const { title, text, goal, hint, start, solution } = (value ?? {}) as Partial<Record<keyof Draft, unknown>>
  const areTexts = [title, text, goal, hint].every(each => typeof each === 'string')
  const areElements = [start, solution].every(each => each === null || isElement(each))
  return areTexts && areElements ? (value as Draft) : null
}

function isElement(value: unknown): boolean {
  return Array.isArray(value) && value.length === COORDINATE_COUNT && value.every(Number.isFinite)
}

export class WriteForm {
  readonly #vertices: () => Vertices
  readonly #onChange: () => void
  readonly #drafts = new Keeper('draft', 1, readDraft)
  #draft = this.#drafts.found() ?? EMPTY
  /** The draft that was discarded last, until something is written again. */
  #discarded: Draft | null = null
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
        Its link is all that others need; the draft is kept in this browser. What each part may be is described in
        <code>docs/challenge.schema.json</code>.
      </p>
      ${field('Title', html`<input maxlength=${LIMITS.title} .value=${this.#draft.title} @input=${this.#to('title')} />`)}
      ${field(
        'What it is about, as plain text',
        html`<textarea rows="3" maxlength=${LIMITS.text} .value=${this.#draft.text} @input=${this.#to('text')}></textarea>`,
      )}
      ${field(
        'Goal: conditions that all have to hold, one a line',
        html`<textarea
          rows="3"
          class="code"
          spellcheck="false"
          autocapitalize="off"
          .value=${this.#draft.goal}
          @input=${this.#to('goal')}
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
        html`<textarea rows="2" maxlength=${LIMITS.hint} .value=${this.#draft.hint} @input=${this.#to('hint')}></textarea>`,
      )}
      <p class="actions">
        <button type="button" @click=${() => this.#take('start')}>Take the element as the start</button>
        <button type="button" @click=${() => this.#take('solution')}>Take the element as a solution</button>
      </p>
      <p class="quiet">
        ${this.#draft.start ? 'The start is taken.' : 'Until one is taken, the start is the element as it is.'}
        ${this.#draft.solution ? 'A solution is taken.' : 'Without a solution there is none to show.'}
      </p>
      <p class="actions">
        <button type="button" @click=${() => this.#make()}>Make the link</button>
        <button type="button" @click=${() => this.#toggleDiscarded()}>
          ${this.#discarded ? 'Bring the draft back' : 'Discard the draft'}
        </button>
      </p>
      <p role="status" class="quiet">${KEEPING_NOTES[this.#drafts.keeping]}</p>
      <p class="complaint" role="alert">${this.#complaint}</p>
      <p role="status" class="quiet">${this.#said}</p>
      ${
        this.#link === null
          ? ''
          : html`<p><input class="link" readonly aria-label="Link to the challenge" .value=${this.#link} /></p>
              <p><a href=${this.#link}>Open it</a></p>`
      }`
  }

  #to(key: 'title' | 'text' | 'goal' | 'hint') {
    return (event: Event) => this.#write({ [key]: (event.target as HTMLInputElement).value })
  }

  #take(what: 'start' | 'solution'): void {
    this.#write({ [what]: this.#vertices() })
  }

  #write(some: Partial<Draft>): void {
    this.#draft = { ...this.#draft, ...some }
    this.#discarded = null
    this.#drafts.keep(this.#draft)
    this.#onChange()
  }

  #toggleDiscarded(): void {
    const before = this.#discarded === null ? this.#draft : null
    this.#write(this.#discarded ?? EMPTY)
    this.#discarded = before
    this.#link = null
    this.#complaint = ''
    this.#said = ''
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
    const { title, text, start, goal, hint, solution } = this.#draft
    return {
      version: CHALLENGE_VERSION,
      title,
      text,
      start: written(start ?? this.#vertices()),
      goal: goal
        .split('\n')
        .map(line => line.trim())
        .filter(line => line !== ''),
      ...(hint.trim() === '' ? {} : { hint }),
      ...(solution ? { solution: written(solution) } : {}),
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
