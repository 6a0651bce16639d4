/** The element, with its types and those of `<hex-mesh>` in JSX of Preact. */
import type { HTMLAttributes } from 'preact'
import type { HexLens } from '../element/hex-lens'
import type { HexMesh } from '../mesh-element/hex-mesh'
import type { HexLensAttributes, HexLensListeners, HexMeshAttributes, HexMeshListeners } from './authors'

export * from './hexlens'

export type HexLensProps = HTMLAttributes<HexLens> & HexLensAttributes & HexLensListeners

export type HexMeshProps = HTMLAttributes<HexMesh> & HexMeshAttributes & HexMeshListeners

declare module 'preact' {
  namespace JSX {
    interface IntrinsicElements {
      'hex-lens': HexLensProps
      'hex-mesh': HexMeshProps
    }
  }
}
