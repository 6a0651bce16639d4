/** The search for the nearest element of the other verdict, in slices while the panel is open. */
import type { Core } from '../../core/report'
import { between, described } from '../../model/document-readers'
import type { Vertices } from '../../model/hexahedron'
import { type Slice, sliceOf } from '../../model/state'
import type { Inquiry, Question } from '../panel'
import type { Nearest, searchNearest } from './search/nearest'

/** Boxes alone have the relative minimum 1; the nearer to it, the longer the search. */
export const SHARES = { least: 0, most: 0.9 } as const

export interface Wanted {
  readonly nearestRelativeMinimum: number
}

export const nearestSlice: Slice<Wanted> = {
  name: 'nearest',
  first: { nearestRelativeMinimum: 0 },
  readers: {
    nearestRelativeMinimum: described(
      'The relative minimum that the nearest valid element is to have, on the pages of Hexlens.',
      between(SHARES.least, SHARES.most),
    ),
  },
}

/** Milliseconds for which the search may keep the page at once. */
const SLICE_MS = 6

let search: typeof searchNearest | null = null

/** The search comes when the panel is opened. */
export function takeSearch(given: typeof searchNearest): void {
  search = given
}

export const nearestQuestion: Question<Nearest> = { name: 'nearest', start: onNews => inquiry(onNews) }

function inquiry(onNews: () => void): Inquiry<Nearest> {
  let nearest: Nearest | null = null
  let searched: Vertices | null = null
  let wanted = 0
  let timer: ReturnType<typeof setTimeout> | undefined

  function stop(): void {
    clearTimeout(timer)
    searched = null
    nearest = null
  }

  function proceed(steps: Generator<Nearest, Nearest>): void {
    timer = setTimeout(() => {
      const end = performance.now() + SLICE_MS
      const known = nearest
      let step = steps.next()
      while (!step.done && performance.now() < end) step = steps.next()
      nearest = step.value
      if (!step.done) proceed(steps)
      if (nearest !== known) onNews()
    })
  }

  return {
    /** The moves found so far, for the vertices that it names. */
    answer(core: Core, state) {
      const { vertices, gestureStart, openPanels } = state
      const { nearestRelativeMinimum } = sliceOf(nearestSlice, state)
      const isWanted = openPanels.includes('nearest')
      const isOther = searched !== null && (searched !== vertices || wanted !== nearestRelativeMinimum)
      if (!isWanted || isOther) stop()
      if (isWanted && search !== null && gestureStart === null && searched === null) {
        searched = vertices
        wanted = nearestRelativeMinimum
        proceed(search(core, vertices, wanted))
      }
      return nearest
    },
    stop,
  }
}
