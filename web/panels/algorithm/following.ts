/** The panel's slice of the state: how Algorithm 1 is followed. */
import { described, indexBelow, oneOf, record } from '../../model/document-readers'
import type { Slice } from '../../model/state'
import { checkIndex } from '../../model/store'

/** The boundary minimum, or only if all of the boundary is positive. */
export type Query = 'minimum' | 'validity'

/** `roots-b` looks at a face's Bernstein bound before it solves its quartic, `roots` does not. */
export type Variant = 'roots' | 'roots-b'

/** Steps of Algorithm 1: 8 vertices, 12 edges, 6 faces. */
export const STEP_COUNT = 26

export interface Following {
  readonly query: Query
  readonly variant: Variant
  /** 0..25; the last one where the algorithm ends before. */
  readonly step: number
}

const first: Following = { query: 'minimum', variant: 'roots-b', step: 0 }

export const followingSlice: Slice<{ readonly following: Following }> = {
  name: 'algorithm',
  first: { following: first },
  readers: {
    following: described(
      'How Algorithm 1 is followed, and to which of its steps, or to the last one where it ends before.',
      record<Following>(
        { query: oneOf('minimum', 'validity'), variant: oneOf('roots', 'roots-b'), step: indexBelow(STEP_COUNT) },
        first,
      ),
    ),
  },
  check: ({ following }) => checkIndex(following.step, STEP_COUNT, 'step'),
}
