/** Foreign hosts as authors have them: installed with their locks into build/hosts, the packed package in each. */
import { execFileSync } from 'node:child_process'
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { test as base, elsewhere, root, serve } from '../package/elsewhere'
import { run as runOfTests } from '../package/pack'

export { expect } from '../package/elsewhere'
export { elsewhere, root }

/** The folder that is served: a host's site is at /NAME/. */
export const hosts = join(root, 'build/hosts')
export const python = join(hosts, 'python/bin')
export const dist = join(elsewhere, 'node_modules/hexlens/dist')

const REMOVED = { recursive: true, force: true }

/** `baseURL` is the server of all hosts. */
export const test = base.extend<object, { served: string }>({
  served: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads which fixtures are asked for
    async ({}, use) => {
      mkdirSync(hosts, { recursive: true })
      const server = await serve(hosts)
      await use(server.origin)
      await server.close()
    },
    { scope: 'worker' },
  ],
})

/** Names the host of the tests in a file, for the table. */
export function nameHost(name: string, version: () => string): void {
  test.beforeEach(() => {
    test.info().annotations.push({ type: 'host', description: `${name}\t${version()}` })
  })
}

/** The version of an installed npm package of a host. */
export function npmVersion(host: string, name: string): string {
  return versionOf(join(hosts, host, 'node_modules', name))
}

export function versionOf(folder: string): string {
  return JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')).version
}

/** The version of an installed Python package. */
export function pythonVersion(name: string): string {
  const read = `import importlib.metadata as m; print(m.version(${JSON.stringify(name)}))`
  return execFileSync(join(python, 'python'), ['-c', read], { encoding: 'utf8' }).trim()
}

/** A new folder for a site, with the script and the picture where the host wants them. */
export function site(name: string, files: string): string {
  const folder = join(hosts, name)
  rmSync(folder, REMOVED)
  putFiles(join(folder, files))
  return folder
}

/** The script, what reads beside it, and the picture. */
export function putFiles(folder: string): void {
  mkdirSync(folder, { recursive: true })
  for (const name of ['hexlens.iife.js', 'hexlens.mesh-worker.js']) copyFileSync(join(dist, name), join(folder, name))
  copyFileSync(join(root, 'tests/visual/snapshots/index-desktop.png'), join(folder, 'hexlens.png'))
}

/**
 * The folder of a host that comes from npm: what its lock names, the packed package, and the project's files of it.
 * Its packages stay until the lock changes; the rest is new in each run.
 */
export function installed(name: string): string {
  const folder = join(hosts, name)
  const source = join(root, 'tests/hosts', name)
  const stamp = join(folder, 'hexlens-stamp')
  const lock = readFileSync(join(source, 'package-lock.json'), 'utf8')
  mkdirSync(folder, { recursive: true })
  for (const file of readdirSync(folder))
    if (!['node_modules', 'hexlens-stamp'].includes(file)) rmSync(join(folder, file), REMOVED)
  for (const file of ['package.json', 'package-lock.json']) copyFileSync(join(source, file), join(folder, file))
  if (!existsSync(stamp) || readFileSync(stamp, 'utf8') !== lock) {
    rmSync(stamp, { force: true })
    npm(folder, 'ci')
    writeFileSync(stamp, lock)
  }
  // Bundlers take packages for what they were as long as the version is the same.
  for (const cache of ['.cache', '.vite', '.astro']) rmSync(join(folder, 'node_modules', cache), REMOVED)
  const packed = readdirSync(elsewhere).find(file => file.endsWith('.tgz')) as string
  npm(folder, 'install', '--no-save', '--offline', join(elsewhere, packed))
  return folder
}

function npm(cwd: string, ...words: string[]): void {
  run(cwd, 'npm', ...words, '--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error')
}

/** Runs a command of a host; what it says is in the error if it fails. */
export function run(cwd: string, command: string, ...words: string[]): void {
  const local = join(cwd, 'node_modules/.bin')
  const env = { ...process.env, PATH: `${local}:${python}:${process.env.PATH}`, CI: 'true', NO_COLOR: '1' }
  try {
    execFileSync(command, words, { cwd, env, stdio: 'pipe', encoding: 'utf8' })
  } catch (error) {
    const { stdout, stderr } = error as { stdout?: string; stderr?: string }
    throw new Error([`${command} ${words.join(' ')} failed.`, stdout, stderr].join('\n'))
  }
}

/** Does the work once in a run of the tests, whichever of its workers asks first. */
export async function onceInRun(name: string, work: () => void | Promise<void>): Promise<void> {
  mkdirSync(join(hosts, 'runs'), { recursive: true })
  const stamp = join(hosts, 'runs', name)
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === runOfTests) return
  rmSync(stamp, { force: true })
  await work()
  writeFileSync(stamp, runOfTests)
}

export function html(head: string, body: string): string {
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A page</title><link rel="icon" href="data:,">${head}</head><body><h1>A page</h1>${body}</body></html>`
}
