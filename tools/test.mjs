// npm test: sets up, runs the native, unit, Python and browser tests and ends with the counts. --fast: without the
// browser, Python and the long native tests.

import { mkdirSync, readdirSync, rmSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { join, relative } from 'node:path'
import { parseArgs } from 'node:util'
import { readJson, runPlaywright } from './playwright.mjs'
import { runPytest, stagePackage } from './pytest.mjs'
import { Failure, isAlive, root, run, runMain } from './run.mjs'
import { setup } from './setup.mjs'

const allResults = join(root, 'test-results')
const results = join(allResults, String(process.pid))

/** One stage after another; the suites of a stage side by side: the native tests use one core. */
const stages = [
  [
    { name: 'native', run: native },
    { name: 'unit', run: unit },
    { name: 'python', run: python, long: true },
  ],
  [{ name: 'browser', run: browser, long: true }],
]

/** Some of test:exact and test:read, proofs of twenty thousand verdicts among them. */
const LONG_UNIT_TESTS = ['tests/property/**', 'tests/exact/**', 'tests/read/**'].flatMap(path => ['--exclude', path])

await runMain(async () => {
  const { fast } = readArguments()
  const total = counts()
  try {
    await setup({ purpose: fast ? 'check' : 'unit' })
    mkdirSync(results, { recursive: true })
    removeOldResults()
    const lines = []
    await buildNativeLibrary()
    for (const stage of stages) {
      const suites = stage.filter(({ long }) => !(fast && long))
      const runs = suites.map(suite => suite.run({ fast }))
      // The browsers are installed while the other tests run.
      const [outcomes] = await Promise.all([Promise.all(runs), fast || setup({ purpose: 'test' })])
      for (const [i, result] of outcomes.entries()) {
        lines.push(`${suites[i].name}: ${sentence(result)}${result.detail ? ` (${result.detail})` : ''}`)
        for (const key of Object.keys(total)) total[key] += result[key]
      }
    }
    process.stdout.write(`\n${lines.join('\n')}\n`)
  } catch (error) {
    if (!(error instanceof Failure)) throw error
    process.stdout.write(`${error.message}\n`)
    total.failed += 1
  }
  process.stdout.write(`${sentence(total)}\n`)
  if (total.failed > 0 || total.skipped > 0) return 1
  rmSync(results, { recursive: true, force: true })
  return 0
})

function readArguments() {
  try {
    return parseArgs({ options: { fast: { type: 'boolean', default: false } } }).values
  } catch (error) {
    throw new Failure(`${error.message}\nUsage: npm test, or npm run test:fast`)
  }
}

/** Removes results of runs that are over: runs side by side leave each other alone. */
function removeOldResults() {
  for (const id of readdirSync(allResults).map(Number)) {
    if (id && !isAlive(id)) rmSync(join(allResults, String(id)), { recursive: true, force: true })
  }
}

function counts(passed = 0, failed = 0, skipped = 0) {
  return { passed, failed, skipped }
}

function sentence({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ''}`
}

/** A suite that ended badly without a failed test, or that ran no test, counts as one failure. */
function judged(result, status) {
  const ranNone = result.passed + result.failed === 0
  return result.failed === 0 && (status !== 0 || ranNone) ? { ...result, failed: 1 } : result
}

/** The native, the unit and the Python tests need it: two makes side by side would write the same files. */
async function buildNativeLibrary() {
  const { status, text } = await run('make', [
    '-s',
    `-j${availableParallelism()}`,
    '-C',
    'wasm',
    ...['native', 'parity', 'library'],
  ])
  if (status !== 0) throw new Failure(`The native library was not built.\n${text}`)
}

/** Every test program closes with a line `N passed, N failed`. */
async function native({ fast }) {
  const words = ['-C', 'wasm', '--no-print-directory', '-k', fast ? 'test-fast' : 'test']
  const { status, stdout, text } = await run('make', words)
  process.stdout.write(text) // in one piece: the unit tests write too
  const result = counts()
  for (const [, passed, failed] of stdout.matchAll(/^(\d+) passed, (\d+) failed$/gm)) {
    result.passed += Number(passed)
    result.failed += Number(failed)
  }
  return judged(result, status)
}

async function unit({ fast }) {
  const file = join(results, 'unit.json')
  const vitest = join(root, 'node_modules', 'vitest', 'vitest.mjs')
  const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`]
  const { status } = await run(process.execPath, [vitest, 'run', ...reporters, ...(fast ? LONG_UNIT_TESTS : [])], {
    output: 'show',
  })
  const report = readJson(file)
  if (!report) return judged(counts(), status)
  // A file that cannot be loaded has no test to fail.
  const brokenFiles = report.testResults.filter(f => f.status === 'failed' && f.assertionResults.length === 0)
  const { numPassedTests, numFailedTests, numPendingTests, numTodoTests } = report
  return judged(counts(numPassedTests, numFailedTests + brokenFiles.length, numPendingTests + numTodoTests), status)
}

/** The tests of verdicts and proofs, without the Node command; npm run test:python has all, of the package as it is published. */
async function python() {
  const tests = ['test_classify.py', 'test_proofs.py'].map(name => join(root, 'python', 'tests', name))
  const env = { ...process.env, PYTHONPATH: stagePackage(), PYTHONDONTWRITEBYTECODE: '1' }
  const interpreter = join(root, 'build', 'python', 'bin', 'python')
  const words = ['-m', 'not node', '-p', 'no:cacheprovider', ...tests]
  const { status, passed, failed, text } = await runPytest(interpreter, words, { env, output: 'capture' })
  process.stdout.write(text)
  return judged(counts(passed, failed), status)
}

async function browser() {
  const { status, report } = await runPlaywright(relative(root, results))
  if (!report) return judged(counts(), status)
  const { expected, unexpected, flaky, skipped } = report.stats
  return { ...judged(counts(expected, unexpected + flaky, skipped), status), detail: testsOfBrowsers(report) }
}

/** "chromium 54, firefox 1, webkit 1". */
function testsOfBrowsers(report) {
  const testsIn = suite => [
    ...(suite.specs ?? []).flatMap(spec => spec.tests),
    ...(suite.suites ?? []).flatMap(testsIn),
  ]
  const names = testsIn(report).map(test => test.projectName)
  return [...new Set(names)].map(name => `${name} ${names.filter(other => other === name).length}`).join(', ')
}
