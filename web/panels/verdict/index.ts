import type { Panel } from '../panel'
import { createVerdict, verdictStyles } from './verdict'

export const verdict: Panel = { name: 'verdict', place: 'panel', create: createVerdict, styles: verdictStyles }
