import { fold } from '../fold'
import type { Panel } from '../panel'
import { nearestQuestion, nearestSlice, takeSearch } from './nearest-question'

async function load() {
  const [view, { searchNearest }] = await Promise.all([import('./nearest'), import('./search/nearest')])
  takeSearch(searchNearest)
  return view
}

export const nearest: Panel = {
  ...fold({ name: 'nearest', title: 'Nearest invalid, nearest valid', load }),
  changes: true,
  slice: nearestSlice,
  question: nearestQuestion,
}
