// Builds the page and the package. Vite is loaded late: these modules are read before the packages are installed.

import { copyFileSync } from 'node:fs'
import { join } from 'node:path'
import { stripVTControlCharacters } from 'node:util'
import { buildPackage } from './package.mjs'
import { Failure, isScript, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

export const viteConfig = join(root, 'vite.config.ts')

/** The Python package carries them. */
const OF_PYTHON = ['hexlens.anywidget.js', 'hexlens.mesh-worker.js']

/** Builds the page into a folder; resolves to what Vite wrote. */
export async function buildPage(folder) {
  const { build } = await import('vite')
  try {
    return await build({ configFile: viteConfig, logLevel: 'warn', build: { outDir: join(root, folder) } })
  } catch (error) {
    throw new Failure(`The page did not build: ${stripVTControlCharacters(error.message)}`)
  }
}

if (isScript(import.meta.url)) {
  await runMain(async () => {
    await setup()
    await buildPage('dist/app')
    await buildPackage('dist')
    for (const name of OF_PYTHON) copyFileSync(join(root, 'dist', name), join(root, 'python', 'hexlens', name))
    process.stdout.write('The page is in dist/app, the package’s scripts and types are in dist.\n')
  })
}
