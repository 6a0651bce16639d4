/** The best place of a vertex of the chosen cell for all cells around it: the answer of the core, in the words of the mesh. */
import { exactJacdet, type RationalPoint, valueAt } from '../../core/exact/exact-jacdet'
import type { BestPlace, RepairCore, Star } from '../../core/repair/best-place'
import { placeCertificateJson } from '../../core/repair/place-certificate'
import { type PlaceProof, provePlace } from '../../core/repair/place-proof'
import { edgeBernstein } from '../../model/bernstein'
import { VERTEX_COUNT, type Vec3, type Vertices, vertexOf, vertexReference, withVertex } from '../../model/hexahedron'
import { magnitude, nearestDouble, scaledDouble } from '../../model/rational'
import type { Around, CellAround } from '../../survey/survey-jobs'

type HexahedraStar = Extract<Star, { hexahedra: unknown }>

/** The cells around one vertex of the chosen cell. */
export interface VertexStar {
  readonly cells: readonly CellAround[]
  readonly star: HexahedraStar
}

export interface StarPlace extends VertexStar {
  readonly place: BestPlace
}

export interface HeldStar extends StarPlace {
  readonly proof: PlaceProof
  /** Where the vertex is. */
  readonly present: Vec3
  /** Of the proof, or what the core says if nothing is proved. */
  readonly holds: readonly StarHold[]
}

export interface StarHold {
  /** Null for a side of the box in which places are sought. */
  readonly cell: CellAround | null
  readonly point: Vec3
  /** Where the point is now. */
  readonly position: Vec3
  /** Null where nothing is proved. */
  readonly weight: number | null
  /** jacdet over the volume of the cell, at the present place and at the best one; null where the volume is 0. */
  readonly now: number | null
  readonly there: number | null
}

/** Nodes of a cell that are the same point move together. */
export function starOf({ points, cells }: Around, vertex: number): VertexStar {
  const point = points.indexOf(points[vertex] as number)
  const own = cells.filter(({ shared }) => shared.includes(point))
  const moving = own.map(({ shared }) => [...shared.keys()].filter(v => shared[v] === point))
  return { cells: own, star: { hexahedra: own.flatMap(({ vertices }) => vertices), moving } }
}

/** Of each vertex of the chosen cell; null where the core refuses the coordinates. */
export function bestPlaces({ bestPlace }: RepairCore, around: Around): (StarPlace | null)[] {
  return Array.from({ length: VERTEX_COUNT }, (_, v) => {
    const own = starOf(around, v)
    const result = bestPlace(own.star)
    return result.ok ? { ...own, place: result.value } : null
  })
}

export function proved(own: StarPlace): HeldStar {
  const { cells, star, place } = own
  const proof = provePlace(star, place)
  const known = proof.isProved
    ? proof.holds.map(hold => ({ ...hold, weight: Number(hold.weight.numerator) / Number(hold.weight.denominator) }))
    : place.holds.map(hold => ({ ...hold, weight: null }))
  const holds = known.map(({ cell, point, weight }): StarHold => {
    if (cell === null) return { cell, point, position: point, weight, now: null, there: null }
    const around = cells[cell] as CellAround
    const { vertices } = around
    const moved = star.moving[cell]?.reduce((all, v) => withVertex(all, v, place.position), vertices) ?? vertices
    return {
      cell: around,
      point,
      position: positionIn(vertices, point),
      weight,
      now: relativeAt(vertices, point),
      there: relativeAt(moved, point),
    }
  })
  return { ...own, proof, present: vertexOf(cells[0]?.vertices ?? [], star.moving[0]?.[0] ?? 0), holds }
}

/** The proof for a checker; null where there is none. */
export function certificateOf({ cells, star, place, proof }: HeldStar, name: string): string | null {
  const names = cells.map(({ row }) => row.id)
  const json = placeCertificateJson(name, names, star, place, proof)
  return json && `[\n${JSON.stringify(json)}\n]\n`
}

/** Cells whose relative minimum is the star's, to a millionth. */
export function limitingCells({ cells }: VertexStar): readonly CellAround[] {
  const least = Math.min(...cells.map(({ row }) => row.relativeMinimum))
  return cells.filter(({ row }) => row.relativeMinimum <= least + 1e-6 * Math.abs(least))
}

/** The volume is the mean of the Bernstein coefficients in the middles of the edges: docs/repair.md (R2). */
function relativeAt(vertices: Vertices, point: Vec3): number | null {
  const jacdet = exactJacdet(vertices)
  const coefficients = edgeBernstein.map(([, middle]) => jacdet.bernstein[middle] as bigint)
  const sum = coefficients.reduce((all, coefficient) => all + coefficient, 0n)
  if (sum === 0n) return null
  const { numerator, denominator } = valueAt(jacdet, point.map(x => scaledDouble(x, 0)) as unknown as RationalPoint)
  const isNegative = numerator < 0n !== sum < 0n
  const ratio = nearestDouble({
    numerator: 12n * magnitude(numerator),
    denominator: denominator * magnitude(sum),
  })
  return isNegative ? -ratio : ratio
}

function positionIn(vertices: readonly number[], point: Vec3): Vec3 {
  const sum: [number, number, number] = [0, 0, 0]
  for (const [v, corner] of vertexReference.entries()) {
    const share = corner.reduce((product, far, axis) => {
      const x = point[axis] as number
      return product * (far ? x : 1 - x)
    }, 1)
    for (const axis of [0, 1, 2] as const) sum[axis] += share * (vertices[3 * v + axis] as number)
  }
  return sum
}
