/** The form of a search: the property, and the elements to search. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { claims, numbers } from '../../core/quantities'
import { VERTEX_COUNT } from '../../model/hexahedron'
import { readNumber } from '../../model/number-text'
import type { QueryError } from './engine/query'
import { symmetries } from './engine/symmetry'
import { type FormState, grids, kindOf, kinds } from './form-state'

export interface FormProps {
  readonly form: FormState
  readonly errors: readonly QueryError[]
  onChange(name: keyof FormState, value: string): void
  onSubmit(): void
}

/** The choice of a search, which stands above the finds. */
export function kindTemplate({ form, onChange }: FormProps): TemplateResult {
  return html`${choiceTemplate(
    'find',
    'Find',
    kinds.map(({ id, title }) => [id, title]),
    form,
    listener('find', onChange),
  )}
    <p class="quiet">${kindOf(form.find)?.note}</p>`
}

type Listener = (event: Event) => void

function listener(name: keyof FormState, onChange: FormProps['onChange']): Listener {
  return event => onChange(name, (event.target as HTMLInputElement | HTMLSelectElement).value)
}

function choiceTemplate(
  name: keyof FormState,
  label: string,
  options: readonly (readonly [string, string])[],
  form: FormState,
  onInput: Listener,
): TemplateResult {
  return html`<label class="choice"
    ><span>${label}</span>
    <select form="query" name=${name} .value=${form[name]} @change=${onInput}>
      ${options.map(([value, title]) => html`<option value=${value} ?selected=${value === form[name]}>${title}</option>`)}
    </select></label
  >`
}

export function formTemplate({ form, errors, onChange, onSubmit }: FormProps): TemplateResult {
  const listen = (name: keyof FormState) => listener(name, onChange)
  const choice = (name: keyof FormState, label: string, options: readonly (readonly [string, string])[]) =>
    choiceTemplate(name, label, options, form, listen(name))
  const unread = unreadNumbers(form)
  const isWrong = (name: keyof FormState, field: QueryError['field']) =>
    unread.length > 0 ? unread.some(each => each.name === name) : errors.some(error => error.field === field)
  const number = (name: keyof FormState, label: string, field: QueryError['field']) =>
    html`<input
      class="number"
      name=${name}
      aria-label=${label}
      inputmode=${name === 'seed' ? 'numeric' : nothing}
      autocomplete="off"
      spellcheck="false"
      .value=${form[name]}
      aria-invalid=${isWrong(name, field) ? 'true' : nothing}
      aria-describedby=${`${field}-error`}
      @input=${listen(name)}
    />`
  const submit = (event: Event) => {
    event.preventDefault()
    onSubmit()
  }
  const law = (value: FormState['law']) =>
    html`<input type="radio" name="law" value=${value} .checked=${form.law === value} @change=${listen('law')} />`

  return html`<form id="query" class="query" @submit=${submit}>
    ${condition('property', 'Property', form, errors, listen('property'))}
    ${condition('measure', 'Most extreme where this is greatest', form, errors, listen('measure'))}
    ${vocabulary()}
    <fieldset>
      <legend>Among these elements</legend>
      <div class="law">
        <label>${law('normal')} the unit cube, moved at random</label>
        <label>sigma ${number('sigma', 'Sigma', 'distribution')}</label>
      </div>
      <div class="law">
        <label>${law('box')} anywhere in a box</label>
        <span
          >from ${number('least', 'Least coordinate of the box', 'distribution')} to
          ${number('greatest', 'Greatest coordinate of the box', 'distribution')}</span
        >
      </div>
      <div class="choices">
        ${choice('grid', 'Coordinates', Object.entries(grids))}
        ${choice(
          'moved',
          'Vertices that move',
          Array.from({ length: VERTEX_COUNT }, (_, i) => [
            String(i + 1),
            i + 1 === VERTEX_COUNT ? 'all 8' : String(i + 1),
          ]),
        )}
        ${choice(
          'symmetry',
          'Symmetry',
          Object.entries(symmetries).map(([name, { title }]) => [name, title]),
        )}
        <label class="choice"><span>Seed</span>${number('seed', 'Seed', 'seed')}</label>
      </div>
      ${complaint('distribution', errors, unread)} ${complaint('seed', errors, unread)}
    </fieldset>
  </form>`
}

function condition(
  name: 'property' | 'measure',
  label: string,
  form: FormState,
  errors: readonly QueryError[],
  onInput: (event: Event) => void,
): TemplateResult {
  const error = errors.find(({ field }) => field === name)
  return html`<label class="condition"
      ><span>${label}</span>
      <input
        name=${name}
        autocomplete="off"
        autocapitalize="none"
        spellcheck="false"
        .value=${form[name]}
        aria-invalid=${error ? 'true' : nothing}
        aria-describedby=${`${name}-error`}
        @input=${onInput}
    /></label>
    <div class="complaint" id=${`${name}-error`}>${error ? [errorPosition(form[name], error.at ?? 0), error.message] : nothing}</div>`
}

/** Characters that are shown after the position, however long the text is. */
const MOST_AFTER = 80

/** The text again, marked where it is not understood. */
function errorPosition(text: string, at: number): TemplateResult {
  const [before, here, after] = [text.slice(0, at), text.charAt(at) || ' ', text.slice(at + 1, at + MOST_AFTER)]
  return html`<code aria-hidden="true">${before}<mark>${here}</mark>${after}</code
    ><span class="said">At character ${at + 1}:</span> `
}

interface UnreadNumber {
  readonly name: keyof FormState
  readonly field: QueryError['field']
  readonly message: string
}

/** The numbers that the search would use, and whose text is none. */
function unreadNumbers(form: FormState): readonly UnreadNumber[] {
  const used = form.law === 'normal' ? ['sigma', 'seed'] : ['least', 'greatest', 'seed']
  return (used as (keyof FormState)[]).flatMap(name => {
    const read = readNumber(form[name])
    const label = name.charAt(0).toUpperCase() + name.slice(1)
    return read.ok
      ? []
      : [{ name, field: name === 'seed' ? 'seed' : 'distribution', message: `${label}: ${read.error.message}` }]
  })
}

/** Why a number is none says more than the refusal of the whole. */
function complaint(
  field: QueryError['field'],
  errors: readonly QueryError[],
  unread: readonly UnreadNumber[],
): TemplateResult {
  const own = unread.filter(each => each.field === field)
  const said = own.length > 0 ? own : errors.filter(error => error.field === field)
  return html`<div class="complaint" id=${`${field}-error`}>${said.map(({ message }) => message).join(' ')}</div>`
}

function vocabulary(): TemplateResult {
  return html`<details class="vocabulary">
    <summary>What a property can say</summary>
    <p>
      Numbers and fractions as 1/4; + − * / and parentheses; &lt; &lt;= &gt; &gt;= = !=, also in chains as 0 &lt; a &lt; b; and, or, not. The
      names:
    </p>
    <dl>
      ${Object.entries({ ...claims, ...numbers }).map(
        ([name, { sentence }]) => html`<dt><code>${name}</code></dt><dd>${sentence}</dd>`,
      )}
    </dl>
  </details>`
}
