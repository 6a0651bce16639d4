/** Elements a second of each search that the page offers, with one worker and with two, in turns; medians of five. --quick: of three. */
import { performance } from 'node:perf_hooks'
import { Search } from '../../web/pages/search/engine/search'
import { searches } from '../../web/pages/search/searches'
import { batchModules, threadsOf } from '../unit/node-workers'

const MILLISECONDS = 2000

export async function main(options: readonly string[]): Promise<void> {
  const trials = options.includes('--quick') ? 3 : 5
  const spawn = await threadsOf('web/pages/search/engine/worker.ts')
  for (const { id, property, measure, distribution } of searches) {
    const rates: number[][] = [[], []]
    let share = 0
    for (let trial = 0; trial < trials; ++trial)
      for (const workers of [1, 2]) {
        const query = { property, measure, distribution, seed: trial + 1 }
        const search = await ran(
          resolve => new Search(query, { module: batchModules.vectors, count: workers, spawn }, ...resolve),
        )
        rates[workers - 1]?.push(search.rate)
        share = search.share
      }
    const [one, two] = rates.map(list => median(list)) as [number, number]
    console.log(
      `${id}: ${thousands(one)} a second with one worker, ${thousands(two)} with two (${(two / one).toFixed(2)} times); one of ${Math.round(1 / share)} elements is one`,
    )
  }
}

/** Runs for two seconds after one of warming up. */
function ran(
  create: (callbacks: [() => void, (reason: Error) => void]) => Search,
): Promise<{ rate: number; share: number }> {
  return new Promise((resolve, reject) => {
    let [since, elements] = [0, 0]
    const begun = performance.now()
    const onNews = () => {
      const now = performance.now()
      if (since === 0 && now - begun > MILLISECONDS / 2) [since, elements] = [now, search.elements]
      if (since === 0 || now - since < MILLISECONDS) return
      search.dispose()
      resolve({ rate: (1000 * (search.elements - elements)) / (now - since), share: search.found / search.elements })
    }
    const search = create([onNews, reject])
    search.start()
  })
}

function median(list: readonly number[]): number {
  return list.toSorted((a, b) => a - b)[list.length >> 1] as number
}

function thousands(rate: number): string {
  return `${Math.round(rate / 1000).toLocaleString('en')},000`
}
