/** What every format of the import has in common: what it gives back, and how it refuses. */
import { COORDINATE_COUNT, type Vec3, type Vertices } from '../hexahedron'

export interface FoundElement {
  /** As the text calls it: "element 17". */
  readonly name: string
  readonly vertices: Vertices
}

export interface Reading {
  /** In the order of the text, at most LISTED of them. */
  readonly elements: readonly FoundElement[]
  /** How many there are in all. */
  readonly count: number
  /** A sentence about what was left out, or had to be assumed. */
  readonly note?: string
}

export interface Format {
  /** As it is named in "read as …" and "looked for …". */
  readonly name: string
  /** Null where the text is not of this format. Throws Refused where it is, but holds no element that can be shown. */
  read(text: string): Reading | null
}

/** A sentence for people on why a text gives no element. */
export class Refused extends Error {}

/** Elements listed of one text: more than anyone chooses from by eye. */
export const LISTED = 1000

/** A reading of elements that are all at hand. */
export function readingOf(elements: readonly FoundElement[], note?: string): Reading {
  const listed = elements.slice(0, LISTED)
  return note === undefined
    ? { elements: listed, count: elements.length }
    : { elements: listed, count: elements.length, note }
}

/** Lists of 24 coordinates, one after another in a list of 24 n. */
export function inTwentyFours(coordinates: readonly number[]): Vertices[] {
  return Array.from({ length: Math.floor(coordinates.length / COORDINATE_COUNT) }, (_, i) =>
    coordinates.slice(COORDINATE_COUNT * i, COORDINATE_COUNT * (i + 1)),
  )
}

export function isEightByThree(rows: readonly (readonly unknown[])[]): boolean {
  return rows.length === 8 && rows.every(row => row.length === 3)
}

/** Three rows of eight are x, y and z of the eight points. */
export function isThreeByEight(rows: readonly (readonly unknown[])[]): boolean {
  return rows.length === 3 && rows.every(row => row.length === 8)
}

/** The points of a 3×8 matrix, one after another. */
export function transposed(rows: readonly (readonly number[])[]): Vertices {
  return (rows[0] as readonly number[]).flatMap((_, v) => rows.map(row => row[v] as number) as unknown as Vec3)
}

export function counted(count: number, one: string, many: string): string {
  return `${count} ${count === 1 ? one : many}`
}
