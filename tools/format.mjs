// npm run format: applies the formatters and the linter's safe corrections.

import { unformattedC } from './c-format.mjs'
import { biome, run, runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  await setup()
  for (const name of await unformattedC({ write: true })) process.stdout.write(`formatted ${name}\n`)
  return (await run(process.execPath, [biome, 'check', '--write', '.'], { output: 'show' })).status
})
