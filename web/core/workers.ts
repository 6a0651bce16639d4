/**
 * Workers for batches, searches and reading: a pool for those who ask, `serve` for the worker's script. A worker is started once and
 * does one job after another. All memory of a message is handed over, none is copied.
 */

/** What the workers of one kind do: functions of a job, which may tell of their progress. */
type Jobs = Readonly<Record<string, (...given: never[]) => unknown>>
type Job<J extends Jobs, Kind extends keyof J> = Parameters<J[Kind]>[0]
type Tell<J extends Jobs, Kind extends keyof J> = Parameters<J[Kind]>[1]
type Answer<J extends Jobs, Kind extends keyof J> = Awaited<ReturnType<J[Kind]>>

/**
 * `given` is the job; for the kind `start`, which comes first, what the worker is started with; for the kind `back`, memory that it has told of and
 * may fill again.
 */
export interface Request {
  readonly kind: string
  readonly given: unknown
}

export type Reply =
  /** The worker holds the Web Lock of this name as long as it lives; null where there are no such locks. */
  | { readonly kind: 'started'; readonly lock: string | null }
  | { readonly kind: 'progress'; readonly progress: unknown }
  | { readonly kind: 'answer'; readonly answer: unknown }
  /** The worker is of no more use. */
  | { readonly kind: 'failed'; readonly message: string }

/** A worker of a page or a thread of Node: ports.ts. */
export interface WorkerPort {
  postMessage(request: Request, transfer: ArrayBuffer[]): void
  onreply: ((reply: Reply) => void) | null
  /** Called when the worker cannot be started or has ended without having been told to: the reason as a clause, null if none is known. */
  onbroken: ((reason: string | null) => void) | null
  terminate(): void
}

export interface WorkerOptions<Start = unknown> {
  /** A worker's name in sentences: "A worker for batches". */
  readonly name: string
  readonly spawn: () => WorkerPort
  readonly start: Start
  /** Milliseconds. */
  readonly startWithin?: number
}

export interface PoolOptions<Start> extends WorkerOptions<Start> {
  /** Workers; they are started when they are needed. */
  readonly size: number
}

/** A worker has its next job when it is done with one. */
const JOBS_AHEAD = 2

/** A guard against waiting for ever, not a measurement: a script may come over a slow line. */
const START_WITHIN = 60_000

/** Called with the progress, and with a function that gives memory of it back to the worker. */
type Listener<Progress> = (progress: Progress, giveBack: (memory: unknown) => void) => void

interface Watched {
  readonly caller: object
  /** The listener of this job, if there is one. */
  readonly onProgress: unknown
}

interface Task extends Watched {
  readonly resolve: (answer: never) => void
  readonly reject: (reason: unknown) => void
}

/**
 * Jobs go to whichever worker is free. A worker that fails, or is ended from outside, leaves the pool; the jobs that it had are refused
 * with a sentence, those of other workers go on. `run` starts another.
 */
export class Pool<Start, J extends Jobs> {
  readonly #options: PoolOptions<Start>
  readonly #workers = new Set<PoolWorker>()

  constructor(options: PoolOptions<Start>) {
    this.#options = options
  }

  /** Jobs that can be under way at once. */
  get capacity(): number {
    return this.#options.size * JOBS_AHEAD
  }

  /** The worker takes over all memory of the job. Jobs of one caller are cancelled together. */
  async run<Kind extends keyof J & string>(
    kind: Kind,
    job: Job<J, Kind>,
    { caller = this, onProgress }: { caller?: object; onProgress?: Listener<Parameters<Tell<J, Kind>>[0]> } = {},
  ): Promise<Answer<J, Kind>> {
    return this.#freest().run({ kind, given: job }, { caller, onProgress })
  }

  /** Ends the workers and with them what they have at hand; `run` starts new ones. */
  stop(reason: unknown): void {
    for (const worker of [...this.#workers]) worker.end(reason)
  }

  /** Refuses what a caller has under way. A worker that has nothing else to do is ended, the others finish it for nothing. */
  cancel(caller: object, reason: unknown): void {
    for (const worker of [...this.#workers]) worker.cancel(caller, reason)
  }

  #freest(): PoolWorker {
    const [first, ...others] = this.#workers
    const freest = others.reduce((a, b) => (a && b.load >= a.load ? a : b), first)
    if (freest && (freest.load === 0 || this.#workers.size >= this.#options.size)) return freest
    const worker = new PoolWorker(this.#options, () => this.#workers.delete(worker))
    this.#workers.add(worker)
    return worker
  }
}

/** One job for a worker of its own, which is ended with it. Rejects with the signal's reason if that aborts. */
export async function runAlone<J extends Jobs, Kind extends keyof J & string>(
  options: WorkerOptions,
  request: { readonly kind: Kind; readonly given: Job<J, Kind> },
  { signal, onProgress }: { readonly signal: AbortSignal | undefined; readonly onProgress: Tell<J, Kind> },
): Promise<Answer<J, Kind>> {
  let worker: PoolWorker | undefined
  const end = (reason?: unknown) => worker?.end(reason)
  return unlessAborted(signal, end, () => {
    worker = new PoolWorker(options, () => {})
    return worker.run(request, { caller: worker, onProgress })
  }).finally(() => end())
}

class PoolWorker {
  readonly #name: string
  readonly #port: WorkerPort
  readonly #onEnd: () => void
  readonly #tasks: Task[] = []
  readonly #deadline: ReturnType<typeof setTimeout>
  #problem = NOT_STARTED

  /** Throws if the worker cannot be started. */
  constructor({ name, spawn, start, startWithin = START_WITHIN }: WorkerOptions, onEnd: () => void) {
    this.#name = name
    this.#onEnd = onEnd
    this.#port = spawned(name, spawn, start)
    this.#port.onreply = reply => this.#take(reply)
    this.#port.onbroken = reason => this.#fail(reason)
    this.#deadline = setTimeout(() => this.#fail(`it has not answered for ${startWithin / 1000} s.`), startWithin)
  }

  get load(): number {
    return this.#tasks.length
  }

  run(request: Request, watched: Watched): Promise<never> {
    this.#port.postMessage(request, memoryOf(request.given))
    return new Promise((resolve, reject) => this.#tasks.push({ ...watched, resolve, reject }))
  }

  cancel(caller: object, reason: unknown): void {
    const own = this.#tasks.filter(task => task.caller === caller)
    for (const { reject } of own) reject(reason)
    if (own.length > 0 && own.length === this.#tasks.length) this.end(reason)
  }

  end(reason: unknown): void {
    clearTimeout(this.#deadline)
    this.#port.onreply = null
    this.#port.onbroken = null
    this.#port.terminate()
    this.#onEnd()
    for (const { reject } of this.#tasks.splice(0)) reject(reason)
  }

  #take(reply: Reply): void {
    if (reply.kind === 'started') {
      clearTimeout(this.#deadline)
      this.#problem = 'ended before it had answered'
    } else if (reply.kind === 'progress') this.#tell(reply.progress)
    else if (reply.kind === 'answer') this.#tasks.shift()?.resolve(reply.answer as never)
    else this.#fail(reply.message)
  }

  #tell(progress: unknown): void {
    const onProgress = this.#tasks[0]?.onProgress as Listener<unknown> | undefined
    onProgress?.(progress, memory => this.#port.postMessage({ kind: 'back', given: memory }, memoryOf(memory)))
  }

  #fail(reason: string | null): void {
    this.end(failureOf(this.#name, this.#problem, reason))
  }
}

function spawned(name: string, spawn: () => WorkerPort, start: unknown): WorkerPort {
  let port: WorkerPort | undefined
  try {
    port = spawn()
    port.postMessage({ kind: 'start', given: start }, [])
    return port
  } catch (reason) {
    port?.terminate()
    throw failureOf(name, NOT_STARTED, wordsOf(reason))
  }
}

const NOT_STARTED = 'did not start'

/** Engines word it differently: "could not allocate memory", "Array buffer allocation failed", "JS heap out of memory". */
const MEMORY = /memory|allocat/i

/** In a sentence, for a reason that is a clause. */
function failureOf(name: string, problem: string, reason: string | null): Error {
  if (reason === null) return new Error(`${name} ${problem}, perhaps for want of memory.`)
  return new Error(`${name} ${MEMORY.test(reason) ? 'ran out of memory' : problem}: ${reason}`)
}

/** An error of ours is a sentence; others say their kind. */
/** Words that end as a sentence does. */
export function sentenceOf(reason: unknown): string {
  return wordsOf(reason).replace(/[.]?$/, '.')
}

export function wordsOf(reason: unknown): string {
  return reason instanceof Error && reason.name === 'Error' ? reason.message : String(reason)
}

/** Does the work, and calls back if the signal aborts meanwhile. Rejects if it has aborted before. */
export async function unlessAborted<T>(
  signal: AbortSignal | undefined,
  onAbort: (reason: unknown) => void,
  work: () => Promise<T>,
): Promise<T> {
  signal?.throwIfAborted()
  const listener = () => onAbort(signal?.reason)
  signal?.addEventListener('abort', listener)
  return work().finally(() => signal?.removeEventListener('abort', listener))
}

/** The memory of the lists in a message and in the plain objects of which it is made. */
export function memoryOf(message: unknown, found: ArrayBuffer[] = []): ArrayBuffer[] {
  const value = ArrayBuffer.isView(message) ? message.buffer : message
  if (value instanceof ArrayBuffer) {
    if (!found.includes(value)) found.push(value)
  } else if (typeof value === 'object' && value !== null && !Array.isArray(value))
    for (const part of Object.values(value)) memoryOf(part, found)
  return found
}

interface Scope {
  onmessage: ((event: { readonly data: Request }) => void) | null
  postMessage(reply: Reply, transfer: ArrayBuffer[]): void
}

/**
 * Serves in a worker of a page or in a thread of Node; `name` is that of its lock. If anything rejects, the worker is of no more use. What comes back
 * does so at any time.
 */
export function serve<Start, J extends Jobs>(
  name: string,
  start: (given: Start) => J | Promise<J>,
  takeBack: (memory: never) => void = () => {},
): void {
  const isInBrowser = 'postMessage' in globalThis
  const scope = isInBrowser ? (globalThis as unknown as Scope) : threadScope()
  let jobs: J
  let turn: Promise<unknown> = Promise.resolve()

  const reply = (message: Reply) => scope.postMessage(message, memoryOf(message))

  async function answer({ kind, given }: Request): Promise<void> {
    if (kind === 'start') {
      const [made, lock] = await Promise.all([start(given as Start), isInBrowser ? heldLock(name) : null])
      jobs = made
      reply({ kind: 'started', lock })
    } else {
      const tell = (progress: unknown) => reply({ kind: 'progress', progress })
      reply({ kind: 'answer', answer: await jobs[kind]?.(given as never, tell as never) })
    }
  }

  scope.onmessage = ({ data }) => {
    if (data.kind === 'back') return takeBack(data.given as never)
    turn = turn.then(() => answer(data)).catch(reason => reply({ kind: 'failed', message: wordsOf(reason) }))
  }
}

/** A thread of Node has its messages elsewhere. */
function threadScope(): Scope {
  const port = process.getBuiltinModule('node:worker_threads').parentPort
  if (!port) throw new Error('This script is a worker, and was not started as one.')
  const scope: Scope = { onmessage: null, postMessage: (reply, transfer) => port.postMessage(reply, transfer) }
  port.on('message', data => scope.onmessage?.({ data }))
  return scope
}

/** Nothing but the release of a lock that it holds tells a page of a worker that was ended from outside. Null if there are no locks. */
function heldLock(prefix: string): Promise<string | null> {
  return new Promise(resolve => {
    if (!navigator.locks) return resolve(null)
    const name = `${prefix}-${crypto.randomUUID()}`
    const held = () => {
      resolve(name)
      return new Promise<never>(() => {})
    }
    navigator.locks.request(name, held).catch(() => resolve(null))
  })
}

/** Milliseconds: progress is to be seen ten times a second. */
const PROGRESS_INTERVAL = 50

/** Tells at most so often. */
export function seldom<Progress>(tell: (progress: Progress) => void): (progress: Progress) => void {
  let told = performance.now()
  return progress => {
    const now = performance.now()
    if (now - told < PROGRESS_INTERVAL) return
    told = now
    tell(progress)
  }
}
