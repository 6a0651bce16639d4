/** The readers' wasm as a file beside the built page's scripts. */
import wasmUrl from '../../build/hexlens-reading.wasm?url'
import { readingCoreOf } from './reading-core'
import type { ReadingCore } from './reading-interface'

export function readingFiles(): Promise<ReadingCore | null> {
  return readingCoreOf(async () => (await fetch(wasmUrl)).arrayBuffer())
}
