/** The core as files beside the page's. */
import wasmUrl from '../../build/hexlens.wasm?url'
import type { CoreSources } from './start-core'

export const coreFiles: CoreSources = {
  async wasm() {
    const response = await fetch(wasmUrl)
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim())
    return response.arrayBuffer()
  },
  twin: () => import('../../build/hexlens-twin.js'),
}
