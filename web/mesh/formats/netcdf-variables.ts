/** The variables of a netCDF file, in whatever form they are stored. */

export interface Variable {
  /** Lengths of its dimensions, the slowest first; none for a single number. */
  readonly shape: readonly number[]
  readonly isFloat32: boolean
  /** The byte of its first number in the file, big-endian, if all lie there one after the other as floats; else null. */
  readonly floatsFrom: number | null
  /** The text of an attribute; null if it has none of that name, or one of numbers. */
  text(attribute: string): string | null
  /** Fills `into` with its numbers, of any type, from number `from` of all on: `from + into.length` is at most their count. */
  numbers(from: number, into: Float64Array): void
  /** The same for indices. What is none, from 0 on, is returned with its place in `into`, which is not all filled then; or is refused. */
  indices(from: number, into: Uint32Array): { readonly at: number; readonly value: string } | null
  /** Fills every third number of `into`, from place `axis` on, with its numbers from `from` on; false, and nothing is done, if it has other ways alone. */
  axis?(from: number, into: Float64Array, axis: number): boolean
  /** Fills `into` with its numbers from `from` on, less 1; false if not all are from 1 to `count`, or it has other ways alone. */
  indicesFrom1?(from: number, into: Uint32Array, count: number): boolean
  /** Its strings: characters along the last dimension, up to the first zero. */
  strings(): readonly string[]
}

/** The variables of a netCDF file, by name. */
export interface Variables {
  readonly names: readonly string[]
  /** Null if there is none of that name. */
  variable(name: string): Variable | null
}

/** The count of all its numbers. */
export function lengthOf({ shape }: Pick<Variable, 'shape'>): number {
  return shape.reduce((product, length) => product * length, 1)
}
