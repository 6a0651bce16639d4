/** The real workers in Node's threads, bundled as the builds do it. */
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { Worker, type WorkerOptions } from 'node:worker_threads'
import { build } from 'vite'
import { type BatchCore, loadBatchCore } from '../../web/core/batch/batch-core'
import { type Classifier, classifierOn } from '../../web/core/batch/classify'
import { threadPort } from '../../web/core/ports'
import type { WorkerPort } from '../../web/core/workers'

const root = fileURLToPath(new URL('../..', import.meta.url))

/** Modules with vectors, and without. */
export const batchModules = {
  vectors: new WebAssembly.Module(readFileSync(`${root}build/hexlens-batch.wasm`)),
  scalar: new WebAssembly.Module(readFileSync(`${root}build/hexlens-scalar.wasm`)),
}

export const batchCores: Record<keyof typeof batchModules, BatchCore> = {
  vectors: await loadBatchCore(batchModules.vectors),
  scalar: await loadBatchCore(batchModules.scalar),
}

const bundles = new Map<string, Promise<string>>()

/** A worker of web/ as one script. */
function bundled(entry: string): Promise<string> {
  const known = bundles.get(entry) ?? bundle(entry)
  bundles.set(entry, known)
  return known
}

async function bundle(entry: string): Promise<string> {
  const output = await build({
    root,
    configFile: false,
    logLevel: 'silent',
    build: { write: false, target: 'es2022', lib: { entry, formats: ['es'] } },
  })
  const [result] = (Array.isArray(output) ? output : [output]) as { output: { code: string }[] }[]
  const code = result?.output[0]?.code
  if (code === undefined) throw new Error('The worker was not bundled.')
  return code
}

function scriptUrl(script: string): URL {
  return new URL(`data:text/javascript,${encodeURIComponent(script)}`)
}

const allThreads = new Set<Worker>()

/** Waits for threads that are being ended: the process might crash if it ended first. */
export async function endThreads(): Promise<void> {
  await Promise.all([...allThreads].map(thread => thread.terminate()))
}

function threadOn(worker: URL, options?: WorkerOptions): Worker {
  const thread = new Worker(worker, options)
  allThreads.add(thread)
  return thread
}

/** Starts threads of a worker of web/; with a script that runs before its own. */
export async function threadsOf(entry: string, before = ''): Promise<() => WorkerPort> {
  const script = scriptUrl(before + (await bundled(entry)))
  return () => threadPort(threadOn(script))
}

interface NodeClassifierOptions {
  readonly module?: WebAssembly.Module
  readonly cellsPerPiece?: number
  readonly startWithin?: number
  /** The script of the worker of this number, from 0, before or instead of its own; its limits. */
  readonly worker?: (number: number) => { before?: string; script?: string } & WorkerOptions
}

/** Keeps the threads it starts in `threads`. */
export async function nodeClassifier(
  workers: number,
  { module = batchModules.vectors, worker = () => ({}), ...options }: NodeClassifierOptions = {},
): Promise<Classifier & { readonly threads: readonly Worker[] }> {
  const ownScript = await bundled('web/core/batch/worker.ts')
  const threads: Worker[] = []
  const spawn = (): WorkerPort => {
    const { before = '', script = ownScript, ...limits } = worker(threads.length)
    const thread = threadOn(scriptUrl(before + script), limits)
    threads.push(thread)
    return threadPort(thread)
  }
  return { ...classifierOn({ start: module, size: workers, spawn, ...options }), threads }
}
