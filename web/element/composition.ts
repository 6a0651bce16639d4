/** The parts of a build: `define` composes the element of them. */
import type { CoreSources } from '../core/start-core'
import type { ReadingWorker } from '../input/input-reader'
import type { Panel } from '../panels/panel'

export interface Composition {
  readonly core: CoreSources
  readonly panels: readonly Panel[]
  readonly readingWorker: ReadingWorker
  /** Names in the attribute `views` that mean panels of other builds. */
  readonly otherPanels?: readonly string[]
}
