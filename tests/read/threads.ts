/** Reads many mutations on threads. A thread that does not come back from one is ended, which is that mutation's fault. */
import { fileURLToPath } from 'node:url'
import { Worker } from 'node:worker_threads'
import { build } from 'esbuild'

export interface Read {
  readonly number: number
  readonly outcome: 'mesh' | 'sentence'
  /** Null if nothing is wrong. */
  readonly fault: string | null
  readonly milliseconds: number
  readonly timesRead: number
}

/** Far beyond what a reading may take, however busy the machine is. */
const HANGS_AFTER = 60_000
/** The memory that V8 may have for objects, in MB: no file here needs as much. */
const HEAP_MEGABYTES = 512

interface Numbers {
  readonly seed: number
  readonly from: number
  readonly to: number
  readonly threads: number
}

/** Calls `onRead` for each number once, in no order. */
export async function readMutations(numbers: Numbers, onRead: (read: Read) => void): Promise<void> {
  const script = await bundledWorker()
  const { seed, from, to, threads: step } = numbers
  await Promise.all(Array.from({ length: step }, (_, i) => readOn(script, { seed, from: from + i, to, step }, onRead)))
}

interface Share {
  readonly seed: number
  readonly from: number
  readonly to: number
  readonly step: number
}

/** One thread after another, each going on behind the number at which the one before has ended. */
async function readOn(script: URL, share: Share, onRead: (read: Read) => void): Promise<void> {
  for (let from = share.from; from < share.to; ) {
    const ended = await readUntilEnd(script, { ...share, from }, onRead)
    if (ended === null) return
    const fault = `the thread ${ended.why}`
    onRead({ number: ended.number, outcome: 'sentence', fault, milliseconds: HANGS_AFTER, timesRead: 0 })
    from = ended.number + share.step
  }
}

/** Null where all has been read; else the number at which the thread ended before its time. */
function readUntilEnd(
  script: URL,
  share: Share,
  onRead: (read: Read) => void,
): Promise<{ number: number; why: string } | null> {
  return new Promise(resolve => {
    const thread = new Worker(script, {
      workerData: share,
      resourceLimits: { maxOldGenerationSizeMb: HEAP_MEGABYTES },
    })
    let number = share.from
    let why: string | null = null
    let timer = setTimeout(() => {}, 0)
    const watch = () => {
      clearTimeout(timer)
      timer = setTimeout(() => {
        why = `was still reading after ${HANGS_AFTER / 1000} s`
        void thread.terminate()
      }, HANGS_AFTER)
    }
    watch()
    thread.on('message', (message: { begun: number } | Read) => {
      watch()
      if ('begun' in message) number = message.begun
      else onRead(message)
    })
    thread.on('error', error => {
      why = `ended with ${error.message}`
    })
    thread.on('exit', () => {
      clearTimeout(timer)
      resolve(why === null ? null : { number, why })
    })
  })
}

async function bundledWorker(): Promise<URL> {
  const entry = new URL('worker.ts', import.meta.url)
  const { outputFiles } = await build({
    entryPoints: [fileURLToPath(entry)],
    bundle: true,
    write: false,
    format: 'esm',
    platform: 'node',
    target: 'node20',
    sourcemap: 'inline',
    sourcesContent: false,
    // The tests' own files, which lie in one folder.
    define: { 'import.meta.url': JSON.stringify(entry.href) },
  })
  const [script] = outputFiles
  if (script === undefined) throw new Error('The worker was not bundled.')
  return new URL(`data:text/javascript,${encodeURIComponent(script.text)}`)
}
