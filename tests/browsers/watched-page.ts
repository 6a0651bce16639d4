/** The page as it is served, with one script before all others that writes down what would be complained of in the console. */
import { once } from 'node:events'
import { createServer } from 'node:http'

const WATCHER = `
globalThis.complaints = []
addEventListener('error', event => complaints.push('error: ' + (event.message ?? event.target?.src ?? event.target?.href)), true)
addEventListener('unhandledrejection', event => complaints.push('rejection: ' + event.reason))
addEventListener('securitypolicyviolation', event => complaints.push('policy: ' + event.violatedDirective + ' ' + event.blockedURI))
for (const level of ['error', 'warn']) {
  const write = console[level]
  console[level] = (...words) => {
    complaints.push(level + ': ' + words.join(' '))
    write(...words)
  }
}
`

export interface WatchedPage {
  readonly url: string
  close(): void
}

/** Passes requests on to the server of the page. */
export async function serveWatched(page: string): Promise<WatchedPage> {
  const server = createServer(async (request, response) => {
    const path = request.url ?? '/'
    if (path === '/watcher.js') {
      response.writeHead(200, { 'content-type': 'text/javascript' }).end(WATCHER)
      return
    }
    const original = await fetch(new URL(path, page))
    const type = original.headers.get('content-type') ?? 'application/octet-stream'
    const body = Buffer.from(await original.arrayBuffer())
    const isPage = type.startsWith('text/html')
    const watched = isPage ? body.toString().replace('<meta charset', '<script src="/watcher.js"></script>$&') : body
    response.writeHead(original.status, { 'content-type': type }).end(watched)
  }).listen(0, '127.0.0.1')
  await once(server, 'listening')
  const { port } = server.address() as { port: number }
  return {
    url: `http://127.0.0.1:${port}/`,
    close: () => {
      server.close()
      server.closeAllConnections()
    },
  }
}
