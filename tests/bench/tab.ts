/** A tab of a headless Chromium with the built page in it, for benchmarks. */
import { existsSync, readFileSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import { extname, join } from 'node:path'
import { type Browser, chromium } from '@playwright/test'
import { findInstalledChromium } from '../../tools/chromium.mjs'

const ARGUMENTS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']
const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
}

/** Serves a folder; resolves to its address. */
export async function served(folder: string): Promise<{ readonly server: Server; readonly address: string }> {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost')
    response.setHeader('Content-Type', TYPES[extname(pathname)] ?? 'application/octet-stream')
    try {
      response.end(readFileSync(join(folder, pathname)))
    } catch {
      response.writeHead(404).end()
    }
  })
  await new Promise<void>(resolve => server.listen(0, '127.0.0.1', resolve))
  const { port } = server.address() as { port: number }
  return { server, address: `http://127.0.0.1:${port}` }
}

export async function startedChromium(): Promise<Browser> {
  const executablePath = await findInstalledChromium()
  return chromium.launch({ ...(executablePath ? { executablePath } : {}), args: ARGUMENTS })
}

/** Bytes that the tabs' processes have to themselves at present, as a browser's task manager shows it. */
export async function memoryOfTabs(browser: Browser): Promise<() => number> {
  const session = await browser.newBrowserCDPSession()
  const { processInfo } = await session.send('SystemInfo.getProcessInfo')
  const renderers = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => id)
  return () => Math.max(...renderers.map(ownMemory))
}

/** 0 for a process that has ended. */
function ownMemory(id: number): number {
  const path = `/proc/${id}/status`
  if (!existsSync(path)) return 0
  const status = readFileSync(path, 'utf8')
  const kilobytes = (name: string) => Number(new RegExp(`${name}:\\s*(\\d+)`).exec(status)?.[1])
  return 1024 * (kilobytes('RssAnon') + kilobytes('RssShmem'))
}
