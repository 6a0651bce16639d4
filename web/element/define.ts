/** Composes `<hex-lens>` of a core and the panels that it can show. Each build calls it once. */
import type { Composition } from './composition'
import { HexLens } from './hex-lens'

/** The class that is registered: a second script leaves the first one's alone. A server has no registry. */
export function define({ otherPanels = [], ...others }: Composition): typeof HexLens {
  HexLens.composition = { otherPanels, ...others }
  const { customElements: registry } = globalThis
  if (registry && !registry.get('hex-lens')) registry.define('hex-lens', HexLens)
  return (registry?.get('hex-lens') as typeof HexLens | undefined) ?? HexLens
}
