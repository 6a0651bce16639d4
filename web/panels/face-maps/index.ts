import { fold } from '../fold'
import type { Panel } from '../panel'
import { faceSlice } from './selected-face'

export const faceMaps: Panel = {
  ...fold({ name: 'face-maps', title: 'Face maps', load: () => import('./face-maps') }),
  slice: faceSlice,
}
