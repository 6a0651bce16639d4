/** `<hex-lens>` out of what it is given: the core, and the panels that it can show. Each build has an entry that calls this once. */
import type { Composition } from './composition'
import { HexLens } from './hex-lens'

/** On a server there is nothing to define it in; on a page a second script leaves the first one's element alone. */
export function define({ otherPanels = [], ...others }: Composition): void {
  HexLens.composition = { otherPanels, ...others }
  if (globalThis.customElements && !customElements.get('hex-lens')) customElements.define('hex-lens', HexLens)
}
