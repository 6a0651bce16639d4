/** Numbers that a text has in rows: a list in brackets, or lines that are written alike. */

export interface NumberTable {
  /** Words that stand before it, outermost first. */
  readonly names: readonly string[]
  readonly rows: readonly (readonly number[])[]
  /** True for columns whose numbers are all written as integers; as long as the longest row. */
  readonly integers: readonly boolean[]
  /** Titles of the columns, where a line above has as many words. */
  readonly header: readonly string[] | null
  /** The element that the text names before each row; null if it names none. */
  readonly labels: readonly (string | null)[] | null
  /** The number of each row's point, if it stands apart from the coordinates; null if none does. */
  readonly ids: readonly number[] | null
  /** True if the text ends or leaves something out inside it: the rows are those before. */
  readonly isCut: boolean
  /** Most significant digits of its numbers as they are written. */
  readonly digits: number
  /** The index from which its language counts; null if that is not known. */
  readonly base: 0 | 1 | null
}

/** The table of these rows, whose numbers are all written as integers or not; about the rest the text says nothing. */
export function numberTable(
  rows: NumberTable['rows'],
  areIntegers: boolean,
  rest: Partial<NumberTable> = {},
): NumberTable {
  const width = rows.reduce((most, row) => Math.max(most, row.length), 0)
  const integers = Array.from({ length: width }, () => areIntegers)
  const unsaid = { names: [], header: null, labels: null, ids: null, isCut: false, digits: 0, base: null }
  return { ...unsaid, rows, integers, ...rest }
}

/** The width that all rows have, or 0. */
export function widthOf({ rows }: NumberTable): number {
  const width = rows[0]?.length ?? 0
  return rows.every(row => row.length === width) ? width : 0
}

export function areAllIntegers({ integers }: NumberTable): boolean {
  return integers.length > 0 && integers.every(isInteger => isInteger)
}

export function column({ rows }: NumberTable, c: number): number[] {
  return rows.map(row => row[c] as number)
}

export function isConstant(values: readonly number[]): boolean {
  return values.every(value => value === values[0])
}

export function countsUp(values: readonly number[]): boolean {
  return values.length > 1 && values.every((value, i) => i === 0 || value === (values[i - 1] as number) + 1)
}

export function areDistinct(values: readonly number[]): boolean {
  return new Set(values).size === values.length
}

/** The table as if its columns were rows. */
export function transposed(rows: readonly (readonly number[])[]): number[][] {
  return (rows[0] ?? []).map((_, c) => rows.map(row => row[c] as number))
}

/** One long list cut into rows. */
export function inRowsOf<T>(values: readonly T[], width: number): T[][] {
  return Array.from({ length: Math.floor(values.length / width) }, (_, i) => values.slice(width * i, width * (i + 1)))
}
