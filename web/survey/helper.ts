/** Another worker of an open mesh: decides cells, and reads parts of its file. */
import { type BatchJobs, startBatchJobs } from '../core/batch/batch-jobs'
import { readingFiles } from '../core/reading-files'
import { serve } from '../core/workers'
import { type LowHalves, lowHalves } from '../input/low-halves'
import { type PackedPart, type UnpackedPart, unpackedPart } from '../input/unpacking'

export type HelperJobs = BatchJobs & {
  /** Holds points for pieces that come without any. */
  hold(points: Float64Array): null
  /** Reads integers of 64 bits. */
  halve(bytes: Blob): Promise<LowHalves>
  /** Null where the blocks are damaged. */
  unpack(job: { readonly bytes: Blob; readonly part: PackedPart }): Promise<UnpackedPart | null>
}

serve<WebAssembly.Module, HelperJobs>('hexlens-helper', async module => {
  const reading = readingFiles()
  const { core, jobs } = await startBatchJobs(module)
  return {
    ...jobs,
    hold(points) {
      core.hold(points)
      return null
    },
    halve: async bytes => lowHalves(await bytes.arrayBuffer()),
    async unpack({ bytes, part }) {
      const core = await reading
      if (!core) throw new Error('The core for reading did not start.')
      return unpackedPart(await bytes.arrayBuffer(), part, core)
    },
  }
})
