/**
 * Panels that only the pages of Hexlens have: in the one-file scripts `web/package/no-page-parts.ts` takes this file's place. “Nearest
 * invalid, nearest valid”: both view and search come when it is opened.
 */
import type { Nearest, searchNearest } from '../panels/nearest/search/nearest'
import type { Core } from '../core/report'
import type { Vertices } from '../model/hexahedron'
import type { State } from '../model/state'
import { panel } from './panel'
import type { Part, PartAnswers } from './parts'

/** How long the search may keep the page at once. */
const SLICE_MS = 6

let search: typeof searchNearest | null = null

/** The search goes on in slices until it is done, or the vertices change, or the panel is closed. */
class NearestAnswers implements PartAnswers {
  readonly #onNews: () => void
  #vertices: Vertices | null = null
  #nearest: Nearest | null = null
  #timer: ReturnType<typeof setTimeout> | undefined

  constructor(onNews: () => void) {
    this.#onNews = onNews
  }

  of(core: Core, { vertices, gestureStart, openPanels }: State): { readonly nearest: Nearest | null } {
    const isWanted = openPanels.includes('nearest')
    if (!isWanted || (this.#vertices !== null && this.#vertices !== vertices)) this.stop()
    if (isWanted && search !== null && gestureStart === null && this.#vertices === null) {
      this.#vertices = vertices
      this.#proceed(search(core, vertices))
    }
    return { nearest: this.#nearest }
  }

  stop(): void {
    clearTimeout(this.#timer)
    this.#vertices = null
    this.#nearest = null
  }

  #proceed(steps: Generator<Nearest, Nearest>): void {
    this.#timer = setTimeout(() => {
      const end = performance.now() + SLICE_MS
      const known = this.#nearest
      let step = steps.next()
      while (!step.done && performance.now() < end) step = steps.next()
      this.#nearest = step.value
      if (!step.done) this.#proceed(steps)
      if (this.#nearest !== known) this.#onNews()
    })
  }
}

async function load() {
  const [view, { searchNearest }] = await Promise.all([
    import('../panels/nearest/nearest'),
    import('../panels/nearest/search/nearest'),
  ])
  search = searchNearest
  return view
}

export const pageParts: readonly Part[] = [
  {
    name: 'nearest',
    place: 'folds',
    create: panel('nearest', 'Nearest invalid, nearest valid', load),
    styles: '',
    changes: true,
    answers: onNews => new NearestAnswers(onNews),
  },
]
