/** Batches are their cells one by one, exactly, in one thread and on workers. */
import { afterAll, expect, it } from 'vitest'
import type { CellChunk, Classification } from '../../web/core/batch/classify'
import { type Answers, type CellStatus, STATUSES, type Wanted } from '../../web/core/batch/lists'
import type { Report, Result } from '../../web/core/report'
import { ALL_LISTS, expectAsReports } from './batch-answers'
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

it('answers as one by one on hard cases, with vectors and without', () => {
  const hexahedra = [...hardHexahedra, ...mixedHexahedra(20260701, 1000)]
  const all = batchCores.vectors.classify(piece(hexahedra), ALL_LISTS)
  expectAsReports(hexahedra.map(reportOf), all)
  for (const [c, { name, answer }] of cases.entries()) expect(all.valid[c] === 1, name).toBe(answer.valid)
  expect(all.exactCount).toBeGreaterThan(30)
  expect(all.exactCount).toBe(all.exact.reduce((a, b) => a + b, 0))
  expect(all.validCount + all.invalidCount).toBe(hexahedra.length)
  expect([all.unansweredCount, all.firstUnanswered]).toEqual([0, null])
  expect(batchCores.scalar.classify(piece(hexahedra), ALL_LISTS)).toEqual(all)
})

/** All that a choice of lists has, and null for the others. */
function expectOnly(wanted: Wanted, answers: Answers, all: Answers): void {
  for (const list of Object.keys(ALL_LISTS) as (keyof typeof ALL_LISTS)[])
    if (list !== 'exact' || !wanted.exact) expect(answers[list], list).toEqual(wanted[list] ? all[list] : null)
  expect(answers.valid).toEqual(all.valid)
}

it('answers in each list alone what it answers in all of them', () => {
  const hexahedra = [...hardHexahedra, ...mixedHexahedra(20260705, 200)]
  const all = batchCores.vectors.classify(piece(hexahedra), ALL_LISTS)
  expectOnly({}, batchCores.vectors.classify(piece(hexahedra), {}), all)
  for (const list of Object.keys(ALL_LISTS) as (keyof typeof ALL_LISTS)[]) {
    const wanted = { [list]: true }
    expectOnly(wanted, batchCores.vectors.classify(piece(hexahedra), wanted), all)
    expectOnly(
      { ...ALL_LISTS, [list]: false },
      batchCores.scalar.classify(piece(hexahedra), { ...ALL_LISTS, [list]: false }),
      all,
    )
  }
  // Verdicts alone need integers less often than minima do.
  const { exact, exactCount } = batchCores.vectors.classify(piece(hexahedra), { exact: true })
  for (const [c, isExact] of exact.entries()) if (isExact) expect(all.exact[c]).toBe(1)
  expect(exactCount).toBe(exact.reduce((a, b) => a + b, 0))
  expect(exactCount).toBeGreaterThan(30)
})

it('answers as one by one in every length', () => {
  const hexahedra = mixedHexahedra(20260702, 66)
  for (let length = 0; length <= 33; ++length) {
    const some = hexahedra.slice(length, 2 * length)
    expectAsReports(some.map(reportOf), batchCores.vectors.classify(piece(some), ALL_LISTS))
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

function answer<W extends Wanted>(result: Result<Classification<W>>): Classification<W> {
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

it('gives the same on one worker and on three, for shared points and for coordinates, in their order', async () => {
  const mesh = grid(9, 1.4)
  const count = mesh.cells.length / 8
  expect(count).toBeGreaterThan(2 * CELLS_PER_PIECE)
  const progress: number[] = []
  const options = { ...ALL_LISTS, onProgress: ({ done }: { done: number }) => progress.push(done) }
  const first = answer(await one.classify(mesh.points, mesh.cells, options))
  const other = answer(await three.classify(mesh.points, mesh.cells, ALL_LISTS))
  expect(other).toEqual(first)
  expect(answer(await three.classify(expanded(mesh), null, ALL_LISTS))).toEqual(first)
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
  for (const c of sample)
    expect(first.valid[c] === 1, `cell ${c}`).toBe(reportOf([...all.subarray(24 * c, 24 * c + 24)]).valid)
})

/** Checks the lists' entries of an unanswered cell. */
function expectUnanswered(answers: Answers<typeof ALL_LISTS>, cell: number, status: CellStatus): void {
  const { valid, minima, relativeMinima, volumes, classes, acceptedBy, exact, statuses } = answers
  expect(STATUSES[statuses[cell] as number], `cell ${cell}`).toBe(status)
  const numbers = [minima.values, minima.cornerMinima, relativeMinima, volumes.values].map(list => list[cell])
  expect([...numbers, ...minima.minimizers.subarray(3 * cell, 3 * cell + 3)]).toEqual(Array(7).fill(Number.NaN))
  const integers = [valid, minima.exponents, volumes.exponents, classes, acceptedBy, exact].map(list => list[cell])
  expect(integers).toEqual([0, 0, 0, 0, 0, 0])
}

it('a cell that is none is unanswered and does not stop the others, wherever it is', async () => {
  const count = 3 * CELLS_PER_PIECE
  const random = randomSource(20260706)
  const hexahedra = Array.from({ length: count }, () => randomHexahedron(random, 0.3))
  const points = new Float64Array(hexahedra.flat())
  const cells = Uint32Array.from({ length: 8 * count }, (_, i) => i)
  const healthy = answer(await three.classify(points, null, ALL_LISTS))
  const bad = new Map<number, CellStatus>([
    [0, 'not-finite'],
    [7, 'no-such-point'],
    [CELLS_PER_PIECE - 1, 'not-finite'],
    [CELLS_PER_PIECE, 'not-finite'],
    [2 * CELLS_PER_PIECE + 3, 'no-such-point'],
    [count - 1, 'no-such-point'],
  ])
  for (const [cell, status] of bad) {
    if (status === 'not-finite') points[24 * cell + (cell % 24)] = cell % 2 ? Number.NaN : Number.NEGATIVE_INFINITY
    else cells[8 * cell + (cell % 8)] = cell % 2 ? 8 * count : 0xffffffff
  }
  // Indices far apart: each piece has its points one by one. Near: those between the least and the greatest.
  const places = Uint32Array.from({ length: count }, (_, c) => (c * 7) % count)
  const scattered = Uint32Array.from(cells, (_, i) =>
    entry([...cells.subarray(8 * entry([...places], i >> 3), 8 * entry([...places], i >> 3) + 8)], i % 8),
  )
  for (const [list, placeOf] of [
    [cells, (c: number) => c],
    [scattered, (c: number) => entry([...places], c)],
  ] as const) {
    const answers = answer(await three.classify(points, list, ALL_LISTS))
    const chunk = { points: points.slice(), cells: list.slice() }
    for await (const streamed of three.stream([chunk], { ...ALL_LISTS, handOver: true }))
      expect(answer(streamed)).toEqual(answers)
    expect([answers.unansweredCount, answers.firstUnanswered]).toEqual([6, 0])
    expect(answers.validCount + answers.invalidCount).toBe(count - 6)
    for (let c = 0; c < count; ++c) {
      const status = bad.get(placeOf(c))
      if (status) expectUnanswered(answers, c, status)
      else {
        const whole = [
          answers.valid,
          answers.minima.values,
          answers.relativeMinima,
          answers.volumes.values,
          answers.acceptedBy,
        ]
        const before = [
          healthy.valid,
          healthy.minima.values,
          healthy.relativeMinima,
          healthy.volumes.values,
          healthy.acceptedBy,
        ]
        expect(whole.map(one => one[c])).toEqual(before.map(one => one[placeOf(c)]))
      }
    }
  }
  const verdicts = answer(await one.classify(points.subarray(24), null))
  expect(verdicts).toMatchObject({ unansweredCount: 2, firstUnanswered: CELLS_PER_PIECE - 2, minima: null })
  const nothing = answer(await one.classify(new Float64Array(0), cells.subarray(0, 8 * 201), ALL_LISTS))
  expect([nothing.unansweredCount, nothing.firstUnanswered]).toEqual([201, 0])
  expectUnanswered(nothing, 200, 'no-such-point')
})

it('refuses lists of a wrong length', async () => {
  const points = new Float64Array(48)
  const cells = new Uint32Array(16)
  const refusal = async (...[list, indices = null]: [Float64Array, (Uint32Array | null)?]) => {
    const result = await three.classify(list, indices)
    const chunk = { points: list.slice(), cells: indices?.slice() ?? null }
    for await (const streamed of three.stream([chunk], { handOver: true })) expect(streamed).toEqual(result)
    return result.ok ? null : result.error
  }
  expect(await refusal(points)).toBeNull()
  expect(await refusal(points, cells)).toBeNull()
  const code = 'incomplete'
  expect(await refusal(points.subarray(1))).toEqual({
    code,
    cell: 1,
    message: 'Cell 1 is incomplete: 24 coordinates make one.',
  })
  expect(await refusal(points, cells.subarray(3))).toEqual({
    code,
    cell: 1,
    message: 'Cell 1 is incomplete: eight indices make one.',
  })
  expect(await refusal(points.subarray(1), cells)).toEqual({
    code,
    message: 'The last point is incomplete: three coordinates make one, and there are 47.',
  })
  expect(await one.classify(new Float64Array(0), null)).toMatchObject({ ok: true, value: { validCount: 0 } })
})

it('streams chunks in their order and stops at the first that is refused', async () => {
  const random = randomSource(20260704)
  const chunks = Array.from({ length: 7 }, () =>
    piece(Array.from({ length: 100 }, () => randomHexahedron(random, 0.3))),
  )
  const expected = chunks.map(chunk => batchCores.scalar.classify(chunk, { minima: true }))
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
  entry(chunks, 3).points[24 * 17] = Number.NaN
  const whole = entry(chunks, 4)
  chunks[4] = { ...whole, points: whole.points.subarray(0, 24 * 17 + 5) }
  let asked = 0
  const source = function* (): Generator<CellChunk> {
    for (const chunk of chunks) {
      asked += 1
      yield chunk
    }
  }
  const seen = []
  for await (const result of one.stream(source())) seen.push(result.ok ? result.value.firstUnanswered : result.error)
  expect(seen.slice(0, 4)).toEqual([null, null, null, 17])
  expect(seen[4]).toMatchObject({ cell: 417, message: 'Cell 417 is incomplete: 24 coordinates make one.' })
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
