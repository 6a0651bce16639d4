// npm run check: everything that is judged without running the tests. All checks run, then the failed ones are named.

import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { unformattedC } from './c-format.mjs'
import { elementReference } from './element-reference.mjs'
import { formatsPage } from './formats.mjs'
import { biome, Failure, root, run, runMain, tsc } from './run.mjs'
import { setup } from './setup.mjs'
import { checkSizes } from './sizes.mjs'

const importsCheck = [
  process.execPath,
  join(root, 'node_modules/dependency-cruiser/bin/dependency-cruise.mjs'),
  '--config',
  '.dependency-cruiser.cjs',
  'web',
]

/** A check resolves to lines of complaint, none if all is well, and may print. */
const checks = [
  {
    name: 'formatter and linter (biome)',
    complaints: () => output([process.execPath, biome, 'ci', '--colors=off', '--error-on-warnings', '.']),
  },
  { name: 'C formatter', complaints: formatOfC },
  { name: 'types (tsc)', complaints: () => output([process.execPath, tsc, '--pretty', 'false']) },
  { name: 'imports (dependency-cruiser)', complaints: () => output(importsCheck) },
  { name: 'C warnings', complaints: () => output(['make', '-C', 'wasm', '--no-print-directory', 'warnings']) },
  { name: 'element reference', complaints: staleReference },
  { name: 'page of formats', complaints: staleFormats },
  { name: 'lock files', complaints: addressesInLocks },
  { name: 'tests', complaints: nothingLeftOut },
  { name: 'sizes', complaints: sizes },
]

await runMain(async () => {
  await setup({ purpose: 'check' })
  const failed = []
  for (const { name, complaints } of checks) {
    const lines = await complaints().catch(linesOfFailure)
    process.stdout.write(`check: ${name}: ${lines.length === 0 ? 'ok' : 'FAILED'}\n`)
    for (const line of lines) process.stdout.write(`${line}\n`)
    if (lines.length > 0) failed.push(name)
  }
  if (failed.length === 0) return 0
  process.stdout.write(`check failed: ${failed.join(', ')}\n`)
  return 1
})

function linesOfFailure(error) {
  if (!(error instanceof Failure)) throw error
  return error.message.split('\n')
}

async function output([command, ...args]) {
  const { status, text } = await run(command, args)
  return status === 0 ? [] : [...text.trimEnd().split('\n'), `(status ${status} of ${[command, ...args].join(' ')})`]
}

async function formatOfC() {
  const names = await unformattedC()
  return names.length === 0 ? [] : [...names, 'These are not formatted: npm run format']
}

async function staleReference() {
  const names = await elementReference({ check: true })
  return names.length === 0 ? [] : [...names, 'These are not as the sources say: npm run reference']
}

async function staleFormats() {
  return (await formatsPage({ check: true })) ? [] : ['docs/formats.md is not as tests/formats has it: npm run formats']
}

/** The address of a package is the installing machine's affair. */
async function addressesInLocks() {
  const hosts = readdirSync(join(root, 'tests/hosts')).map(name => join('tests/hosts', name, 'package-lock.json'))
  const named = ['package-lock.json', ...hosts].filter(existsInProject).flatMap(file => {
    const { packages } = JSON.parse(readFileSync(join(root, file), 'utf8'))
    return Object.keys(packages).filter(name => packages[name].resolved !== undefined)
  })
  return named.length === 0 ? [] : [...named, 'Take out the addresses: npm install --omit-lockfile-registry-resolved']
}

function existsInProject(file) {
  return existsSync(join(root, file))
}

/** Tests that are excepted from running, and test files that no suite picks up. */
async function nothingLeftOut() {
  const files = ['web', 'tests']
    .filter(folder => existsSync(join(root, folder)))
    .flatMap(folder => readdirSync(join(root, folder), { recursive: true }).map(name => join(folder, name)))
    .filter(name => /\.(test|spec)\.[cm]?[jt]sx?$/.test(name))
  const excepted = /\b(?:test|it|describe|suite|bench)(?:\.\w+)*\.(?:only|skip|skipIf|runIf|todo|fixme|fail|fails)\b/
  return files.flatMap(name => {
    const isRun =
      /^tests\/.*\.test\.ts$/.test(name) || /^tests\/(e2e|browsers|hosts|package|visual)\/.*\.spec\.ts$/.test(name)
    const lines = readFileSync(join(root, name), 'utf8').split('\n')
    return [
      ...(isRun ? [] : [`${name}: no suite runs this file`]),
      ...lines.flatMap((line, i) => (excepted.test(line) ? [`${name}:${i + 1}: ${line.trim()}`] : [])),
    ]
  })
}

async function sizes() {
  const { table, exceeded } = await checkSizes()
  process.stdout.write(`${table.join('\n')}\n`)
  return exceeded ? ['A size is over its budget, or there is no wasm.'] : []
}
