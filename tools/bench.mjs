// Benchmarks: what design.md's budgets say of time, measured; never part of the tests.

import { join } from 'node:path'
import { root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  await setup()
  const { runnerImport } = await import('vite')
  const { module } = await runnerImport(join(root, 'tests/bench/core.ts'), {
    root,
    configFile: false,
    logLevel: 'silent',
  })
  await module.main()
})
