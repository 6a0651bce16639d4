/**
 * The settings of the picture, its camera and the list as a text that travels: `picture=1&of=7168&cells=invalid&rings=1&…`. Cells are
 * counted from 0 in the file's order.
 */
import { percentDecoded } from '../../model/permalink'
import { type CodedError, type Result, refused } from '../../model/result'
import type { CameraView } from '../../model/state'
import type { Arrangement, Column, Overview } from '../../survey/survey-jobs'
import { blockOf, type CellSet, MOST_RINGS, type PictureSettings, type Slice } from './picture-settings'

/** The list beside the picture. */
export interface Listing {
  readonly condition: string
  readonly range: readonly [number, number] | null
  readonly order: Arrangement
}

export const FIRST_LISTING: Listing = { condition: '', range: null, order: { column: 'worst', isDescending: false } }

/** All that travels. */
export interface Travelling {
  /** Hexahedra of the mesh that the settings are of: single cells are meant in such a mesh alone. */
  readonly of: number
  readonly picture: PictureSettings
  /** The name of the block that is shown; null if it is another set. */
  readonly block: string | null
  readonly camera: CameraView | null
  /** Null is the worst cell. */
  readonly chosen: number | null
  readonly listing: Listing
}

const NAME = 'picture'
const VERSION = '1'
const COLUMNS: readonly Column[] = ['worst', 'id', 'block', 'minimum', 'volume', 'class', 'accepted-by']

/** Whether a text, or the fragment of an address in it, is such settings, broken ones included. */
export function isSettingsText(text: string): boolean {
  return /^(?:\S*#)?picture=/.test(text.trim())
}

/** What is as it is at first is left out. */
export function settingsText({ of, picture, block, camera, chosen, listing }: Travelling): string {
  const { set, rings, slice, relative, layers, away, isApart, colours } = picture
  const fields: [name: string, value: string | null][] = [
    [NAME, VERSION],
    ['of', String(of)],
    ['cells', set === 'all' ? null : block === null ? set : `${set}:${encodeURIComponent(block)}`],
    ['rings', rings === 0 ? null : String(rings)],
    ['slice', slice && [...slice.normal, slice.place].map(numberText).join(',')],
    ['relative', relative && rangeText(relative)],
    ['peel', layers === 0 ? null : String(layers)],
    ['away', away.length === 0 ? null : away.join(',')],
    ['apart', isApart ? 'yes' : null],
    ['colours', colours === 'all' ? null : colours],
    ['camera', camera && [...camera.direction, camera.zoom, ...camera.pan].map(numberText).join(',')],
    ['chosen', chosen === null ? null : String(chosen)],
    ['list', listing.condition.trim() === '' ? null : encodeURIComponent(listing.condition.trim())],
    ['range', listing.range && rangeText(listing.range)],
    ['sort', sortText(listing.order)],
  ]
  return fields.flatMap(([name, value]) => (value === null ? [] : [`${name}=${value}`])).join('&')
}

export type SettingsResult = Result<Travelling, CodedError<'malformed' | 'unknown-version'>>

/** Reads a text or an address that ends in it. The message is one sentence. */
export function readSettings(text: string): SettingsResult {
  const fields = new Map<string, string>()
  for (const field of text
    .trim()
    .replace(/^[^#]*#/, '')
    .split('&')) {
    const [name = '', given, ...more] = field.split('=')
    const value = given === undefined ? null : percentDecoded(given)
    if (value === null || more.length > 0 || fields.has(name))
      return refused('malformed', `These settings are broken at “${clipped(field)}”.`)
    fields.set(name, value)
  }
  if (fields.get(NAME) !== VERSION)
    return refused(
      'unknown-version',
      'These settings are of a kind that is not known here: they should begin with picture=1.',
    )
  const stranger = [...fields.keys()].find(name => !Object.hasOwn(READERS, name) && name !== NAME)
  if (stranger !== undefined) return refused('malformed', `“${clipped(stranger)}” is no setting of the picture.`)
  try {
    const field = <Value>(name: keyof typeof READERS, read: (text: string) => Value | null, absent: Value): Value => {
      const given = fields.get(name)
      if (given === undefined) return absent
      const value = read(given)
      if (value === null) throw new RangeError(`The setting ${name}=${clipped(given)} should be ${READERS[name]}.`)
      return value
    }
    const { set, block } = field('cells', cellsOf, { set: 'all' as CellSet, block: null as string | null })
    const of = field('of', whole, -1)
    if (of < 0)
      return refused('malformed', 'These settings do not say of how many hexahedra their mesh is: of= is missing.')
    const picture: PictureSettings = {
      set,
      rings: field('rings', given => wholeUpTo(MOST_RINGS, given), 0),
      slice: field<Slice | null>('slice', sliceOf, null),
      relative: field<readonly [number, number] | null>('relative', rangeOf, null),
      layers: field('peel', given => wholeUpTo(MOST_LAYERS, given), 0),
      away: field<readonly number[]>('away', cellList, []),
      isApart: field('apart', given => (given === 'yes' ? true : null), false),
      colours: field<PictureSettings['colours']>('colours', given => (given === 'invalid' ? given : null), 'all'),
    }
    const camera = field<CameraView | null>('camera', cameraOf, null)
    const chosen = field<number | null>('chosen', whole, null)
    const listing: Listing = {
      condition: field('list', given => given, ''),
      range: field<readonly [number, number] | null>('range', rangeOf, null),
      order: field('sort', sortOf, FIRST_LISTING.order),
    }
    return { ok: true, value: { of, picture, block, camera, chosen, listing } }
  } catch (reason) {
    if (reason instanceof RangeError) return refused('malformed', reason.message)
    throw reason
  }
}

/** What the settings are in this mesh, and a sentence for each that it cannot have. */
export function settingsIn(
  given: Travelling,
  { hexahedra, blocks }: Overview,
): { readonly fitting: Travelling; readonly unfit: readonly string[] } {
  const unfit: string[] = []
  let { picture, block, chosen, listing } = given
  if (block !== null) {
    const own = blockOf(picture.set)
    const isOwn = own !== null && blocks[own]?.name === block
    const found = isOwn ? own : blocks.findIndex(({ name }) => name === block)
    if (found < 0) unfit.push(`This mesh has no block “${block}”: all cells are shown.`)
    picture = { ...picture, set: found < 0 ? 'all' : `block-${found}` }
    block = found < 0 ? null : block
  }
  if (listing.order.column === 'block' && blocks.length === 0) {
    unfit.push('This mesh has no blocks to sort by.')
    listing = { ...listing, order: FIRST_LISTING.order }
  }
  const isOther = given.of !== hexahedra || [...picture.away, chosen ?? 0].some(cell => cell >= hexahedra)
  if (isOther && (picture.away.length > 0 || chosen !== null)) {
    const what = [
      ...(picture.away.length > 0 ? [`${picture.away.length.toLocaleString('en')} dug away`] : []),
      ...(chosen === null ? [] : ['the chosen one']),
    ]
    unfit.push(
      `Single cells are left out (${what.join(', ')}): the settings are of a mesh of ${given.of.toLocaleString('en')} hexahedra.`,
    )
    picture = { ...picture, away: [] }
    chosen = null
  }
  return { fitting: { of: hexahedra, picture, block, camera: given.camera, chosen, listing }, unfit }
}

/** What each field should be, in words. */
const READERS = {
  of: 'a number of hexahedra',
  cells: 'all, invalid, listed, around or a block, as in block-0:name',
  rings: `a whole number from 0 to ${MOST_RINGS}`,
  slice: 'four numbers, a normal that is not 0 and a place from 0 to 1',
  relative: 'two numbers, as in 0.1..0.5; one of them may be missing',
  peel: 'a number of layers',
  away: 'indices of cells, each once, with commas between',
  apart: 'yes',
  colours: 'invalid',
  camera: 'seven numbers: a direction, a zoom and a shift',
  chosen: 'the index of a cell',
  list: 'a condition, percent-encoded',
  range: 'two numbers, as in 0.1..0.5; one of them may be missing',
  sort: `one of ${COLUMNS.join(', ')}, and perhaps -down`,
} as const

/** No mesh in a browser's memory has so many. */
const MOST_LAYERS = 65_533
const DECIMAL = /^-?\d+(\.\d+)?(e-?\d+)?$/i

function numberText(value: number): string {
  return String(value).replace('+', '')
}

function number(text: string | undefined): number | null {
  const value = text !== undefined && DECIMAL.test(text) ? Number(text) : Number.NaN
  return Number.isFinite(value) ? value : null
}

function numbers(text: string, count: number): number[] | null {
  const parts = text.split(',').map(number)
  return parts.length === count && parts.every(part => part !== null) ? (parts as number[]) : null
}

function whole(text: string): number | null {
  return /^\d{1,10}$/.test(text) ? Number(text) : null
}

function wholeUpTo(most: number, text: string): number | null {
  const value = whole(text)
  return value !== null && value <= most ? value : null
}

function cellList(text: string): number[] | null {
  const cells = text.split(',').map(whole)
  return cells.every(cell => cell !== null) && new Set(cells).size === cells.length ? (cells as number[]) : null
}

function cellsOf(text: string): { readonly set: CellSet; readonly block: string | null } | null {
  if (text === 'all' || text === 'invalid' || text === 'listed' || text === 'around') return { set: text, block: null }
  const [, set, block] = /^(block-\d{1,9}):(.*)$/s.exec(text) ?? []
  return block === undefined ? null : { set: set as CellSet, block }
}

function sliceOf(text: string): Slice | null {
  const [x, y, z, place] = numbers(text, 4) ?? []
  if (x === undefined || y === undefined || z === undefined || place === undefined) return null
  const length = Math.hypot(x, y, z)
  return length > 0 && Number.isFinite(length) && place >= 0 && place <= 1 ? { normal: [x, y, z], place } : null
}

function cameraOf(text: string): CameraView | null {
  const [x, y, z, zoom, right, back, up] = numbers(text, 7) ?? []
  if (x === undefined || y === undefined || z === undefined || zoom === undefined) return null
  if (right === undefined || back === undefined || up === undefined) return null
  const length = Math.hypot(x, y, z)
  return length > 0 && Number.isFinite(length) && zoom > 0
    ? { direction: [x, y, z], zoom, pan: [right, back, up] }
    : null
}

function rangeText([lower, upper]: readonly [number, number]): string {
  return `${Number.isFinite(lower) ? numberText(lower) : ''}..${Number.isFinite(upper) ? numberText(upper) : ''}`
}

function rangeOf(text: string): readonly [number, number] | null {
  const [from, to, ...more] = text.split('..')
  if (from === undefined || to === undefined || more.length > 0) return null
  const lower = from === '' ? -Infinity : number(from)
  const upper = to === '' ? Infinity : number(to)
  return lower !== null && upper !== null && lower <= upper ? [lower, upper] : null
}

function sortText({ column, isDescending }: Arrangement): string | null {
  return column === 'worst' && !isDescending ? null : `${column}${isDescending ? '-down' : ''}`
}

function sortOf(text: string): Arrangement | null {
  const column = COLUMNS.find(known => text === known || text === `${known}-down`)
  return column === undefined ? null : { column, isDescending: text.endsWith('-down') }
}

const LONGEST = 40

function clipped(text: string): string {
  return text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text
}
