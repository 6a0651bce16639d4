import { execFileSync } from 'node:child_process'
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { elsewhere, expect, test } from './elsewhere'

test('the package is packed and installs elsewhere', () => {
  const installed = readdirSync(join(elsewhere, 'node_modules/hexlens'), { recursive: true }).map(String)
  expect(installed).toEqual(
    expect.arrayContaining([
      'dist/hexlens.es.js',
      'dist/hexlens.iife.js',
      'dist/hexlens.light.js',
      'dist/hexlens.hex-mesh.js',
      'dist/hexlens.twin.js',
      'dist/hexlens.batch.js',
      'dist/hexlens.batch-worker.js',
      'dist/hexlens.mesh.js',
      'dist/hexlens.mesh-worker.js',
      'dist/hexlens.hdf5.js',
      'dist/hexlens.lang.de.js',
      'dist/hexlens.lang.zh.js',
      'dist/app/index.html',
      'custom-elements.json',
      'CHANGELOG.md',
    ]),
  )
  expect(installed.filter(name => name.startsWith('web') || name.startsWith('tests'))).toEqual([])
})

test('its README stands alone, and what it shows runs', () => {
  const readme = readFileSync(join(elsewhere, 'node_modules/hexlens/README.md'), 'utf8')
  expect(readme).toMatch(/^# Hexlens\n\n {4}npm install hexlens\n/)
  expect([...readme.matchAll(/\]\(([^)]*)\)/g)].filter(([, address]) => !address?.startsWith('https://'))).toEqual([])
  const script = /```js\n(import \{ loadCore \}.*?)```/s.exec(readme)?.[1] ?? ''
  const run = ['--input-type=module', '--eval', script]
  expect(execFileSync(process.execPath, run, { cwd: elsewhere, encoding: 'utf8' })).toContain('true') // in colour, if Playwright wants it
})
