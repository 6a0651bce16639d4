/** The core for one-file builds: wasm inside, as text that works from file:// too; its twin a file beside, asked for where wasm fails. */
import base64 from 'virtual:hexlens.wasm.deflated'
import type { CoreSources } from '../core/start-core'
import { inflated } from './inflate'

export const coreInside: CoreSources = {
  wasm: () => inflated(base64),
  twin: () => import('../../build/hexlens-twin.js'),
}
