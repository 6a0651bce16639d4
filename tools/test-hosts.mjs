// npm run test:hosts: installs the foreign hosts and the packed package in each, and looks at the element there. With
// names, those hosts alone: npm run test:hosts -- vitepress reveal.

import { join } from 'node:path'
import { runPlaywright } from './playwright.mjs'
import { runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  await setup({ purpose: 'hosts' })
  const results = join('test-results', 'hosts')
  const names = process.argv.slice(2).map(name => `tests/hosts/${name}.spec.ts`)
  const { status, report } = await runPlaywright(results, ['--config', 'playwright.hosts.config.ts', ...names])
  const { expected = 0, unexpected = 0, flaky = 0, skipped = 0 } = report?.stats ?? {}
  // A host that could not be made ready has tests that were not run.
  const failed = Math.max(unexpected + flaky + skipped, status === 0 && expected > 0 ? 0 : 1)
  process.stdout.write(`${expected} passed, ${failed} failed\n`)
  return failed > 0 ? 1 : 0
})
