/** Loads hexlens-repair.wasm; with untangling-core.ts the only place that sees its memory. */
import { COORDINATE_COUNT, VERTEX_COUNT, type Vec3 } from '../../model/hexahedron'
import { type CodedError, type Result, refused } from '../../model/result'
import { Unpacker } from '../unpack'
import type { BestPlace, Hold, Measure, RepairCore, Star, StarError } from './best-place'
import type { Limits } from './limits'
import { beginUntangling, reversedCells } from './untangling-core'

interface RepairExports {
  readonly memory: WebAssembly.Memory
  _initialize?(): void
  output_address(): number
  output_length(): number
  best_place_room(cellCount: number): number
  best_place(
    coordinates: number,
    coordinateCount: number,
    indices: number,
    indexCount: number,
    moving: number,
    vertex: number,
    limits: number,
    memory: number,
    room: number,
  ): number
}

/** Statuses of hexlens.h. */
const HL_OK = 0
const HL_NOT_FINITE = 1
const HL_NO_SUCH_POINT = 4
const HL_MISSING_LIST = 6
const HL_NOTHING_MOVES = 7
const HL_SEVERAL_PLACES = 8
const HL_OUTSIDE_LIMITS = 9
const HL_BOX_SIDE = 0xffffffff

const REFUSALS: Readonly<Record<number, StarError>> = {
  [HL_NOT_FINITE]: { code: 'not-finite', message: 'A coordinate of the cells is not a finite number.' },
  [HL_NO_SUCH_POINT]: { code: 'no-such-point', message: 'An index of the cells is not that of a point.' },
  [HL_MISSING_LIST]: { code: 'no-cells', message: 'There are no cells around the vertex.' },
  [HL_NOTHING_MOVES]: { code: 'nothing-moves', message: 'The vertex is not one of every cell.' },
  [HL_SEVERAL_PLACES]: { code: 'several-places', message: 'What moves is not at one place in all cells.' },
  [HL_OUTSIDE_LIMITS]: { code: 'outside-limits', message: 'The limits do not contain the place of the vertex.' },
}

const MEASURES: readonly Measure[] = ['scale', 'volume']
const WASM_PAGE = 65536

/** The lists of hl_star. */
interface Lists {
  readonly coordinates: Float64Array
  readonly indices: Uint32Array | null
  readonly moving: Uint8Array | null
  readonly vertex: number
  readonly cellCount: number
}

/** Rejects with the engine's own error where WebAssembly is missing, forbidden, or the bytes are others. */
export async function loadRepairCore(bytes: BufferSource): Promise<RepairCore> {
  const { instance, module } = await WebAssembly.instantiate(bytes, {})
  const wasm = instance.exports as unknown as RepairExports
  wasm._initialize?.()
  const { memory } = wasm
  const start = memory.buffer.byteLength

  /** Puts lists one after the other into memory that nothing else uses; returns their addresses, 0 for null, and that behind them. */
  function put(lists: readonly (Float64Array | Uint32Array | Uint8Array | null)[], room: number): number[] {
    const addresses: number[] = []
    let next = start
    for (const list of lists) {
      addresses.push(list ? next : 0)
      next += Math.ceil((list?.byteLength ?? 0) / 8) * 8
    }
    const missing = next + room - memory.buffer.byteLength
    if (missing > 0) memory.grow(Math.ceil(missing / WASM_PAGE))
    lists.forEach((list, i) => {
      if (!list) return
      const bytes = new Uint8Array(list.buffer, list.byteOffset, list.byteLength)
      new Uint8Array(memory.buffer, addresses[i], list.byteLength).set(bytes)
    })
    return [...addresses, next]
  }

  function bestPlace(star: Star): Result<BestPlace, StarError> {
    const read = listsOf(star)
    if (!read.ok) return read
    const { coordinates, indices, moving, vertex, cellCount } = read.value
    const room = wasm.best_place_room(cellCount)
    const limits = star.limits ? packedLimits(star.limits) : null
    const addresses = put([coordinates, indices, moving, limits], room) as [number, number, number, number, number]
    const [atCoordinates, atIndices, atMoving, atLimits, atRoom] = addresses
    const [coordinateCount, indexCount] = [coordinates.length, indices?.length ?? 0]
    const status = wasm.best_place(
      atCoordinates,
      coordinateCount,
      atIndices,
      indexCount,
      atMoving,
      vertex,
      atLimits,
      atRoom,
      room,
    )
    if (status === HL_OK)
      return {
        ok: true,
        value: unpackPlace(new Float64Array(memory.buffer, wasm.output_address(), wasm.output_length())),
      }
    const error = REFUSALS[status]
    if (!error) throw new Error(`The core answered with an unknown status, ${status}.`)
    return { ok: false, error }
  }

  return {
    bestPlace,
    untangling: (mesh, options) => beginUntangling(module, mesh, options),
    reversedCells: mesh => reversedCells(module, mesh),
  }
}

function listsOf(star: Star): Result<Lists, CodedError<'wrong-count' | 'no-such-point' | 'nothing-moves'>> {
  if ('points' in star) return listsOfPoints(star)
  const { hexahedra, moving } = star
  const cellCount = moving.length
  if (hexahedra.length !== COORDINATE_COUNT * cellCount)
    return refused(
      'wrong-count',
      `${cellCount} cells have ${COORDINATE_COUNT * cellCount} coordinates, not ${hexahedra.length}.`,
    )
  const bits = new Uint8Array(cellCount)
  for (const [cell, vertices] of moving.entries())
    for (const v of vertices) {
      if (!isIndex(v, VERTEX_COUNT)) return refused('nothing-moves', `A cell has vertices 0 to 7, not ${v}.`)
      bits[cell] = (bits[cell] as number) | (1 << v)
    }
  return {
    ok: true,
    value: { coordinates: Float64Array.from(hexahedra), indices: null, moving: bits, vertex: 0, cellCount },
  }
}

function listsOfPoints({
  points,
  cells,
  vertex,
}: Extract<Star, { points: unknown }>): Result<Lists, CodedError<'wrong-count' | 'no-such-point'>> {
  if (points.length % 3 !== 0)
    return refused('wrong-count', `Points have three coordinates each; ${points.length} are not.`)
  if (cells.length % VERTEX_COUNT !== 0)
    return refused('wrong-count', `Cells have eight indices each; ${cells.length} are not.`)
  const pointCount = points.length / 3
  for (let i = 0; i < cells.length; ++i)
    if (!isIndex(cells[i] as number, pointCount))
      return refused(
        'no-such-point',
        `Cell ${Math.floor(i / VERTEX_COUNT)} has the index ${cells[i]}, which is no point's.`,
      )
  if (!isIndex(vertex, pointCount)) return refused('no-such-point', `The vertex ${vertex} is no point's index.`)
  return { ok: true, value: ofUsedPoints(points, cells, vertex) }
}

/** Only the points of the cells cross over: a mesh has millions. */
function ofUsedPoints(points: ArrayLike<number>, cells: ArrayLike<number>, vertex: number): Lists {
  const indices = new Uint32Array(cells.length)
  const numbers = new Map<number, number>([[vertex, 0]])
  for (let i = 0; i < cells.length; ++i) {
    const point = cells[i] as number
    const number = numbers.get(point) ?? numbers.size
    numbers.set(point, number)
    indices[i] = number
  }
  const coordinates = new Float64Array(3 * numbers.size)
  for (const [point, number] of numbers)
    for (let r = 0; r < 3; ++r) coordinates[3 * number + r] = points[3 * point + r] as number
  return { coordinates, indices, moving: null, vertex: 0, cellCount: cells.length / VERTEX_COUNT }
}

/** The order of hl_limits. */
function packedLimits({ low, high, normals }: Limits): Float64Array {
  return Float64Array.from([...low, ...high, ...(normals[0] ?? NO_NORMAL), ...(normals[1] ?? NO_NORMAL)])
}

const NO_NORMAL: Vec3 = [0, 0, 0]

function isIndex(value: number, count: number): boolean {
  return Number.isInteger(value) && value >= 0 && value < count
}

/** The order of hl_pack_place in wasm/src/pack.c. */
function unpackPlace(packed: Float64Array): BestPlace {
  const from = new Unpacker(packed)
  const position = from.numbers(3) as unknown as Vec3
  const isMoved = from.flag()
  const isClosed = from.flag()
  const measure = MEASURES[from.number()] as Measure
  const [value, bound, relative, presentRelative, unitExponent, roundCount, holdCount] = from.numbers(
    7,
  ) as unknown as number[] as [number, number, number, number, number, number, number]
  const holds = Array.from({ length: holdCount }, () => unpackHold(from))
  return {
    position,
    isMoved,
    isClosed,
    measure,
    value,
    bound,
    relativeMinimum: Number.isNaN(relative) ? null : relative,
    presentRelativeMinimum: Number.isNaN(presentRelative) ? null : presentRelative,
    unitExponent,
    roundCount,
    holds,
  }
}

function unpackHold(from: Unpacker): Hold {
  const cell = from.number()
  const point = from.numbers(3) as unknown as Vec3
  const weight = from.number()
  const scale = from.number()
  return { cell: cell === HL_BOX_SIDE ? null : cell, point, weight, scale, isBySign: from.flag() }
}
