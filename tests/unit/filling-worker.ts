/** A worker that tells of memory again and again, and fills what comes back. */
import { serve } from '../../web/core/workers'

const spare: Uint32Array<ArrayBuffer>[] = []
const backAgain = () => new Promise(resolve => setTimeout(resolve, 1))

export type FillingJobs = { fill(times: number, tell: (list: Uint32Array) => void): Promise<number> }

serve<null, FillingJobs>(
  'filling',
  () => ({
    /** How many lists it has made. */
    async fill(times, tell) {
      let made = 0
      for (let i = 0; i < times; ++i) {
        while (made > 0 && spare.length === 0) await backAgain()
        const own = spare.pop() ?? new Uint32Array(4)
        if (made === 0) made++
        tell(own.fill(i))
      }
      return made
    },
  }),
  (list: Uint32Array<ArrayBuffer>) => spare.push(list),
)
