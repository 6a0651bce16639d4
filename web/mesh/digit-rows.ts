/** Rows of numbers below ten, written as words of digits: “01 12” is [[0, 1], [1, 2]]. */
export function digitRows(words: string): readonly (readonly number[])[] {
  return words.split(' ').map(word => Array.from(word, Number))
}
