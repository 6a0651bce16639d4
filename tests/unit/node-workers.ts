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

let bundle: Promise<string> | undefined

async function bundledWorker(): Promise<string> {
  const output = await build({
    root,
    configFile: false,
    logLevel: 'silent',
    build: { write: false, target: 'es2022', lib: { entry: 'web/core/batch/worker.ts', formats: ['es'] } },
  })
  const [result] = (Array.isArray(output) ? output : [output]) as { output: { code: string }[] }[]
  const code = result?.output[0]?.code
  if (code === undefined) throw new Error('The worker was not bundled.')
  return PRELUDE + code
}

/** Counts the threads it starts in `threads`. */
export async function nodeClassifier(
  workers: number,
  { module = batchModules.vectors, cellsPerPiece }: { module?: WebAssembly.Module; cellsPerPiece?: number } = {},
): Promise<Classifier & { readonly threads: { started: number } }> {
  bundle ??= bundledWorker()
  const url = new URL(`data:text/javascript,${encodeURIComponent(await bundle)}`)
  const threads = { started: 0 }
  const spawn = (): WorkerPort => {
    threads.started += 1
    const thread = new Worker(url)
    const port: WorkerPort = {
      postMessage: (request, transfer) => thread.postMessage(request, transfer),
      onmessage: null,
      onerror: null,
      terminate: () => void thread.terminate(),
    }
    thread.on('message', data => port.onmessage?.({ data }))
    thread.on('error', error => port.onerror?.(error as Error))
    return port
  }
  return { ...classifierOn(new Pool(module, workers, spawn, cellsPerPiece)), threads }
}
