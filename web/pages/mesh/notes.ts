/** What is said of a mesh below the sentence on top: what it was read from, and each note with what to do about it. */
import { html, nothing, type TemplateResult } from 'lit-html'
import type { Overview } from '../../survey/survey-jobs'
import { adviceFor } from './advice'
import { ALL_FORMATS, EXAMPLE, FORMATS, nextSentence, STAYS } from './page-words'

export interface Noted {
  readonly overview: Overview | null
  readonly isExample: boolean
  /** About the files that were given. */
  readonly beside: string
}

/** More are folded: the list of cells has to be seen. */
const SEEN = 3

export function notesTemplate({ overview, isExample, beside }: Noted): TemplateResult {
  const formats = html`<span class="formats" title=${ALL_FORMATS}>${FORMATS}</span>`
  if (!overview) return html`<p>${STAYS} ${formats}</p>`
  const sentences = [...overview.sentences, beside].filter(sentence => sentence !== '')
  const first = isExample
    ? html`<p>${EXAMPLE} ${STAYS} ${formats}</p>`
    : html`<p><b>${overview.name}</b>, ${overview.format}. ${STAYS} ${nextSentence(overview)}</p>`
  const seen = sentences.length === SEEN + 1 ? SEEN + 1 : SEEN
  const [some, more] = [sentences.slice(0, seen), sentences.slice(seen)]
  return html`${first}
  ${some.length === 0 ? nothing : html`<ul>${some.map(noteTemplate)}</ul>`}
  ${
    more.length === 0
      ? nothing
      : html`<details>
        <summary>${more.length} more notes</summary>
        <ul>
          ${more.map(noteTemplate)}
        </ul>
      </details>`
  }`
}

function noteTemplate(sentence: string): TemplateResult {
  const advice = adviceFor(sentence) ?? ''
  return html`<li>${sentence}${advice === '' ? nothing : html` <span class="advice">${advice}</span>`}</li>`
}
