import { expect, it, vi } from 'vitest'

it('importing the elements where there is no page does no harm', async () => {
  expect(['HTMLElement', 'document', 'customElements', 'CSSStyleSheet'].filter(name => name in globalThis)).toEqual([])
  // Other files' imports must not stand in for this one.
  vi.resetModules()
  await import('../../web/pages/element')
  const { HexLens } = await import('../../web/element/hex-lens')
  expect(HexLens.observedAttributes).toContain('vertices')
  const { HexMesh } = await import('../../web/mesh-element/hex-mesh')
  expect(HexMesh.observedAttributes).toContain('src')
})
