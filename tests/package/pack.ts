/** Builds the package, packs it and installs it elsewhere, as its users get it. */
import { execFileSync } from 'node:child_process'
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { withLock } from '../../tools/lock.mjs'
import { stagePackage } from '../../tools/package.mjs'

export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/[\\/]$/, '')

/** The folder it is installed in, one of each port that tests run at. */
export const elsewhere = join(tmpdir(), `hexlens-elsewhere-${process.env.HEXLENS_TEST_PORT ?? 41735}`)

/** Names the run of the tests: its workers have one parent. Runs that are given one name share what they have made. */
export const run = process.env.HEXLENS_TEST_RUN ?? String(process.ppid)

/** Once in a run of the tests, by the worker that asks first; the others wait. */
export async function packOnce(): Promise<void> {
  const stamp = join(elsewhere, 'run')
  const isStamped = () => existsSync(stamp) && readFileSync(stamp, 'utf8') === run
  await withLock(
    `${elsewhere}.lock`,
    () => {},
    async () => {
      if (!isStamped()) {
        rmSync(elsewhere, { recursive: true, force: true })
        mkdirSync(elsewhere)
        writeFileSync(stamp, run)
        await pack()
      }
    },
  )
  if (!existsSync(join(elsewhere, 'node_modules/hexlens')))
    throw new Error('The package was not packed: see pack.spec.ts.')
}

async function pack(): Promise<void> {
  const staging = join(elsewhere, 'staging')
  mkdirSync(staging)
  await stagePackage(staging)
  cpSync(join(root, `dist/test-${process.env.HEXLENS_TEST_PORT ?? 41735}`), join(staging, 'dist/app'), {
    recursive: true,
  })
  const npm = (cwd: string, ...args: string[]) =>
    execFileSync('npm', [...args, '--ignore-scripts', '--offline'], { cwd, stdio: 'pipe' })
  npm(staging, 'pack', '--pack-destination', elsewhere)
  const packed = readdirSync(elsewhere).find(name => name.endsWith('.tgz'))
  writeFileSync(join(elsewhere, 'package.json'), '{ "name": "elsewhere", "private": true, "type": "module" }\n')
  npm(elsewhere, 'install', '--no-audit', '--no-fund', `./${packed}`)
  rmSync(staging, { recursive: true })
}
