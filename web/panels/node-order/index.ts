import { fold } from '../fold'
import type { Panel } from '../panel'
import { triedOrdersQuestion } from './tried-orders'

export const nodeOrder: Panel = {
  ...fold({ name: 'node-order', title: 'Node order', load: () => import('./node-order') }),
  changes: true,
  question: triedOrdersQuestion,
}
