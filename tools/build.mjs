// Builds the page. Vite is loaded late: these modules are read before the packages are installed.

import { join } from 'node:path'
import { isScript, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

export const viteConfig = join(root, 'vite.config.ts')

/** Builds the page into a folder; resolves to what Vite wrote. */
export async function buildPage(folder) {
  const { build } = await import('vite')
  return build({ configFile: viteConfig, logLevel: 'warn', build: { outDir: join(root, folder) } })
}

if (isScript(import.meta.url)) {
  await runMain(async () => {
    await setup()
    await buildPage('dist/app')
    process.stdout.write('The page is in dist/app.\n')
  })
}
