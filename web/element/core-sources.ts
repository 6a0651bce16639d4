/** The core as files beside the page's; one-file builds take web/package/core-inside.ts in its place. */
import wasmUrl from '../../build/hexlens.wasm?url'
import type { CoreSources } from '../core/start-core'

export const coreSources: CoreSources = {
  async wasm() {
    const response = await fetch(wasmUrl)
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim())
    return response.arrayBuffer()
  },
  twin: () => import('../../build/hexlens-twin.js'),
}
