/** The readers' wasm inside one file. */
import base64 from 'virtual:hexlens-reading.wasm.deflated'
import { readingCoreOf } from '../core/reading-core'
import type { ReadingCore } from '../core/reading-interface'
import { inflated } from './inflate'

export function readingInside(): Promise<ReadingCore | null> {
  return readingCoreOf(() => inflated(base64))
}
