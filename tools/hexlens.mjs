#!/usr/bin/env node
// The command line: runs web/cli/main.ts. Standard output is main's alone; a setup that is needed speaks on standard error.

import { importSource } from './import-source.mjs'
import { root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

// A reader that has seen enough (head) is no error.
process.stdout.on('error', error => {
  if (error.code !== 'EPIPE') throw error
  process.exit(0)
})

await runMain(async () => {
  await setup({ say: line => process.stderr.write(`${line}\n`) })
  const { main } = await importSource('web/cli/main.ts')
  // npm runs scripts in the package's folder; file names are meant from where the user is.
  if (process.env.INIT_CWD && process.cwd() === root) process.chdir(process.env.INIT_CWD)
  return main(process.argv.slice(2))
})
