/** The form with which a teacher writes challenges: what it makes is a link, and what cannot be read is said in a sentence. */
import { html, type TemplateResult } from 'lit-html'
import { quantitiesOf } from '../../core/quantities'
import type { Report } from '../../core/report'
import { truthOf } from '../../model/condition'
import { sameBits, type Vertices } from '../../model/hexahedron'
import { Refusal } from '../../model/result'
import { copyText } from '../../views/copy-text'
import { chooser } from '../conditions/chooser'
import { KEEPING_NOTES, Keeper } from '../keep'
import { LIMITS, MOST_CHARACTERS } from './challenge'
import { lengthWarning, linkTo } from './challenge-link'
import { challenges } from './challenges'
import { goalRow } from './column'
import {
  canGrow,
  conditionsOf,
  current,
  type Draft,
  documentOf,
  newDraft,
  newWriting,
  readWriting,
  titleOf,
  type Writing,
  withDraft,
  withMember,
  withMoved,
  withoutMember,
} from './drafts'
import { type Member, memberReader, SERIES_VERSION } from './series'
import { encodeSeries } from './series-code'

/** What the form needs of the page. */
export interface FormHost {
  readonly vertices: () => Vertices
  readonly report: () => Report | null
  readonly analyze: (vertices: Vertices) => Promise<Report>
  /** Puts an element on the page: one step to undo. */
  readonly show: (vertices: Vertices) => void
  readonly print: (members: readonly Member[], link: string) => Promise<string>
  /** What was made ready to print is not what the form says any more. */
  readonly discardPrint: () => void
  /** The form looks different now. */
  readonly onChange: () => void
}

export class WriteForm {
  readonly #host: FormHost
  readonly #drafts = new Keeper('writing', 1, readWriting)
  #writing = this.#drafts.found() ?? newWriting()
  /** What was written before a draft was discarded, until something is written again. */
  #before: Writing | null = null
  #solution: { readonly vertices: Vertices; readonly report: Report } | null = null
  #made: { readonly members: readonly Member[]; readonly link: string } | null = null
  #said = ''
  #complaint = ''

  constructor(host: FormHost) {
    this.#host = host
  }

  column(): TemplateResult {
    const member = current(this.#writing)
    return html`<p class="quiet"><a href="#">All challenges</a></p>
      <h2 tabindex="-1" class="title">Write a challenge</h2>
      <p>
        Its link is all that others need; the draft is kept in this browser. What each part may be is described in
        <code>docs/challenge.schema.json</code>.
      </p>
      ${this.#writing.members.length > 1 ? this.#seriesList() : ''}
      ${member.kind === 'draft' ? this.#fields(member) : html`<p>“${titleOf(member)}” is one of this page’s: it is not changed here.</p>`}
      <h3>Series</h3>
      <p class="quiet">Several challenges go into one link. A student gets them in order and may skip one.</p>
      <p class="actions">
        <button type="button" ?disabled=${!canGrow(this.#writing)} @click=${() => this.#write(withMember(this.#left(), newDraft()))}>
          Add another challenge
        </button>
        <select aria-label="Add one of this page’s" ?disabled=${!canGrow(this.#writing)} @change=${(event: Event) => this.#addOfThisPage(event)}>
          <option value="">Add one of this page’s …</option>
          ${challenges.map(({ id, title }) => html`<option value=${id}>${title}</option>`)}
        </select>
      </p>
      <p class="actions">
        <button type="button" @click=${() => this.#make()}>Make the link</button>
        <button type="button" @click=${() => this.#toggleDiscarded()}>
          ${this.#before ? 'Bring the draft back' : 'Discard the draft'}
        </button>
      </p>
      <p role="status" class="quiet">${KEEPING_NOTES[this.#drafts.keeping]}</p>
      <p class="complaint" role="alert">${this.#complaint}</p>
      <p role="status" class="quiet">${this.#said}</p>
      ${
        this.#made === null
          ? ''
          : html`<p><input class="link" readonly aria-label="Link to the challenge" .value=${this.#made.link} /></p>
              <p class="actions">
                <a class="button" href=${this.#made.link}>Open it</a>
                <button type="button" @click=${() => this.#print()}>Print on one side</button>
              </p>`
      }`
  }

  #seriesList(): TemplateResult {
    const { members, at } = this.#writing
    return html`<h3 id="in-series">The series, in order</h3>
      <ol class="series" aria-labelledby="in-series">
        ${members.map((member, i) => {
          const title = titleOf(member)
          const name = `${i + 1}, ${title}`
          return html`<li>
            <button type="button" class="series-title" aria-current=${i === at ? 'true' : 'false'} @click=${() => this.#open(i)}>
              ${title}
            </button>
            <button type="button" class="small" aria-label=${`Move ${name} up`} ?disabled=${i === 0} @click=${() => this.#write(withMoved(this.#writing, i, -1))}>↑</button>
            <button type="button" class="small" aria-label=${`Move ${name} down`} ?disabled=${i === members.length - 1} @click=${() => this.#write(withMoved(this.#writing, i, 1))}>↓</button>
            <button type="button" class="small" aria-label=${`Remove ${name}`} @click=${() => this.#discard(i)}>Remove</button>
          </li>`
        })}
      </ol>`
  }

  #fields(draft: Draft): TemplateResult {
    const to = (key: 'title' | 'text' | 'hint') => (event: Event) =>
      this.#write(withDraft(this.#writing, { [key]: (event.target as HTMLInputElement).value }))
    return html`${field('Title', html`<input maxlength=${LIMITS.title} .value=${draft.title} @input=${to('title')} />`)}
      ${field(
        'What it is about, as plain text',
        html`<textarea rows="3" maxlength=${LIMITS.text} .value=${draft.text} @input=${to('text')}></textarea>`,
      )}
      ${chooser({
        rows: draft.goal,
        most: LIMITS.goal,
        mostCharacters: LIMITS.condition,
        onChange: goal => this.#write(withDraft(this.#writing, { goal })),
      })}
      ${field(
        'Hint, if you like',
        html`<textarea rows="2" maxlength=${LIMITS.hint} .value=${draft.hint} @input=${to('hint')}></textarea>`,
      )}
      <p class="actions">
        <button type="button" @click=${() => this.#take('start')}>Take the element as the start</button>
        <button type="button" @click=${() => this.#take('solution')}>Take the element as a solution</button>
      </p>
      <p class="quiet">
        ${draft.start ? 'The start is taken.' : 'Until one is taken, the start is the element as it is.'}
        ${draft.solution ? 'A solution is taken.' : 'Without a solution there is none to show.'}
      </p>
      ${this.#preview(draft)}`
  }

  /** The challenge as a student sees it, with the conditions of the element as it is now. */
  #preview(draft: Draft): TemplateResult {
    const report = this.#host.report()
    const start = draft.start ?? this.#host.vertices()
    const conditions = conditionsOf(draft.goal)
    const quantities = report && quantitiesOf(report, start)
    return html`<section class="preview" aria-labelledby="preview-title">
      <h3 id="preview-title">As a student sees it, with the element as it is now</h3>
      <p class="preview-heading">${draft.title.trim() || 'No title yet'}</p>
      <p class="as-written">${draft.text.trim() || 'No text yet.'}</p>
      <ul class="goal">
        ${conditions.map((condition, i) =>
          condition === null
            ? html`<li><span class="mark" aria-hidden="true">–</span><span>Condition ${i + 1} is not understood.</span></li>`
            : goalRow(condition, quantities ? truthOf(condition, quantities) : undefined, report, start),
        )}
      </ul>
      <p class="quiet solution-check">${this.#solutionInWords(draft, start)}</p>
    </section>`
  }

  /** Whether the solution fulfils every condition, by the core. */
  #solutionInWords({ solution, goal }: Draft, start: Vertices): string {
    if (solution === null) return 'No solution is taken, so it is open whether there is one.'
    if (this.#solution === null || !sameBits(this.#solution.vertices, solution)) {
      void this.#analyzeSolution(solution)
      return 'The solution is being judged.'
    }
    const quantities = quantitiesOf(this.#solution.report, start)
    const missed = conditionsOf(goal).flatMap((condition, i) =>
      condition !== null && truthOf(condition, quantities) === true ? [] : [i + 1],
    )
    if (missed.length === 0) return 'The solution fulfils every condition.'
    return `The solution does not fulfil condition ${missed.join(', ')}.`
  }

  async #analyzeSolution(vertices: Vertices): Promise<void> {
    const report = await this.#host.analyze(vertices).catch(() => null) // the element says that there is no core
    if (report === null) return
    this.#solution = { vertices, report }
    this.#host.onChange()
  }

  /** A link that was made is not this challenge's any more. */
  #write(writing: Writing): void {
    this.#writing = writing
    this.#before = null
    this.#drafts.keep(writing)
    this.#made = null
    this.#said = ''
    this.#host.discardPrint()
    this.#host.onChange()
  }

  #discard(index: number): void {
    const before = this.#writing
    this.#complaint = ''
    this.#write(withoutMember(before, index))
    this.#before = before
    this.#host.onChange()
  }

  #toggleDiscarded(): void {
    if (this.#before) this.#write(this.#before)
    else this.#discard(this.#writing.at)
  }

  /** The members once the form turns to another: a start that was the element as it is then stays that element. */
  #left(): Writing {
    const member = current(this.#writing)
    const isOpen = member.kind === 'draft' && member.start === null
    return isOpen ? withDraft(this.#writing, { start: this.#host.vertices() }) : this.#writing
  }

  /** Another member is in the form, and its start in the lens. */
  #open(at: number): void {
    if (at === this.#writing.at) return
    const { members } = this.#left()
    this.#write({ members, at })
    const member = current(this.#writing)
    if (member.kind === 'draft' && member.start) this.#host.show(member.start)
  }

  #take(what: 'start' | 'solution'): void {
    this.#write(withDraft(this.#writing, { [what]: this.#host.vertices() }))
  }

  #addOfThisPage(event: Event): void {
    const select = event.target as HTMLSelectElement
    const { value: id } = select
    select.value = ''
    if (id !== '') this.#write(withMember(this.#left(), { kind: 'of this page', id }))
  }

  async #make(): Promise<void> {
    this.#made = null
    this.#said = ''
    const members = this.#readMembers()
    if (members) {
      const link = await linkOf(members)
      const isCopied = await copyText(link)
      this.#made = { members, link }
      this.#said = [
        isCopied ? 'The link is copied.' : 'Copying is not allowed here; this is the link:',
        lengthWarning(link),
      ].join(' ')
    }
    this.#host.onChange()
  }

  /** The members as a student's page reads them; null, and a complaint, if one cannot be read. */
  #readMembers(): readonly Member[] | null {
    const { members } = this.#writing
    this.#complaint = ''
    const read: Member[] = []
    for (const [i, member] of members.entries()) {
      const document = documentOf(member, this.#host.vertices())
      try {
        const { length } = JSON.stringify(document)
        if (length > MOST_CHARACTERS)
          throw new Refusal(`The challenge is ${length} characters long; ${MOST_CHARACTERS} are the most that is read.`)
        read.push(memberReader(document, 'challenge'))
      } catch (reason) {
        if (!(reason instanceof Refusal)) throw reason
        const sentence = asInTheForm(reason.message)
        this.#complaint = members.length > 1 ? `Challenge ${i + 1}: ${sentence}` : sentence
        this.#writing = { members, at: i }
        return null
      }
    }
    return read
  }

  async #print(): Promise<void> {
    if (this.#made === null) return
    this.#said = await this.#host.print(this.#made.members, await printedLink(this.#made.members))
    this.#host.onChange()
  }
}

/** A single challenge's link can be read by people; several are deflated. */
async function linkOf(members: readonly Member[]): Promise<string> {
  const [first] = members
  if (members.length > 1 || first === undefined) return printedLink(members)
  return first.id === null
    ? linkTo({ kind: 'own', json: JSON.stringify(first.document), vertices: null })
    : linkTo({ kind: 'challenge', id: first.id, vertices: null })
}

/** The shortest link: the coarser its QR code, the better cameras read it. */
export async function printedLink(members: readonly Member[]): Promise<string> {
  const [first] = members
  if (members.length === 1 && first && first.id !== null)
    return linkTo({ kind: 'challenge', id: first.id, vertices: null })
  const document = { version: SERIES_VERSION, challenges: members.map(({ document }) => document) } as const
  return linkTo({ kind: 'series', code: await encodeSeries(document), at: 0, vertices: null })
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
