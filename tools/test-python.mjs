// npm run test:python: builds the Python package as it is published, the sdist and of it the wheel, installs that in an environment of
// its own, and runs python/tests, ruff and mypy. --all: 10,000 cases at the border in
// place of 500, 20 million cells in pieces in place of 160,000, and each way of installing it. Other words go to pytest.

import { readdirSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { buildScripts } from './package.mjs'
import { runPytest } from './pytest.mjs'
import { must, root, run, runMain } from './run.mjs'
import { setup } from './setup.mjs'

const environment = join(root, 'build', 'package-python', 'bin')
const builds = join(root, 'build', 'package-python', 'dist')
const source = join(root, 'python')

await runMain(async () => {
  const words = process.argv.slice(2)
  await setup({ purpose: 'python' })
  await buildScripts(join(source, 'hexlens'), ['hexlens.anywidget.js', 'hexlens.mesh-worker.js'])
  rmSync(builds, { recursive: true, force: true })
  const build = ['-m', 'build', '--no-isolation', '--outdir', builds, source]
  await must(join(environment, 'python'), build, 'The package was not built.')
  const [wheel] = readdirSync(builds).filter(name => name.endsWith('.whl'))
  const install = ['pip', 'install', '--quiet', '--no-deps', '--reinstall', '--python', join(environment, 'python')]
  await must(join(environment, 'uv'), [...install, join(builds, wheel)], 'The wheel was not installed.')
  const counts = { passed: 0, failed: 0 }
  for (const [command, ...args] of [['ruff', 'check', '.'], ['ruff', 'format', '--check', '.'], ['mypy']]) {
    const { status } = await run(join(environment, command), args, { cwd: source, output: 'show' })
    counts[status === 0 ? 'passed' : 'failed'] += 1
  }
  const isAll = words.includes('--all')
  const tests = ['--durations=5', join(source, 'tests'), ...words.filter(word => word !== '--all')]
  const env = { ...process.env, HEXLENS_ALL: isAll ? '1' : '', HEXLENS_BUILDS: builds }
  const tested = await runPytest(join(environment, 'python'), tests, { env, output: 'tee' })
  counts.passed += tested.passed
  counts.failed += Math.max(tested.failed, tested.status === 0 ? 0 : 1)
  process.stdout.write(`${counts.passed} passed, ${counts.failed} failed\n`)
  return counts.failed > 0 ? 1 : 0
})
