/** The element, with its types and those of `<hex-mesh>` in JSX of React 19. */
import type { DetailedHTMLProps, HTMLAttributes } from 'react'
import type { HexLens } from '../element/hex-lens'
import type { HexMesh } from '../mesh-element/hex-mesh'
import type { HexLensAttributes, HexLensListeners, HexMeshAttributes, HexMeshListeners } from './authors'

export * from './hexlens'

export type HexLensProps = DetailedHTMLProps<HTMLAttributes<HexLens>, HexLens> & HexLensAttributes & HexLensListeners

export type HexMeshProps = DetailedHTMLProps<HTMLAttributes<HexMesh>, HexMesh> & HexMeshAttributes & HexMeshListeners

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'hex-lens': HexLensProps
      'hex-mesh': HexMeshProps
    }
  }
}
