/**
 * Firefox and WebKitGTK by the commands of WebDriver (https://www.w3.org/TR/webdriver2/): WebKitGTK's own driver takes them over
 * HTTP, Firefox itself over a socket (Marionette). Neither draws WebGL without a screen: theirs is a virtual one.
 */
import { type ChildProcess, spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { createConnection, createServer as createSocketServer, type Socket } from 'node:net'
import { join } from 'node:path'
import type { Readable } from 'node:stream'
import { findFirefox, findWebKitDriver, findXvfb } from '../../tools/browsers.mjs'

export type BrowserName = 'firefox' | 'webkit'

/** Sends one command, named as in Marionette, and resolves to its value. */
type Send = (command: string, parameters: object) => Promise<unknown>

export interface Point {
  readonly x: number
  readonly y: number
}

/** Key codes of WebDriver. */
export const KEYS = { ArrowRight: '\uE014' } as const

/** A browser with one window. */
export class Driver {
  readonly version: string
  readonly #send: Send
  readonly #processes: readonly ChildProcess[]

  constructor(send: Send, session: unknown, processes: readonly ChildProcess[]) {
    const { browserName, browserVersion } = (session as { capabilities: Record<string, string> }).capabilities
    this.version = `${browserName} ${browserVersion}`
    this.#send = send
    this.#processes = processes
  }

  async open(url: string): Promise<void> {
    await this.#send('WebDriver:Navigate', { url })
  }

  /** The window's outer size. */
  async resize(width: number, height: number): Promise<void> {
    await this.#send('WebDriver:SetWindowRect', { x: 0, y: 0, width, height })
  }

  async reload(): Promise<void> {
    await this.#send('WebDriver:Refresh', {})
  }

  /** The value that a function of the page returns. It is sent as text: it sees nothing but its arguments, which are JSON. */
  async run<Given extends unknown[], Result>(work: (...given: Given) => Result, ...given: Given): Promise<Result> {
    const script = `return (${work}).apply(null, arguments)`
    // With the page's own globals; only Firefox has a choice.
    return (await this.#send('WebDriver:ExecuteScript', { script, args: given, sandbox: null })) as Result
  }

  /** Presses the mouse at the first point, moves it over the others, and lets go. */
  async drag(from: Point, ...over: readonly Point[]): Promise<void> {
    const move = ({ x, y }: Point) => ({
      type: 'pointerMove',
      origin: 'viewport',
      x: Math.round(x),
      y: Math.round(y),
      duration: 20,
    })
    await this.#perform({
      type: 'pointer',
      id: 'mouse',
      parameters: { pointerType: 'mouse' },
      actions: [move(from), { type: 'pointerDown', button: 0 }, ...over.map(move), { type: 'pointerUp', button: 0 }],
    })
  }

  async press(key: string): Promise<void> {
    await this.#perform({
      type: 'key',
      id: 'keyboard',
      actions: [
        { type: 'keyDown', value: key },
        { type: 'keyUp', value: key },
      ],
    })
  }

  async #perform(source: object): Promise<void> {
    await this.#send('WebDriver:PerformActions', { actions: [source] })
  }

  /** Also a browser that hangs. */
  async close(): Promise<void> {
    const goodbye = this.#send('WebDriver:DeleteSession', {}).catch(() => undefined)
    await Promise.race([goodbye, new Promise(resolve => setTimeout(resolve, 5000))])
    await end(this.#processes)
  }
}

/** A fresh profile in the folder, a fresh screen; the folder must not be used by another. */
export async function startBrowser(name: BrowserName, folder: string): Promise<Driver> {
  const processes: ChildProcess[] = []
  const start = (
    path: string | undefined,
    args: readonly string[],
    display = '',
    stdio: 'ignore' | 'pipe' = 'ignore',
  ) => {
    if (!path) throw new Error(`What ${name} needs is not installed: npm run setup -- --for test`)
    const env = { ...process.env, DISPLAY: display, LIBGL_ALWAYS_SOFTWARE: '1' }
    const child = spawn(path, args, { env, stdio: ['ignore', 'ignore', 'ignore', stdio] })
    processes.unshift(child)
    process.once('exit', () => child.kill('SIGKILL'))
    return child
  }
  try {
    const screen = start(findXvfb(), ['-displayfd', '3', '-screen', '0', '1280x800x24', '-nolisten', 'tcp'], '', 'pipe')
    const display = `:${await firstLine(screen.stdio[3] as Readable)}`
    const { send, capabilities } =
      name === 'firefox'
        ? await startFirefox(folder, args => start(findFirefox(), args, display))
        : await startWebKit(args => start(findWebKitDriver(), args, display))
    return new Driver(send, await send('WebDriver:NewSession', { capabilities }), processes)
  } catch (error) {
    await end(processes)
    throw error
  }
}

interface Started {
  readonly send: Send
  readonly capabilities: object
}

async function startFirefox(folder: string, start: (args: string[]) => ChildProcess): Promise<Started> {
  const profile = join(folder, 'profile')
  mkdirSync(profile, { recursive: true })
  writeFileSync(join(profile, 'user.js'), 'user_pref("marionette.port", 0);\n')
  const firefox = start(['--marionette', '--no-remote', '--profile', profile])
  const port = await until(firefox, () => Number(readFileSync(join(profile, 'MarionetteActivePort'), 'utf8')))
  const socket = createConnection(port, '127.0.0.1')
  await once(socket, 'connect')
  return { send: marionette(socket), capabilities: {} }
}

/** Messages are `length:[0, id, command, parameters]` and, back, `length:[1, id, error, result]`. */
function marionette(socket: Socket): Send {
  const waiting = new Map<number, { resolve(value: unknown): void; reject(error: Error): void }>()
  let received = Buffer.alloc(0)
  let lastId = 0
  socket.on('data', chunk => {
    received = Buffer.concat([received, chunk])
    for (let colon = received.indexOf(':'); colon > 0; colon = received.indexOf(':')) {
      const stop = colon + 1 + Number(received.subarray(0, colon))
      if (received.length < stop) return
      const message = JSON.parse(received.subarray(colon + 1, stop).toString())
      received = received.subarray(stop)
      if (!Array.isArray(message)) continue // the greeting
      const [, id, error, result] = message
      if (error) waiting.get(id)?.reject(new Error(`${error.error}: ${error.message}`))
      else waiting.get(id)?.resolve(result !== null && 'value' in result ? result.value : result)
      waiting.delete(id)
    }
  })
  socket.on('close', () => {
    for (const { reject } of waiting.values()) reject(new Error('Firefox has ended.'))
  })
  return (command, parameters) =>
    new Promise((resolve, reject) => {
      const text = JSON.stringify([0, ++lastId, command, parameters])
      waiting.set(lastId, { resolve, reject })
      socket.write(`${Buffer.byteLength(text)}:${text}`)
    })
}

const ROUTES: Readonly<Record<string, readonly [method: string, path: string]>> = {
  'WebDriver:NewSession': ['POST', ''],
  'WebDriver:Navigate': ['POST', '/url'],
  'WebDriver:Refresh': ['POST', '/refresh'],
  'WebDriver:SetWindowRect': ['POST', '/window/rect'],
  'WebDriver:ExecuteScript': ['POST', '/execute/sync'],
  'WebDriver:PerformActions': ['POST', '/actions'],
  'WebDriver:DeleteSession': ['DELETE', ''],
}

async function startWebKit(start: (args: string[]) => ChildProcess): Promise<Started> {
  const port = await freePort()
  const driver = start([`--port=${port}`, '--host=127.0.0.1'])
  await until(driver, async () => (await fetch(`http://127.0.0.1:${port}/status`)).ok)
  let session = `http://127.0.0.1:${port}/session`
  const send: Send = async (command, parameters) => {
    const [method, path] = ROUTES[command] as readonly [string, string]
    const body = method === 'POST' ? { body: JSON.stringify(parameters) } : {}
    const response = await fetch(session + path, { method, ...body })
    const { value } = (await response.json()) as { value: Record<string, unknown> | null }
    if (!response.ok) throw new Error(`${value?.error}: ${value?.message}`)
    if (command === 'WebDriver:NewSession') session += `/${value?.sessionId}`
    return value
  }
  return { send, capabilities: { alwaysMatch: {} } }
}

async function freePort(): Promise<number> {
  const server = createSocketServer().listen(0, '127.0.0.1')
  await once(server, 'listening')
  const { port } = server.address() as { port: number }
  server.close()
  return port
}

async function firstLine(stream: Readable): Promise<string> {
  let text = ''
  for await (const chunk of stream) {
    text += chunk
    if (text.includes('\n')) return text.trim()
  }
  throw new Error('The virtual screen ended at once.')
}

/** The first value of `look` that is something; while it throws or gives nothing the process is on its way. */
async function until<T>(child: ChildProcess, look: () => T | Promise<T>): Promise<T> {
  while (child.exitCode === null && child.signalCode === null) {
    try {
      const seen = await look()
      if (seen) return seen
    } catch {}
    await new Promise(resolve => setTimeout(resolve, 50))
  }
  throw new Error(`${child.spawnfile} ended at once.`)
}

/** Last the screen: what is left on it ends with it. */
async function end(processes: readonly ChildProcess[]): Promise<void> {
  for (const child of processes) {
    if (child.exitCode !== null || child.signalCode !== null) continue
    child.kill('SIGKILL')
    await once(child, 'exit')
  }
}
