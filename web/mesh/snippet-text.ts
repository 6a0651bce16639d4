/** Texts as people paste them: quoted mail, fenced code, "..." where something was left out. */
import type { MeshFile } from './source'
import { fileOfBytes } from './source'

/** A text of up to so many bytes may be a part of a file that somebody posted; a larger one is a file. */
export const LARGEST_SNIPPET = 4 * 1024 * 1024

const [TAB, LF, CR, SPACE, GREATER, BACKTICK, TILDE] = [9, 10, 13, 32, 62, 96, 126] as const
/** Where a NUL byte stands this early, the file is binary. */
const BINARY_HEAD = 1024
/** A fence and what follows it, such as "```text", is no longer. */
const LONGEST_FENCE = 40
const FEWEST_QUOTED = 3

/**
 * The text without what mail and Markdown put around it: "> " at the beginning of lines, lines of "```", no-break spaces and a byte order
 * mark become blanks, so that lines and bytes keep their places. UTF-16 becomes UTF-8. A file that is binary or larger than a snippet
 * comes back as it is.
 */
export function unwrapped(file: MeshFile): MeshFile {
  if (file.size > LARGEST_SNIPPET || file.size === 0) return file
  const original = file.read(0, file.size)
  const bytes = utf8(original)
  if (bytes.subarray(0, BINARY_HEAD).includes(0)) return file
  let hasChanged = bytes !== original
  const blank = (from: number, to: number) => {
    bytes.fill(SPACE, from, to)
    hasChanged = true
  }
  const isQuoted = quotedLines(bytes) >= FEWEST_QUOTED
  for (let from = 0; from < bytes.length; from = lineEnd(bytes, from) + 1) {
    const end = lineEnd(bytes, from)
    let at = skipBlanks(bytes, from, end)
    while (isQuoted && bytes[at] === GREATER && at < end) {
      blank(at, at + 1)
      at = skipBlanks(bytes, at, end)
    }
    const mark = bytes[at]
    if ((mark === BACKTICK || mark === TILDE) && bytes[at + 1] === mark && bytes[at + 2] === mark) {
      const length = bytes[end - 1] === CR ? end - at - 1 : end - at
      blank(at, at + (length <= LONGEST_FENCE ? length : 3))
    }
  }
  if (bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf) blank(0, 3)
  for (let at = bytes.indexOf(0xc2); at >= 0; at = bytes.indexOf(0xc2, at + 1))
    if (bytes[at + 1] === 0xa0) blank(at, at + 2)
  return hasChanged ? fileOfBytes(file.name, bytes) : file
}

function utf8(bytes: Uint8Array): Uint8Array {
  const isBig = bytes[0] === 0xfe && bytes[1] === 0xff
  if (!isBig && !(bytes[0] === 0xff && bytes[1] === 0xfe)) return bytes
  return new TextEncoder().encode(new TextDecoder(isBig ? 'utf-16be' : 'utf-16le').decode(bytes))
}

function quotedLines(bytes: Uint8Array): number {
  let count = 0
  for (let from = 0; from < bytes.length; from = lineEnd(bytes, from) + 1)
    if (bytes[skipBlanks(bytes, from, bytes.length)] === GREATER) count++
  return count
}

function lineEnd(bytes: Uint8Array, from: number): number {
  const end = bytes.indexOf(LF, from)
  return end < 0 ? bytes.length : end
}

/** Blanks within a line. */
function skipBlanks(bytes: Uint8Array, from: number, end: number): number {
  let at = from
  while (at < end && (bytes[at] === SPACE || bytes[at] === TAB)) at++
  return at
}

const LONGEST_ELLIPSIS = 200
/** "...", "[...]", "# ... 3000 more", a dot or a colon alone, and the characters for dots as the bytes of UTF-8 look in Latin 1. */
const DOTS = /^[[({<*#/%!;,|\s-]*(?:\.\.|\. \.|\u2026|\u22ee|\u00e2\u0080\u00a6|\u00e2\u008b\u00ae|[.:]$)/
const WORDS = /^[[({<*#/%!;,|\s-]*(?:snip|cut|omitted|truncated|skipped|etc)\b/i

/** Whether a line stands for what was left out. */
export function isEllipsis(line: string): boolean {
  const text = line.trim()
  return text.length > 0 && text.length <= LONGEST_ELLIPSIS && (DOTS.test(text) || WORDS.test(text))
}
