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

const CELLS_PER_CUT = 16384
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
    return whole ? inCuts(whole, { points, cells, wanted, onProgress }) : alone(points, cells, wanted)
  }
  return {
    classify: classify as ClassifyCells,
    prepare: () => void crewOnce(),
    async close() {
      for (const own of (await crew)?.helpers ?? []) own.stop(new Error('The helpers were ended.'))
    },
  }
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

  function take(): Cut | null {
    const again = left.pop()
    if (again || next >= total) return again ?? null
    const first = next
    next = Math.min(first + CELLS_PER_CUT, total)
    return { first, count: next - first }
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
    for (let cut = take(); cut; cut = take())
      try {
        const { points: some, cells: indices, firstPoint } = pieceOf(points, cells, cut)
        if (some === null && held.get(helper) !== points) {
          held.set(helper, points)
          void helper.run('hold', points.slice()).catch(() => {})
        }
        const piece = { points: some?.slice() ?? null, cells: (indices as Uint32Array).slice(), firstPoint }
        const block = memory.take(cut.count * bytesPerCell(wanted))
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
function pieceOf(points: Float64Array, cells: Uint32Array, { first, count }: Cut): Piece {
  const own = cells.subarray(8 * first, 8 * (first + count))
  let [least, greatest] = [0xffffffff, 0]
  for (let i = 0; i < own.length; ++i) {
    const index = own[i] as number
    if (index < least) least = index
    if (index > greatest) greatest = index
  }
  if (greatest - least >= 8 * count) return { points: null, cells: own, firstPoint: 0 }
  return { points: points.subarray(3 * least, 3 * (greatest + 1)), cells: own, firstPoint: least }
}

const channel = new MessageChannel()

/** Lets messages come in. */
function turn(): Promise<void> {
  return new Promise(resolve => {
    channel.port2.onmessage = () => resolve()
    channel.port1.postMessage(null)
  })
}
