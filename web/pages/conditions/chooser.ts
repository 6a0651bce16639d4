/** Conditions by choosing: a row of menus for each, a mistake in a sentence at its row, and the same as text. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { live } from 'lit-html/directives/live.js'
import { claims, numbers } from '../../core/quantities'
import type { Comparison } from '../../model/condition/parse'
import {
  COMPARISONS_IN_WORDS,
  mistakeIn,
  newRow,
  type Row,
  rowsOf,
  SUBJECTS,
  type Subject,
  subjectOf,
  textOfRows,
  withSubject,
} from './rows'

export interface ChooserProps {
  readonly rows: readonly Row[]
  readonly most: number
  readonly mostCharacters: number
  onChange(rows: readonly Row[]): void
}

export function chooser({ rows, most, mostCharacters, onChange }: ChooserProps): TemplateResult {
  const put = (i: number, row: Row) => onChange(rows.with(i, row))
  return html`<fieldset class="chooser">
      <legend>Goal: conditions that all have to hold</legend>
      <ol class="rows">
        ${rows.map((row, i) =>
          rowTemplate(
            row,
            i,
            mostCharacters,
            next => put(i, next),
            () => onChange(rows.toSpliced(i, 1)),
          ),
        )}
      </ol>
      <p class="actions">
        <button type="button" ?disabled=${rows.length >= most} @click=${() => onChange([...rows, newRow(rows)])}>
          Add a condition
        </button>
      </p>
    </fieldset>
    <details class="quiet">
      <summary>The conditions as text</summary>
      <p>
        One a line. Comparisons with &lt;, &lt;=, &gt;, &gt;=, = and != of sums, products and numbers such as 0.2 and 1/3, joined by and, or,
        not.
      </p>
      <textarea
        rows="4"
        class="code"
        aria-label="The conditions as text, one a line"
        spellcheck="false"
        autocapitalize="off"
        .value=${live(typed.get(rows) ?? textOfRows(rows))}
        @input=${(event: Event) => onChange(rowsOfTyped((event.target as HTMLTextAreaElement).value))}
      ></textarea>
      <p>They speak of:</p>
      <dl class="meanings">
        ${Object.entries({ ...claims, ...numbers }).map(
          ([name, { sentence }]) => html`<dt><code>${name}</code></dt>
            <dd>${sentence}</dd>`,
        )}
      </dl>
    </details>`
}

/** Rows that were typed as text: as long as no menu changes them, the text stays as it was typed. */
const typed = new WeakMap<readonly Row[], string>()

function rowsOfTyped(text: string): readonly Row[] {
  const rows = rowsOf(text)
  typed.set(rows, text)
  return rows
}

function rowTemplate(
  row: Row,
  i: number,
  mostCharacters: number,
  put: (row: Row) => void,
  remove: () => void,
): TemplateResult {
  const label = `Condition ${i + 1}`
  const mistake = mistakeIn(row)
  const subject = subjectOf(row)
  const choose = (event: Event) => put(withSubject(row, (event.target as HTMLSelectElement).value as Subject))
  return html`<li>
    <div class=${`row is-${row.kind}`}>
      <select aria-label=${label} .value=${live(subject)} @change=${choose}>
        ${SUBJECTS.map(each => html`<option value=${each} ?selected=${each === subject}>${SUBJECT_NAMES[each]}</option>`)}
      </select>
      ${row.kind === 'comparison' ? comparison(row, label, mistake, put) : ''}
      ${row.kind === 'text' ? field(`${label} as text`, row.text, mistake, text => put({ kind: 'text', text }), mostCharacters) : ''}
      <button type="button" class="small" aria-label=${`Remove condition ${i + 1}`} @click=${remove}>✕</button>
    </div>
    <p class="complaint" id=${idOf(label)}>${mistake ?? ''}</p>
  </li>`
}

function comparison(
  row: Row & { kind: 'comparison' },
  label: string,
  mistake: string | null,
  put: (row: Row) => void,
): TemplateResult {
  const choose = (event: Event) => put({ ...row, comparison: (event.target as HTMLSelectElement).value as Comparison })
  return html`<select aria-label=${`${label}, comparison`} .value=${live(row.comparison)} @change=${choose}>
      ${Object.entries(COMPARISONS_IN_WORDS).map(
        ([sign, words]) => html`<option value=${sign} ?selected=${sign === row.comparison}>${words}</option>`,
      )}
    </select>
    ${field(`${label}, number`, row.number, mistake, number => put({ ...row, number }), 60)}`
}

function field(
  label: string,
  value: string,
  mistake: string | null,
  put: (value: string) => void,
  mostCharacters: number,
): TemplateResult {
  return html`<input
    class="code"
    aria-label=${label}
    aria-invalid=${mistake === null ? nothing : 'true'}
    aria-describedby=${mistake === null ? nothing : idOf(label.replace(/(,| as) .*/, ''))}
    autocomplete="off"
    autocapitalize="none"
    spellcheck="false"
    maxlength=${mostCharacters}
    .value=${live(value)}
    @input=${(event: Event) => put((event.target as HTMLInputElement).value)}
  />`
}

function idOf(label: string): string {
  return `${label.toLowerCase().replaceAll(' ', '-')}-mistake`
}

const SUBJECT_NAMES = Object.fromEntries(
  SUBJECTS.map(subject => {
    if (subject === 'valid') return [subject, claims.valid.name]
    if (subject === 'invalid') return [subject, 'Invalid']
    return [subject, subject === 'text' ? 'As text …' : numbers[subject].name]
  }),
) as Readonly<Record<Subject, string>>
