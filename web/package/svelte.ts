/** The element, with its types and those of `<hex-mesh>` in templates of Svelte 5. */
import type { HTMLAttributes } from 'svelte/elements'
import type { HexLens } from '../element/hex-lens'
import type { HexMesh } from '../mesh-element/hex-mesh'
import type { HexLensAttributes, HexLensListeners, HexMeshAttributes, HexMeshListeners } from './authors'

export * from './hexlens'

export type HexLensProps = HTMLAttributes<HexLens> & HexLensAttributes & HexLensListeners

export type HexMeshProps = HTMLAttributes<HexMesh> & HexMeshAttributes & HexMeshListeners

declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'hex-lens': HexLensProps
    'hex-mesh': HexMeshProps
  }
}
