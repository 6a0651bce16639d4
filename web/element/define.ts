/** `<hex-lens>` out of what it is given: the core, and the panels that it can show. Each build has an entry that calls this once. */
import type { CoreSources } from '../core/start-core'
import type { StartReadingWorker } from '../input/read-input'
import type { Panel } from '../panels/panel'
import { HexLens } from './hex-lens'

export interface Composition {
  readonly core: CoreSources
  readonly panels: readonly Panel[]
  /** For what is pasted, dropped or opened; called with the first of it. */
  readonly startReadingWorker: StartReadingWorker
  /** Names in the attribute `views` that mean panels of other builds. */
  readonly otherPanels?: readonly string[]
}

/** On a server there is nothing to define it in; on a page a second script leaves the first one's element alone. */
export function define({ core, panels, startReadingWorker, otherPanels = [] }: Composition): void {
  HexLens.composition = { core, panels, startReadingWorker, otherPanels }
  if (globalThis.customElements && !customElements.get('hex-lens')) customElements.define('hex-lens', HexLens)
}
