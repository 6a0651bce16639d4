/** The core, fetched and started once for all elements on the page. */
import type { Core } from '../core/report'
import { startCore } from '../core/start-core'
import { coreSources } from './core-sources'

let core: Promise<Core> | undefined

/** Rejects when it can be had neither as wasm nor as JavaScript; a later call then tries again. */
export function fetchCore(): Promise<Core> {
  core ??= startCore(coreSources).catch(reason => {
    core = undefined
    throw reason
  })
  return core
}
