/** What readers have done by wasm, as a file beside the built page's scripts. */
import wasmUrl from '../../build/hexlens-reading.wasm?url'
import type { ReadingCore } from '../mesh/reading-core'
import { readingCoreOf } from './reading-core'

export function readingFiles(): Promise<ReadingCore | null> {
  return readingCoreOf(async () => (await fetch(wasmUrl)).arrayBuffer())
}
