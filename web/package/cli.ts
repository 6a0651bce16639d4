#!/usr/bin/env node
/** `npx hexlens`: the command line in one file, by Node. */
import { main } from '../cli/main'

// A reader that has seen enough (head) is no error.
process.stdout.on('error', (error: NodeJS.ErrnoException) => {
  if (error.code !== 'EPIPE') throw error
  process.exit(0)
})

process.exitCode = await main(process.argv.slice(2))
