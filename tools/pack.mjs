// npm run pack: the package as npm gets it. Its README is not the repository's, so npm packs a folder made for it.

import { mkdirSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { buildPage } from './build.mjs'
import { stagePackage } from './package.mjs'
import { must, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

await runMain(async () => {
  const folder = join(root, 'dist', 'npm')
  await setup()
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder, { recursive: true })
  await stagePackage(folder)
  await buildPage('dist/npm/dist/app')
  await must('npm', ['pack', folder, '--pack-destination', join(root, 'dist')], 'npm did not pack it.')
})
