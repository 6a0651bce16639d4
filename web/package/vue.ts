/** The element, with its types and those of `<hex-mesh>` in templates of Vue 3. */
import type { EmitFn, HTMLAttributes, PublicProps } from 'vue'
import type { HexLensEventMap } from '../element/events'
import type { HexMeshEventMap } from '../mesh-element/events'
import type { HexLensAttributes, HexMeshAttributes } from './authors'

export * from './hexlens'

type Emitted<EventMap> = { [Name in keyof EventMap]: (event: EventMap[Name]) => void }

/** The element as a component's instance, which is how Vue looks at all tags. */
export interface HexLensComponent {
  new (): { $props: PublicProps & HTMLAttributes & HexLensAttributes; $emit: EmitFn<Emitted<HexLensEventMap>> }
}

export interface HexMeshComponent {
  new (): { $props: PublicProps & HTMLAttributes & HexMeshAttributes; $emit: EmitFn<Emitted<HexMeshEventMap>> }
}

declare module 'vue' {
  interface GlobalComponents {
    'hex-lens': HexLensComponent
    'hex-mesh': HexMeshComponent
  }
}
