/** The Python package at the border: 500 elements beside integers. `npm run test:python` has the others. */
import { execFileSync } from 'node:child_process'
import { copyFileSync, mkdirSync, readdirSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, test } from 'vitest'

const root = fileURLToPath(new URL('../..', import.meta.url))
const staged = join(root, 'build', 'python-staged')
const library = join(root, 'build', 'native', 'library')

/** What an installation has: the modules, the library that npm test has built, and the checker. */
function stage(): void {
  const folder = join(staged, 'hexlens')
  const source = join(root, 'python', 'hexlens')
  rmSync(staged, { recursive: true, force: true })
  mkdirSync(folder, { recursive: true })
  for (const name of readdirSync(source).filter(name => name.endsWith('.py')))
    copyFileSync(join(source, name), join(folder, name))
  copyFileSync(join(root, 'tests', 'certificates', 'check_certificates.py'), join(folder, '_checker.py'))
  const isMac = process.platform === 'darwin'
  const [built] = readdirSync(library).filter(name => name.startsWith(isMac ? 'libhexlens.0' : 'libhexlens.so')) as [
    string,
  ]
  copyFileSync(join(library, built), join(folder, isMac ? 'libhexlens.dylib' : 'libhexlens.so'))
}

test('verdicts of 500 elements at the border are those of integers', () => {
  stage()
  const python = join(root, 'build', 'python', 'bin', 'python')
  const env = { ...process.env, PYTHONPATH: staged, PYTHONDONTWRITEBYTECODE: '1' }
  const printed = execFileSync(python, [join(root, 'python', 'tests', 'border.py'), '500'], { encoding: 'utf8', env })
  expect(printed).toBe('500 border cases agree\n')
}, 60_000)
