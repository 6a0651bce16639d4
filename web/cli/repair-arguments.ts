/** The arguments of `repair`. */
import { command, decimalOf, flag, type Option, readOptions, stepOf } from './options'

export interface RepairArguments {
  readonly input: string
  readonly output: string
  /** Relative minima are to be at least this; null: all hexahedra are to be valid. */
  readonly minRelative: number | null
  /** Boundary points move so far at most; null: they stay. */
  readonly freeBoundary: number | null
  readonly slides: boolean
  /** Nodes that are listed in another order than was meant are written in that one. */
  readonly reorders: boolean
  /** The file for the certificates of what holds the rest. */
  readonly certificates: string | null
  readonly format: string | null
  /** The time step, counted from 0. */
  readonly step: number | 'last'
  readonly allowsUnchecked: boolean
}

type Values = Omit<RepairArguments, 'input' | 'output'> & { readonly output: string | null }

const REPAIR = command('repair')

const output: Option<Values> = { value: 'a file', read: path => ({ output: path }) }

const options = new Map<string, Option<Values>>([
  ['-o', output],
  ['--output', output],
  ['--min-relative', { value: 'a number from 0 to 1', read: text => ({ minRelative: readRelative(text) }) }],
  ['--free-boundary', { value: 'a distance', read: text => ({ freeBoundary: readDistance(text) }) }],
  ['--slide', flag(() => ({ slides: true }))],
  ['--reorder', flag(() => ({ reorders: true }))],
  ['--certificates', { value: 'a file', read: certificates => ({ certificates }) }],
  ['--format', { value: 'the name of a format', read: format => ({ format }) }],
  ['--step', { value: 'a number from 1 on or last', read: text => ({ step: stepOf(REPAIR, text) }) }],
  ['--allow-unchecked', flag(() => ({ allowsUnchecked: true }))],
])

const NOTHING: Omit<Values, 'output'> = {
  minRelative: null,
  freeBoundary: null,
  slides: false,
  reorders: false,
  certificates: null,
  format: null,
  step: 0,
  allowsUnchecked: false,
}

/** Throws a Refusal that says what is wrong. */
export function readRepairArguments(args: readonly string[]): RepairArguments {
  const { files, values } = readOptions(REPAIR, options, args)
  const [input] = files
  if (input === undefined || files.length > 1) throw REPAIR.wrong('it wants one file')
  if (!values.output) throw REPAIR.wrong('it wants -o and the file to write')
  if (values.output === '-') throw REPAIR.wrong('it writes a file, not standard output')
  if (values.certificates === '-') throw REPAIR.wrong('it writes certificates to a file, not to standard output')
  return { ...NOTHING, ...values, input, output: values.output }
}

function readRelative(text: string): number {
  const value = decimalOf(text)
  if (value >= 0 && value <= 1) return value
  throw REPAIR.wrong(`--min-relative wants a number from 0 to 1, not ${text}`)
}

function readDistance(text: string): number {
  const value = decimalOf(text)
  if (value >= 0) return value
  throw REPAIR.wrong(`--free-boundary wants a distance, not ${text}`)
}
