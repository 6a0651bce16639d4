import type { Panel } from '../panel'
import { createReading, readingStyles } from './reading'

export const reading: Panel = {
  name: 'reading',
  region: 'panel',
  create: createReading,
  styles: readingStyles,
  with: 'paste',
  changes: true,
}
