/** A classifier's start on any host: wasm that the engine takes, as many workers as help. */

type Bytes = () => Promise<BufferSource>

/** An engine without vectors refuses to compile them; it then gets the same code without. */
export async function compiledOf({
  vectors,
  scalar,
}: Record<'vectors' | 'scalar', Bytes>): Promise<WebAssembly.Module> {
  if (!globalThis.WebAssembly) throw new Error('Batches need WebAssembly, which is missing here.')
  const withVectors = await vectors()
  try {
    return await WebAssembly.compile(withVectors)
  } catch (reason) {
    if (!(reason instanceof WebAssembly.CompileError)) throw reason
  }
  const without = await scalar()
  try {
    return await WebAssembly.compile(without)
  } catch (reason) {
    throw new Error(`Batches need WebAssembly, which may not run here: ${(reason as Error).message}`, { cause: reason })
  }
}

/** More workers than that wait for memory. */
const MOST_WORKERS = 16

export function defaultWorkers(): number {
  const cores = globalThis.navigator?.hardwareConcurrency ?? process.getBuiltinModule('node:os').availableParallelism()
  return Math.min(cores, MOST_WORKERS)
}
