// npm start: sets up, builds the page and serves it until it is told to end. npm run dev: serves the sources instead.

import { createServer as createSocketServer } from 'node:net'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { buildPage, viteConfig } from './build.mjs'
import { Failure, root, runMain } from './run.mjs'
import { setup } from './setup.mjs'

const DEFAULT_PORT = 5173
const HOST = '127.0.0.1'
const USAGE = 'Usage: npm start [-- --port N]'

await runMain(async () => {
  const { dev, out, port: wanted } = readArguments()
  if (wanted !== undefined && !(await isFree(wanted))) {
    throw new Failure(`Port ${wanted} is taken. Choose another one: npm start -- --port ${wanted + 1}`)
  }
  await setup()
  if (!dev) await buildPage(out)
  const server = await serve({ dev, out, port: wanted ?? (await nextFreePort(DEFAULT_PORT)) })
  process.stdout.write(`Hexlens: http://localhost:${server.port}/\n`)
  for (const signal of ['SIGINT', 'SIGTERM']) {
    process.removeAllListeners(signal)
    process.on(signal, () => server.close().finally(() => process.exit(0)))
  }
})

function readArguments() {
  const options = { port: { type: 'string' }, dev: { type: 'boolean' }, out: { type: 'string', default: 'dist/app' } }
  let values
  try {
    values = parseArgs({ options }).values
  } catch (error) {
    throw new Failure(`${error.message}\n${USAGE}`)
  }
  if (values.port === undefined) return { ...values, port: undefined }
  const port = Number(values.port)
  if (!/^\d+$/.test(values.port) || port < 1 || port > 65535) {
    throw new Failure(`--port takes a number from 1 to 65535, not "${values.port}".\n${USAGE}`)
  }
  return { ...values, port }
}

async function nextFreePort(first) {
  for (let port = first; port < first + 100; ++port) if (await isFree(port)) return port
  throw new Failure(`Ports ${first} to ${first + 99} are taken. Choose another one: npm start -- --port N`)
}

/** Free on both addresses that a browser may take for localhost. */
async function isFree(port) {
  return (await canListen(port, HOST)) && (await canListen(port, '::1'))
}

function canListen(port, host) {
  return new Promise(resolve => {
    const socket = createSocketServer()
    socket.once('error', error => resolve(error.code === 'EADDRNOTAVAIL' || error.code === 'EAFNOSUPPORT'))
    socket.listen({ port, host, exclusive: true }, () => socket.close(() => resolve(true)))
  })
}

/** Serves and resolves to { port, close }. */
async function serve({ dev, out, port }) {
  const vite = await import('vite')
  const address = { host: HOST, port, strictPort: true }
  const config = { configFile: viteConfig, logLevel: 'warn', clearScreen: false }
  if (dev) {
    const server = await vite.createServer({ ...config, server: address })
    await server.listen()
    return { port, close: () => server.close() }
  }
  const server = await vite.preview({ ...config, build: { outDir: join(root, out) }, preview: address })
  return { port, close: () => server.close() }
}
