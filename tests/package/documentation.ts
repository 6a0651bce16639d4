/** The snippets of docs/embedding.md, as authors copy them. */
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { root } from './elsewhere'

/** The fences below a heading, in their order. */
export function snippetsOf(heading: string): string[] {
  const text = readFileSync(join(root, 'docs/embedding.md'), 'utf8')
  const section = text.split(/^## /m).find(part => part.startsWith(`${heading}\n`))
  const fences = [...(section ?? '').matchAll(/^(`{3,})\w+\n(.*?)\n\1$/gms)].map(([, , content]) => content as string)
  if (fences.length === 0) throw new Error(`docs/embedding.md has no snippet for ${heading}.`)
  return fences
}
