/** The order of bytes in numbers of files and of this machine. */

export const MACHINE_IS_LITTLE_ENDIAN = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1

/** Turns the bytes of each number of `size` bytes around; the bytes begin at a multiple of that in their buffer. */
export function swapBytes({ buffer, byteOffset, byteLength }: Uint8Array, size: number): void {
  if (size === 2) {
    const halves = new Uint16Array(buffer, byteOffset, byteLength / 2)
    for (let i = 0; i < halves.length; ++i) {
      const half = halves[i] as number
      halves[i] = (half << 8) | (half >>> 8)
    }
  }
  if (size < 4) return
  const words = new Uint32Array(buffer, byteOffset, byteLength / 4)
  if (size === 4) for (let i = 0; i < words.length; ++i) words[i] = swappedWord(words[i] as number)
  else copySwapped(words, words)
}

/** The two words of each number of 64 bits with their bytes turned around, into the same list or another. */
export function copySwapped(from: Uint32Array, to: Uint32Array): void {
  for (let i = 0; i + 1 < from.length; i += 2) {
    const word = from[i] as number
    to[i] = swappedWord(from[i + 1] as number)
    to[i + 1] = swappedWord(word)
  }
}

/** Words with their bytes turned around, into another list; returns a number that is negative if one of them is, as a signed one. */
export function copySwappedWords(from: Uint32Array, to: Uint32Array): number {
  let signs = 0
  for (let i = 0; i < from.length; ++i) {
    const word = swappedWord(from[i] as number)
    signs |= word
    to[i] = word
  }
  return signs
}

/** The two words of each number of 64 bits, turned around, into every third number of another list, which begins with the first of these. */
export function copySwappedToThirds(from: Uint32Array, to: Uint32Array): void {
  for (let i = 0, at = 0; i + 1 < from.length; i += 2, at += 6) {
    to[at] = swappedWord(from[i + 1] as number)
    to[at + 1] = swappedWord(from[i] as number)
  }
}

/** Words, turned around, less 1, into another list; true if all are from 0 to `most` then, which is below 2^31. */
export function copySwappedIndices(from: Uint32Array, to: Uint32Array, most: number): boolean {
  // Of an index from 0 to `most`, it and its difference to `most` are not negative.
  let signs = 0
  for (let i = 0; i < from.length; ++i) {
    const index = (swappedWord(from[i] as number) - 1) | 0
    signs |= index | (most - index)
    to[i] = index
  }
  return signs >= 0
}

/** The bytes of a word of 32 bits, turned around. */
export function swappedWord(word: number): number {
  return (word << 24) | ((word & 0xff00) << 8) | ((word >>> 8) & 0xff00) | (word >>> 24)
}
