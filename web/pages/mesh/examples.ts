/** Meshes that the page makes itself. */
import { partFile } from './part'
import { thrownBlockFile } from './thrown-block'

export interface Example {
  readonly name: string
  /** What one sees. */
  readonly sentence: string
  file(): File
}

export const EXAMPLES: readonly [Example, ...Example[]] = [
  { name: 'Elbow of a pipe', sentence: 'An example: an elbow of a pipe with some points misplaced.', file: partFile },
  {
    name: 'Block to untangle',
    sentence:
      'An example: a block in which some inner vertices were thrown about. Drag one back, or untangle them all.',
    file: thrownBlockFile,
  },
]
