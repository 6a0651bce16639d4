/** JSON: 24 numbers, 8×3 or 3×8, alone, in lists, or as "vertices" of an object, at any depth. */
import { COORDINATE_COUNT, type Vertices } from '../hexahedron'
import {
  counted,
  type Format,
  type FoundElement,
  isEightByThree,
  isThreeByEight,
  Refused,
  readingOf,
  transposed,
} from './format'

export const json: Format = {
  name: 'JSON',
  read(text) {
    const value = parsed(text)
    if (value === undefined) return null
    const search: Search = { elements: [], problems: [] }
    collect(value, '', search)
    if (search.elements.length === 0) {
      throw new Refused(
        search.problems[0] ?? 'In this JSON nothing has eight points: 24 numbers, or eight lists of three.',
      )
    }
    const left = search.problems.length
    return left === 0
      ? readingOf(search.elements)
      : readingOf(search.elements, `${counted(left, 'entry was', 'entries were')} left out. ${search.problems[0]}`)
  },
}

interface Search {
  readonly elements: FoundElement[]
  readonly problems: string[]
}

function parsed(text: string): unknown {
  if (!/^\s*[[{]/.test(text)) return undefined
  try {
    return JSON.parse(text)
  } catch {
    return undefined
  }
}

function collect(value: unknown, name: string, search: Search): void {
  if (Array.isArray(value)) collectList(value, name, search)
  else if (typeof value === 'object' && value !== null) {
    const own = 'name' in value && typeof value.name === 'string' ? value.name : name
    if ('vertices' in value) collectVertices(value.vertices, own, search)
    else for (const [key, entry] of Object.entries(value)) collect(entry, own === '' ? key : own, search)
  }
}

function collectList(value: readonly unknown[], name: string, search: Search): void {
  const vertices = coordinatesOf(value)
  if (vertices) add(vertices, name, search)
  else if (isRows(value)) {
    search.problems.push(
      `${capital(subject(name))} has ${counted(value.length, 'point', 'points')}; an element needs 8.`,
    )
  } else if (!isNumbers(value)) {
    for (const [i, entry] of value.entries()) collect(entry, name === '' ? `entry ${i}` : `${name}, ${i}`, search)
  } else if (name === '') {
    search.problems.push(`${counted(value.length, 'number was', 'numbers were')} found; an element needs 24.`)
  }
}

function collectVertices(value: unknown, name: string, search: Search): void {
  const vertices = Array.isArray(value) ? coordinatesOf(value) : null
  if (vertices) add(vertices, name, search)
  else search.problems.push(`The vertices of ${subject(name)} are not 24 numbers, nor eight lists of three.`)
}

type Numbers = readonly number[]

function isNumbers(value: unknown): value is Numbers {
  return Array.isArray(value) && value.every(entry => typeof entry === 'number')
}

function isRows(value: readonly unknown[]): value is readonly Numbers[] {
  return value.length > 0 && value.every(row => isNumbers(row) && row.length === 3)
}

/** The 24 coordinates that a list says, flat or by points or by axes; null for any other list. */
function coordinatesOf(value: readonly unknown[]): Vertices | null {
  if (isNumbers(value)) return value.length === COORDINATE_COUNT ? value : null
  if (!value.every(isNumbers)) return null
  return isThreeByEight(value) ? transposed(value) : isEightByThree(value) ? value.flat() : null
}

function add(vertices: Vertices, name: string, search: Search): void {
  const bad = vertices.findIndex(coordinate => !Number.isFinite(coordinate))
  if (bad < 0) search.elements.push({ name: name || 'the element', vertices })
  else {
    search.problems.push(
      `Number ${bad + 1} of ${subject(name)} is too large: a coordinate is a double, at most 1.8×10³⁰⁸.`,
    )
  }
}

function subject(name: string): string {
  return name === '' ? 'the element' : `“${name}”`
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1)
}
