/** Facts about formats: sentences of docs/formats.md, each with files that show it. */
import { readFileSync } from 'node:fs'

export type Content = string | Uint8Array

/** A file of ../shared or of tests/unit/hdf5 by its path, or files that are made here and belong together: the first is given. */
export type Given = string | Readonly<Record<string, Content>>

/** The mesh in a file, as far as a fact is about it. */
export interface Gives {
  readonly hexahedra?: number
  /** 24 coordinates of the first. */
  readonly vertices?: readonly number[]
  /** Hexahedra of more nodes and Lagrange cells. */
  readonly curved?: number
  readonly other?: Readonly<Record<string, number>>
  /** The first of the ids; null where there are none. */
  readonly ids?: readonly (number | string)[] | null
  readonly blocks?: readonly string[]
  readonly steps?: readonly string[]
  /** Is in a note. */
  readonly note?: RegExp
  readonly isCutOff?: boolean
}

export interface Fact {
  /** As the document has it: a clause. */
  readonly says: string
  /** Each is read alone. */
  readonly given: readonly Given[]
  readonly step: number | 'last'
  /** The mesh in each file, or the sentence with which each is refused. */
  readonly gives: Gives | RegExp
}

export interface FormatFacts {
  /** As in web/mesh/format-names.ts. */
  readonly format: string
  readonly read: readonly Fact[]
  readonly notRead: readonly Fact[]
}

export function fact(
  says: string,
  given: Given | readonly Given[],
  gives: Gives | RegExp,
  step: number | 'last' = 0,
): Fact {
  return { says, given: Array.isArray(given) ? given : [given as Given], step, gives }
}

export const CUBE: readonly number[] = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
export const ROWS: readonly (readonly number[])[] = Array.from({ length: 8 }, (_, v) => CUBE.slice(3 * v, 3 * v + 3))
export const ONE: Gives = { hexahedra: 1, vertices: CUBE }
/** As `other-formats.ts` makes it. */
export const SHAKEN: Gives = { hexahedra: 64 }
/** The mesh of ../shared/meshes/made. */
export const MADE: Gives = { hexahedra: 15 }
export const MADE_WITH_VOXEL: Gives = { hexahedra: 16 }

/** A file of tests/unit/hdf5 with other text of the same length wherever the first stands. */
export function changedHdf5(name: string, before: string, after: string): Given {
  const text = readFileSync(new URL(`../unit/hdf5/${name}`, import.meta.url), 'latin1')
  if (!text.includes(before) || before.length !== after.length) throw new Error(`${name} has no ${before}.`)
  return { [name]: new Uint8Array(Buffer.from(text.replaceAll(before, after), 'latin1')) }
}

export const made = (...names: readonly string[]): string[] => names.map(name => `meshes/made/${name}`)

/** A line for each row. */
export function rows(of: (row: readonly number[], number: number) => string): string {
  return ROWS.map((row, i) => of(row, i + 1)).join('\n')
}
