/** Batches are their cells one by one, exactly, in one thread and on workers. */
import { afterAll, expect, it } from 'vitest'
import type { PieceResult } from '../../web/core/batch/batch-core'
import type { CellChunk, Classification } from '../../web/core/batch/classify'
import type { Report } from '../../web/core/report'
import { cases, core, depthGuardCases, entry, randomHexahedron, randomSource, unitCube } from './core-fixtures'
import { batchCores, endThreads, nodeClassifier } from './node-workers'

/** Small, so that few cells are many pieces. */
const CELLS_PER_PIECE = 200

const one = await nodeClassifier(1, { cellsPerPiece: CELLS_PER_PIECE })
const three = await nodeClassifier(3, { cellsPerPiece: CELLS_PER_PIECE })
afterAll(async () => {
  one.close()
  three.close()
  await endThreads()
})

function piece(hexahedra: readonly (readonly number[])[]) {
  return { points: new Float64Array(hexahedra.flat()), cells: null, firstPoint: 0 }
}

const hardHexahedra = [...cases, ...depthGuardCases].map(({ vertices }) => vertices.flat())

/** Random elements, and elements of small integers: many touch zero. */
function mixedHexahedra(seed: number, count: number): number[][] {
  const random = randomSource(seed)
  return Array.from({ length: count }, (_, n) => {
    const hexahedron = randomHexahedron(random, 0.1 * (n % 21))
    return n % 4 ? hexahedron : hexahedron.map(x => Math.round(2 * x) / 2)
  })
}

const reports = new Map<readonly number[], Report>()

function reportOf(hexahedron: readonly number[]): Report {
  const known = reports.get(hexahedron)
  if (known) return known
  const result = core.analyze(hexahedron)
  if (!result.ok) throw new Error(result.error.message)
  reports.set(hexahedron, result.value)
  return result.value
}

function expectAsOneByOne(hexahedra: readonly number[][], valid: Uint8Array, minima: PieceResult['minima']): void {
  for (const [c, hexahedron] of hexahedra.entries()) {
    const report = reportOf(hexahedron)
    expect(valid[c] === 1, `cell ${c}: ${hexahedron}`).toBe(report.valid)
    if (!minima) continue
    expect([...minima.minimizers.subarray(3 * c, 3 * c + 3)], `minimizer of cell ${c}`).toEqual(report.minimizer.point)
    if (report.exponent === minima.exponents[c]) {
      expect(minima.values[c]).toBe(report.boundaryMinimum)
      expect(minima.cornerMinima[c]).toBe(report.cornerMinimum)
    } else {
      // The report has more numbers to bring to one exponent.
      expect(minima.exponents[c]).toBe(0)
      expect(minima.values[c]).toBe(timesPowerOfTwo(report.boundaryMinimum, report.exponent))
    }
  }
}

function timesPowerOfTwo(value: number, exponent: number): number {
  const half = Math.trunc(exponent / 2)
  return value * 2 ** half * 2 ** (exponent - half)
}

it('answers as one by one on hard cases, with vectors and without', () => {
  const hexahedra = [...hardHexahedra, ...mixedHexahedra(20260701, 1000)]
  const all = batchCores.vectors.classify(piece(hexahedra), true)
  const { valid, minima, exact } = all
  expectAsOneByOne(hexahedra, valid, minima)
  for (const [c, { name, answer }] of cases.entries()) expect(valid[c] === 1, name).toBe(answer.valid)
  expect(exact).toBeGreaterThan(30)
  expect(batchCores.scalar.classify(piece(hexahedra), true)).toEqual(all)
  const withoutMinima = batchCores.vectors.classify(piece(hexahedra), false)
  expect([withoutMinima.valid, withoutMinima.minima]).toEqual([valid, null])
})

it('answers as one by one in every length', () => {
  const hexahedra = mixedHexahedra(20260702, 66)
  for (let length = 0; length <= 33; ++length) {
    const some = hexahedra.slice(length, 2 * length)
    const { valid, minima, fault } = batchCores.vectors.classify(piece(some), true)
    expect([valid.length, fault]).toEqual([length, null])
    expectAsOneByOne(some, valid, minima)
  }
})

/** A grid of n^3 cells with shared, shaken points. */
function grid(n: number, sigma: number): { points: Float64Array; cells: Uint32Array } {
  const random = randomSource(20260703)
  const points: number[] = []
  const cells: number[] = []
  const at = (i: number, j: number, k: number) => (i * (n + 1) + j) * (n + 1) + k
  for (let i = 0; i <= n; ++i)
    for (let j = 0; j <= n; ++j)
      for (let k = 0; k <= n; ++k) points.push(...[i, j, k].map(x => x + sigma * (random() - 0.5)))
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j)
      for (let k = 0; k < n; ++k)
        for (let v = 0; v < 8; ++v)
          cells.push(at(i + entry(unitCube, 3 * v), j + entry(unitCube, 3 * v + 1), k + entry(unitCube, 3 * v + 2)))
  return { points: new Float64Array(points), cells: new Uint32Array(cells) }
}

function expanded({ points, cells }: ReturnType<typeof grid>): Float64Array {
  return new Float64Array([...cells].flatMap(index => [...points.subarray(3 * index, 3 * index + 3)]))
}

function answer(result: Awaited<ReturnType<typeof one.classify>>): Classification {
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

it('gives the same on one worker and on three, for shared points and for coordinates, in their order', async () => {
  const mesh = grid(9, 1.4)
  const count = mesh.cells.length / 8
  expect(count).toBeGreaterThan(2 * CELLS_PER_PIECE)
  const progress: number[] = []
  const options = { minima: true, onProgress: ({ done }: { done: number }) => progress.push(done) }
  const first = answer(await one.classify(mesh.points, mesh.cells, options))
  const other = answer(await three.classify(mesh.points, mesh.cells, { minima: true }))
  expect(other).toEqual(first)
  expect(answer(await three.classify(expanded(mesh), null, { minima: true }))).toEqual(first)
  // Indices far apart: every piece has points of the whole mesh.
  const scattered = mesh.cells.slice()
  for (let c = 0; c < count; ++c) scattered.copyWithin(8 * c, 8 * ((c * 7919) % count), 8 * ((c * 7919) % count) + 8)
  const again = answer(await three.classify(mesh.points, scattered))
  expect(again.minima).toBeNull()
  expect(first.validCount).toBe(first.valid.reduce((a, b) => a + b, 0))
  expect(first.validCount).toBeGreaterThan(count / 10)
  expect(first.validCount).toBeLessThan(count)
  expect(progress.length).toBeGreaterThanOrEqual(3)
  expect(progress).toEqual(progress.toSorted((a, b) => a - b))
  expect(progress.at(-1)).toBe(count)
  expect([one.threads.length, three.threads.length]).toEqual([1, 3])
  const sample = [0, 1, count >> 1, count - 1]
  const all = expanded(mesh)
  expectAsOneByOne(
    sample.map(c => [...all.subarray(24 * c, 24 * c + 24)]),
    new Uint8Array(sample.map(c => entry([...first.valid], c))),
    null,
  )
})

it('refuses with the first cell that is none, wherever the others are', async () => {
  const count = 3 * CELLS_PER_PIECE
  const points = new Float64Array(24 * count)
  for (let c = 0; c < count; ++c) points.set(unitCube, 24 * c)
  const at = (cell: number) => 24 * cell + 7
  const refusal = async (...[list, cells = null]: [Float64Array, (Uint32Array | null)?]) => {
    const result = await three.classify(list, cells)
    const chunk = { points: list.slice(), cells: cells?.slice() ?? null }
    for await (const streamed of three.stream([chunk], { handOver: true })) expect(streamed).toEqual(result)
    return result.ok ? null : result.error
  }
  expect(await refusal(points)).toBeNull()
  for (const cell of [0, CELLS_PER_PIECE - 1, CELLS_PER_PIECE, count - 1]) {
    const bad = points.slice()
    bad[at(cell)] = Number.NaN
    bad[at(count - 1)] = Number.POSITIVE_INFINITY
    const message = `Cell ${cell}, vertex 2 y is not a finite number.`
    expect(await refusal(bad)).toEqual({ code: 'not-finite', cell, message })
  }
  expect(await refusal(points.subarray(0, 24 * count - 1))).toMatchObject({ code: 'incomplete', cell: count - 1 })
  const cells = Uint32Array.from({ length: 8 * count }, (_, i) => i)
  expect(await refusal(points, cells)).toBeNull()
  expect(await refusal(points, cells.subarray(0, 8 * count - 3))).toMatchObject({ code: 'incomplete', cell: count - 1 })
  expect(await refusal(points.subarray(1), cells)).toMatchObject({ code: 'no-such-point', cell: count - 1 })
  cells[8 * 400 + 3] = 8 * count
  expect(await refusal(points, cells)).toEqual({
    code: 'no-such-point',
    cell: 400,
    message: `Cell 400, vertex 3: there is no point ${8 * count}.`,
  })
  points[at(399)] = Number.NaN
  expect(await refusal(points, cells)).toMatchObject({ code: 'not-finite', cell: 399 })
  const many = new Float64Array(24 * 1100 + 5)
  for (let c = 0; c < 1100; ++c) many.set(unitCube, 24 * c)
  const fault = (list: Float64Array) =>
    batchCores.vectors.classify({ points: list, cells: null, firstPoint: 0 }, false).fault
  expect([fault(many.subarray(0, 24 * 1100)), fault(many)]).toEqual([null, { cell: 1100, code: 'incomplete' }])
  many[at(1050)] = Number.NaN
  expect(fault(many)).toEqual({ cell: 1050, code: 'not-finite' })
  expect(await one.classify(new Float64Array(0), null)).toMatchObject({ ok: true, value: { validCount: 0 } })
})

it('streams chunks in their order and stops at the first refusal', async () => {
  const random = randomSource(20260704)
  const chunks = Array.from({ length: 7 }, () =>
    piece(Array.from({ length: 100 }, () => randomHexahedron(random, 0.3))),
  )
  const expected = chunks.map(chunk => batchCores.scalar.classify(chunk, true))
  const answers: Classification[] = []
  for await (const result of three.stream(chunks, { minima: true })) answers.push(answer(result))
  expect(answers.map(({ valid, minima }) => ({ valid, minima }))).toEqual(
    expected.map(({ valid, minima }) => ({ valid, minima })),
  )
  const handedOver = chunks.map(({ points }) => ({ points: points.slice() }))
  const all = new Float64Array(chunks.flatMap(({ points }) => [...points]))
  const parts = chunks.map(({ points }, n) => ({ points: all.subarray(n * points.length, (n + 1) * points.length) }))
  for (const given of [handedOver, parts]) {
    const same: Classification[] = []
    for await (const result of three.stream(given, { minima: true, handOver: true })) same.push(answer(result))
    expect(same).toEqual(answers)
  }
  expect(handedOver.every(({ points }) => points.length === 0)).toBe(true)
  expect(parts.every(({ points }) => points.length > 0)).toBe(true)
  entry(chunks, 4).points[24 * 17] = Number.NaN
  let asked = 0
  const source = function* (): Generator<CellChunk> {
    for (const chunk of chunks) {
      asked += 1
      yield chunk
    }
  }
  const seen = []
  for await (const result of one.stream(source())) seen.push(result.ok ? 'ok' : result.error)
  expect(seen.slice(0, 4)).toEqual(['ok', 'ok', 'ok', 'ok'])
  expect(seen[4]).toMatchObject({ cell: 417, message: 'Cell 417, vertex 0 x is not a finite number.' })
  expect([seen.length, asked]).toEqual([5, 6])
})

it('ends when it is told to, and only what belongs to that call', async () => {
  const mesh = grid(12, 1)
  const controller = new AbortController()
  const cancelled = three.classify(mesh.points, mesh.cells, {
    signal: controller.signal,
    onProgress: () => controller.abort(new Error('enough')),
  })
  const other = three.classify(mesh.points, mesh.cells)
  await expect(cancelled).rejects.toThrow('enough')
  expect(answer(await other).valid).toEqual(answer(await one.classify(mesh.points, mesh.cells)).valid)
  await expect(three.classify(mesh.points, mesh.cells, { signal: controller.signal })).rejects.toThrow('enough')
})
