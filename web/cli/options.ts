/** Options of a command: `--name VALUE`, `--name=VALUE` or a flag; all else are files. */
import { Refusal } from '../model/result'

export interface Option<Values> {
  /** The value's description; null for an option that has none. */
  readonly value: string | null
  /** Throws a Refusal for a value that is none. */
  read(text: string): Partial<Values>
}

export interface Command {
  readonly name: string
  /** What ends its sentences of refusal. */
  wrong(what: string): Refusal
}

export function command(name: string): Command {
  return { name, wrong: what => new Refusal(`${name}: ${what}. hexlens ${name} --help says what there is.`) }
}

export function flag<Values>(read: () => Partial<Values>): Option<Values> {
  return { value: null, read }
}

/** Throws a Refusal that says what is wrong. A value follows its option, as the next argument or after "="; names may be short ones. */
export function readOptions<Values>(
  { wrong }: Command,
  options: ReadonlyMap<string, Option<Values>>,
  args: readonly string[],
): { readonly files: readonly string[]; readonly values: Partial<Values> } {
  const files: string[] = []
  const values: Partial<Values> = {}
  const seen = new Set<Option<Values>>()
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
    if (seen.has(option)) throw wrong(`${name} is given twice`)
    seen.add(option)
    if (option.value === null && equals >= 0) throw wrong(`${name} has no value`)
    const text = option.value === null ? '' : equals < 0 ? args[++i] : argument.slice(equals + 1)
    if (text === undefined || (option.value !== null && text === '')) throw wrong(`${name} wants ${option.value}`)
    Object.assign(values, option.read(text))
  }
  return { files, values }
}

const DECIMAL = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$/

/** NaN for what is no finite decimal number. */
export function decimalOf(text: string): number {
  const value = DECIMAL.test(text) ? Number(text) : Number.NaN
  return Number.isFinite(value) ? value : Number.NaN
}

/** A time step, counted from 0. */
export function stepOf({ wrong }: Command, text: string, expected = 'a number from 1 on or last'): number | 'last' {
  if (text === 'last') return text
  if (/^[1-9]\d{0,8}$/.test(text)) return Number(text) - 1
  throw wrong(`--step wants ${expected}, not ${text}`)
}
