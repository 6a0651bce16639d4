/** The element, with its types in templates of Svelte 5. */
import type { HTMLAttributes } from 'svelte/elements'
import type { HexLens } from '../element/hex-lens'
import type { HexLensAttributes, HexLensListeners } from './authors'

export * from './hexlens'

export type HexLensProps = HTMLAttributes<HexLens> & HexLensAttributes & HexLensListeners

declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'hex-lens': HexLensProps
  }
}
