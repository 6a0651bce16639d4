// npm run bench: the main function of tests/bench/sweep.ts, the paper's tables; npm run bench -- NAME one of its neighbours. What
// begins with -- is theirs to read.

import { readdirSync } from 'node:fs'
import { join } from 'node:path'
import { importSource } from './import-source.mjs'
import { Failure, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  const names = readdirSync(join(root, 'tests/bench'))
    .filter(name => name.endsWith('.bench.ts'))
    .map(name => name.slice(0, -'.bench.ts'.length))
  const options = process.argv.slice(2).filter(word => word.startsWith('--'))
  const [name = 'sweep', ...others] = process.argv.slice(2).filter(word => !word.startsWith('--'))
  if (!names.includes(name) || others.length > 0)
    throw new Failure(`One of these: ${names.join(', ')}. Without a name it is sweep.`)
  await setup({ purpose: 'bench', say: line => process.stderr.write(`${line}\n`) })
  const { main } = await importSource(`tests/bench/${name}.bench.ts`)
  await main(options)
})
