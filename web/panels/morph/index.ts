import { fold } from '../fold'
import type { Panel } from '../panel'
import { endsSlice, morphQuestion } from './morph-question'

export const morph: Panel = {
  ...fold({ name: 'morph', title: 'Morph', load: () => import('./morph') }),
  changes: true,
  slice: endsSlice,
  question: morphQuestion,
}
