import { fold } from '../fold'
import type { Panel } from '../panel'

export const takeAway: Panel = fold({ name: 'take-away', title: 'Take away', load: () => import('./take-away') })
