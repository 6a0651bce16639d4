// npm run formats: docs/formats.md from the facts of tests/formats, which npm test holds to be true.
// --check: complains if it is not as it would be written.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { importSource } from './import-source.mjs'
import { isScript, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

const PAGE = 'docs/formats.md'

/** True if the page is as it would be written; it is written unless only checked. */
export async function formatsPage({ check }) {
  const { formatsDocument } = await importSource('tests/formats/document.ts')
  const text = formatsDocument()
  const isFresh = readFileSync(join(root, PAGE), 'utf8') === text
  if (!isFresh && !check) writeFileSync(join(root, PAGE), text)
  return isFresh
}

if (isScript(import.meta.url))
  await runMain(async () => {
    const { check } = parseArgs({ options: { check: { type: 'boolean', default: false } } }).values
    await setup({ purpose: 'check' })
    const isFresh = await formatsPage({ check })
    if (check && !isFresh) process.stdout.write(`${PAGE} is not up to date: npm run formats\n`)
    return check && !isFresh ? 1 : 0
  })
