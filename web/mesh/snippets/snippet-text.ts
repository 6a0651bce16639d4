/** A pasted text as one string, which only texts of some megabytes become. */
import type { MeshFile } from '../source'

/** Bytes: a larger text is no snippet, and is read as numbers or not at all. */
export const LARGEST_SNIPPET = 16 * 1024 * 1024

/** The characters of a file: UTF-8, or UTF-16 by its mark; ends of lines are LF. Null if it is binary. */
export function snippetText(file: MeshFile): string | null {
  const bytes = file.read(0, file.size)
  const [first, second] = bytes
  const encoding =
    first === 0xff && second === 0xfe ? 'utf-16le' : first === 0xfe && second === 0xff ? 'utf-16be' : 'utf-8'
  const text = new TextDecoder(encoding).decode(bytes)
  if (text.includes('\0')) return null
  return text.includes('\r') ? text.replaceAll('\r\n', '\n').replaceAll('\r', '\n') : text
}

/** Whether the first bytes of a file may be those of a text. */
export function isText(head: Uint8Array): boolean {
  const isUtf16 = (head[0] === 0xff && head[1] === 0xfe) || (head[0] === 0xfe && head[1] === 0xff)
  return isUtf16 || !head.includes(0)
}

const decoder = new TextDecoder('latin1')

/** The first bytes of a file as text in which marks of a format are looked for. */
export function headText(head: Uint8Array, most = head.length): string {
  return decoder.decode(head.subarray(0, most))
}
