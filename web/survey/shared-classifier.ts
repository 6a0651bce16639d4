/** Verdicts of many cells on several workers, the one that has the mesh among them: cut by cut, each with the points that it needs. */
import { loadBatchCore } from '../core/batch/batch-core'
import { type Wanted, wantedOf } from '../core/batch/lists'
import { defaultWorkers } from '../core/batch/start'
import type { Core } from '../core/report'
import { Pool, type WorkerPort } from '../core/workers'
import { cellClassifier } from '../input/classify-cells'
import type { CellsInParts, HalvesOfPiece, PartReader } from '../input/file-at-hand'
import type { ClassifyCells } from '../mesh/check'
import { type Crew, Deciding, type Helper, MANY } from './deciding'

/** More wait for the one that hands out the cuts. */
const MOST_HELPERS = 3

export interface ClassifierParts {
  readonly core: Core
  readonly batchModule: () => Promise<WebAssembly.Module>
  /** Starts a helper. */
  readonly helper: () => WorkerPort
  readonly onProgress: (done: number, total: number) => void
}

export interface SharedClassifier {
  readonly classify: ClassifyCells
  /** Starts the helpers before they are needed. False where cells are decided one by one. */
  prepare(): Promise<boolean>
  /**
   * The first so many of the cells are known, and of all the points: they are decided before anybody asks. Who then asks for the same lists
   * of the same points and cells finds the answers.
   */
  know(points: Float64Array, cells: CellsInParts, count: number, wanted: Wanted): void
  /** The helpers that have started. */
  readers(): readonly PartReader[]
  /** Ends them. */
  close(): Promise<void>
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
    return own ? alone(own, indices(cells.length), wanted) : alone(points, cells, wanted)
  }
  /** Null before it has started, and where it cannot. */
  let ready: Crew | null = null
  let crew: Promise<Crew | null> | null = null
  const crewOnce = () => {
    crew ??= once()
      .then(module => crewOf(module, helper))
      .then(
        found => {
          ready = found
          return found
        },
        () => null,
      )
    return crew
  }
  let begun: Deciding | null = null
  const classify = async (points: Float64Array, cells: Uint32Array, wanted: Wanted) => {
    const whole = cells.length >= 8 * MANY ? await crewOnce() : null
    if (!whole) return few(points, cells, wanted)
    const all = wantedOf(wanted)
    const isBegun = begun && areSame(begun.points, points) && areSame(begun.cells, cells) && areAlike(begun.wanted, all)
    const deciding = begun && isBegun ? begun : new Deciding(whole, { points, cells, parts: null }, all)
    begun = null
    deciding.onProgress = onProgress
    deciding.know(cells.length / 8)
    return deciding.answers
  }
  return {
    classify: classify as ClassifyCells,
    prepare: async () => (await crewOnce()) !== null,
    know(points, cells, count, wanted) {
      if (!ready || cells.list.length < 8 * MANY) return
      if (begun?.cells !== cells.list)
        begun = new Deciding(ready, { points, cells: cells.list, parts: cells.parts }, wantedOf(wanted))
      begun.know(count)
    },
    readers: () =>
      [...(ready?.helpers ?? [])].map(helper => ({
        halve: (bytes, onPiece) => {
          const onProgress = (piece: HalvesOfPiece, giveBack: (list: Uint32Array) => void) => {
            onPiece(piece)
            giveBack(piece.list)
          }
          return helper.run('halve', bytes, { onProgress })
        },
        unpack: (bytes, part) => helper.run('unpack', { bytes, part }),
      })),
    async close() {
      for (const own of (await crew)?.helpers ?? []) own.stop(new Error('The helpers were ended.'))
    },
  }
}

/** The same memory. */
function areSame<T extends Float64Array | Uint32Array>(a: T, b: T): boolean {
  return a.buffer === b.buffer && a.byteOffset === b.byteOffset && a.length === b.length
}

function areAlike(a: Wanted, b: Wanted): boolean {
  return JSON.stringify(a) === JSON.stringify(b)
}

function indices(count: number): Uint32Array {
  const own = new Uint32Array(count)
  for (let i = 0; i < count; ++i) own[i] = i
  return own
}

/** Null if one of them is not there. */
function pointsOf(points: Float64Array, cells: Uint32Array): Float64Array | null {
  const own = new Float64Array(3 * cells.length)
  for (let i = 0; i < cells.length; ++i) {
    const from = 3 * (cells[i] as number)
    if (from >= points.length) return null
    own[3 * i] = points[from] as number
    own[3 * i + 1] = points[from + 1] as number
    own[3 * i + 2] = points[from + 2] as number
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
