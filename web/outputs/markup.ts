/** Text of files in XML and HTML. */

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }

/** Text without characters that XML forbids or that turn the text around, for contents and for attributes in double quotes. */
export function markup(text: string): string {
  return text
    .replace(/[\p{Cf}\p{Cs}\u2028\u2029\ufffe\uffff]|(?!\n)\p{Cc}/gu, '')
    .replace(/[&<>"]/g, character => ENTITIES[character] ?? '')
}
