import { fold } from '../fold'
import type { Panel } from '../panel'
import { followingSlice } from './following'

export const algorithm: Panel = {
  ...fold({ name: 'algorithm', title: 'Algorithm 1, step by step', load: () => import('./algorithm') }),
  slice: followingSlice,
}
