import type { Panel } from '../panel'
import { createMinimum, minimumStyles } from './minimum'

/** The numbers behind the verdict; below the checks, which more readers want. */
export const minimum: Panel = {
  name: 'minimum',
  region: 'panel',
  with: 'verdict',
  create: createMinimum,
  styles: minimumStyles,
}
