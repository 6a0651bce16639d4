/** The real workers in Node's threads: worker.ts bundled as the page's build does it, and a browser's Worker on top of a thread. */
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { Worker } from 'node:worker_threads'
import { build } from 'vite'
import { type BatchCore, loadBatchCore } from '../../web/core/batch/batch-core'
import { type Classifier, classifierOn } from '../../web/core/batch/classify'
import type { WorkerPort } from '../../web/core/batch/messages'
import { Pool } from '../../web/core/batch/pool'

const root = fileURLToPath(new URL('../..', import.meta.url))

/** With vectors, and without. */
export const batchModules = {
  vectors: new WebAssembly.Module(readFileSync(`${root}build/hexlens-batch.wasm`)),
  scalar: new WebAssembly.Module(readFileSync(`${root}build/hexlens-scalar.wasm`)),
}

export const batchCores: Record<keyof typeof batchModules, BatchCore> = {
  vectors: await loadBatchCore(batchModules.vectors),
  scalar: await loadBatchCore(batchModules.scalar),
}

const PRELUDE = `const { parentPort } = await import('node:worker_threads')
globalThis.postMessage = (message, transfer) => parentPort.postMessage(message, transfer)
parentPort.on('message', data => globalThis.onmessage({ data }))
`

const bundles = new Map<string, Promise<URL>>()

/** The address of a worker of web/, bundled. */
export function bundledWorker(entry: string): Promise<URL> {
  const known = bundles.get(entry) ?? bundled(entry)
  bundles.set(entry, known)
  return known
}

async function bundled(entry: string): Promise<URL> {
  const output = await build({
    root,
    configFile: false,
    logLevel: 'silent',
    build: { write: false, target: 'es2022', lib: { entry, formats: ['es'] } },
  })
  const [result] = (Array.isArray(output) ? output : [output]) as { output: { code: string }[] }[]
  const code = result?.output[0]?.code
  if (code === undefined) throw new Error('The worker was not bundled.')
  return new URL(`data:text/javascript,${encodeURIComponent(PRELUDE + code)}`)
}

interface Port<Request, Answer> {
  postMessage(request: Request, transfer?: ArrayBuffer[]): void
  onmessage: ((event: { readonly data: Answer }) => void) | null
  onerror: ((event: { readonly message?: string }) => void) | null
  terminate(): void
}

const allThreads = new Set<Worker>()

/** Before the process ends: it may crash on threads that are still being ended then. */
export async function endThreads(): Promise<void> {
  await Promise.all([...allThreads].map(thread => thread.terminate()))
}

export function nodePort<Request, Answer>(worker: URL): Port<Request, Answer> {
  const thread = new Worker(worker)
  allThreads.add(thread)
  const port: Port<Request, Answer> = {
    postMessage: (request, transfer) => thread.postMessage(request, transfer),
    onmessage: null,
    onerror: null,
    terminate: () => void thread.terminate(),
  }
  thread.on('message', data => port.onmessage?.({ data }))
  thread.on('error', error => port.onerror?.(error as Error))
  return port
}

/** Counts the threads it starts in `threads`. */
export async function nodeClassifier(
  workers: number,
  { module = batchModules.vectors, cellsPerPiece }: { module?: WebAssembly.Module; cellsPerPiece?: number } = {},
): Promise<Classifier & { readonly threads: { started: number } }> {
  const worker = await bundledWorker('web/core/batch/worker.ts')
  const threads = { started: 0 }
  const spawn = (): WorkerPort => {
    threads.started += 1
    return nodePort(worker)
  }
  return { ...classifierOn(new Pool(module, workers, spawn, cellsPerPiece)), threads }
}
