/** Loops over lists of a byte a cell. What an engine has of its own is fast from the beginning; it makes fast code of ours only while it runs. */

/** Calls for each entry that is `value`, in their order. */
export function eachPlace(list: Uint8Array, value: number, visit: (at: number) => void): void {
  for (let at = list.indexOf(value); at >= 0; ) {
    visit(at)
    ++at
    if (list[at] !== value) at = list.indexOf(value, at)
  }
}

/** How many entries are `value`. */
export function countOf(list: Uint8Array, value: number): number {
  let count = 0
  eachPlace(list, value, () => ++count)
  return count
}

/** A list of zeros and ones with both exchanged: four bytes at a time, in memory of its own. */
export function turned(list: Uint8Array): Uint8Array<ArrayBuffer> {
  const words = new Uint32Array(Math.ceil(list.length / 4))
  const own = new Uint8Array(words.buffer, 0, list.length)
  own.set(list)
  for (let i = 0; i < words.length; ++i) words[i] = (words[i] as number) ^ 0x01010101
  return own
}
