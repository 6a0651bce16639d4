// npm run test:read: 100,000 damaged files, where npm test has some of them, and texts of megabytes. HEXLENS_SEED=7 draws others.

import { join } from 'node:path'
import { root, run, runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  await setup({ purpose: 'unit' })
  const vitest = join(root, 'node_modules', 'vitest', 'vitest.mjs')
  const env = { ...process.env, HEXLENS_READ: 'whole' }
  const { status } = await run(process.execPath, [vitest, 'run', 'tests/read', '--disable-console-intercept'], {
    output: 'show',
    env,
  })
  return status
})
