/** The core, fetched and started once for all elements on the page. */
import wasmUrl from '../../build/hexlens.wasm?url'
import { loadCore } from '../core/core'
import type { Core } from '../core/report'

let core: Promise<Core> | undefined

/** Rejects when the bytes cannot be had or the browser will not run them; a later call then tries again. */
export function fetchCore(): Promise<Core> {
  core ??= start().catch(reason => {
    core = undefined
    throw reason
  })
  return core
}

async function start(): Promise<Core> {
  const response = await fetch(wasmUrl)
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim())
  return loadCore(await response.arrayBuffer())
}
