/**
 * Ten million random elements through a tab: the page's search, with as many workers as it takes, in Chromium. What is counted is the memory
 * that the tab's process has to itself, as a browser's task manager shows it, before the search and at its most.
 */
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { cpus, loadavg } from 'node:os'
import { extname, join } from 'node:path'
import { chromium } from '@playwright/test'
import { findChromium } from '../../tools/chromium.mjs'

const ELEMENTS = 10_000_000
const MEGABYTE = 2 ** 20
const ARGUMENTS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']
const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
}

/** Numbers of any length about the unit cube, corners positive and yet invalid. */
const SEARCH = 'search.html?find=corners&grid=free&sigma=0.3'

export async function main(): Promise<void> {
  execFileSync(process.execPath, ['tools/build.mjs'], { stdio: 'ignore' })
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost')
    response.setHeader('Content-Type', TYPES[extname(pathname)] ?? 'application/octet-stream')
    response.end(readFileSync(join('dist/app', pathname)))
  })
  await new Promise<void>(resolve => server.listen(0, '127.0.0.1', resolve))
  const { port } = server.address() as { port: number }
  const executablePath = await findChromium()
  const browser = await chromium.launch({ ...(executablePath ? { executablePath } : {}), args: ARGUMENTS })
  console.log(`${cpus()[0]?.model.trim()}, Chromium ${browser.version()}, load ${loadavg()[0]?.toFixed(1)}`)
  const tab = await browser.newPage()
  await tab.goto(`http://127.0.0.1:${port}/${SEARCH}`)
  await tab.getByRole('button', { name: 'Start' }).waitFor()
  await tab.waitForTimeout(3000)
  const session = await browser.newBrowserCDPSession()
  const { processInfo } = await session.send('SystemInfo.getProcessInfo')
  const renderers = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => id)
  const own = () => Math.max(...renderers.map(ownMemory))
  const before = own()
  await tab.getByRole('button', { name: 'Start' }).click()
  let [most, counts] = [before, '']
  while (elementsOf(counts) < ELEMENTS) {
    await tab.waitForTimeout(100)
    most = Math.max(most, own())
    counts = (await tab.locator('.counts').textContent()) ?? ''
  }
  console.log(`${counts}: ${megabytes(before)} before, ${megabytes(most)} at most`)
  await browser.close()
  server.close()
}

function elementsOf(counts: string): number {
  return Number(/^([\d,]+) elements/.exec(counts)?.[1]?.replaceAll(',', '') ?? 0)
}

/** Bytes of a process. */
function ownMemory(id: number): number {
  return 1024 * Number(/RssAnon:\s*(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1])
}

function megabytes(bytes: number): string {
  return `${(bytes / MEGABYTE).toFixed(0)} MB`
}
