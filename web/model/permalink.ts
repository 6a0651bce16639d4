/**
 * The whole element in a URL fragment, for people to read and bit for bit: `v=1&vertices=0,0,0,1,0,0,…`, 24 decimals in
 * VTK_HEXAHEDRON order, each the shortest that reads back as the same double, exponents without '+', -0 kept.
 */
import { COORDINATE_COUNT, type Vertices } from './hexahedron'
import { type CodedError, type Result, refused } from './result'

/** `absent` is an address without a fragment: no link at all rather than a broken one. */
export type PermalinkErrorCode =
  | 'absent'
  | 'malformed'
  | 'unknown-version'
  | 'wrong-count'
  | 'not-a-number'
  | 'not-finite'

export type PermalinkResult = Result<Vertices, CodedError<PermalinkErrorCode>>

const VERSION = '1'
const DECIMAL = /^-?\d+(\.\d+)?(e[-+]?\d+)?$/i

/** The fragment without its '#'. Throws RangeError unless given 24 finite numbers. */
export function encodePermalink(vertices: Vertices): string {
  if (vertices.length !== COORDINATE_COUNT || !vertices.every(Number.isFinite))
    throw new RangeError('A link holds 24 finite numbers.')
  return `v=${VERSION}&vertices=${vertices.map(decimalText).join(',')}`
}

/** Reads a fragment, with or without its '#'. Percent-encoding is undone first, as mail and chat programs put it in. */
export function decodePermalink(fragment: string): PermalinkResult {
  const text = fragment.replace(/^#/, '')
  if (text === '') return refused('absent', 'The address holds no element.')
  const fields = readFields(text)
  const version = fields?.get('v')
  if (version !== undefined && version !== VERSION)
    return refused('unknown-version', `The link is of version ${quoted(version)}, which is not known here.`)
  const list = fields?.get('vertices')
  if (version === undefined || list === undefined || fields?.size !== 2)
    return refused('malformed', 'The link is broken: it should read v=1&vertices= and 24 numbers with commas between.')
  return readVertices(list === '' ? [] : list.split(','))
}

function readVertices(numbers: readonly string[]): PermalinkResult {
  if (numbers.length !== COORDINATE_COUNT) {
    const count = numbers.length === 1 ? '1 number' : `${numbers.length} numbers`
    return refused('wrong-count', `The link holds ${count} where 24 are needed.`)
  }
  const bad = numbers.findIndex(number => !DECIMAL.test(number))
  if (bad >= 0)
    return refused('not-a-number', `Number ${bad + 1} of the link, ${quoted(numbers[bad] as string)}, is not a number.`)
  const value = numbers.map(Number)
  const huge = value.findIndex(number => !Number.isFinite(number))
  if (huge >= 0)
    return refused('not-finite', `Number ${huge + 1} of the link, ${quoted(numbers[huge] as string)}, is too large.`)
  return { ok: true, value }
}

/** `a=b&c=d` by name; null where it is anything else or says a name twice. */
function readFields(text: string): ReadonlyMap<string, string> | null {
  const pairs = percentDecoded(text)
    ?.split('&')
    .map(part => part.split('='))
  if (!pairs?.every(pair => pair.length === 2)) return null
  const fields = new Map(pairs as [string, string][])
  return fields.size === pairs.length ? fields : null
}

/** Null if the encoding is cut off or not UTF-8. */
export function percentDecoded(text: string): string | null {
  try {
    return decodeURIComponent(text)
  } catch {
    return null
  }
}

function decimalText(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value).replace('+', '')
}

function quoted(text: string): string {
  return `“${text.length > 24 ? `${text.slice(0, 24)}…` : text}”`
}
