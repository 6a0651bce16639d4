/** The core from its file; the package's command line has it inside, web/package/core-inside.ts. */
import { readFile } from 'node:fs/promises'
import { loadCore } from '../core/core'
import type { Core } from '../core/report'

export async function fetchCore(): Promise<Core> {
  return loadCore(await readFile(new URL('../../build/hexlens.wasm', import.meta.url)))
}
