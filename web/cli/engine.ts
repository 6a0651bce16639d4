/** The command line's wasm: from the sources, or from inside the package's one file. */
import type { Core } from '../core/report'

export interface Engine {
  readonly core: () => Promise<Core>
  readonly batchModule: () => Promise<WebAssembly.Module>
  /** A script that Node can evaluate in a thread. */
  readonly workerScript: () => Promise<string>
}
