/** Batches in the browser: the wasm and the workers as the built page serves them. */

import vectorUrl from '../../../build/hexlens-batch.wasm?url'
import scalarUrl from '../../../build/hexlens-scalar.wasm?url'
import type { Result } from '../report'
import { type Classification, type Classifier, type ClassifyOptions, classifierOn } from './classify'
import type { WorkerPort } from './messages'
import { Pool } from './pool'

/** More workers than that wait for memory. */
const MOST_WORKERS = 16

/** Rejects when the wasm cannot be had or may not run. */
export async function startClassifier(
  workers = Math.min(navigator.hardwareConcurrency, MOST_WORKERS),
): Promise<Classifier> {
  return classifierOn(new Pool(await batchModule(), workers, spawn))
}

let shared: Promise<Classifier> | undefined

/** With workers that all callers of the page share: see Classifier. */
export async function classify(
  points: Float64Array,
  cells: Uint32Array | null,
  options?: ClassifyOptions,
): Promise<Result<Classification>> {
  shared ??= startClassifier().catch(reason => {
    shared = undefined
    throw reason
  })
  return (await shared).classify(points, cells, options)
}

function spawn(): WorkerPort {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }) as unknown as WorkerPort
}

/** An engine without vectors refuses to compile them; it then gets the same code without. */
export async function batchModule(): Promise<WebAssembly.Module> {
  try {
    return await compiled(vectorUrl)
  } catch (reason) {
    if (!(reason instanceof WebAssembly.CompileError)) throw reason
    return compiled(scalarUrl)
  }
}

async function compiled(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url)
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim())
  return WebAssembly.compile(await response.arrayBuffer())
}
