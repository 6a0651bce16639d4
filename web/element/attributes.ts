/** The attributes of `<hex-lens>`: their values, the sentences that refuse others, and what each changes. */

import { COORDINATE_COUNT, VERTEX_COUNT, type Vec3, type Vertices } from '../model/hexahedron'
import { numberText } from '../model/number-text'
import { type Preset, presetOf, presets, presetVertices } from '../model/presets'
import { type CameraView, type Dispatch, type State, sliceChange } from '../model/state'
import { CONTROLS, type Control, controlsSlice, scriptSlice } from '../views/scene-slices'
import type { Problem } from '../views/view'
import { say } from '../words/say'
import type { Composition } from './composition'
import { HexLensError } from './hex-lens-error'
import { SHARED, type Shared, type Sharing } from './sharing'

export interface Attributes {
  readonly vertices: Vertices | null
  readonly preset: Preset | null
  /** Names of panels. */
  readonly views: readonly string[]
  readonly controls: readonly Control[]
  readonly camera: CameraView | null
  readonly theme: Theme
  readonly readonly: boolean
  readonly poster: string | null
  readonly label: string | null
  /** Null outside a group. */
  readonly group: string | null
  readonly share: readonly Shared[]
  readonly 'hidden-faces': readonly number[]
  readonly app: URL | null
}

export type AttributeName = keyof Attributes
export type Theme = (typeof THEMES)[number]

const FACES = ['0', '1', '2', '3', '4', '5'] as const
export const THEMES = ['auto', 'light', 'dark'] as const
export const FIRST_VIEWS = ['scene', 'verdict']
const DECIMAL = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i
/** The reader can turn no farther, and a state can zoom no farther. */
const MOST_ELEVATION = 90
const ZOOMS = [0.001, 1000] as const

/** The words that the attribute `views` may have: panels of this build, and others, passed over. */
export interface ViewNames {
  readonly known: readonly string[]
  readonly passedOver: readonly string[]
}

export function viewNames({ panels, otherPanels }: Pick<Required<Composition>, 'panels' | 'otherPanels'>): ViewNames {
  return {
    known: panels.filter(panel => !panel.always && !panel.with).map(({ name }) => name),
    passedOver: otherPanels,
  }
}

/** Parses an attribute's text, null if there is no attribute. Throws HexLensError. */
type Read<T> = (text: string | null, views: ViewNames) => T

const readers: { readonly [Name in AttributeName]: Read<Attributes[Name]> } = {
  vertices: text => (text === null ? null : readVertices(text)),
  preset: text => (text === null ? null : readPreset(text)),
  views: (text, names) => (text === null ? FIRST_VIEWS : readViews(text, names)),
  controls: text => (text === null ? CONTROLS : words('controls', text, CONTROLS)),
  camera: text => (text === null ? null : readCamera(text)),
  theme: text => oneOf('theme', text ?? 'auto', THEMES),
  readonly: text => text !== null,
  poster: text => text,
  label: text => text,
  group: text => text || null,
  share: text => (text === null ? SHARED : words('share', text, SHARED)),
  'hidden-faces': text => (text === null ? [] : words('hidden-faces', text, FACES).map(Number)),
  app: text => (text === null ? null : readAddress(text)),
}

export const attributeNames = Object.keys(readers) as AttributeName[]

export function readAttribute<Name extends AttributeName>(
  name: Name,
  text: string | null,
  views: ViewNames,
): Attributes[Name] {
  return readers[name](text, views)
}

/** The text of the attribute `vertices`, which gives these very bits back. */
export function verticesText(vertices: Vertices): string {
  const points = Array.from({ length: COORDINATE_COUNT / 3 }, (_, v) => vertices.slice(3 * v, 3 * v + 3))
  return points.map(point => point.map(numberText).join(' ')).join(', ')
}

/** 24 numbers; commas, brackets and white space stand between them. */
export function readVertices(text: string): Vertices {
  const numbers = text.split(/[\s,;()[\]]+/).filter(word => word !== '')
  const bad = numbers.find(number => !DECIMAL.test(number))
  if (bad !== undefined) throw refusal('vertices', say('“{text}” is not a number', { text: shortened(bad) }))
  return checkedVertices(numbers.map(Number))
}

/** A text as in the attribute, 24 numbers, or eight times three. */
export type GivenVertices = string | ArrayLike<number> | ArrayLike<ArrayLike<number>>

/** Returns a copy. Throws HexLensError unless given 24 finite numbers, whatever else it is given. */
export function checkedVertices(given: unknown): Vertices {
  if (typeof given === 'string') return readVertices(given)
  const rows = listOf(given)
  const isNested = rows?.length === VERTEX_COUNT && rows.every(row => listOf(row)?.length === 3)
  const vertices = isNested ? rows.flatMap(row => listOf(row)) : rows
  if (vertices?.length !== COORDINATE_COUNT)
    throw new HexLensError(
      'wrong-count',
      vertices
        ? say('A hexahedron has 24 coordinates; {count} were given.', { count: vertices.length })
        : say('A hexahedron has 24 coordinates; none were given.'),
    )
  const bad = vertices.findIndex(value => !Number.isFinite(value))
  if (bad >= 0)
    throw new HexLensError(
      'not-finite',
      say('Coordinate {index} is {value}, not a finite number.', { index: bad, value: wordOf(vertices[bad]) }),
    )
  return vertices as number[]
}

/** A copy of an array or the like; null if it is none. */
export function listOf(given: unknown): unknown[] | null {
  const isList = typeof given === 'object' && given !== null && 'length' in given && typeof given.length === 'number'
  return isList ? Array.from(given as ArrayLike<unknown>) : null
}

/** What somebody has given instead of a number, in a sentence. */
function wordOf(given: unknown): string {
  return typeof given === 'number' || given === null ? String(given) : say('of the type {type}', { type: typeof given })
}

/** The address of a page, from this one; the fragment is the element's. */
function readAddress(text: string): URL {
  let address: URL | null = null
  try {
    address = new URL(text, globalThis.document?.baseURI)
  } catch {}
  if (address === null || !/^(https?|file):$/.test(address.protocol))
    throw refusal('app', say('“{text}” is not the address of a page', { text: shortened(text) }))
  return address
}

function readPreset(text: string): Preset {
  const preset = presets.find(({ id }) => id === text.trim())
  const known = presets.map(({ id }) => id).join(', ')
  if (!preset) throw refusal('preset', say('“{text}” is none of {known}', { text: shortened(text), known }))
  return preset
}

/** Azimuth and elevation in degrees, and how much nearer than all in view. */
function readCamera(text: string): CameraView {
  const numbers = text
    .trim()
    .split(/[\s,]+/)
    .map(word => word.replace(/(deg|°)$/, ''))
  const [azimuth, elevation, zoom] = numbers.map(Number) as [number, number, number?]
  const isRight =
    numbers.every(number => DECIMAL.test(number)) &&
    (numbers.length === 2 || numbers.length === 3) &&
    Number.isFinite(azimuth) &&
    Math.abs(elevation) <= MOST_ELEVATION &&
    (zoom === undefined || (zoom >= ZOOMS[0] && zoom <= ZOOMS[1]))
  if (!isRight) {
    const form = say('“{text}” is not azimuth and elevation in degrees and a zoom, such as “-58 24 1.5”', {
      text: shortened(text),
    })
    throw refusal('camera', form)
  }
  return { direction: direction(azimuth, elevation), zoom: zoom ?? 1, pan: [0, 0, 0] }
}

function direction(azimuthDegrees: number, elevationDegrees: number): Vec3 {
  const [azimuth, elevation] = [azimuthDegrees, elevationDegrees].map(angle => (angle * Math.PI) / 180) as [
    number,
    number,
  ]
  const across = Math.cos(elevation)
  return [across * Math.cos(azimuth), across * Math.sin(azimuth), Math.sin(elevation)]
}

function readViews(text: string, { known, passedOver }: ViewNames): readonly string[] {
  const given = text.split(/[\s,]+/).filter(word => !passedOver.includes(word))
  return words('views', given.join(' '), known)
}

/** A list of words, `all` or `none`. */
function words<Word extends string>(name: AttributeName, text: string, known: readonly Word[]): readonly Word[] {
  const given = text.split(/[\s,]+/).filter(word => word !== '')
  if (given.length === 1 && given[0] === 'all') return known
  if (given.length === 1 && given[0] === 'none') return []
  return given.map(word => oneOf(name, word, [...known, 'all' as Word, 'none' as Word]))
}

export function oneOf<Word extends string>(name: string, text: string, known: readonly Word[]): Word {
  const word = known.find(each => each === text.trim())
  if (word === undefined)
    throw refusal(name, say('“{text}” is none of {known}', { text: shortened(text), known: known.join(', ') }))
  return word
}

function refusal(name: string, why: string): HexLensError {
  return new HexLensError('bad-attribute', say('The attribute {name} is not understood: {why}.', { name, why }))
}

function shortened(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}…` : text
}

/** The element whose attributes they are. */
export interface AttributeHost {
  getAttribute(name: string): string | null
  setAttribute(name: string, text: string): void
  removeAttribute(name: string): void
  raise(problem: Problem): void
  clear(code: Problem['code']): void
}

/** The rest of what an attribute may ask for, beside actions. */
export interface AttributeActions {
  readonly state: () => State
  readonly dispatch: Dispatch
  readonly setVertices: (vertices: Vertices) => void
  readonly setApp: (address: URL | null) => void
  readonly showViews: (names: readonly string[]) => void
  readonly setReadonly: (isReadonly: boolean) => void
  readonly lookFrom: (camera: CameraView | null) => void
  readonly setPoster: (address: string | null) => void
  readonly setLabel: (label: string | null) => void
  readonly share: (change: Partial<Pick<Sharing, 'name' | 'kinds'>>) => void
}

/** Takes the value of an attribute or a property; one that is not understood raises a problem, and changes nothing. */
export function taking(host: Pick<AttributeHost, 'raise' | 'clear'>, name: string, take: () => void): void {
  try {
    take()
    host.clear(`bad-${name}`)
  } catch (reason) {
    if (!(reason instanceof HexLensError)) throw reason
    host.raise({ code: `bad-${name}`, message: reason.message })
  }
}

/** Turns attributes into actions, and writes the vertices and the preset back. */
export class AttributeInput {
  readonly #host: AttributeHost
  readonly #actions: AttributeActions
  readonly #names: ViewNames
  #isReflecting = false
  readonly #takes: { readonly [Name in AttributeName]: (value: Attributes[Name]) => void } = {
    vertices: vertices => this.#takeElement(vertices, null),
    preset: preset => this.#takeElement(null, preset),
    views: names => this.#actions.showViews(names),
    controls: controls => this.#actions.dispatch(sliceChange(controlsSlice, { controls })),
    camera: camera => this.#actions.lookFrom(camera),
    theme: () => {}, // the style sheet does it
    readonly: isReadonly => this.#actions.setReadonly(isReadonly),
    poster: poster => this.#actions.setPoster(poster),
    label: label => this.#actions.setLabel(label),
    group: name => this.#actions.share({ name }),
    share: kinds => this.#actions.share({ kinds }),
    'hidden-faces': hiddenFaces => this.#actions.dispatch(sliceChange(scriptSlice, { hiddenFaces })),
    app: address => this.#actions.setApp(address),
  }

  constructor(host: AttributeHost, names: ViewNames, actions: AttributeActions) {
    this.#host = host
    this.#names = names
    this.#actions = actions
  }

  /** Does what an attribute says; one that is not understood changes nothing. */
  take(name: AttributeName): void {
    if (this.#isReflecting) return
    const take = this.#takes[name] as (value: unknown) => void
    taking(this.#host, name, () => take(this.#valueOf(name)))
  }

  /** Writes the present vertices and preset. */
  reflect({ vertices, preset }: State): void {
    this.#isReflecting = true
    this.#host.setAttribute('vertices', verticesText(vertices))
    if (preset === null) this.#host.removeAttribute('preset')
    else this.#host.setAttribute('preset', preset)
    this.#isReflecting = false
    for (const name of ['vertices', 'preset'] as const) this.#host.clear(`bad-${name}`)
  }

  /** The two attributes, in any order before the first frame, are where the element starts. */
  #takeElement(vertices: Vertices | null, preset: Preset | null): void {
    const isStarting = this.#actions.state().phase === 'starting'
    if (vertices !== null && !isStarting) {
      this.#actions.setVertices(vertices)
      return
    }
    const own = vertices ?? (isStarting ? this.#understood('vertices') : null)
    const from = preset ?? (isStarting ? this.#understood('preset') : null)
    const first = own ?? (from && presetVertices(from))
    if (!first) return
    const start = from && from.valid !== null ? presetVertices(from) : first
    this.#actions.dispatch({ type: 'set-vertices', vertices: first, preset: from?.id ?? presetOf(first), start })
  }

  #valueOf<Name extends AttributeName>(name: Name): Attributes[Name] {
    return readAttribute(name, this.#host.getAttribute(name), this.#names)
  }

  /** The value of an attribute; null if there is none, or its text is not understood. */
  #understood<Name extends AttributeName>(name: Name): Attributes[Name] | null {
    try {
      return this.#valueOf(name)
    } catch {
      return null // its own call of `take` refuses it
    }
  }
}
