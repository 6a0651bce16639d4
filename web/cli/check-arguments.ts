/** The arguments of `check`. */
import { ID_KINDS, type IdKind } from '../outputs/ids'
import type { MeshForm } from '../outputs/meshes/mesh-form'
import { MESH_ENDINGS, meshFormOf } from '../outputs/meshes/mesh-output'
import { command, decimalOf, flag, type Option, readOptions, stepOf } from './options'

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
  readonly annotate: { readonly path: string; readonly form: MeshForm } | null
  readonly html: string | null
  readonly ids: IdKind | null
}

const CHECK = command('check')

const options = new Map<string, Option<CheckArguments>>([
  ['--json', flag(() => ({ json: true }))],
  ['--allow-unchecked', flag(() => ({ allowsUnchecked: true }))],
  ['--format', { value: 'the name of a format', read: format => ({ format }) }],
  ['--step', { value: 'a number from 1 on, last or all', read: text => ({ step: readStep(text) }) }],
  ['--csv', { value: 'a file', read: csv => ({ csv }) }],
  ['--junit', { value: 'a file', read: junit => ({ junit }) }],
  ['--annotate', { value: 'a file', read: path => ({ annotate: readAnnotate(path) }) }],
  ['--html', { value: 'a file', read: html => ({ html }) }],
  ['--worst', { value: 'a count or all', read: text => ({ worst: readWorst(text) }) }],
  ['--min-relative', { value: 'a number', read: text => ({ minRelative: readRelative(text) }) }],
  ['--degenerate', { value: 'skip', read: text => ({ skipsDegenerate: readDegenerate(text) }) }],
  ['--ids', { value: ID_KINDS.join(', '), read: text => ({ ids: readIdKind(text) }) }],
])

/** Throws a Refusal that says what is wrong. */
export function readCheckArguments(args: readonly string[]): CheckArguments {
  const { files, values } = readOptions(CHECK, options, args)
  const wanted: CheckArguments = {
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
    ...values,
  }
  const problem = contradiction(wanted)
  if (problem !== null) throw CHECK.wrong(problem)
  return wanted
}

function contradiction({ files, json, ids, annotate }: CheckArguments): string | null {
  if (files.length === 0) return 'it wants a file'
  if (files.filter(file => file === '-').length > 1) return 'standard input can be read but once'
  if (json && ids !== null) return 'either --json or --ids can be printed'
  if (annotate !== null && files.length > 1) return '--annotate is for one file'
  return null
}

function readWorst(text: string): number {
  if (text === 'all') return Infinity
  if (/^\d{1,15}$/.test(text)) return Number(text)
  throw CHECK.wrong(`--worst wants a count or all, not ${text}`)
}

function readStep(text: string): CheckArguments['step'] {
  return text === 'all' ? text : stepOf(CHECK, text, 'a number from 1 on, last or all')
}

function readRelative(text: string): number {
  const value = decimalOf(text)
  if (!Number.isNaN(value)) return value
  throw CHECK.wrong(`--min-relative wants a number, not ${text}`)
}

function readDegenerate(text: string): boolean {
  if (text === 'skip') return true
  throw CHECK.wrong(`--degenerate wants skip, not ${text}`)
}

function readAnnotate(path: string): CheckArguments['annotate'] {
  const form = meshFormOf(path)
  if (form) return { path, form }
  throw CHECK.wrong(`--annotate wants a file that ends in one of ${MESH_ENDINGS}, not ${path}`)
}

function readIdKind(text: string): IdKind {
  const kind = ID_KINDS.find(name => name === text)
  if (kind) return kind
  throw CHECK.wrong(`--ids wants ${ID_KINDS.join(', ')}, not ${text}`)
}
