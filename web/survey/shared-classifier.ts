/** Verdicts of many cells on several workers, the one that has the mesh among them: cut by cut, each with the points that it needs. */
import { type BatchCore, loadBatchCore, NOTHING_COUNTED, type Piece, sumOfCounts } from '../core/batch/batch-core'
import {
  answersOf,
  bytesPerCell,
  emptyLists,
  listsIn,
  partOf,
  putLists,
  type Wanted,
  wantedOf,
} from '../core/batch/lists'
import { Recycled } from '../core/batch/pieces'
import { defaultWorkers } from '../core/batch/start'
import type { BatchJobs } from '../core/batch/worker'
import type { Core } from '../core/report'
import { Pool, type WorkerPort } from '../core/workers'
import { cellClassifier } from '../input/classify-cells'
import type { ClassifyCells } from '../mesh/check'
import { turn } from './turn'

const CELLS_PER_CUT = 16384
/** Helpers take longer cuts while much is left, which are fewer messages: at most so many, and this share of what is left. */
const CELLS_PER_MESSAGE = 8 * CELLS_PER_CUT
const SHARE = 1 / 8
/** Fewer cells are no work for several. */
const MANY = 4 * CELLS_PER_CUT
/** More wait for the one that hands out the cuts. */
const MOST_HELPERS = 3
/** A helper has its next cut when it is done with one. */
const CUTS_AHEAD = 2

export interface ClassifierParts {
  readonly core: Core
  readonly batchModule: () => Promise<WebAssembly.Module>
  /** Starts a helper. */
  readonly helper: () => WorkerPort
  readonly onProgress: (done: number, total: number) => void
}

export interface SharedClassifier {
  readonly classify: ClassifyCells
  /** Starts the helpers before they are needed. */
  prepare(): void
  /** Ends them. */
  close(): Promise<void>
}

type Helper = Pool<WebAssembly.Module, BatchJobs>

/** Whoever can decide, and whose points they hold. */
interface Crew {
  readonly own: BatchCore
  readonly helpers: Set<Helper>
  readonly held: Map<BatchCore | Helper, Float64Array>
}

export function sharedClassifier({ core, batchModule, helper, onProgress }: ClassifierParts): SharedClassifier {
  let compiled: Promise<WebAssembly.Module> | null = null
  const once = () => {
    compiled ??= batchModule()
    return compiled
  }
  const alone = cellClassifier(core, once, onProgress)
  /** A few cells of many points, with their own alone. */
  const few: typeof alone = (points, cells, wanted) => {
    const own = 3 * cells.length < points.length ? pointsOf(points, cells) : null
    return own ? alone(own, cells.map((_, i) => i), wanted) : alone(points, cells, wanted)
  }
  let crew: Promise<Crew | null> | null = null
  const crewOnce = () => {
    crew ??= once().then(
      module => crewOf(module, helper),
      () => null,
    )
    return crew
  }
  const classify = async (points: Float64Array, cells: Uint32Array, wanted: Wanted) => {
    const whole = cells.length >= 8 * MANY ? await crewOnce() : null
    return whole ? inCuts(whole, { points, cells, wanted, onProgress }) : few(points, cells, wanted)
  }
  return {
    classify: classify as ClassifyCells,
    prepare: () => void crewOnce(),
    async close() {
      for (const own of (await crew)?.helpers ?? []) own.stop(new Error('The helpers were ended.'))
    },
  }
}

/** Null if one of them is not there. */
function pointsOf(points: Float64Array, cells: Uint32Array): Float64Array | null {
  const own = new Float64Array(3 * cells.length)
  for (let i = 0; i < cells.length; ++i) {
    const from = 3 * (cells[i] as number)
    if (from >= points.length) return null
    own.set(points.subarray(from, from + 3), 3 * i)
  }
  return own
}

async function crewOf(module: WebAssembly.Module, spawn: () => WorkerPort): Promise<Crew> {
  const helpers = new Set<Helper>()
  const count = Math.min(MOST_HELPERS, defaultWorkers() - 1)
  for (let i = 0; i < count; ++i) {
    const helper: Helper = new Pool({ name: 'A worker for batches', size: 1, spawn, start: module })
    helpers.add(helper)
    helper.run('hold', new Float64Array(0)).catch(() => helpers.delete(helper))
  }
  return { own: await loadBatchCore(module), helpers, held: new Map() }
}

interface Job {
  readonly points: Float64Array
  readonly cells: Uint32Array
  readonly wanted: Wanted
  readonly onProgress: (done: number, total: number) => void
}

interface Cut {
  readonly first: number
  readonly count: number
}

async function inCuts({ own, helpers, held }: Crew, { points, cells, wanted: asked, onProgress }: Job) {
  const wanted = wantedOf(asked)
  const total = cells.length / 8
  const lists = emptyLists(total, wanted)
  const memory = new Recycled()
  let [next, done, counts] = [0, 0, NOTHING_COUNTED]
  /** Cuts of helpers that have failed. */
  const left: Cut[] = []

  function take(most = CELLS_PER_CUT): Cut | null {
    const again = left.pop()
    if (again || next >= total) return again ?? null
    const first = next
    next = Math.min(first + most, total)
    return { first, count: next - first }
  }

  function takeLong(): Cut | null {
    const share = CELLS_PER_CUT * Math.floor((SHARE * (total - next)) / CELLS_PER_CUT)
    return take(Math.min(CELLS_PER_MESSAGE, Math.max(CELLS_PER_CUT, share)))
  }

  function count(cut: Cut, own: typeof counts): void {
    counts = sumOfCounts(counts, own, cut.first)
    done += cut.count
    onProgress(done, total)
  }

  async function decideHere(): Promise<void> {
    for (let cut = take(); cut; cut = take()) {
      const piece = pieceOf(points, cells, cut)
      if (piece.points === null && held.get(own) !== points) {
        own.hold(points)
        held.set(own, points)
      }
      const part = partOf(lists, cut.first, cut.count)
      count(cut, own.classify(piece, wanted, { into: () => part }))
      await turn()
    }
  }

  async function decideThere(helper: Helper): Promise<void> {
    for (let cut = takeLong(); cut; cut = takeLong())
      try {
        const own = pieceOf(points, cells, cut)
        if (own.points === null && held.get(helper) !== points) {
          held.set(helper, points)
          void helper.run('hold', points.slice()).catch(() => {})
        }
        const { piece, block } = inBlock(own, memory, cut.count * bytesPerCell(wanted))
        const back = await helper.run('classify', { piece, block, wanted })
        putLists(listsIn(back.block, cut.count, wanted), lists, cut.first)
        memory.give(back.block)
        count(cut, back.counts)
      } catch {
        // It is done here instead.
        left.push(cut)
        helpers.delete(helper)
        return
      }
  }

  const others = [...helpers].flatMap(helper => Array.from({ length: CUTS_AHEAD }, () => decideThere(helper)))
  await decideHere()
  await Promise.all(others)
  await decideHere()
  return { ...answersOf(lists), ...counts }
}

/** A cut with the points between its least and its greatest index; without, where those are far apart. */
function pieceOf(points: Float64Array, cells: Uint32Array, { first, count }: Cut): OwnPiece {
  const own = cells.subarray(8 * first, 8 * (first + count))
  // Integers with a sign are faster, and no list has 2^31 points.
  const indices = new Int32Array(own.buffer, own.byteOffset, own.length)
  let [least, greatest] = [0x7fffffff, 0]
  for (let i = 0; i < indices.length; ++i) {
    const index = indices[i] as number
    if (index < least) least = index
    if (index > greatest) greatest = index
  }
  if (least < 0 || greatest - least >= 8 * count) return { points: null, cells: own, firstPoint: 0 }
  return { points: points.subarray(3 * least, 3 * (greatest + 1)), cells: own, firstPoint: least }
}

interface OwnPiece extends Piece {
  readonly cells: Uint32Array
}

/** A copy in one block of memory, with room for the answers to it. */
function inBlock({ points, cells, firstPoint }: OwnPiece, memory: Recycled, answers: number) {
  const count = points?.length ?? 0
  const block = memory.take(Math.max(8 * count + 4 * cells.length, answers))
  const indices = new Uint32Array(block, 8 * count, cells.length)
  indices.set(cells)
  if (points) new Float64Array(block, 0, count).set(points)
  return { piece: { points: points && new Float64Array(block, 0, count), cells: indices, firstPoint }, block }
}
