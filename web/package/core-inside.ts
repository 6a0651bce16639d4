/** The core for one-file builds: wasm inside, as text that works from file:// too; its twin a file beside, asked for where wasm fails. */
import base64 from 'virtual:hexlens.wasm.deflated'
import type { CoreSources } from '../core/start-core'

export const coreSources: CoreSources = {
  wasm() {
    const deflated = Uint8Array.from(atob(base64), character => character.charCodeAt(0))
    const bytes = new Blob([deflated]).stream().pipeThrough(new DecompressionStream('deflate'))
    return new Response(bytes).arrayBuffer()
  },
  twin: () => import('../../build/hexlens-twin.js'),
}
