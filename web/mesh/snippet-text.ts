/** Texts as people paste them: their characters, and "..." where something was left out. */
import { MACHINE_IS_LITTLE_ENDIAN } from './endian'
import type { MeshFile } from './source'

/** Bytes: a text of up to so many may be a part of a file that somebody posted; a larger one is a file. */
export const LARGEST_SNIPPET = 4 * 1024 * 1024

/** Bytes: up to so many become one string. A larger text is read as numbers or not at all. */
export const LARGEST_STRING = 16 * 1024 * 1024

/** The characters of a file in UTF-8; ends of lines are LF. Null if it is binary. */
export function snippetText(file: MeshFile): string | null {
  const text = new TextDecoder().decode(file.read(0, file.size))
  if (text.includes('\0')) return null
  return text.includes('\r') ? text.replaceAll('\r\n', '\n').replaceAll('\r', '\n') : text
}

/** The encoding that the first two bytes state; null where they state none. */
export function utf16Of([first, second]: Uint8Array): 'utf-16le' | 'utf-16be' | null {
  if (first === 0xff && second === 0xfe) return 'utf-16le'
  return first === 0xfe && second === 0xff ? 'utf-16be' : null
}

/** True if the first bytes of a file may be those of a text. */
export function isText(head: Uint8Array): boolean {
  return utf16Of(head) !== null || !head.includes(0)
}

/** Of units of two bytes, each of which is a character here: decoders are faster than loops. */
const units = new TextDecoder(MACHINE_IS_LITTLE_ENDIAN ? 'utf-16le' : 'utf-16be')
/** Texts of heads: all formats look at the same one. */
const texts = new WeakMap<Uint8Array, string>()

/**
 * The first bytes of a file as text in which marks of a format are looked for, a character for each byte. Browsers take the decoder called
 * latin1 for that of Windows, which has other characters from 0x80 to 0x9f.
 */
export function headText(head: Uint8Array, most = head.length): string {
  let text = texts.get(head)
  if (text === undefined) {
    text = units.decode(new Uint16Array(head))
    texts.set(head, text)
  }
  return text.slice(0, most)
}

const LONGEST_ELLIPSIS = 200
/** "...", "[...]", "# ... 3000 more", a dot or a colon alone, and the characters for dots as the bytes of UTF-8 look in Latin 1 and Windows'. */
const DOTS =
  /^[[({<*#/%!;,|\s-]*(?:\.\.|\. \.|\u2026|\u22ee|\u00e2[\u0080\u20ac]\u00a6|\u00e2[\u008b\u2039]\u00ae|[.:]$)/
const WORDS = /^[[({<*#/%!;,|\s-]*(?:snip|cut|omitted|truncated|skipped|etc)\b/i

/** True if a line stands for lines that were left out. */
export function isEllipsis(line: string): boolean {
  const text = line.trim()
  return text.length > 0 && text.length <= LONGEST_ELLIPSIS && (DOTS.test(text) || WORDS.test(text))
}

/** The note about points that are taken as they come. */
export function orderOfText(cellCount: number): string {
  return cellCount === 1
    ? 'Eight points taken in the order of the text.'
    : 'Points taken in the order of the text, eight for each element.'
}
