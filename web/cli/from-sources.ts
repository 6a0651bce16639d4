/** The command line from the sources: wasm out of build/, the workers' script bundled when it is needed. tools/hexlens.mjs runs it. */
import { readFile } from 'node:fs/promises'
import { fileURLToPath } from 'node:url'
import { build } from 'esbuild'
import { compiledOf } from '../core/batch/start'
import { loadCore } from '../core/core'
import { readingCoreOf } from '../core/reading-core'
import type { Engine } from './engine'
import { main as run } from './main'
import type { Streams } from './streams'

const engine: Engine = {
  core: async () => loadCore(await built('hexlens.wasm')),
  readingCore: () => readingCoreOf(() => built('hexlens-reading.wasm')),
  batchModule: () =>
    compiledOf({ vectors: () => built('hexlens-batch.wasm'), scalar: () => built('hexlens-scalar.wasm') }),
  async workerScript() {
    const { outputFiles } = await build({
      entryPoints: [fileURLToPath(new URL('../core/batch/worker.ts', import.meta.url))],
      bundle: true,
      write: false,
      format: 'iife',
      target: 'es2022',
    })
    return outputFiles[0]?.text ?? ''
  },
}

export function main(args: readonly string[], streams?: Streams): Promise<number> {
  return run(args, engine, streams)
}

async function built(name: string): Promise<BufferSource> {
  return readFile(new URL(`../../build/${name}`, import.meta.url))
}
