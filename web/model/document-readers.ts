/**
 * Readers of plain data that a person or a program wrote as JSON. Each takes a value and its path,
 * and gives what it means or throws a Refusal; it also knows the JSON Schema of what it takes, and
 * how to write it. Numbers are JSON's, so every double comes back bit for bit, except that -0 is
 * "-0".
 */
import { COORDINATE_COUNT, type Vertices } from './hexahedron'
import { type CodedError, Refusal, type Result, refused } from './result'

export type Coordinate = number | '-0'

export interface Reader<T> {
  (value: unknown, path: string): T
  /** The values it takes, as JSON Schema 2020-12. */
  readonly schema: Schema
  /** The value as JSON has it. */
  readonly write: (value: T) => unknown
}

export type Schema = Readonly<Record<string, unknown>>
export type Readers<T> = { readonly [Key in keyof T]: Reader<T[Key]> }

export function reader<T>(
  schema: Schema,
  read: (value: unknown, path: string) => T,
  write: (value: T) => unknown = value => value,
): Reader<T> {
  return Object.assign((given: unknown, path: string) => read(given, path), { schema, write })
}

/** The same, with a sentence for the schema. */
export function described<T>(description: string, inner: Reader<T>): Reader<T> {
  return reader({ ...inner.schema, description }, inner, inner.write)
}

export const flag = reader({ type: 'boolean' }, (value, path) => {
  if (typeof value !== 'boolean') throw new Refusal(`${path} has to be true or false.`)
  return value
})

export const text = reader({ type: 'string' }, (value, path) => {
  if (typeof value !== 'string') throw new Refusal(`${path} has to be a text.`)
  return value
})

export const texts = reader<readonly string[]>({ type: 'array', items: text.schema }, (value, path) =>
  list(value, path).map((each, i) => text(each, `${path}[${i}]`)),
)

export function oneOf<const Choices extends readonly unknown[]>(...choices: Choices): Reader<Choices[number]> {
  return reader({ enum: choices }, (value, path) => {
    if (!choices.includes(value)) throw new Refusal(`${path} has to be one of ${choices.join(', ')}.`)
    return value as Choices[number]
  })
}

export function between(minimum: number, maximum: number): Reader<number> {
  return reader({ type: 'number', minimum, maximum }, (value, path) => {
    if (typeof value !== 'number' || !(value >= minimum && value <= maximum))
      throw new Refusal(`${path} has to be a number from ${minimum} to ${maximum}.`)
    return value
  })
}

export function indexBelow(count: number): Reader<number> {
  const number = between(0, count - 1)
  return reader({ ...number.schema, type: 'integer' }, (value, path) => {
    if (!Number.isInteger(number(value, path))) throw new Refusal(`${path} has to be a whole number.`)
    return value as number
  })
}

export function orNull<T>(inner: Reader<T>): Reader<T | null> {
  return reader(
    { anyOf: [{ type: 'null' }, inner.schema] },
    (value, path) => (value === null ? null : inner(value, path)),
    value => (value === null ? null : inner.write(value)),
  )
}

/** Other keys are ignored. One that is missing has its default, or is refused unless it is `optional`. */
export function record<T>(readers: Readers<T>, defaults: Partial<T>, optional: readonly (keyof T)[] = []): Reader<T> {
  const keys = Object.keys(readers) as (keyof T & string)[]
  const each = <V>(of: (key: keyof T & string) => V) => Object.fromEntries(keys.map(key => [key, of(key)]))
  const isLeftOut = (key: keyof T) => key in defaults || optional.includes(key)
  const withDefault = (key: keyof T & string) => {
    const { schema, write } = readers[key]
    return key in defaults ? { ...schema, default: write(defaults[key] as T[typeof key]) } : schema
  }
  return reader(
    { type: 'object', required: keys.filter(key => !isLeftOut(key)), properties: each(withDefault) },
    (value, path) => {
      const given = object(value, path)
      return each(key =>
        given[key] === undefined && isLeftOut(key) ? defaults[key] : readers[key](given[key], `${path}.${key}`),
      ) as T
    },
    value => each(key => readers[key].write(value[key])),
  )
}

export function object(value: unknown, path: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    throw new Refusal(`${path} has to be an object.`)
  return value as Record<string, unknown>
}

/** Reads a document by its version: a later one is refused as that, what is no such document with `code`. */
export function readVersion<T, const Code extends string>(
  name: string,
  code: Code,
  known: number,
  given: unknown,
  read: () => T,
): Result<T, CodedError<Code | 'unknown-version'>> {
  try {
    const { version } = object(given, name)
    if (typeof version === 'number' && version > known)
      return refused('unknown-version', `The ${name} is of version ${version}, which is not known here.`)
    if (version !== known) throw new Refusal(`The ${name}’s version has to be ${known}.`)
    return { ok: true, value: read() }
  } catch (reason) {
    if (reason instanceof Refusal) return refused(code, reason.message)
    throw reason
  }
}

export function list(value: unknown, path: string, length?: number): readonly unknown[] {
  if (!Array.isArray(value) || (length !== undefined && value.length !== length))
    throw new Refusal(`${path} has to be a list${length === undefined ? '' : ` of ${length}`}.`)
  return value
}

export const COORDINATES_SCHEMA: Schema = {
  description:
    'Eight vertices x, y, z in VTK_HEXAHEDRON order, flat, finite doubles. Minus zero is the string "-0", since JavaScript’s JSON.stringify loses its sign.',
  type: 'array',
  minItems: COORDINATE_COUNT,
  maxItems: COORDINATE_COUNT,
  items: { anyOf: [{ type: 'number' }, { const: '-0' }] },
}

export const coordinates = reader<Vertices>(
  { $ref: '#/$defs/vertices' },
  (value, path) =>
    list(value, path, COORDINATE_COUNT).map((coordinate, i) => {
      if (coordinate === '-0') return -0
      if (!Number.isFinite(coordinate)) throw new Refusal(`${path}[${i}] has to be a finite number, or "-0".`)
      return coordinate as number
    }),
  written,
)

export function written(vertices: Vertices): Coordinate[] {
  return vertices.map(value => (Object.is(value, -0) ? '-0' : value))
}
