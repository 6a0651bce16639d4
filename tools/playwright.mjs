// Runs Playwright's tests at a port of their own, and removes what they built.

import { readFileSync, rmSync } from 'node:fs'
import { createServer } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { root, run } from './run.mjs'

/** `results` is a folder of the project. Resolves to the exit status and Playwright's report, if it wrote one. */
export async function runPlaywright(results, words = []) {
  const port = await freePort()
  const env = { ...process.env, HEXLENS_TEST_PORT: String(port), HEXLENS_TEST_RESULTS: results }
  const playwright = join(root, 'node_modules', '@playwright', 'test', 'cli.js')
  const file = join(root, results, 'browser.json')
  rmSync(file, { force: true })
  const { status } = await run(process.execPath, [playwright, 'test', ...words], { output: 'show', env })
  rmSync(join(root, 'dist', `test-${port}`), { recursive: true, force: true })
  rmSync(join(tmpdir(), `hexlens-elsewhere-${port}`), { recursive: true, force: true })
  return { status, report: readJson(file) }
}

export function readJson(file) {
  try {
    return JSON.parse(readFileSync(file, 'utf8'))
  } catch {
    return undefined
  }
}

function freePort() {
  return new Promise((resolve, reject) => {
    const socket = createServer().on('error', reject)
    socket.listen(0, '127.0.0.1', () => {
      const { port } = socket.address()
      socket.close(() => resolve(port))
    })
  })
}
