/** The element, with its types in templates of Vue 3. */
import type { EmitFn, HTMLAttributes, PublicProps } from 'vue'
import type { HexLensEventMap } from '../element/events'
import type { HexLensAttributes } from './authors'

export * from './hexlens'

type Emitted = { [Name in keyof HexLensEventMap]: (event: HexLensEventMap[Name]) => void }

/** The element as a component's instance, which is how Vue looks at all tags. */
export interface HexLensComponent {
  new (): { $props: PublicProps & HTMLAttributes & HexLensAttributes; $emit: EmitFn<Emitted> }
}

declare module 'vue' {
  interface GlobalComponents {
    'hex-lens': HexLensComponent
  }
}
