/** Decks of solvers, which the solver's own program ends by a word of its own: without it, the end may be missing. */
import { headText } from './snippet-text'
import type { MeshFile } from './source'

/** A word that begins a whole deck, the word that ends it, and what that looks like. */
const ENDS: readonly (readonly [begin: RegExp, end: RegExp, word: string])[] = [
  [/^BEGIN[ ,]+BULK/im, /^[ \t]*ENDDATA/im, 'ENDDATA'],
  [/^\*KEYWORD/im, /^\*END\b/im, '*END'],
  [/^\/BEGIN/m, /^\/END\b/m, '/END'],
  [/^[ \t]*\$ENTER/im, /^[ \t]*\$(?:FIN|EXIT)\b/im, '$FIN'],
]
const HEAD = 65_536
const TAIL = 4096

/** A note; null where nothing is missing. */
export function missingEnd(file: MeshFile): string | null {
  const { size } = file
  const head = headText(file.read(0, Math.min(HEAD, size)))
  const [, end, word] = ENDS.find(([begin]) => begin.test(head)) ?? []
  if (end === undefined || end.test(headText(file.read(Math.max(0, size - TAIL), size)))) return null
  return `The text does not end with ${word}: it may be cut off.`
}
