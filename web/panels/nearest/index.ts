import { fold } from '../fold'
import type { Panel } from '../panel'
import { load, nearestQuestion } from './nearest-question'

export const nearest: Panel = {
  ...fold({ name: 'nearest', title: 'Nearest invalid, nearest valid', load }),
  changes: true,
  question: nearestQuestion,
}
