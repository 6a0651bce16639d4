/** The package as npm installs it, in a folder outside this project, and a server for that folder. */
import { createReadStream, statSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join, normalize } from 'node:path'
import { test as base } from '../e2e/lens'
import { elsewhere, packOnce, root } from './pack'

export { elsewhere, root }

/** Anyone's static server. No wasm type among them: the package must not need one. */
const MEDIA_TYPES: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
}

export async function serve(folder: string): Promise<{ origin: string; close(): Promise<void> }> {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname)
    const file = join(folder, normalize(path), path.endsWith('/') ? 'index.html' : '')
    if (path === '/favicon.ico') {
      response.writeHead(204).end()
      return
    }
    if (!statSync(file, { throwIfNoEntry: false })?.isFile()) {
      response.writeHead(404).end()
      return
    }
    response.writeHead(200, { 'content-type': MEDIA_TYPES[extname(file)] ?? 'application/octet-stream' })
    createReadStream(file).pipe(response)
  })
  await new Promise<void>(resolve => server.listen(0, '127.0.0.1', resolve))
  return {
    origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}`,
    close: () =>
      new Promise(resolve => {
        server.close(() => resolve())
        server.closeAllConnections()
      }),
  }
}

/** `baseURL` is the folder's server. */
export const test = base.extend<object, { packed: undefined; served: string }>({
  packed: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads which fixtures are asked for
    async ({}, use) => {
      await packOnce()
      await use(undefined)
    },
    { scope: 'worker', auto: true, timeout: 300_000 },
  ],
  served: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads which fixtures are asked for
    async ({}, use) => {
      const server = await serve(elsewhere)
      await use(server.origin)
      await server.close()
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ served }, use) => use(`${served}/`),
})

export { expect } from '../e2e/lens'
