/** The core for one-file builds: wasm inside, as text that works from file:// too; its twin a file beside, asked for where wasm fails. */
import base64 from 'virtual:hexlens.wasm.deflated'
import type { CoreSources } from '../core/start-core'

export const coreSources: CoreSources = {
  wasm: () => inflated(Uint8Array.from(atob(base64), character => character.charCodeAt(0))),
  twin: () => import('../../build/hexlens-twin.js'),
}

/** Without `Response`, which in Node brings a network client along, with wasm of its own. */
async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader()
  const chunks: Uint8Array<ArrayBuffer>[] = []
  for (let part = await reader.read(); !part.done; part = await reader.read()) chunks.push(part.value)
  return new Uint8Array(await new Blob(chunks).arrayBuffer())
}
