/** A better place of a vertex and the points that hold the vertex back, for the scene: from the panel `best-place`, or from the page. */
import type { Vec3 } from '../model/hexahedron'
import { type PassingSlice, sliceOf } from '../model/state'
import type { Frame } from './view'

export const BEST_PLACE = 'best-place'

export interface PlaceMarks {
  readonly vertex: number
  /** Null where the vertex is at its best place. */
  readonly position: Vec3 | null
  readonly points: readonly PlacePoint[]
}

/** A point that holds the vertex back. */
export interface PlacePoint {
  readonly position: Vec3
  /** (xi, eta, zeta) in the element; null in another cell. */
  readonly point: Vec3 | null
  readonly label: string
  /** From 0 to 1; null before it is proved. */
  readonly weight: number | null
}

/** What the page's script wants to be seen. Who asks for it has checked it. */
export const placeSlice: PassingSlice<{ readonly place: PlaceMarks | null }> = {
  name: 'place',
  first: { place: null },
  endsWithVertices: true,
}

export function placeMarksOf({ answers, state }: Pick<Frame, 'answers' | 'state'>): PlaceMarks | null {
  const answer = answers[BEST_PLACE] as { readonly marks: PlaceMarks } | null | undefined
  return answer?.marks ?? sliceOf(placeSlice, state).place
}

/** Two digits: "0.42". */
export function shortWeight(weight: number): string {
  return weight < 0.005 ? '<0.01' : weight.toFixed(2)
}

export const LETTERS: readonly string[] = ['A', 'B', 'C', 'D']
