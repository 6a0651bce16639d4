import { fold } from '../fold'
import type { Panel } from '../panel'

export const inside: Panel = fold({ name: 'inside', title: 'Inside', load: () => import('./inside-panel') })
