/** The form of a search as the reader typed it, in the address and as a query. */

import { readNumber } from '../../model/number-text'
import type { Distribution, GridName } from './engine/distribution'
import type { Query } from './engine/query'
import { type SymmetryName, symmetries } from './engine/symmetry'
import { ownSearch, type SearchKind, searches } from './searches'

export const grids: Readonly<Record<GridName, string>> = {
  free: 'any numbers',
  quarters: 'quarters',
  integers: 'integers',
}

/** Numbers as texts: the reader may not have finished them. */
export interface FormState {
  readonly find: string
  readonly property: string
  readonly measure: string
  readonly law: 'normal' | 'box'
  readonly sigma: string
  readonly least: string
  readonly greatest: string
  readonly grid: GridName
  readonly symmetry: SymmetryName
  readonly moved: string
  readonly seed: string
}

const EMPTY_BOX = { least: '-4', greatest: '4' }
const FIRST_SIGMA = '0.5'
const FIRST_SEED = '1'

export const kinds: readonly SearchKind[] = [...searches, ownSearch]

export function kindOf(id: string): SearchKind | undefined {
  return kinds.find(kind => kind.id === id)
}

export function formOf(kind: SearchKind, seed: string = FIRST_SEED): FormState {
  const { id: find, property, measure, distribution } = kind
  return { find, property, measure, ...fieldsOf(distribution), seed }
}

function fieldsOf({ law, grid, symmetry, moved }: Distribution) {
  const sigma = law.kind === 'normal' ? String(law.sigma) : FIRST_SIGMA
  const box = law.kind === 'box' ? { least: String(law.least), greatest: String(law.greatest) } : EMPTY_BOX
  return { law: law.kind, sigma, ...box, grid, symmetry, moved: String(moved) }
}

export function queryOf(form: FormState): Query {
  const { law, grid, symmetry } = form
  const [sigma, least, greatest, moved, seed] = [form.sigma, form.least, form.greatest, form.moved, form.seed].map(
    numberOf,
  ) as [number, number, number, number, number]
  return {
    property: form.property,
    measure: form.measure,
    distribution: {
      law: law === 'normal' ? { kind: law, sigma } : { kind: law, least, greatest },
      grid,
      symmetry,
      moved,
    },
    seed,
  }
}

/** NaN if the text is not a number. */
function numberOf(text: string): number {
  const read = readNumber(text)
  return read.ok ? read.value : Number.NaN
}

/** The kind's name, then the fields that differ from its own. */
export function encodeForm(form: FormState): URLSearchParams {
  const offered = formOf(kindOf(form.find) ?? ownSearch)
  const entries = Object.entries(form).filter(
    ([name, value]) => name !== 'find' && value !== offered[name as keyof FormState],
  )
  return new URLSearchParams([['find', form.find], ...entries])
}

export interface DecodedForm {
  readonly form: FormState
  /** One sentence for each thing in the address that is not understood. */
  readonly problems: readonly string[]
}

export function decodeForm(params: URLSearchParams): DecodedForm {
  const find = params.get('find')
  const kind = find === null ? searches[0] : kindOf(find)
  const problems = kind ? [] : [`The address asks for the search “${find}”, which this page does not have.`]
  const choices: Readonly<Record<string, object>> = { law: { normal: '', box: '' }, grid: grids, symmetry: symmetries }
  const form: Record<string, string> = { ...formOf(kind ?? searches[0]) }
  for (const name of Object.keys(form)) {
    const value = params.get(name)
    if (name === 'find' || value === null) continue
    const choice = choices[name]
    if (choice && !Object.hasOwn(choice, value))
      problems.push(`The address has “${value}” as ${name}; this page knows ${Object.keys(choice).join(', ')}.`)
    else form[name] = value
  }
  return { form: form as unknown as FormState, problems }
}

/** The same with another text: a condition that is changed is the reader's own. */
export function withField(form: FormState, name: keyof FormState, value: string): FormState {
  if (name === 'find') return formOf(kindOf(value) ?? ownSearch, form.seed)
  const find = name === 'property' ? ownSearch.id : form.find
  return { ...form, find, [name]: value }
}
