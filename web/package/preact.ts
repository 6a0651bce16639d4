/** The element, with its types in JSX of Preact. */
import type { HTMLAttributes } from 'preact'
import type { HexLens } from '../element/hex-lens'
import type { HexLensAttributes, HexLensListeners } from './authors'

export * from './hexlens'

export type HexLensProps = HTMLAttributes<HexLens> & HexLensAttributes & HexLensListeners

declare module 'preact' {
  namespace JSX {
    interface IntrinsicElements {
      'hex-lens': HexLensProps
    }
  }
}
