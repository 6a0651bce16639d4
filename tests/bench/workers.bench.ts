/**
 * Two workers against one for 2 million elements, by the clock, in turns; then 10 million random elements as a stream, and the memory
 * that takes. The clock counts what others do on the machine: its load is named.
 */
import { availableParallelism, cpus, loadavg } from 'node:os'
import type { CellChunk, Classifier } from '../../web/core/batch/classify'
import { entry, randomSource, unitCube } from '../unit/core-fixtures'
import { nodeClassifier } from '../unit/node-workers'

const ELEMENTS = 2_000_000
const ROUNDS = 9
const STREAMED = 10_000_000
const CHUNK = 20_000
const SIGMA = 0.3
const MEGABYTE = 2 ** 20

export async function main(): Promise<void> {
  console.log(
    `${cpus()[0]?.model.trim()}, ${availableParallelism()} cores, load ${loadavg()[0]?.toFixed(1)}; Node ${process.version}; sigma ${SIGMA}`,
  )
  await stream()
  const elements = randomElements(ELEMENTS)
  await compare('24 coordinates a cell, in chunks that are handed over', ELEMENTS, inChunks(elements))
  await compare('24 coordinates a cell, in one list', ELEMENTS, atOnce(elements, null))
  const { points, cells } = mesh()
  await compare('shared points and indices', cells.length / 8, atOnce(points, cells))
}

/** Standard normal numbers to take from: as many as are different enough, and quick. */
const normals = (() => {
  const random = randomSource(20260901)
  return Float64Array.from(
    { length: 2 ** 20 + 7 },
    () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random()),
  )
})()

function randomElements(count: number, seed = 0): Float64Array {
  const points = new Float64Array(24 * count)
  let at = (seed * 7919) % normals.length
  for (let i = 0; i < points.length; ++i) {
    points[i] = (unitCube[i % 24] as number) + SIGMA * (normals[at] as number)
    if (++at === normals.length) at = 0
  }
  return points
}

/** A grid of 126^3 cells, about as many, whose points are shaken. */
function mesh(): { points: Float64Array; cells: Uint32Array } {
  const n = Math.round(ELEMENTS ** (1 / 3))
  const points = new Float64Array(3 * (n + 1) ** 3)
  const cells = new Uint32Array(8 * n ** 3)
  const at = (i: number, j: number, k: number) => (i * (n + 1) + j) * (n + 1) + k
  let [p, c] = [0, 0]
  for (let i = 0; i <= n; ++i)
    for (let j = 0; j <= n; ++j)
      for (let k = 0; k <= n; ++k)
        for (const x of [i, j, k]) points[p] = x + SIGMA * (normals[p++ % normals.length] as number)
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j)
      for (let k = 0; k < n; ++k)
        for (let v = 0; v < 24; v += 3)
          cells[c++] = at(i + (unitCube[v] as number), j + (unitCube[v + 1] as number), k + (unitCube[v + 2] as number))
  return { points, cells }
}

/** A trial: the first call prepares, untimed, what the second one takes. */
type Ask = (minima: boolean) => (classifier: Classifier) => Promise<unknown>

function atOnce(points: Float64Array, cells: Uint32Array | null): Ask {
  return minima => async classifier => {
    const result = await classifier.classify(points, cells, { minima })
    if (!result.ok) throw new Error(result.error.message)
  }
}

/** The memory that comes back with the answers is what the next trial's chunks lie in. */
function inChunks(points: Float64Array): Ask {
  const length = 24 * CHUNK
  let blocks = Array.from({ length: points.length / length }, () => new Float64Array(length).buffer)
  return minima => {
    const chunks = blocks.map(block => ({ points: new Float64Array(block) }))
    for (const [n, chunk] of chunks.entries()) chunk.points.set(points.subarray(n * length, (n + 1) * length))
    return async classifier => {
      blocks = []
      for await (const result of classifier.stream(chunks, { minima, handOver: true })) {
        if (!result.ok) throw new Error(result.error.message)
        blocks.push(result.value.valid.buffer as ArrayBuffer)
      }
    }
  }
}

async function compare(what: string, count: number, ask: Ask): Promise<void> {
  const classifiers = [await nodeClassifier(1), await nodeClassifier(2)]
  for (const minima of [false, true]) {
    const times: number[][] = [[], []]
    for (let round = 0; round <= ROUNDS; ++round)
      for (const k of round % 2 ? [1, 0] : [0, 1]) {
        const run = ask(minima)
        const begin = performance.now()
        await run(classifiers[k] as Classifier)
        if (round > 0) times[k]?.push(performance.now() - begin) // the first round starts the workers
      }
    const [one, two] = times.map(list =>
      entry(
        list.toSorted((a, b) => a - b),
        ROUNDS >> 1,
      ),
    ) as [number, number]
    const [best, other] = times.map(list => Math.min(...list)) as [number, number]
    const ns = (ms: number) => `${((1e6 * ms) / count).toFixed(0)} ns`
    console.log(
      `${what}, ${minima ? 'minima' : 'verdicts'}, ${count} cells: one worker ${ns(one)}, two ${ns(two)} a cell: ${(one / two).toFixed(2)} times; the best of ${ROUNDS} rounds ${ns(best)} and ${ns(other)}: ${(best / other).toFixed(2)} times`,
    )
  }
  for (const classifier of classifiers) classifier.close()
}

async function stream(): Promise<void> {
  const classifier = await nodeClassifier(2)
  function* chunks(): Generator<CellChunk> {
    for (let n = 0; n < STREAMED / CHUNK; ++n) yield { points: randomElements(CHUNK, n) }
  }
  const before = process.memoryUsage.rss()
  let [most, cells, valid] = [before, 0, 0]
  for await (const result of classifier.stream(chunks(), { minima: true, handOver: true })) {
    if (!result.ok) throw new Error(result.error.message)
    cells += result.value.valid.length
    valid += result.value.validCount
    most = Math.max(most, process.memoryUsage.rss())
  }
  classifier.close()
  const megabytes = (bytes: number) => `${(bytes / MEGABYTE).toFixed(0)} MB`
  console.log(
    `stream of ${cells} elements, ${valid} of them valid, with minima: ${megabytes(most - before)} of memory more than before, workers and all (the process had ${megabytes(before)})`,
  )
}
