/** Texts as mails and issues hold them: lines that are quoted with ">", and code between fences. */
import { isText, LARGEST_SNIPPET, snippetText } from './snippets/snippet-text'
import { fileOfBytes, type MeshFile } from './source'

const QUOTED = /^(?!>>>)[ \t]?>(?:[ \t]?>(?!>))*[ \t]?/
const FENCE = /^\s{0,20}(?:```|~~~)/

/**
 * The text without its marks of quotation, and without what stands outside its fences; the file itself if it has none. In a text that is in
 * UTF-16 the characters are those of UTF-8 afterwards.
 */
export function withoutQuotation(file: MeshFile): MeshFile {
  if (file.size > LARGEST_SNIPPET) return file
  const head = file.read(0, Math.min(file.size, 65_536))
  const isUtf16 = (head[0] === 0xff && head[1] === 0xfe) || (head[0] === 0xfe && head[1] === 0xff)
  const mayHaveMarks = head.includes(62) || includesFence(head)
  if (!isText(head) || !(isUtf16 || mayHaveMarks)) return file
  const text = snippetText(file)
  if (text === null) return file
  const plain = insideFences(unquoted(text))
  return plain === text && !isUtf16 ? file : fileOfBytes(file.name, new TextEncoder().encode(plain))
}

function includesFence(head: Uint8Array): boolean {
  for (let i = head.indexOf(96); i >= 0; i = head.indexOf(96, i + 1))
    if (head[i + 1] === 96 && head[i + 2] === 96) return true
  for (let i = head.indexOf(126); i >= 0; i = head.indexOf(126, i + 1))
    if (head[i + 1] === 126 && head[i + 2] === 126) return true
  return false
}

/** Most lines of a quoted text are quoted; those that are not are somebody's words around it. Python's ">>>" is no quotation. */
function unquoted(text: string): string {
  const lines = text.split('\n')
  const full = lines.filter(line => line.trim() !== '')
  const quoted = full.filter(line => QUOTED.test(line.slice(0, 100))).length
  if (quoted < 3 || 2 * quoted < full.length) return text
  return lines.map(line => (QUOTED.test(line.slice(0, 100)) ? line.replace(QUOTED, '') : '')).join('\n')
}

/** What stands between fences, if that has numbers at all. A fence that does not end goes to the end. */
function insideFences(text: string): string {
  if (!text.includes('```') && !text.includes('~~~')) return text
  const inside: string[] = []
  let isInside = false
  let fences = 0
  for (const line of text.split('\n')) {
    if (FENCE.test(line.slice(0, 100))) {
      isInside = !isInside
      fences++
    } else if (isInside) inside.push(line)
  }
  // One fence alone is the end of a block whose beginning was not copied.
  if (fences === 1)
    return text
      .split('\n')
      .filter(line => !FENCE.test(line.slice(0, 100)))
      .join('\n')
  const code = inside.join('\n')
  return /\d/.test(code) ? code : text
}
