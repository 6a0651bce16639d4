/** `<hex-lens>` out of what it is given: the core, and the panels that it can show. Each build has an entry that calls this once. */
import type { CoreSources } from '../core/start-core'
import type { Panel } from '../panels/panel'
import { HexLens } from './hex-lens'

export interface Composition {
  readonly core: CoreSources
  readonly panels: readonly Panel[]
  /** Names in the attribute `views` that mean panels of other builds. */
  readonly otherPanels?: readonly string[]
}

/** On a server there is nothing to define it in; on a page a second script leaves the first one's element alone. */
export function define({ core, panels, otherPanels = [] }: Composition): void {
  HexLens.composition = { core, panels, otherPanels }
  if (globalThis.customElements && !customElements.get('hex-lens')) customElements.define('hex-lens', HexLens)
}
