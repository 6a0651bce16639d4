/**
 * Whatever is done to a file, reading it ends in a mesh that is well-formed or in a sentence, within two seconds and in memory that the file
 * allows. All of it by `npm run test:read`; HEXLENS_SEED draws others, HEXLENS_MUTATION=123 reads one alone.
 */
import { availableParallelism } from 'node:os'
import { expect, it } from 'vitest'
import { seed } from '../property/replay'
import { corpus } from './corpus'
import { type Read, readMutations } from './threads'

const isWhole = process.env.HEXLENS_READ === 'whole'
const only = process.env.HEXLENS_MUTATION
const [FROM, TO] = only === undefined ? [0, isWhole ? 100_000 : 600] : [Number(only), Number(only) + 1]
const MOST_TOLD = 20

it(`${TO - FROM} mutations of ${corpus.length} files end in a mesh or a sentence`, { timeout: 7_200_000 }, async () => {
  const faults: string[] = []
  const counts = { mesh: 0, sentence: 0 }
  let slowest: Read | null = null
  const start = performance.now()
  await readMutations({ seed, from: FROM, to: TO, threads: Math.min(availableParallelism(), TO - FROM) }, read => {
    counts[read.outcome]++
    if (slowest === null || read.milliseconds > slowest.milliseconds) slowest = read
    if (read.fault === null) return
    faults.push(`HEXLENS_SEED=${seed} HEXLENS_MUTATION=${read.number}: ${read.fault}`)
  })
  if (isWhole) {
    const { number, milliseconds } = slowest as unknown as Read
    const seconds = Math.round((performance.now() - start) / 1000)
    process.stdout.write(
      `read: ${counts.mesh} meshes, ${counts.sentence} sentences, ${faults.length} faults (seed ${seed}), ${seconds} s; the slowest, ${number}, ${Math.round(milliseconds)} ms\n`,
    )
  }
  expect(faults.slice(0, MOST_TOLD)).toEqual([])
  expect(counts.mesh + counts.sentence).toBe(TO - FROM)
})
