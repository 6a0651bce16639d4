/** What readers have done by wasm, from its file; the package's command line has it inside, web/package/reading-inside.ts. */
import { readFile } from 'node:fs/promises'
import { readingCoreOf } from '../core/reading-core'
import type { ReadingCore } from '../mesh/reading-core'

export function fetchReadingCore(): Promise<ReadingCore | null> {
  return readingCoreOf(() => readFile(new URL('../../build/hexlens-reading.wasm', import.meta.url)))
}
