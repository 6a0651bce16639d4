import { fold } from '../fold'
import type { Panel } from '../panel'

export const paste: Panel = {
  ...fold({ name: 'paste', title: 'Paste or drop', load: () => import('./paste') }),
  changes: true,
}
