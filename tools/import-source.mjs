// Runs TypeScript of this project in Node by Vite's module runner.

import { join } from 'node:path'
import { root } from './run.mjs'

/** The exports of a source file, given relative to the root. */
export async function importSource(path) {
  const { runnerImport } = await import('vite')
  const { module } = await runnerImport(join(root, path), { root, configFile: false, logLevel: 'silent' })
  return module
}
