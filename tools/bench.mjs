// npm run bench: the main functions of tests/bench/*.ts, one after another; npm run bench -- NAME runs one.

import { readdirSync } from 'node:fs'
import { join } from 'node:path'
import { importSource } from './import-source.mjs'
import { Failure, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  const names = readdirSync(join(root, 'tests/bench'))
    .filter(name => name.endsWith('.ts'))
    .map(name => name.slice(0, -'.ts'.length))
  const wanted = process.argv.slice(2)
  const unknown = wanted.find(name => !names.includes(name))
  if (unknown !== undefined) throw new Failure(`No benchmark is called "${unknown}". There are: ${names.join(', ')}.`)
  await setup({ purpose: 'check' })
  for (const name of wanted.length > 0 ? wanted : names) {
    process.stdout.write(`\n${name}\n`)
    const { main } = await importSource(`tests/bench/${name}.ts`)
    await main()
  }
})
