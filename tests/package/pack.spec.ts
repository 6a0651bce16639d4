import { readdirSync } from 'node:fs'
import { join } from 'node:path'
import { elsewhere, expect, test } from './elsewhere'

test('the package is packed and installs elsewhere', () => {
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
      'dist/hexlens.lang.de.js',
      'dist/hexlens.lang.zh.js',
      'dist/app/index.html',
      'custom-elements.json',
    ]),
  )
  expect(installed.filter(name => name.startsWith('web') || name.startsWith('tests'))).toEqual([])
})
