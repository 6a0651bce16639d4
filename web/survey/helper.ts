/** Another worker of an open mesh: decides cells, and reads parts of its file. */
import { type BatchJobs, startBatchJobs } from '../core/batch/batch-jobs'
import { readingFiles } from '../core/reading-files'
import type { ReadingCore } from '../core/reading-interface'
import { serve } from '../core/workers'
import type { HalvesOfPiece } from '../input/file-at-hand'
import { eachPiece } from '../input/pieces-of'
import { type PackedPart, type UnpackedPart, unpackedPart } from '../input/unpacking'

export type HelperJobs = BatchJobs & {
  /** Holds points for pieces that come without any. */
  hold(points: Float64Array): null
  /** Reads integers of 64 bits, and tells of them piece after piece. */
  halve(bytes: Blob, tell: (piece: HalvesOfPiece) => void): Promise<null>
  /** Null where the blocks are damaged. */
  unpack(job: { readonly bytes: Blob; readonly part: PackedPart }): Promise<UnpackedPart | null>
}

/** Lists of pieces that have been told of. */
const spare: Uint32Array<ArrayBuffer>[] = []

function spareList(count: number): Uint32Array<ArrayBuffer> {
  const own = spare.pop()
  return own && own.length >= count ? own.subarray(0, count) : new Uint32Array(count)
}

serve<WebAssembly.Module, HelperJobs>('hexlens-helper', start, (list: Uint32Array<ArrayBuffer>) => spare.push(list))

async function start(module: WebAssembly.Module): Promise<HelperJobs> {
  const started = readingFiles()
  async function reading(): Promise<ReadingCore> {
    const core = await started
    if (!core) throw new Error('The core for reading did not start.')
    return core
  }
  const { core, jobs } = await startBatchJobs(module)
  return {
    ...jobs,
    hold(points) {
      core.hold(points)
      return null
    },
    async halve(bytes, tell) {
      const core = await reading()
      await eachPiece(bytes, (piece, at) => tell({ ...core.lowHalves(piece, spareList(piece.length / 8)), at }))
      return null
    },
    unpack: async ({ bytes, part }) => unpackedPart(await bytes.arrayBuffer(), part, await reading()),
  }
}
