/** What is said of a mesh below the sentence on top: what it was read from, and each note with what to do about it. */
import { html, nothing, type TemplateResult } from 'lit-html'
import type { Overview } from '../../survey/survey-jobs'
import { adviceFor } from './advice'
import type { Example } from './examples'
import { ALL_FORMATS, FORMATS, MEANS, nextSentence, STAYS } from './page-words'

export interface Noted {
  readonly overview: Overview | null
  readonly example: Example | null
  /** About the files that were given. */
  readonly beside: string
}

/** More are folded: the list of cells has to be seen. */
const SEEN = 3

export function notesTemplate({ overview, example, beside }: Noted): TemplateResult {
  const formats = html`<span class="formats" title=${ALL_FORMATS}>${FORMATS}</span>`
  if (!overview) return html`<p>${STAYS} ${formats}</p>`
  const sentences = [...overview.sentences, beside].filter(sentence => sentence !== '')
  const first = example
    ? html`<p>${example.sentence} ${MEANS} Drop your own mesh anywhere here. ${STAYS} ${formats}</p>`
    : html`<p><b>${overview.name}</b>, ${overview.format}. ${STAYS} ${nextSentence(overview)}</p>`
  const seen = sentences.length === SEEN + 1 ? SEEN + 1 : SEEN
  const notes = advised(sentences)
  const [some, more] = [notes.slice(0, seen), notes.slice(seen)]
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

interface Note {
  readonly sentence: string
  readonly advice: string
}

/** What helps against several is said once. */
function advised(sentences: readonly string[]): Note[] {
  const said = new Set([''])
  return sentences.map(sentence => {
    const advice = adviceFor(sentence) ?? ''
    const own = said.has(advice) ? '' : advice
    said.add(advice)
    return { sentence, advice: own }
  })
}

function noteTemplate({ sentence, advice }: Note): TemplateResult {
  return html`<li>${sentence}${advice === '' ? nothing : html` <span class="advice">${advice}</span>`}</li>`
}
