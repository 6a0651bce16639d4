/** What batches run with: wasm and the workers' script from the sources; the package has both inside, web/package/batch-inside.ts. */
import { readFile } from 'node:fs/promises'
import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import { compiledOf } from '../core/batch/start'

export function batchModule(): Promise<WebAssembly.Module> {
  return compiledOf({ vectors: () => built('hexlens-batch.wasm'), scalar: () => built('hexlens-scalar.wasm') })
}

async function built(name: string): Promise<BufferSource> {
  return readFile(new URL(`../../build/${name}`, import.meta.url))
}

/** A script that Node can evaluate in a thread. */
export async function workerScript(): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [fileURLToPath(new URL('../core/batch/worker.ts', import.meta.url))],
    bundle: true,
    write: false,
    format: 'iife',
    target: 'es2022',
  })
  return outputFiles[0]?.text ?? ''
}
