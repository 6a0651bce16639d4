import type { Panel } from '../panel'
import { createVerdict, verdictStyles } from './verdict'

export const verdict: Panel = { name: 'verdict', region: 'panel', create: createVerdict, styles: verdictStyles }
