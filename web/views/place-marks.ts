/** The best place of a vertex, for the scene: whoever answers the question `best-place` has it in the answer. */
import type { Vec3 } from '../model/hexahedron'
import type { Frame } from './view'

export const BEST_PLACE = 'best-place'

export interface PlaceMarks {
  readonly vertex: number
  /** Null where the vertex is at its best place. */
  readonly position: Vec3 | null
  readonly holds: readonly HoldMark[]
}

/** A point (xi, eta, zeta) that holds the vertex, with its letter and, once it is proved, its weight, from 0 to 1. */
export interface HoldMark {
  readonly point: Vec3
  readonly letter: string
  readonly weight: number | null
}

export function placeMarksOf({ answers }: Pick<Frame, 'answers'>): PlaceMarks | null {
  return (answers[BEST_PLACE] as { readonly marks: PlaceMarks } | null | undefined)?.marks ?? null
}

/** "A 0.42", with a weight of two digits. */
export function holdText({ letter, weight }: Omit<HoldMark, 'point'>): string {
  return weight === null ? letter : `${letter} ${weight < 0.005 ? '< 0.01' : weight.toFixed(2)}`
}
