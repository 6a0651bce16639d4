#!/usr/bin/env node
// The command line: runs web/cli/main.ts. Standard output is main's alone; a setup that is needed speaks on standard error.

import { join } from 'node:path'
import { root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

// A reader that has seen enough (head) is no error.
process.stdout.on('error', error => {
  if (error.code !== 'EPIPE') throw error
  process.exit(0)
})

await runMain(async () => {
  await setup({ say: line => process.stderr.write(`${line}\n`) })
  const { runnerImport } = await import('vite')
  const { module } = await runnerImport(join(root, 'web/cli/main.ts'), { root, configFile: false, logLevel: 'silent' })
  // npm runs scripts in the package's folder; file names are meant from where the user is.
  if (process.env.INIT_CWD && process.cwd() === root) process.chdir(process.env.INIT_CWD)
  return module.main(process.argv.slice(2))
})
