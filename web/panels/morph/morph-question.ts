/** The ends of the way between two elements, and the minimum along it. */
import { coordinates, described, orNull } from '../../model/document-readers'
import { sameBits, type Vertices, vertexReference } from '../../model/hexahedron'
import { type Slice, type State, sliceOf } from '../../model/state'
import { checkFinite } from '../../model/store'
import type { Question } from '../panel'
import { type Morph, morphOf } from './morph-answer'

/** The ends that were kept; else the way goes from `start` to `vertices`, or from a box if these are the same. */
export interface Ends {
  readonly morphA: Vertices | null
  readonly morphB: Vertices | null
}

export const endsSlice: Slice<Ends> = {
  name: 'morph',
  first: { morphA: null, morphB: null },
  readers: {
    morphA: described(
      'The element that was kept as A, one end of the way of Morph; null where A is `start`, or the box around it.',
      orNull(coordinates),
    ),
    morphB: described('Likewise B; null where B is `vertices`.', orNull(coordinates)),
  },
  check({ morphA, morphB }) {
    for (const end of [morphA, morphB]) if (end) checkFinite(end)
  },
}

/** An element that an end follows while none is kept. */
export type Follows = 'start' | 'box' | 'element' | 'dented'

/** The way, and what its ends follow where they are not kept. */
export interface Way extends Morph {
  readonly follows: readonly [Follows, Follows]
}

/** Two ends that differ, so that there is a way to see. */
function followsOf({ start, vertices }: State): Way['follows'] {
  if (!isSame(start, vertices)) return ['start', 'element']
  return isSame(boxAround(vertices), vertices) ? ['start', 'dented'] : ['box', 'element']
}

function isSame(a: Vertices, b: Vertices): boolean {
  return a.every((value, i) => value === b[i])
}

function followed(follows: Follows, { start, vertices }: State): Vertices {
  if (follows === 'start') return start
  return follows === 'element' ? vertices : follows === 'box' ? boxAround(vertices) : dented(vertices)
}

/** Along the axes, with the element's least and greatest coordinates. */
function boxAround(vertices: Vertices): Vertices {
  const own = [0, 1, 2].map(axis => vertices.filter((_, i) => i % 3 === axis))
  return vertexReference.flatMap(corner =>
    own.map((values, axis) => (corner[axis] === 0 ? Math.min(...values) : Math.max(...values))),
  )
}

/** Vertex 6 is pushed to a quarter of the way from vertex 0: of a box, through the plane of its neighbours. */
function dented(vertices: Vertices): Vertices {
  return vertices.map((x, i) => (Math.floor(i / 3) === 6 ? x / 4 + (3 * (vertices[i % 3] as number)) / 4 : x))
}

/** The answer stays that of before while a gesture runs. */
export const morphQuestion: Question<Way> = {
  name: 'morph',
  start() {
    let way: Way | null = null
    let asked: readonly (Vertices | null)[] = []
    return {
      answer(core, state) {
        const { vertices, start, gestureStart, openPanels } = state
        const { morphA, morphB } = sliceOf(endsSlice, state)
        const now = [start, vertices, morphA, morphB]
        if (!openPanels.includes('morph')) {
          way = null
          asked = []
        } else if (gestureStart === null && now.some((each, i) => each !== asked[i])) {
          asked = now
          const follows = followsOf(state)
          const a = morphA ?? followed(follows[0], state)
          const b = morphB ?? followed(follows[1], state)
          const isKnown = way !== null && sameBits(way.a, a) && sameBits(way.b, b)
          way = { ...(way && isKnown ? way : morphOf(core, a, b)), follows }
        }
        return way
      },
    }
  },
}
