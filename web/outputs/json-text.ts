/** JSON for a terminal, in which names from files may be shown. */

/** JSON on one line. Names stay whole, but control and bidirectional characters are escaped. */
export function jsonText(value: object): string {
  return JSON.stringify(value).replace(/[\p{Cc}\p{Cf}\u2028\u2029]/gu, character =>
    Array.from({ length: character.length }, (_, i) => escaped(character.charCodeAt(i))).join(''),
  )
}

function escaped(unit: number): string {
  return `\\u${unit.toString(16).padStart(4, '0')}`
}

/** The text before an entry of a list that is written entry by entry, and after the last of so many. */
export const jsonList = {
  before: (index: number) => (index === 0 ? '[\n' : ',\n'),
  end: (count: number) => (count === 0 ? '[]\n' : '\n]\n'),
}
