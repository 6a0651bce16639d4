/** Loops over lists of a byte a cell, each in a function of its own, which engines make fast code of. */
import { inParts } from './in-parts'

/** How many entries are `value`. */
export function countOf(list: Uint8Array, value: number): number {
  let count = 0
  inParts(list.length, (from, to) => {
    count += countIn(list.subarray(from, to), value)
  })
  return count
}

function countIn(part: Uint8Array, value: number): number {
  let count = 0
  for (let i = 0; i < part.length; ++i) count += Number(part[i] === value)
  return count
}
