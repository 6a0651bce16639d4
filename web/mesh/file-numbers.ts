/** Names of files that differ only in a number, in its order: "wing_2.vtu" before "wing_10.vtu", "t0.25.vtu" before "t0.5.vtu". */

interface Reading<T> {
  readonly numbers: RegExp
  readonly read: (text: string) => T
}

const COUNTERS: Reading<bigint> = { numbers: /\d+/g, read: BigInt }
const DECIMALS: Reading<number> = { numbers: /\d+(?:\.\d+)?(?:e[+-]?\d+)?/gi, read: Number }

/**
 * Indices of the names in the order of the one number in which they differ, those with the same number as they come. Null where
 * they differ in more or in nothing, or where it is open whether "a1.5" before "a1.10" are counters or "a1.10" before "a1.5" decimals.
 */
export function orderOfNumbers(names: readonly string[]): readonly number[] | null {
  const [counters, decimals] = [ranked(names, COUNTERS), ranked(names, DECIMALS)]
  if (counters === null || decimals === null) return counters ?? decimals
  return counters.every((index, rank) => index === decimals[rank]) ? counters : null
}

function ranked<T extends bigint | number>(
  names: readonly string[],
  { numbers, read }: Reading<T>,
): readonly number[] | null {
  const rows = names.map(name => (name.match(numbers) ?? []).map(read))
  const [first] = rows
  const frames = new Set(names.map(name => name.replace(numbers, '0').toLowerCase()))
  if (first === undefined || frames.size > 1) return null
  const differing = first.flatMap((value, at) => (rows.some(row => row[at] !== value) ? [at] : []))
  const [at] = differing
  if (differing.length !== 1 || at === undefined) return null
  const keyOf = (index: number) => rows[index]?.[at] as T
  return names.map((_, i) => i).sort((a, b) => (keyOf(a) < keyOf(b) ? -1 : keyOf(a) > keyOf(b) ? 1 : a - b))
}
