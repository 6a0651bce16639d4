/** Jobs of a mesh that moves. */
import { MOVES } from '../core/repair/untangling'
import type { Core } from '../core/report'
import type { ClassifyCells } from '../mesh/check'
import type { MeshCheck } from '../mesh/mesh-check'
import type { MeshFile } from '../mesh/source'
import { Refusal } from '../model/result'
import { asStored, movedFile, whyNotInPlace } from '../outputs/moved-file'
import { aroundOf } from './around'
import { grow } from './faces'
import { meeting } from './meeting'
import type { Movement } from './movement'
import { OpenedSurvey } from './opened-survey'
import { cellsWith, recheck } from './recheck'
import { Survey } from './survey'
import type { MovedMesh, MovementCounts, Served, SurveyJobs, TangledPart } from './survey-jobs'
import { wholeOrderOf } from './whole-order'

type MovingJobs = Served<Pick<SurveyJobs, 'around' | 'move' | 'undo' | 'redo' | 'restore' | 'tangled'>>

/** An open mesh that moves. */
export interface Moving {
  readonly name: string
  readonly survey: OpenedSurvey
  readonly movement: Movement
  readonly classify: ClassifyCells
  readonly core: Core
  /** The files that the mesh was read from. */
  readonly files: readonly MeshFile[]
}

/** `put` takes the survey of the moved mesh in the place of the one before. */
export function movingJobs(opened: () => Moving, put: (survey: OpenedSurvey) => void): MovingJobs {
  async function moved(step: (movement: Movement) => Uint32Array): Promise<MovedMesh> {
    const { name, survey, movement, classify, core } = opened()
    const before = await survey.whole()
    const points = step(movement)
    const check = await recheck(before.check, movement.now, points, { classify, core })
    const own = new Survey(check, { core, meeting }, before)
    put(new OpenedSurvey(own, null, classify))
    const wholeOrder = await wholeOrderOf(check, { classify, core })
    return { opened: own.overview(name, wholeOrder), movement: countsOf(opened()) }
  }

  return {
    around: async cell => aroundOf(await opened().survey.withCell(cell), opened().movement, cell),
    move: moves => moved(movement => movement.move(moves)),
    undo: () => moved(movement => movement.undo()),
    redo: () => moved(movement => movement.redo()),
    restore: points => moved(movement => movement.restore(points && Uint32Array.from(points))),
    tangled: async part => tangledPart((await opened().survey.whole()).check, part),
  }
}

function countsOf(moving: Moving): MovementCounts {
  const { movedCount, canUndo, canRedo } = moving.movement
  return { movedCount, canUndo, canRedo, whyNotInPlace: whyNotHere(moving) }
}

function whyNotHere({ movement, files }: Moving): string | null {
  if (movement.isRenumbered) return 'The file has the nodes of its cells in another order than they have here.'
  if (files.length !== 1) return 'The mesh was read from several files.'
  return whyNotInPlace(movement.first)
}

/** The file that was read, with the points as they are. Throws a Refusal where there is none. */
export function* inOwnFormat(moving: Moving): Generator<Uint8Array> {
  const why = whyNotHere(moving)
  if (why !== null) throw new Refusal(why)
  const [file] = moving.files
  if (file) yield* movedFile(file, moving.movement.first, moving.movement.now.points)
}

/** What single precision makes of the moved points: a sentence, or none where the file has doubles. */
export async function roundedNote({ movement, classify }: Moving): Promise<string[]> {
  const { first, now } = movement
  const points = asStored(first, now.points)
  const rounded: number[] = []
  for (let i = 0; i < points.length; ++i) if (!Object.is(points[i], now.points[i])) rounded.push(Math.floor(i / 3))
  if (rounded.length === 0) return []
  const some = cellsWith(now, rounded)
  const cells = new Uint32Array(8 * some.length)
  for (const [i, cell] of some.entries()) cells.set(now.cells.subarray(8 * cell, 8 * cell + 8), 8 * i)
  const [before, after] = [await classify(now.points, cells, {}), await classify(points, cells, {})]
  const others = after.invalidCount - before.invalidCount
  const verdicts =
    others > 0 ? `${others} more of their cells are invalid in it` : 'none of their cells is invalid by that'
  return [`The file has single precision, to which the moved vertices are rounded: ${verdicts}.`]
}

/** Cells whose points may move have all of their neighbours among the cells of the part. */
function tangledPart(check: MeshCheck, part: { readonly cell: number; readonly rings: number } | null): TangledPart {
  const { points, cells, ids } = check.mesh
  const pointCount = points.length / 3
  if (part === null) {
    const moves = new Uint8Array(pointCount).fill(MOVES.unlessBoundary)
    return {
      points: points.slice(),
      cells: cells.slice(),
      moves,
      indices: null,
      cellIndices: null,
      ids: ids?.slice() ?? null,
    }
  }
  const mask = new Uint8Array(cells.length / 8)
  mask[part.cell] = 1
  for (let ring = 0; ring < part.rings; ++ring) grow(mask, check)
  const isOfPart = new Uint8Array(pointCount)
  for (let i = 0; i < cells.length; ++i) if (mask[i >> 3] === 1) isOfPart[cells[i] as number] = 1
  grow(mask, check)
  const places = new Map<number, number>()
  const own: number[] = []
  const cellIndices: number[] = []
  for (let i = 0; i < cells.length; ++i) {
    if (mask[i >> 3] !== 1) continue
    if (i % 8 === 0) cellIndices.push(i / 8)
    const point = cells[i] as number
    const place = places.get(point) ?? places.size
    places.set(point, place)
    own.push(place)
  }
  const indices = Uint32Array.from(places.keys())
  const coordinates = new Float64Array(3 * indices.length)
  for (const [i, point] of indices.entries()) coordinates.set(points.subarray(3 * point, 3 * point + 3), 3 * i)
  const moves = Uint8Array.from(indices, point => (isOfPart[point] === 1 ? MOVES.unlessBoundary : MOVES.stays))
  return {
    points: coordinates,
    cells: Uint32Array.from(own),
    moves,
    indices,
    cellIndices: Uint32Array.from(cellIndices),
    ids: ids && cellIndices.map(cell => String(ids[cell])),
  }
}
