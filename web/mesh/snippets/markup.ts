/** HTML tables as text: a line for each row, tabs between its cells. */
import { wordTable } from '../word-table'

const ENTITIES: Readonly<Record<string, string>> = wordTable({
  nbsp: ' ',
  minus: '-',
  '#8722': '-',
  '#160': ' ',
  thinsp: ' ',
})

/** Texts without rows or cells of HTML come back as they are. */
export function withoutTags(text: string): string {
  if (!/<t[dhr][\s>]/i.test(text)) return text
  return text
    .replace(/\n/g, ' ')
    .replace(/<\/tr\s{0,9}>|<tr[\s>]/gi, '\n$&')
    .replace(/<\/?t[dh]\b[^<>]{0,2000}>/gi, '\t')
    .replace(/<[^<>]{0,2000}>/g, ' ')
    .replace(/&(#?\w{1,8});/g, (whole, name) => ENTITIES[name] ?? whole)
    .replace(/^[^\S\n]+/gm, '')
}
