/** The command line's wasm: from the sources, or from inside the package's one file. */
import type { ReadingCore } from '../core/reading-interface'
import type { RepairCore } from '../core/repair/best-place'
import type { Core } from '../core/report'
import type { Hdf5Loading } from '../mesh/hdf5-reader'

export interface Engine {
  readonly core: () => Promise<Core>
  /** Null where there is none; readers then do without. */
  readonly readingCore: () => Promise<ReadingCore | null>
  readonly repairCore: () => Promise<RepairCore>
  readonly hdf5: Hdf5Loading
  readonly batchModule: () => Promise<WebAssembly.Module>
  /** A script that Node can evaluate in a thread. */
  readonly workerScript: () => Promise<string>
}
