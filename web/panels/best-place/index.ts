import { BEST_PLACE } from '../../views/place-marks'
import { fold } from '../fold'
import type { Panel } from '../panel'
import { bestPlaceQuestion, takeRepair } from './best-place-question'

async function load() {
  const [view, { repairFiles }, { provePlace }] = await Promise.all([
    import('./best-place'),
    import('../../core/repair/repair-files'),
    import('../../core/repair/place-proof'),
  ])
  takeRepair({ ...(await repairFiles()), provePlace })
  return view
}

export const bestPlace: Panel = {
  ...fold({ name: BEST_PLACE, title: 'Best place of a vertex', load }),
  changes: true,
  question: bestPlaceQuestion,
}
