// pytest for npm test and npm run test:python, and the Python package as far as npm test needs it.

import { copyFileSync, mkdirSync, readdirSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { root, run } from './run.mjs'

/** Resolves to { status, passed, failed, text }. An error and a skipped test count as failed. */
export async function runPytest(python, words, { env, output }) {
  const { status, stdout, text } = await run(python, ['-m', 'pytest', '-q', ...words], { env, output })
  const counted = word => Number(new RegExp(`(\\d+) ${word}`).exec(stdout)?.[1] ?? 0)
  const failed = counted('failed') + counted('error') + counted('skipped')
  return { status, passed: counted('passed'), failed, text }
}

/** A folder with what an installation of the package has but the widget's script: nothing is built that `make library` has not built. */
export function stagePackage() {
  const staged = join(root, 'build', 'python-staged')
  const folder = join(staged, 'hexlens')
  const source = join(root, 'python', 'hexlens')
  const library = join(root, 'build', 'native', 'library')
  rmSync(staged, { recursive: true, force: true })
  mkdirSync(folder, { recursive: true })
  for (const name of readdirSync(source).filter(name => name.endsWith('.py')))
    copyFileSync(join(source, name), join(folder, name))
  copyFileSync(join(root, 'tests', 'certificates', 'check_certificates.py'), join(folder, '_checker.py'))
  const isMac = process.platform === 'darwin'
  const [built] = readdirSync(library).filter(name => name.startsWith(isMac ? 'libhexlens.0' : 'libhexlens.so'))
  copyFileSync(join(library, built), join(folder, isMac ? 'libhexlens.dylib' : 'libhexlens.so'))
  return staged
}
