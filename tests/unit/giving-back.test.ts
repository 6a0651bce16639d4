/** Memory of a progress goes back to the worker that has told of it, while its job goes on. */
import { afterAll, expect, test } from 'vitest'
import { Pool } from '../../web/core/workers'
import type { FillingJobs } from './filling-worker'
import { endThreads, threadsOf } from './node-workers'

const spawn = await threadsOf('tests/unit/filling-worker.ts')
afterAll(endThreads)

test('one list is enough', async () => {
  const pool = new Pool<null, FillingJobs>({ name: 'A worker', size: 1, spawn, start: null })
  const told: number[][] = []
  const onProgress = (list: Uint32Array, giveBack: (memory: unknown) => void) => {
    told.push([...list])
    giveBack(list)
    expect(list.length).toBe(0)
  }
  for (const times of [5, 3]) expect(await pool.run('fill', times, { onProgress })).toBe(1)
  expect(told).toEqual([0, 1, 2, 3, 4, 0, 1, 2].map(i => Array(4).fill(i)))
})
