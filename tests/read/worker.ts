/** A thread that reads mutations from one number to another, each told of before and after. */
import { setImmediate } from 'node:timers/promises'
import { parentPort, workerData } from 'node:worker_threads'
import { loadHdf5, reading } from './reading'

const { seed, from, to, step } = workerData as { seed: number; from: number; to: number; step: number }

for (let number = from; number < to; number += step) {
  parentPort?.postMessage({ begun: number })
  await loadHdf5()
  const { fault, mutation, outcome, milliseconds, timesRead } = reading(seed, number)
  const { path, name, steps } = mutation
  parentPort?.postMessage({
    number,
    outcome,
    fault: fault === null ? null : `${path}, as ${JSON.stringify(name)} (${steps.join(', ')}): ${fault}`,
    milliseconds,
    timesRead,
  })
  // The memory that zlib has held is given back between turns of the event loop.
  await setImmediate()
}
