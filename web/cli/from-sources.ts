/** The command line from the sources: wasm out of build/, the workers' script and the reader of HDF5 files bundled when they are needed. tools/hexlens.mjs runs it. */
import { readFile } from 'node:fs/promises'
import { fileURLToPath } from 'node:url'
import { runInThisContext } from 'node:vm'
import { build } from 'esbuild'
import { compiledOf } from '../core/batch/start'
import { loadCore } from '../core/core'
import { readingCoreOf } from '../core/reading-core'
import { loadRepairCore } from '../core/repair/repair-core'
import type { startHdf5 } from '../mesh/hdf5/start'
import { Hdf5Loading } from '../mesh/hdf5-reader'
import type { Engine } from './engine'
import { main as run } from './main'
import type { Streams } from './streams'

const engine: Engine = {
  core: async () => loadCore(await built('hexlens.wasm')),
  readingCore: () => readingCoreOf(() => built('hexlens-reading.wasm')),
  repairCore: async () => loadRepairCore(await built('hexlens-repair.wasm')),
  hdf5: new Hdf5Loading(async () => {
    const script = await bundled('../mesh/hdf5/start.ts')
    return (runInThisContext(`${script};hexlens`) as { startHdf5: typeof startHdf5 }).startHdf5()
  }),
  batchModule: () =>
    compiledOf({ vectors: () => built('hexlens-batch.wasm'), scalar: () => built('hexlens-scalar.wasm') }),
  workerScript: () => bundled('../core/batch/worker.ts'),
}

export function main(args: readonly string[], streams?: Streams): Promise<number> {
  return run(args, engine, streams)
}

async function bundled(path: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [fileURLToPath(new URL(path, import.meta.url))],
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'hexlens',
    target: 'es2022',
    logOverride: { 'empty-import-meta': 'silent' },
  })
  return outputFiles[0]?.text ?? ''
}

async function built(name: string): Promise<BufferSource> {
  return readFile(new URL(`../../build/${name}`, import.meta.url))
}
