/**
 * Readers of plain data that a person or a program wrote as JSON: each takes a value and its path, and gives what it means or throws
 * Refused with a sentence. Numbers are JSON's, so every double comes back bit for bit, except that -0 is "-0".
 */
import { COORDINATE_COUNT, type Vertices } from './hexahedron'

export type Coordinate = number | '-0'

/** Of a value, called by its path; throws Refused with a sentence. */
export type Reader<T> = (value: unknown, path: string) => T
export type Readers<T> = { readonly [Key in keyof T]: Reader<T[Key]> }

export class Refused extends Error {}

export const flag: Reader<boolean> = (value, path) => {
  if (typeof value !== 'boolean') throw new Refused(`${path} has to be true or false.`)
  return value
}

export const text: Reader<string> = (value, path) => {
  if (typeof value !== 'string') throw new Refused(`${path} has to be a text.`)
  return value
}

export function oneOf<const Choices extends readonly unknown[]>(...choices: Choices): Reader<Choices[number]> {
  return (value, path) => {
    if (!choices.includes(value)) throw new Refused(`${path} has to be one of ${choices.join(', ')}.`)
    return value
  }
}

export function between(least: number, greatest: number): Reader<number> {
  return (value, path) => {
    if (typeof value !== 'number' || !(value >= least && value <= greatest))
      throw new Refused(`${path} has to be a number from ${least} to ${greatest}.`)
    return value
  }
}

export function indexBelow(count: number): Reader<number> {
  return (value, path) => {
    if (!Number.isInteger(between(0, count - 1)(value, path))) throw new Refused(`${path} has to be a whole number.`)
    return value as number
  }
}

export function orNull<T>(reader: Reader<T>): Reader<T | null> {
  return (value, path) => (value === null ? null : reader(value, path))
}

/** Other keys are ignored; the value of one that is missing is its default, or it is refused. */
export function record<T>(readers: Readers<T>, defaults: Partial<T>): Reader<T> {
  return (value, path) => {
    const given = object(value, path)
    const keys = Object.keys(readers) as (keyof T & string)[]
    return Object.fromEntries(
      keys.map(key => {
        if (given[key] === undefined && key in defaults) return [key, defaults[key]]
        return [key, readers[key](given[key], `${path}.${key}`)]
      }),
    ) as T
  }
}

export function object(value: unknown, path: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    throw new Refused(`${path} has to be an object.`)
  return value as Record<string, unknown>
}

export function list(value: unknown, path: string, length?: number): readonly unknown[] {
  if (!Array.isArray(value) || (length !== undefined && value.length !== length))
    throw new Refused(`${path} has to be a list${length === undefined ? '' : ` of ${length}`}.`)
  return value
}

export const coordinates: Reader<Vertices> = (value, path) =>
  list(value, path, COORDINATE_COUNT).map((coordinate, i) => {
    if (coordinate === '-0') return -0
    if (!Number.isFinite(coordinate)) throw new Refused(`${path}[${i}] has to be a finite number, or "-0".`)
    return coordinate as number
  })

export function written(vertices: Vertices): Coordinate[] {
  return vertices.map(value => (Object.is(value, -0) ? '-0' : value))
}
