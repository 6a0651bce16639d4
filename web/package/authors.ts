/** The elements in the templates of frameworks: their attributes and properties, and listeners of their events. */
import type { AttributeName } from '../element/attributes'
import type { HexLensEventMap } from '../element/events'
import type { HexLens } from '../element/hex-lens'
import type { CameraGoal } from '../element/script-arguments'
import type { HexMeshEventMap } from '../mesh-element/events'
import type { MeshAttribute } from '../mesh-element/mesh-attributes'

type Texts = { readonly [Name in Exclude<AttributeName, 'vertices' | 'camera' | 'readonly'>]?: string | undefined }

/** Attributes as texts, and properties as themselves. */
export interface HexLensAttributes extends Texts {
  readonly vertices?: string | ArrayLike<number> | undefined
  readonly camera?: string | CameraGoal | null | undefined
  readonly readonly?: boolean | '' | undefined
  readonly readOnly?: boolean | undefined
  readonly hiddenFaces?: string | readonly number[] | undefined
  readonly state?: HexLens['state'] | undefined
  readonly history?: HexLens['history'] | undefined
}

/** `onhex-change` and so on, as React 19, Preact and Svelte 5 write them. */
export type HexLensListeners = {
  readonly [Name in keyof HexLensEventMap as `on${Name}`]?: ((event: HexLensEventMap[Name]) => void) | undefined
}

/** Of `<hex-mesh>`, which `hexlens/hex-mesh` defines. */
export type HexMeshAttributes = { readonly [Name in MeshAttribute]?: string | undefined }

export type HexMeshListeners = {
  readonly [Name in keyof HexMeshEventMap as `on${Name}`]?: ((event: HexMeshEventMap[Name]) => void) | undefined
}
