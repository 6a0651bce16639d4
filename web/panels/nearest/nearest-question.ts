/** The search for the nearest element of the other verdict, in slices while the panel is open. */
import type { Core } from '../../core/report'
import type { Vertices } from '../../model/hexahedron'
import type { Inquiry, Question } from '../panel'
import type { Nearest, searchNearest } from './search/nearest'

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
    answer(core: Core, { vertices, gestureStart, openPanels }) {
      const isWanted = openPanels.includes('nearest')
      if (!isWanted || (searched !== null && searched !== vertices)) stop()
      if (isWanted && search !== null && gestureStart === null && searched === null) {
        searched = vertices
        proceed(search(core, vertices))
      }
      return nearest
    },
    stop,
  }
}
