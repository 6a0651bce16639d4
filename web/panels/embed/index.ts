import { fold } from '../fold'
import type { Panel } from '../panel'
import { choiceSlice } from './choice'

export const embed: Panel = {
  links: true,
  ...fold({ name: 'embed', title: 'Copy embed', load: () => import('./embed-view') }),
  slice: choiceSlice,
}
