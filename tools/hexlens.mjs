#!/usr/bin/env node
// The command line: runs web/cli/from-sources.ts. Standard output is main's alone; a setup that is needed speaks on standard error.

import { importSource } from './import-source.mjs'
import { root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  await setup({ say: line => process.stderr.write(`${line}\n`) })
  const { main } = await importSource('web/cli/from-sources.ts')
  // npm runs scripts in the package's folder; file names are meant from where the user is.
  if (process.env.INIT_CWD && process.cwd() === root) process.chdir(process.env.INIT_CWD)
  return main(process.argv.slice(2))
})
