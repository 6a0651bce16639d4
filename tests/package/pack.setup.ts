/** Builds the package, packs it and installs it elsewhere, as its users get it. */
import { execFileSync } from 'node:child_process'
import { copyFileSync, cpSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { buildPackage } from '../../tools/package.mjs'
import { elsewhere, root } from './elsewhere'

test('the package is packed and installs elsewhere', async () => {
  const staging = join(elsewhere, 'staging')
  rmSync(elsewhere, { recursive: true, force: true })
  mkdirSync(staging, { recursive: true })
  mkdirSync(join(staging, 'docs'))
  const schemas = ['docs/state.schema.json', 'docs/check.schema.json']
  for (const name of ['package.json', 'README.md', 'LICENSE', 'custom-elements.json', ...schemas])
    copyFileSync(join(root, name), join(staging, name))
  await buildPackage(join(staging, 'dist'))
  cpSync(join(root, `dist/test-${process.env.HEXLENS_TEST_PORT ?? 41735}`), join(staging, 'dist/app'), {
    recursive: true,
  })
  const npm = (cwd: string, ...args: string[]) =>
    execFileSync('npm', [...args, '--ignore-scripts', '--offline'], { cwd, stdio: 'pipe' })
  npm(staging, 'pack', '--pack-destination', elsewhere)
  const packed = readdirSync(elsewhere).find(name => name.endsWith('.tgz'))
  expect(packed).toMatch(/^hexlens-/)
  writeFileSync(join(elsewhere, 'package.json'), '{ "name": "elsewhere", "private": true, "type": "module" }\n')
  npm(elsewhere, 'install', '--no-audit', '--no-fund', `./${packed}`)
  const installed = readdirSync(join(elsewhere, 'node_modules/hexlens'), { recursive: true }).map(String)
  expect(installed).toEqual(
    expect.arrayContaining([
      'dist/hexlens.es.js',
      'dist/hexlens.iife.js',
      'dist/hexlens.twin.js',
      'dist/hexlens.batch.js',
      'dist/hexlens.batch-worker.js',
      'dist/hexlens.mesh.js',
      'dist/hexlens.mesh-worker.js',
      'dist/app/index.html',
      'custom-elements.json',
    ]),
  )
  expect(installed.filter(name => name.startsWith('web') || name.startsWith('tests'))).toEqual([])
  rmSync(staging, { recursive: true })
})
