/**
 * The core by WebAssembly or, where a page's policy forbids that, a browser has it switched off, or its bytes do not
 * arrive, by its twin: JavaScript made of the same wasm, slower and of the same bits.
 */
import { type CoreExports, coreOf, loadCore } from './core'
import type { Core } from './report'

export interface CoreSources {
  /** The bytes of hexlens.wasm. */
  wasm(): Promise<BufferSource>
  /** hexlens-twin.js as a module; asked for only where wasm fails. */
  twin(): Promise<CoreExports>
}

/** Rejects with both reasons where neither starts. */
export async function startCore({ wasm, twin }: CoreSources): Promise<Core> {
  try {
    return await loadCore(await wasm())
  } catch (reason) {
    try {
      return coreOf(await twin())
    } catch (twinReason) {
      throw new Error(`${sentence(reason)}; its twin in JavaScript: ${sentence(twinReason)}`)
    }
  }
}

function sentence(reason: unknown): string {
  return reason instanceof Error ? reason.message : String(reason)
}
