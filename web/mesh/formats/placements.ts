/** One mesh of node models, each where it is placed: the one model of a file, or instances of parts. */
import {
  type Block,
  type Mesh,
  MeshRefusal,
  MOST_IMPLIED_CELLS,
  NOTHING_NOT_TRILINEAR,
  type NotTrilinear,
} from '../mesh'
import { ALL_MIDDLES, isAtMean } from '../middles'
import { largestOf, type PrintedDigits } from '../precision'
import type { Runs } from '../runs'
import { shown } from '../text-cursor'
import type { TypedList } from '../typed-list'
import { type Move, NO_NODE, type NodeModel, QUADRATIC_SLOTS } from './node-model'

/** A model somewhere: an instance of a part, or the one model there is. */
export interface Placement {
  readonly model: NodeModel
  /** Null for a model that is in no part. */
  readonly name: string | null
  readonly move: Move | null
  /** Blocks of this placement alone. */
  readonly blocks?: ReadonlyMap<string, Runs>
}

export interface Collected {
  readonly format: string
  readonly fileName: string
  readonly placements: readonly Placement[]
  readonly precision: PrintedDigits
  /** Sentences for people; one that comes twice is said once. */
  readonly notes: Iterable<string>
  readonly isCutOff: boolean
}

/** One mesh of all placements. Ids and names of blocks stand behind the name of their instance if several have cells. */
export function collect({ format, fileName, placements, precision, notes, isCutOff }: Collected): Mesh {
  const said = [...notes]
  let leftOut = 0
  for (const model of new Set(placements.map(placement => placement.model))) leftOut += model.check(fileName, isCutOff)
  if (leftOut > 0) said.push(`The text leaves lines out: ${leftOut} elements without all of their nodes are not read.`)
  const total = (count: (model: NodeModel) => number) => placements.reduce((sum, { model }) => sum + count(model), 0)
  const [pointCount, cellCount] = [total(model => model.nodeCount), total(model => model.cellCount)]
  const quadraticCount = total(model => model.quadraticIds.length)
  if (placements.length > 1 && Math.max(pointCount, cellCount, quadraticCount) > MOST_IMPLIED_CELLS)
    throw new MeshRefusal(
      `${shown(fileName).slice(1, -1)}: its instances have ${Math.max(pointCount, cellCount)} nodes or elements; ${MOST_IMPLIED_CELLS} are read at most.`,
    )

  // A single model that is not moved is the mesh.
  const only = placements.length === 1 && placements[0]?.move === null ? placements[0].model : null
  const points = only?.points.whole() ?? new Float64Array(3 * pointCount)
  const cells = only?.cells.whole() ?? new Uint32Array(8 * cellCount)
  const quadratic = new Uint32Array(QUADRATIC_SLOTS * quadraticCount)
  const others = new Map<string, number>()
  const isNamed = placements.filter(({ model }) => model.cellCount > 0).length > 1
  const numbers = isNamed ? null : (only?.cellIds.whole() ?? new Float64Array(cellCount))
  const names: string[] = []
  const blocks: Block[] = []
  let [point, cell, far] = [0, 0, 0]
  for (const { model, name, move, blocks: more } of placements) {
    if (only === null) {
      points.set(model.points.values.subarray(0, 3 * model.nodeCount), 3 * point)
      if (move !== null) for (let i = 0; i < model.nodeCount; ++i) move(points, 3 * (point + i))
      shifted(model.cells, cells, 8 * cell, point)
      numbers?.set(model.cellIds.values.subarray(0, model.cellCount), cell)
    }
    shifted(model.quadratic, quadratic, far, point)
    for (const [type, count] of model.others) others.set(type, (others.get(type) ?? 0) + count)
    if (numbers === null)
      for (let i = 0; i < model.cellCount; ++i)
        names.push(`${name === null ? '' : `${name}.`}${model.cellIds.values[i]}`)
    if (isNamed && name !== null && model.cellCount > 0)
      blocks.push({ name, cells: Uint32Array.from({ length: model.cellCount }, (_, i) => cell + i) })
    for (const [block, runs] of [...model.blocks, ...(more ?? [])]) {
      if (runs.isEmpty) continue
      const list = runs.sorted()
      if (cell > 0) for (let i = 0; i < list.length; ++i) list[i] = (list[i] as number) + cell
      blocks.push({ name: isNamed && name !== null ? `${name}.${block}` : block, cells: list })
    }
    point += model.nodeCount
    cell += model.cellCount
    far += model.quadratic.length
  }

  precision.largest = largestOf(points)
  const note = precision.note()
  if (note !== null) said.push(note)
  return {
    format,
    points,
    cells,
    ids: numbers ?? names,
    blocks,
    notTrilinear: notTrilinearOf(quadratic, points, precision),
    other: others,
    notes: [...new Set(said)],
    isOrderStated: true,
    isCutOff,
    coordinatePlaces: only?.coordinatePlaces() ?? null,
    steps: [],
  }
}

function shifted(from: TypedList<Uint32Array>, to: Uint32Array, at: number, by: number): void {
  const { values, length } = from
  for (let i = 0; i < length; ++i) to[at + i] = values[i] === NO_NODE ? NO_NODE : (values[i] as number) + by
}

/**
 * A further node is in the middle if it is where the corners' mean is, up to what printing has moved: u for the node and u for the mean,
 * where u is half a unit of the last place, or of the double.
 */
function notTrilinearOf(quadratic: Uint32Array, points: Float64Array, precision: PrintedDigits): NotTrilinear {
  const count = quadratic.length / QUADRATIC_SLOTS
  if (count === 0) return NOTHING_NOT_TRILINEAR
  const corners = new Uint32Array(8 * count)
  const tolerance = 2 * Math.max(precision.movement(), 4 * Number.EPSILON * precision.largest)
  let straight = 0
  for (let cell = 0; cell < count; ++cell) {
    const at = QUADRATIC_SLOTS * cell
    for (let v = 0; v < 8; ++v) corners[8 * cell + v] = quadratic[at + v] as number
    if (isStraight(quadratic, at, points, tolerance)) straight++
  }
  return { corners, straight }
}

function isStraight(quadratic: Uint32Array, at: number, points: Float64Array, tolerance: number): boolean {
  const coordinate = (slot: number, axis: number) => points[3 * (quadratic[at + slot] as number) + axis] as number
  return ALL_MIDDLES.every(
    (corners, i) => quadratic[at + 8 + i] === NO_NODE || isAtMean(coordinate, 8 + i, corners, tolerance),
  )
}
