/** The element, with its types in JSX of React 19. */
import type { DetailedHTMLProps, HTMLAttributes } from 'react'
import type { HexLens } from '../element/hex-lens'
import type { HexLensAttributes, HexLensListeners } from './authors'

export * from './hexlens'

export type HexLensProps = DetailedHTMLProps<HTMLAttributes<HexLens>, HexLens> & HexLensAttributes & HexLensListeners

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'hex-lens': HexLensProps
    }
  }
}
