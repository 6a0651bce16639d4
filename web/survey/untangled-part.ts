/** A part of a mesh, untangled: what has moved, in the mesh's own numbers, and the lines that show it. */
import type { RepairCore } from '../core/repair/best-place'
import { type Reason, reasonsOf } from '../core/repair/held'
import { untangle } from '../core/repair/untangle'
import type { Untangled, UntangledCounts } from '../core/repair/untangling'
import { edgeVertices } from '../model/hexahedron'
import { writeHeldCertificates } from '../outputs/held-certificates'
import type { Moves, TangledPart } from './survey-jobs'

export interface UntangleWanted {
  readonly part: TangledPart
  /** The least relative minimum that is wanted. */
  readonly margin: number
  readonly boundary: BoundaryMoves
}

/** What vertices on the boundary of the hexahedra may do: nothing, slide in the planes of its planar parts, or move so far. */
export type BoundaryMoves = 'stays' | 'slides' | { readonly within: number }

export interface PartUntangled {
  readonly counts: UntangledCounts
  readonly moves: Moves
  /** How many vertices may move and still have a cell below the margin, and why of the first of them. */
  readonly heldCount: number
  readonly held: readonly HeldVertex[]
  readonly holding: Holding
  readonly ghost: GhostLines
}

/** What `certify` wants of an untangled part: its points that hold what is left, by their places in it. */
export type Holding = Pick<Untangled, 'heldPoints' | 'heldLimits'>

export interface HeldVertex {
  /** A cell that has it, and which of its vertices it is. */
  readonly cell: number
  /** The cell's id in the file, or its index where it has none. */
  readonly id: string
  readonly vertex: number
  readonly cellCount: number
  /** Proved: no place of it makes all of these cells valid, or none gives them the margin. Null if neither is. */
  readonly forbids: Reason['forbids']
  /** No place has a greater least relative minimum, where the margin is what is forbidden. */
  readonly bound: number
  /** Points of the cells that prove it. */
  readonly pointCount: number
}

/** Edges with a vertex that has moved, as they are then. */
export interface GhostLines {
  /** Two points each: six numbers. */
  readonly ends: Float64Array
  /** How many there are; those of the vertices that have moved farthest are among the ends. */
  readonly wanted: number
}

export type UntangleJobs = {
  /** Tells of cells below the margin and of places that were sought. One sentence if it is refused. */
  untangle(
    wanted: UntangleWanted,
    tell: (soFar: UntangledCounts) => void,
  ): Promise<PartUntangled | { readonly refused: string }>
  /** The certificates of all vertices that hold what is left. Tells which part is done, from 0 to 1. */
  certify(wanted: CertificatesWanted, tell: (fraction: number) => void): HeldCertificates
}

export interface CertificatesWanted {
  /** With the points where untangling has brought them. */
  readonly part: TangledPart
  readonly margin: number
  readonly holding: Holding
}

export interface HeldCertificates {
  readonly text: string
  /** How many of the vertices have one. */
  readonly count: number
}

/** More lines than that are no picture. */
export const MOST_LINES = 4000
/** Vertices whose reasons are said: a proof takes milliseconds. */
const MOST_REASONS = 10

export async function untangledPart(
  core: RepairCore,
  { part, margin, boundary }: UntangleWanted,
  tell: (soFar: UntangledCounts) => void,
): Promise<PartUntangled | { readonly refused: string }> {
  const { points, cells, moves } = part
  const options = {
    margin,
    moves,
    slides: boundary === 'slides',
    boundaryDistance: typeof boundary === 'string' ? undefined : boundary.within,
  }
  const result = await untangle(core, { points, cells }, options, tell)
  if (!result.ok) return { refused: result.error.message }
  const { points: after, heldPoints, heldLimits, ...counts } = result.value
  const own = movedPoints(points, after)
  const to = new Float64Array(3 * own.length)
  for (const [i, point] of own.entries()) to.set(after.subarray(3 * point, 3 * point + 3), 3 * i)
  return {
    counts,
    moves: { points: own.map(point => part.indices?.[point] ?? point), to },
    heldCount: heldPoints.length,
    held: heldOf(part, reasonsOf(core, part, result.value, margin), heldPoints.length),
    holding: { heldPoints, heldLimits },
    ghost: ghostOf(part, after, own),
  }
}

export function heldCertificates(
  core: RepairCore,
  { part, margin, holding }: CertificatesWanted,
  tell: (fraction: number) => void,
): HeldCertificates {
  const { points, cells, indices } = part
  const reasonOf = reasonsOf(core, { cells }, { points, ...holding }, margin)
  const count = holding.heldPoints.length
  function* reasons() {
    for (let held = 0; held < count; ++held) {
      tell(held / count)
      yield reasonOf(held)
    }
  }
  const named = { indexOf: (point: number) => indices?.[point] ?? point, nameOf: (cell: number) => idOf(part, cell) }
  const texts: string[] = []
  return { count: writeHeldCertificates(reasons(), named, text => texts.push(text)), text: texts.join('') }
}

/** The part with its points where the moves bring them, which are the mesh's. */
export function withMoves(part: TangledPart, { points, to }: Moves): TangledPart {
  const places = part.indices && new Map(Array.from(part.indices, (point, place) => [point, place]))
  const after = part.points.slice()
  for (const [i, point] of points.entries()) {
    const place = places ? places.get(point) : point
    if (place !== undefined) after.set(to.subarray(3 * i, 3 * i + 3), 3 * place)
  }
  return { ...part, points: after }
}

function idOf({ ids, cellIndices }: TangledPart, cell: number): string {
  return String(ids?.[cell] ?? cellIndices?.[cell] ?? cell)
}

function movedPoints(before: Float64Array, after: Float64Array): Uint32Array {
  const found: number[] = []
  for (let point = 0; point < before.length / 3; ++point)
    if ([0, 1, 2].some(axis => !Object.is(before[3 * point + axis], after[3 * point + axis]))) found.push(point)
  return Uint32Array.from(found)
}

function heldOf(part: TangledPart, reasonOf: (held: number) => Reason, count: number): HeldVertex[] {
  return Array.from({ length: Math.min(count, MOST_REASONS) }, (_, held) => {
    const { cells: own, vertex, best, proof, forbids } = reasonOf(held)
    const first = own[0] as number
    return {
      cell: part.cellIndices?.[first] ?? first,
      id: idOf(part, first),
      vertex,
      cellCount: own.length,
      forbids,
      bound: best.bound,
      pointCount: proof.isProved ? proof.holds.length : 0,
    }
  })
}

function ghostOf({ points, cells }: TangledPart, after: Float64Array, moved: Uint32Array): GhostLines {
  const distance = (point: number) =>
    Math.hypot(...[0, 1, 2].map(axis => (after[3 * point + axis] as number) - (points[3 * point + axis] as number)))
  const ranks = new Map([...moved].sort((a, b) => distance(b) - distance(a)).map((point, rank) => [point, rank]))
  const edges = new Map<string, readonly [number, number, number]>()
  for (let cell = 0; cell < cells.length; cell += 8)
    for (const [v, w] of edgeVertices) {
      const [a, b] = [cells[cell + v] as number, cells[cell + w] as number]
      const rank = Math.min(ranks.get(a) ?? Infinity, ranks.get(b) ?? Infinity)
      if (rank < Infinity) edges.set(a < b ? `${a} ${b}` : `${b} ${a}`, [rank, a, b])
    }
  const drawn = [...edges.values()].sort(([first], [second]) => first - second).slice(0, MOST_LINES)
  const ends = new Float64Array(6 * drawn.length)
  for (const [i, [, a, b]] of drawn.entries()) {
    ends.set(after.subarray(3 * a, 3 * a + 3), 6 * i)
    ends.set(after.subarray(3 * b, 3 * b + 3), 6 * i + 3)
  }
  return { ends, wanted: edges.size }
}
