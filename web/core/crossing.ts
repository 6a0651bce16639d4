/** Two neighbouring doubles between which the verdict changes on the straight way from one element to another. */
import type { Vertices } from '../model/hexahedron'
import { elementAt } from '../model/way'
import type { Core } from './report'

/** Places on a way, in [0,1]: the verdict at `near` is that at the end where the search began, at `far` the other. */
export interface Change {
  readonly near: number
  readonly far: number
}

export function changeBetween(core: Core, a: Vertices, b: Vertices, change: Change): Change {
  const bisection = changesBetween(vertices => verdictOf(core, vertices), a, b, change)
  for (;;) {
    const { done, value } = bisection.next()
    if (done) return value
  }
}

/**
 * Bisects with the certain verdict or another claim, pausing after each; those at `near` and `far`
 * must differ. Ends early if the two are no more than `least` apart.
 */
export function* changesBetween(
  holds: (vertices: Vertices) => boolean,
  a: Vertices,
  b: Vertices,
  { near, far }: Change,
  least = 0,
): Generator<undefined, Change> {
  const holdsNear = holds(elementAt(a, b, near))
  let [last, first] = [near, far]
  for (;;) {
    const middle = (last + first) / 2
    if (middle === last || middle === first || Math.abs(first - last) <= least) break
    if (holds(elementAt(a, b, middle)) === holdsNear) last = middle
    else first = middle
    yield
  }
  return { near: last, far: first }
}

/** Finite numbers always have a verdict. */
export function verdictOf(core: Core, vertices: Vertices): boolean {
  const result = core.isValid(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}
