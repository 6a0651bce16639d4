/** The top of the page: what is being read, what is said of the open mesh, and what can be done with it. */
import { html, nothing, type TemplateResult } from 'lit-html'
import type { PastedInput } from '../../input/pasted-input'
import type { ReadingProgress } from '../../input/reading'
import { LOADING } from '../../mesh/hdf5-reader'
import { headlineTemplate } from '../../mesh-views/headline'
import type { Fix } from '../../survey/survey-jobs'
import { EXAMPLES, type Example } from './examples'
import { notesTemplate } from './notes'
import type { PutAside, Shown, UnderWay } from './page-state'
import { NOTHING_OPEN, unsavedSentence } from './page-words'

export interface OverviewActions {
  open(input: PastedInput, example: Example): void
  cancel(): void
  bringBack(aside: PutAside): void
  mend(fix: Fix): void
}

/** What others draw in it. */
export interface OverviewParts {
  readonly door: TemplateResult
  readonly buttons: readonly HTMLElement[]
  readonly panels: readonly HTMLElement[]
}

export function overviewTemplate(shown: Shown, actions: OverviewActions, parts: OverviewParts): TemplateResult {
  const { overview, progress, news, aside } = shown
  return html`${progress ? progressTemplate(progress, actions) : nothing}
    <div role="status" aria-atomic="false">
      <p class="said">${progress && !news ? `Reading ${progress.name}.` : ''}</p>
      ${news === '' ? nothing : html`<p class="news">${news}</p>`}
      ${aside ? asideTemplate(aside, actions) : nothing}
      ${overview ? html`<p class="headline" tabindex="-1">${headlineTemplate(overview.headline)}</p>` : nothing}
      ${!overview && !progress ? html`<p class="headline">${NOTHING_OPEN}</p>` : nothing}
    </div>
    <div class=${overview ? 'below has-mesh' : 'below'}>
      <div class="notes">${notesTemplate(shown)}</div>
      <p class="buttons">
        ${overview?.fixes.map(fix => html`<button type="button" class="fix" @click=${() => actions.mend(fix)}>${fix.words}</button>`)}
        ${parts.door}
        ${parts.buttons}
        ${examplesTemplate(shown, actions)}
      </p>
    </div>
    ${parts.panels}`
}

function progressTemplate({ name, step, fraction }: UnderWay, actions: OverviewActions): TemplateResult {
  return html`<p class="progress">
    <label>${doing[step](name)} <progress max="1" value=${step === 'loading' ? nothing : fraction}></progress></label>
    <button type="button" @click=${() => actions.cancel()}>Cancel</button>
  </p>`
}

function asideTemplate(aside: PutAside, actions: OverviewActions): TemplateResult {
  const name = aside.example ? 'the example before' : aside.overview.name
  return html`<p class="news">
    ${unsavedSentence(name, aside.movement.movedCount)}
    <button type="button" @click=${() => actions.bringBack(aside)}>Back to ${name}</button>
  </p>`
}

function examplesTemplate({ example }: Shown, actions: OverviewActions): TemplateResult {
  const onChange = ({ target }: Event) => {
    const chosen = EXAMPLES[Number((target as HTMLSelectElement).value || -1)]
    if (chosen) actions.open({ files: [chosen.file()] }, chosen)
  }
  return html`<select class="examples" aria-label="Examples" @change=${onChange}>
    <option value="" .selected=${example === null}>Examples</option>
    ${EXAMPLES.map((each, i) => html`<option value=${i} .selected=${each === example}>${each.name}</option>`)}
  </select>`
}

const doing: Readonly<Record<ReadingProgress['step'], (name: string) => string>> = {
  loading: () => LOADING,
  reading: name => `Reading ${name}`,
  deciding: name => `Deciding the cells of ${name}`,
}
