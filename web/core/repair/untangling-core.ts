/** An untangling in a wasm instance of its own, whose memory goes with it. */
import { VERTEX_COUNT, type Vec3 } from '../../model/hexahedron'
import type { Result } from '../../model/result'
import { Unpacker } from '../unpack'
import type { Limits } from './limits'
import type { PointMesh, Untangled, UntangledCounts, UntangleError, UntangleOptions, Untangling } from './untangling'

interface UntangleExports {
  readonly memory: WebAssembly.Memory
  _initialize?(): void
  output_address(): number
  output_length(): number
  untangle_room(pointCount: number, cellCount: number): number
  begin_untangle(
    coordinates: number,
    coordinateCount: number,
    indices: number,
    indexCount: number,
    moves: number,
    margin: number,
    slides: number,
    boundaryDistance: number,
    memory: number,
    room: number,
    points: number,
  ): number
  step_untangle(): number
  end_untangle(held: number): void
  untangled_limits(point: number): number
  reversed_cells(
    coordinates: number,
    coordinateCount: number,
    indices: number,
    indexCount: number,
    memory: number,
    room: number,
    reversed: number,
  ): number
}

/** Statuses of hexlens.h. */
const HL_OK = 0
const HL_NOT_FINITE = 1
const HL_NO_SUCH_POINT = 4

const REFUSALS: Readonly<Record<number, UntangleError>> = {
  [HL_NOT_FINITE]: { code: 'not-finite', message: 'A coordinate of the mesh is not a finite number.' },
  [HL_NO_SUCH_POINT]: { code: 'no-such-point', message: 'An index of the cells is not that of a point.' },
}

const WASM_PAGE = 65536

export async function beginUntangling(
  module: WebAssembly.Module,
  mesh: PointMesh,
  options: UntangleOptions,
): Promise<Result<Untangling, UntangleError>> {
  const problem = problemOf(mesh, options)
  if (problem) return { ok: false, error: problem }
  const wasm = await instanceOf(module)
  const { points, cells } = mesh
  const moves = options.moves ?? null
  const pointCount = points.length / 3
  const room = wasm.untangle_room(pointCount, cells.length / VERTEX_COUNT)
  const sizes = [points.byteLength, cells.byteLength, moves?.byteLength ?? 0, points.byteLength, pointCount, room]
  const addresses = reserve(wasm.memory, sizes) as [number, number, number, number, number, number]
  const [atPoints, atCells, atMoves, atMoved, atHeld, atRoom] = addresses
  const { buffer } = wasm.memory
  new Float64Array(buffer, atPoints, points.length).set(points)
  new Uint32Array(buffer, atCells, cells.length).set(cells)
  if (moves) new Uint8Array(buffer, atMoves, moves.length).set(moves)
  const status = wasm.begin_untangle(
    atPoints,
    points.length,
    atCells,
    cells.length,
    moves ? atMoves : 0,
    options.margin,
    Number(options.slides ?? false),
    options.boundaryDistance ?? 0,
    atRoom,
    room,
    atMoved,
  )
  if (status !== HL_OK) {
    const error = REFUSALS[status]
    if (!error) throw new Error(`The core answered an untangling with the status ${status}.`)
    return { ok: false, error }
  }
  const counts = () => unpackCounts(new Float64Array(buffer, wasm.output_address(), wasm.output_length()))
  const end = (): Untangled => {
    wasm.end_untangle(atHeld)
    const heldPoints = Uint32Array.from(indicesOfOnes(new Uint8Array(buffer, atHeld, pointCount)))
    return {
      ...counts(),
      points: new Float64Array(buffer, atMoved, points.length).slice(),
      heldPoints,
      heldLimits: Array.from(heldPoints, point =>
        unpackLimits(new Float64Array(buffer, wasm.untangled_limits(point), LIMITS_LENGTH)),
      ),
    }
  }
  return { ok: true, value: { step: () => wasm.step_untangle() !== 0, progress: counts, end } }
}

/** Throws for what is no mesh. */
export async function reversedCells(module: WebAssembly.Module, { points, cells }: PointMesh): Promise<Uint8Array> {
  const wasm = await instanceOf(module)
  const cellCount = cells.length / VERTEX_COUNT
  const room = wasm.untangle_room(points.length / 3, cellCount)
  const addresses = reserve(wasm.memory, [points.byteLength, cells.byteLength, cellCount, room])
  const [atPoints, atCells, atReversed, atRoom] = addresses as [number, number, number, number]
  const { buffer } = wasm.memory
  new Float64Array(buffer, atPoints, points.length).set(points)
  new Uint32Array(buffer, atCells, cells.length).set(cells)
  const status = wasm.reversed_cells(atPoints, points.length, atCells, cells.length, atRoom, room, atReversed)
  if (status !== HL_OK) throw new Error(`The core answered with the status ${status}.`)
  return new Uint8Array(buffer, atReversed, cellCount).slice()
}

async function instanceOf(module: WebAssembly.Module): Promise<UntangleExports> {
  const wasm = (await WebAssembly.instantiate(module, {})).exports as unknown as UntangleExports
  wasm._initialize?.()
  return wasm
}

function problemOf(
  { points, cells }: PointMesh,
  { margin, moves, boundaryDistance = 0 }: UntangleOptions,
): UntangleError | null {
  if (points.length % 3 !== 0) return wrongCount(`Points have three coordinates each; ${points.length} are not.`)
  if (cells.length % VERTEX_COUNT !== 0) return wrongCount(`Cells have eight indices each; ${cells.length} are not.`)
  if (moves && moves.length !== points.length / 3)
    return wrongCount(`There are ${points.length / 3} points, and ${moves.length} that say which of them may move.`)
  if (!(margin >= 0 && margin <= 1))
    return { code: 'no-such-margin', message: `A relative minimum is asked for from 0 to 1, not ${margin}.` }
  if (boundaryDistance >= 0) return null
  return { code: 'no-such-distance', message: `A distance is 0 or more, not ${boundaryDistance}.` }
}

function wrongCount(message: string): UntangleError {
  return { code: 'wrong-count', message }
}

/** Addresses of lists of these sizes in bytes, one after the other behind what the module has. */
function reserve(memory: WebAssembly.Memory, sizes: readonly number[]): number[] {
  let next = memory.buffer.byteLength
  const addresses = sizes.map(size => {
    const address = next
    next += Math.ceil(size / 8) * 8
    return address
  })
  memory.grow(Math.ceil((next - memory.buffer.byteLength) / WASM_PAGE))
  return addresses
}

function* indicesOfOnes(list: Uint8Array): Generator<number> {
  for (let i = list.indexOf(1); i >= 0; i = list.indexOf(1, i + 1)) yield i
}

/** The order of hl_pack_untangled in wasm/src/pack.c. */
function unpackCounts(packed: Float64Array): UntangledCounts {
  const from = new Unpacker(packed)
  return {
    invalidBefore: from.number(),
    invalidAfter: from.number(),
    belowBefore: from.number(),
    belowAfter: from.number(),
    movedCount: from.number(),
    placeCount: from.number(),
    sweepCount: from.number(),
    tooManyCount: from.number(),
    greatestDistance: from.number(),
    meanDistance: from.number(),
    leastBefore: numberOrNull(from.number()),
    leastAfter: numberOrNull(from.number()),
  }
}

const LIMITS_LENGTH = 12

/** The order of hl_limits; null where there are none. */
function unpackLimits(packed: Float64Array): Limits | null {
  const [low, high, ...normals] = [0, 3, 6, 9].map(at => [...packed.subarray(at, at + 3)]) as unknown as [Vec3, Vec3]
  const limits = { low, high, normals: (normals as Vec3[]).filter(n => n.some(x => x !== 0)) }
  return limits.normals.length === 0 && [...low, ...high].every(x => !Number.isFinite(x)) ? null : limits
}

function numberOrNull(value: number): number | null {
  return Number.isNaN(value) ? null : value
}
