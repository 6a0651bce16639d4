/** Names and words out of files, for people. */

const MOST_SHOWN = 60

/** A name or a word of a file for people: without control and bidirectional characters, cut to a length, in quotes. */
export function shown(word: string): string {
  const plain = withoutControls(word)
  return `“${plain.length > MOST_SHOWN ? `${plain.slice(0, MOST_SHOWN)}…` : plain}”`
}

/** The end of a name that is too long: it says of which format the file may be. */
const END_SHOWN = 20

/** The name of a file for people, the same without quotes; one that is too long is cut before its end. */
export function shownFileName(name: string): string {
  const plain = withoutControls(name)
  return plain.length > MOST_SHOWN ? `${plain.slice(0, MOST_SHOWN - END_SHOWN - 1)}…${plain.slice(-END_SHOWN)}` : plain
}

/** The whole text without control and bidirectional characters. */
export function withoutControls(text: string): string {
  return text.replace(/[\p{Cc}\p{Cf}\u2028\u2029]/gu, '')
}
