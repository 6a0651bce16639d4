/** The core, fetched and started once for all elements on the page. */
import type { Core } from './report'
import { type CoreSources, startCore } from './start-core'

const cores = new WeakMap<CoreSources, Promise<Core>>()

/** Rejects when it can be had neither as wasm nor as JavaScript; a later call then tries again. */
export function fetchCore(sources: CoreSources): Promise<Core> {
  const core =
    cores.get(sources) ??
    startCore(sources).catch(reason => {
      cores.delete(sources)
      throw reason
    })
  cores.set(sources, core)
  return core
}
