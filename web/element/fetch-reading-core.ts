/** What readers have done by wasm, fetched by the page's worker: `readMeshes(file, { core: await fetchReadingCore() })`. */
import wasmUrl from '../../build/hexlens-reading.wasm?url'
import { readingCoreOf } from '../core/reading-core'
import type { ReadingCore } from '../mesh/reading-core'

export function fetchReadingCore(): Promise<ReadingCore | null> {
  return readingCoreOf(async () => (await fetch(wasmUrl)).arrayBuffer())
}
