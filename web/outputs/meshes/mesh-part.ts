/** Cells of a checked mesh with the points that are theirs, and as arrays what is said of each. */
import type { MeshCheck } from '../../mesh/mesh-check'
import { invalidCells } from '../invalid-cells'

/** `valid` of a cell without an answer. */
const UNANSWERED = 255

/** Numbers are written in chunks of so many. */
export const PIECE = 131_072

export interface MeshPart {
  readonly check: MeshCheck
  readonly points: Float64Array
  /** Eight indices of these points a cell. */
  readonly cells: Uint32Array
  /** Their indices in the mesh; null for all cells in its order. */
  readonly chosen: Uint32Array | null
}

/** A number for each cell of a part. */
export interface CellArray {
  readonly name: string
  readonly type: 'UInt8' | 'Float64'
  numberOf(cell: number): number
}

/** How many arrays a whole mesh has. */
export const WHOLE_ARRAYS = 4

export function wholeMesh(check: MeshCheck): MeshPart {
  const { points, cells } = check.mesh
  return { check, points, cells, chosen: null }
}

export function invalidPart(check: MeshCheck): MeshPart {
  const { points, cells } = check.mesh
  const chosen = Uint32Array.from(invalidCells(check))
  const places = new Map<number, number>()
  const own = new Uint32Array(8 * chosen.length)
  for (let i = 0; i < own.length; ++i) {
    const point = cells[8 * (chosen[i >> 3] as number) + (i & 7)] as number
    const place = places.get(point) ?? places.size
    places.set(point, place)
    own[i] = place
  }
  const ownPoints = new Float64Array(3 * places.size)
  for (const [point, place] of places) ownPoints.set(points.subarray(3 * point, 3 * point + 3), 3 * place)
  return { check, points: ownPoints, cells: own, chosen }
}

/** The index in the mesh of a part's cell. */
export function cellIn({ chosen }: MeshPart, cell: number): number {
  return chosen === null ? cell : (chosen[cell] as number)
}

/**
 * valid, 255 where a cell is unanswered, boundary_min, relative_min and volume, NaN where there is none. Of invalid ones alone also what
 * they are called: index, counted from 0 in the file's order, and cell_id, the same where the file has no ids.
 */
export function cellArrays(part: MeshPart): CellArray[] {
  const { answers, isAnswered, mesh } = part.check
  const { minima, volumes, relativeMinima, valid } = answers
  if (!minima || !volumes) throw new Error('The minima and volumes were not asked for.')
  const array = (name: string, type: CellArray['type'], without: number, of: (cell: number) => number): CellArray => ({
    name,
    type,
    numberOf(i) {
      const cell = cellIn(part, i)
      return isAnswered(cell) ? of(cell) : without
    },
  })
  return [
    array('valid', 'UInt8', UNANSWERED, cell => valid[cell] as number),
    array('boundary_min', 'Float64', Number.NaN, cell => scaled(minima.values[cell], minima.exponents[cell])),
    array('relative_min', 'Float64', Number.NaN, cell => relativeMinima[cell] as number),
    array('volume', 'Float64', Number.NaN, cell => scaled(volumes.values[cell], volumes.exponents[cell])),
    ...(part.chosen === null ? [] : namesOf(mesh.ids, cell => cellIn(part, cell))),
  ]
}

/** What cells are called, in numbers; ids that are words are none. */
function namesOf(ids: MeshCheck['mesh']['ids'], index: (cell: number) => number): CellArray[] {
  const array = (name: string, numberOf: CellArray['numberOf']): CellArray => ({ name, type: 'Float64', numberOf })
  if (ids === null) return [array('index', index), array('cell_id', index)]
  return ids instanceof Float64Array
    ? [array('index', index), array('cell_id', cell => ids[index(cell)] as number)]
    : [array('index', index)]
}

/** value * 2^exponent in a double: an infinity or 0 where there is no room for it. Two steps, as 2^exponent alone may have none. */
function scaled(value = Number.NaN, exponent = 0): number {
  if (value === 0) return 0
  const half = Math.trunc(exponent / 2)
  return value * 2 ** half * 2 ** (exponent - half)
}
