/** Composes `<hex-lens>` of a core and the panels that it can show. Each build calls it once. */
import type { Composition } from './composition'
import { HexLens } from './hex-lens'

/** A server has no registry; a second script leaves the first one's element alone. */
export function define({ otherPanels = [], ...others }: Composition): void {
  HexLens.composition = { otherPanels, ...others }
  if (globalThis.customElements && !customElements.get('hex-lens')) customElements.define('hex-lens', HexLens)
}
