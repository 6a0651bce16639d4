/** The core for one-file builds: wasm inside, as text that works from file:// too; its twin a file beside, asked for where wasm fails. */
import wasmUrl from '../../build/hexlens.wasm?url&inline'
import type { CoreSources } from '../core/start-core'

export const coreSources: CoreSources = {
  async wasm() {
    const base64 = wasmUrl.slice(wasmUrl.indexOf(',') + 1)
    return Uint8Array.from(atob(base64), character => character.charCodeAt(0))
  },
  twin: () => import('../../build/hexlens-twin.js'),
}
