import { expect, it, vi } from 'vitest'

it('importing the element where there is no page does no harm', async () => {
  expect(['HTMLElement', 'document', 'customElements', 'CSSStyleSheet'].filter(name => name in globalThis)).toEqual([])
  // Other files' imports must not stand in for this one.
  vi.resetModules()
  await import('../../web/pages/element')
  const { HexLens } = await import('../../web/element/hex-lens')
  expect(HexLens.observedAttributes).toContain('vertices')
})
