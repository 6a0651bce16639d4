/** The ends of the way between two elements, and the minimum along it. */
import { coordinates, described, orNull } from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import { type Slice, sliceOf } from '../../model/state'
import { checkFinite } from '../../model/store'
import type { Question } from '../panel'
import { type Morph, morphOf } from './morph-answer'

/** The ends that were kept; else the way goes from `start` to `vertices`. */
export interface Ends {
  readonly morphA: Vertices | null
  readonly morphB: Vertices | null
}

export const endsSlice: Slice<Ends> = {
  name: 'morph',
  first: { morphA: null, morphB: null },
  readers: {
    morphA: described(
      'The element that was kept as A, one end of the way of Morph; null where A is `start`.',
      orNull(coordinates),
    ),
    morphB: described('Likewise B; null where B is `vertices`.', orNull(coordinates)),
  },
  check({ morphA, morphB }) {
    for (const end of [morphA, morphB]) if (end) checkFinite(end)
  },
}

/** The answer stays that of before while a gesture runs. */
export const morphQuestion: Question<Morph> = {
  name: 'morph',
  start() {
    let morph: Morph | null = null
    return {
      answer(core, state) {
        const { vertices, start, gestureStart, openPanels } = state
        const { morphA, morphB } = sliceOf(endsSlice, state)
        const [a, b] = [morphA ?? start, morphB ?? vertices]
        if (!openPanels.includes('morph')) morph = null
        else if (gestureStart === null && (morph?.a !== a || morph.b !== b)) morph = morphOf(core, a, b)
        return morph
      },
    }
  },
}
