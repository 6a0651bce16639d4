// npm run test:exact: the laws of tests/exact in whole, where npm test has a hundredth of them, with their counts and times;
// all proofs of verdicts, where npm test has a fifth; and all bit patterns of the parity of the wasm's twin.
// HEXLENS_SEED=7 draws others.

import { join } from 'node:path'
import { root, run, runMain } from './run.mjs'
import { setup } from './setup.mjs'

const TESTS = ['tests/exact', 'tests/property/verdict.', 'tests/property/verdict-border', 'tests/unit/parity.test.ts']

await runMain(async () => {
  await setup({ purpose: 'unit' })
  const vitest = join(root, 'node_modules', 'vitest', 'vitest.mjs')
  const env = { ...process.env, HEXLENS_EXACT: 'whole' }
  const { status } = await run(process.execPath, [vitest, 'run', ...TESTS, '--disable-console-intercept'], {
    output: 'show',
    env,
  })
  return status
})
