/** docs/architecture.md against the sources: its walks, its folders and its words. */
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'

const root = fileURLToPath(new URL('../..', import.meta.url))
const page = readFileSync(join(root, 'docs/architecture.md'), 'utf8')
const section = (title: string) => page.split(/^## /m).find(text => text.startsWith(`${title}\n`)) ?? ''
const rowsOf = (title: string) =>
  section(title)
    .split('\n')
    .filter(line => line.startsWith('| '))
    .slice(2)

/** At most so many files: half of what each walk took before the house was rebuilt; the text's, which then went to the pixel. */
const MOST: readonly (readonly [walk: RegExp, files: number])[] = [
  [/vertex/, 11],
  [/text/, 8],
  [/attribute/, 5],
  [/cell/, 5],
  [/click/, 6],
]

it('the walks go through files that are there, as many as the page says', () => {
  const rows = rowsOf('Five walks')
  expect(rows).toHaveLength(MOST.length)
  for (const [i, row] of rows.entries()) {
    const [walk, most] = MOST[i] as (typeof MOST)[number]
    const files = [...row.matchAll(/`([\w/-]+\.ts)`/g)].map(match => match[1] as string)
    expect(row).toMatch(walk)
    expect(files.filter(file => !existsSync(join(root, 'web', file)))).toEqual([])
    expect(row).toContain(`| ${files.length} |`)
    expect(files.length).toBeLessThanOrEqual(most)
  }
})

it('the tree has every folder of web', () => {
  const folders = readdirSync(join(root, 'web'), { withFileTypes: true }).filter(entry => entry.isDirectory())
  const named = rowsOf('The tree').map(row => /`web\/([\w-]+)\/`/.exec(row)?.[1])
  expect(folders.map(({ name }) => name).sort()).toEqual(named.filter(name => name !== undefined).sort())
})

it('the glossary has at most 25 words, in their order', () => {
  const words = rowsOf('Words').map(row => row.split('|')[1]?.trim() ?? '')
  expect(words.length).toBeLessThanOrEqual(25)
  expect(words).toEqual(words.toSorted())
})
