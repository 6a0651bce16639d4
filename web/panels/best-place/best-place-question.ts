/**
 * The best places of the eight vertices, each alone, and the proof of the chosen one's, while the panel is open: of the one that gains most
 * before a vertex is chosen.
 */
import type { BestPlace, RepairCore, Star } from '../../core/repair/best-place'
import type { PlaceProof, provePlace } from '../../core/repair/place-proof'
import type { Core, JacobianReport } from '../../core/report'
import { VERTEX_COUNT, type Vertices, withVertex } from '../../model/hexahedron'
import { BEST_PLACE, LETTERS, type PlaceMarks } from '../../views/place-marks'
import type { Question } from '../panel'

export interface VertexPlace {
  readonly vertices: Vertices
  readonly vertex: number
  /** Of each vertex; null where the coordinates are refused. */
  readonly places: readonly (BestPlace | null)[]
  readonly star: Star
  readonly place: BestPlace
  /** Null while a gesture runs. */
  readonly proof: PlaceProof | null
  /** The holds, of the proof where there is one. */
  readonly holds: readonly ShownHold[]
  readonly marks: PlaceMarks
}

export interface ShownHold {
  readonly letter: string
  /** Null for a side of the box in which places are sought. */
  readonly now: JacobianReport | null
  readonly there: JacobianReport | null
  readonly weight: number | null
}

interface Repair extends RepairCore {
  readonly provePlace: typeof provePlace
}

let repair: Repair | null = null

/** Both come when the panel is opened. */
export function takeRepair(given: Repair): void {
  repair = given
}

export const bestPlaceQuestion: Question<VertexPlace> = {
  name: BEST_PLACE,
  start() {
    let places: { readonly vertices: Vertices; readonly list: readonly (BestPlace | null)[] } | null = null
    let answered: VertexPlace | null = null
    return {
      answer(core, state) {
        if (repair === null || !state.openPanels.includes(BEST_PLACE)) {
          places = null
          answered = null
          return null
        }
        const { bestPlace } = repair
        const { vertices, gestureStart } = state
        if (places?.vertices !== vertices) {
          const list = Array.from({ length: VERTEX_COUNT }, (_, v) => {
            const result = bestPlace(starOf(vertices, v))
            return result.ok ? result.value : null
          })
          places = { vertices, list }
        }
        // The first vertex is everybody's who chose none.
        const isChosen = state.isVertexChosen || state.selectedVertex !== 0
        const vertex = isChosen ? state.selectedVertex : mostGaining(places.list)
        const isKnown = answered?.vertices === vertices && answered.vertex === vertex
        const isProofWanted = gestureStart === null
        if (!isKnown || (isProofWanted && answered?.proof === null))
          answered = answerOf(core, repair, { vertices, vertex }, places.list, isProofWanted)
        return answered
      },
    }
  },
}

function starOf(vertices: Vertices, vertex: number): Star {
  return { hexahedra: vertices, moving: [[vertex]] }
}

/** The vertex whose best place makes the element best; the first where no vertex has a valid place. */
function mostGaining(places: readonly (BestPlace | null)[]): number {
  const after = places.map(place => (place?.measure === 'volume' ? (place.relativeMinimum ?? 0) : 0))
  return after.indexOf(Math.max(...after))
}

function answerOf(
  core: Core,
  own: Repair,
  { vertices, vertex }: Pick<VertexPlace, 'vertices' | 'vertex'>,
  places: readonly (BestPlace | null)[],
  isProofWanted: boolean,
): VertexPlace | null {
  const place = places[vertex]
  if (!place) return null
  const star = starOf(vertices, vertex)
  const proof = isProofWanted ? own.provePlace(star, place) : null
  const moved = withVertex(vertices, vertex, place.position)
  const jacobian = (of: Vertices, point: JacobianReport['point']) => {
    const result = core.jacobian(of, point)
    return result.ok ? result.value : null
  }
  const known = proof?.isProved
    ? proof.holds.map(hold => ({ ...hold, weight: Number(hold.weight.numerator) / Number(hold.weight.denominator) }))
    : place.holds.map(hold => ({ ...hold, weight: null }))
  const holds = known.map(({ cell, point, weight }, i) => ({
    letter: LETTERS[i] as string,
    now: cell === null ? null : jacobian(vertices, point),
    there: cell === null ? null : jacobian(moved, point),
    weight,
  }))
  const marks = {
    vertex,
    position: place.isMoved ? place.position : null,
    points: holds.flatMap(({ now, letter, weight }) => {
      if (!now) return []
      const { point, position } = now
      return [{ point, position, label: letter, weight }]
    }),
  }
  return { vertices, vertex, places, star, place, proof, holds, marks }
}
