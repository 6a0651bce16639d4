/** The arguments of `check`. */
import { Refusal } from '../model/result'
import { ID_KINDS, type IdKind } from '../outputs/ids'

export interface CheckArguments {
  readonly files: readonly string[]
  readonly format: string | null
  /** The time step, counted from 0. */
  readonly step: number | 'last' | 'all'
  readonly json: boolean
  /** Null where it is not said; Infinity for all. */
  readonly worst: number | null
  readonly minRelative: number | null
  readonly skipsDegenerate: boolean
  readonly allowsUnchecked: boolean
  readonly csv: string | null
  readonly junit: string | null
  readonly annotate: string | null
  readonly html: string | null
  readonly ids: IdKind | null
}

interface Option {
  /** The value's description; null for an option that has none. */
  readonly value: string | null
  read(text: string): Partial<CheckArguments>
}

const options = new Map<string, Option>([
  ['--json', flag(() => ({ json: true }))],
  ['--allow-unchecked', flag(() => ({ allowsUnchecked: true }))],
  ['--format', { value: 'the name of a format', read: format => ({ format }) }],
  ['--step', { value: 'a number from 1 on, last or all', read: text => ({ step: readStep(text) }) }],
  ['--csv', { value: 'a file', read: csv => ({ csv }) }],
  ['--junit', { value: 'a file', read: junit => ({ junit }) }],
  ['--annotate', { value: 'a file', read: annotate => ({ annotate }) }],
  ['--html', { value: 'a file', read: html => ({ html }) }],
  ['--worst', { value: 'a count or all', read: text => ({ worst: readWorst(text) }) }],
  ['--min-relative', { value: 'a number', read: text => ({ minRelative: readRelative(text) }) }],
  ['--degenerate', { value: 'skip', read: text => ({ skipsDegenerate: readDegenerate(text) }) }],
  ['--ids', { value: ID_KINDS.join(', '), read: text => ({ ids: readIdKind(text) }) }],
])

function flag(read: Option['read']): Option {
  return { value: null, read }
}

/** Throws a Refusal that says what is wrong. A value follows its option, as the next argument or after "=". */
export function readCheckArguments(args: readonly string[]): CheckArguments {
  const files: string[] = []
  const values: CheckArguments = {
    files,
    format: null,
    step: 0,
    json: false,
    worst: null,
    minRelative: null,
    skipsDegenerate: false,
    allowsUnchecked: false,
    csv: null,
    junit: null,
    annotate: null,
    html: null,
    ids: null,
  }
  const seen = new Set<string>()
  for (let i = 0; i < args.length; ++i) {
    const argument = args[i] as string
    if (argument === '--') {
      files.push(...args.slice(i + 1))
      break
    }
    if (argument === '-' || !argument.startsWith('-')) {
      files.push(argument)
      continue
    }
    const equals = argument.indexOf('=')
    const name = equals < 0 ? argument : argument.slice(0, equals)
    const option = options.get(name)
    if (!option) throw wrong(`there is no option ${name}`)
    if (seen.has(name)) throw wrong(`${name} is given twice`)
    seen.add(name)
    if (option.value === null && equals >= 0) throw wrong(`${name} has no value`)
    const text = option.value === null ? '' : equals < 0 ? args[++i] : argument.slice(equals + 1)
    if (text === undefined || (option.value !== null && text === '')) throw wrong(`${name} wants ${option.value}`)
    Object.assign(values, option.read(text))
  }
  const problem = contradiction(values)
  if (problem !== null) throw wrong(problem)
  return values
}

function contradiction({ files, json, ids, annotate }: CheckArguments): string | null {
  if (files.length === 0) return 'it wants a file'
  if (files.filter(file => file === '-').length > 1) return 'standard input can be read but once'
  if (json && ids !== null) return 'either --json or --ids can be printed'
  if (annotate !== null && files.length > 1) return '--annotate is for one file'
  return null
}

function wrong(what: string): Refusal {
  return new Refusal(`check: ${what}. hexlens check --help says what there is.`)
}

function readWorst(text: string): number {
  if (text === 'all') return Infinity
  if (/^\d{1,15}$/.test(text)) return Number(text)
  throw wrong(`--worst wants a count or all, not ${text}`)
}

function readStep(text: string): CheckArguments['step'] {
  if (text === 'last' || text === 'all') return text
  if (/^[1-9]\d{0,8}$/.test(text)) return Number(text) - 1
  throw wrong(`--step wants a number from 1 on, last or all, not ${text}`)
}

const DECIMAL = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$/

function readRelative(text: string): number {
  const value = DECIMAL.test(text) ? Number(text) : Number.NaN
  if (Number.isFinite(value)) return value
  throw wrong(`--min-relative wants a number, not ${text}`)
}

function readDegenerate(text: string): boolean {
  if (text === 'skip') return true
  throw wrong(`--degenerate wants skip, not ${text}`)
}

function readIdKind(text: string): IdKind {
  const kind = ID_KINDS.find(name => name === text)
  if (kind) return kind
  throw wrong(`--ids wants ${ID_KINDS.join(', ')}, not ${text}`)
}
