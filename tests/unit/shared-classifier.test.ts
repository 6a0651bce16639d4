/** Cells shared out among workers are answered as by one. */
import { afterAll, expect, test } from 'vitest'
import { KNOWN_OF_PART, PART } from '../../web/core/reading-interface'
import type { WorkerPort } from '../../web/core/workers'
import { sharedClassifier } from '../../web/survey/shared-classifier'
import { core, randomSource, unitCube } from './core-fixtures'
import { batchCores, batchModules, endThreads, threadsOf } from './node-workers'

const LISTS = {
  minima: true,
  statuses: true,
  classes: true,
  volumes: true,
  coincident: true,
  acceptedInvalid: true,
  box: true,
}
const SIDE = 42

/** A shaken lattice of 42^3 cubes with a point that is not finite. */
function lattice(isShuffled: boolean): { points: Float64Array; cells: Uint32Array } {
  const next = randomSource(5)
  const along = SIDE + 1
  const count = along ** 3
  const place = Uint32Array.from({ length: count }, (_, i) => i)
  if (isShuffled)
    for (let i = count - 1; i > 0; --i) {
      const j = Math.floor(next() * (i + 1))
      ;[place[i], place[j]] = [place[j] as number, place[i] as number]
    }
  const points = new Float64Array(3 * count)
  const at = (i: number, j: number, k: number) => place[i + along * (j + along * k)] as number
  for (let k = 0; k < along; ++k)
    for (let j = 0; j < along; ++j)
      for (let i = 0; i < along; ++i)
        points.set(
          [i, j, k].map(x => x + 0.9 * (next() - 0.5)),
          3 * at(i, j, k),
        )
  points[3 * at(30, 30, 30)] = Number.NaN
  const cells = new Uint32Array(8 * SIDE ** 3)
  for (let k = 0, to = 0; k < SIDE; ++k)
    for (let j = 0; j < SIDE; ++j)
      for (let i = 0; i < SIDE; ++i)
        for (let v = 0; v < 8; ++v)
          cells[to++] = at(
            i + (unitCube[3 * v] as number),
            j + (unitCube[3 * v + 1] as number),
            k + (unitCube[3 * v + 2] as number),
          )
  return { points, cells }
}

const spawn = await threadsOf('web/survey/helper.ts')
afterAll(endThreads)

/** By their bytes: millions of numbers. */
function expectSame(own: object, expected: object): void {
  expect(Object.keys(own).toSorted()).toEqual(Object.keys(expected).toSorted())
  for (const [name, value] of Object.entries(own)) {
    const other = (expected as Record<string, unknown>)[name]
    if (ArrayBuffer.isView(value) && ArrayBuffer.isView(other)) expect(bytesOf(value).equals(bytesOf(other))).toBe(true)
    else if (typeof value === 'object' && value !== null) expectSame(value, other as object)
    else expect(value).toBe(other)
  }
}

function bytesOf({ buffer, byteOffset, byteLength }: ArrayBufferView): Buffer {
  return Buffer.from(buffer as ArrayBuffer, byteOffset, byteLength)
}

function none(): WorkerPort {
  throw new Error('none')
}

test.each([
  { name: 'in order', isShuffled: false, helper: spawn },
  { name: 'shuffled', isShuffled: true, helper: spawn },
  { name: 'without a helper', isShuffled: true, helper: none },
])('$name', async ({ isShuffled, helper }) => {
  const { points, cells } = lattice(isShuffled)
  const expected = batchCores.vectors.classify({ points, cells, firstPoint: 0 }, LISTS)
  let most = 0
  const { classify, close } = sharedClassifier({
    core,
    batchModule: async () => batchModules.vectors,
    helper,
    onProgress: done => {
      most = Math.max(most, done)
    },
  })
  for (let again = 0; again < 2; ++again) {
    const answers = await classify(points, cells, LISTS)
    expectSame(answers, expected)
    expect(answers.unansweredCount).toBe(8)
  }
  expect(most).toBe(SIDE ** 3)
  await close()
})

test('where WebAssembly is forbidden it says that cells are decided one by one', async () => {
  const forbidden = () => Promise.reject(new Error('forbidden'))
  const prepared = (batchModule: () => Promise<WebAssembly.Module>) =>
    sharedClassifier({ core, batchModule, helper: none, onProgress() {} }).prepare()
  expect(await prepared(forbidden)).toBe(false)
  expect(await prepared(async () => batchModules.vectors)).toBe(true)
})

/** With what is known of each part of a file's indices; the steps are nobody's question. */
function inParts(list: Uint32Array) {
  const parts = new Int32Array(KNOWN_OF_PART * Math.ceil(list.length / PART))
  for (let part = 0; KNOWN_OF_PART * part < parts.length; ++part) {
    const own = list.subarray(PART * part, PART * (part + 1))
    parts[KNOWN_OF_PART * part] = own.reduce((a, b) => Math.min(a, b))
    parts[KNOWN_OF_PART * part + 1] = own.reduce((a, b) => Math.max(a, b))
  }
  return { list, parts }
}

test.each([
  { name: 'in order', isShuffled: false, helper: spawn },
  { name: 'shuffled', isShuffled: true, helper: spawn },
  { name: 'without a helper', isShuffled: false, helper: none },
])('cells that become known bit by bit, $name', async ({ isShuffled, helper }) => {
  const { points, cells } = lattice(isShuffled)
  const expected = batchCores.vectors.classify({ points, cells, firstPoint: 0 }, LISTS)
  const shared = sharedClassifier({ core, batchModule: async () => batchModules.vectors, helper, onProgress() {} })
  // Nobody is there yet, so that nothing is begun.
  shared.know(points, inParts(cells), 100, LISTS)
  await shared.classify(points.slice(), cells.slice(), {})
  const known = inParts(new Uint32Array(cells.length))
  for (let count = 0; count < SIDE ** 3; ) {
    const more = Math.min(count + 10_240, SIDE ** 3)
    known.list.set(cells.subarray(8 * count, 8 * more), 8 * count)
    const own = inParts(known.list.subarray(8 * count, 8 * more)).parts
    known.parts.set(own, (8 * KNOWN_OF_PART * count) / PART)
    count = more
    shared.know(points, known, count, LISTS)
    await new Promise(resolve => setTimeout(resolve))
  }
  expectSame(await shared.classify(points, known.list, LISTS), expected)
  // Other lists, and other cells in the place of those that were known, are asked for anew.
  shared.know(points, known, 10_240, LISTS)
  expectSame(
    await shared.classify(points, known.list, {}),
    batchCores.vectors.classify({ points, cells, firstPoint: 0 }, {}),
  )
  await shared.close()
})

test.each([
  { name: 'with helpers', helper: spawn },
  { name: 'without a helper', helper: none },
])('the worst cells are among the candidates of all who decide, $name', async ({ helper }) => {
  const { points, cells } = lattice(true)
  const { relativeMinima } = batchCores.vectors.classify({ points, cells, firstPoint: 0 }, { relativeMinima: true })
  const worst = Array.from(relativeMinima.keys()).filter(cell => !Number.isNaN(relativeMinima[cell]))
  worst.sort((a, b) => (relativeMinima[a] as number) - (relativeMinima[b] as number))
  const shared = sharedClassifier({ core, batchModule: async () => batchModules.vectors, helper, onProgress() {} })
  const { candidates } = await shared.classify(points, cells, { minima: true, worst: 64 })
  expect(worst.slice(0, 64).filter(cell => !candidates?.cells.includes(cell))).toEqual([])
  expect(candidates?.cells.length).toBeLessThan(1000)
  // Fewer than several decide together.
  const few = cells.subarray(0, 8 * 5000)
  const alone = (await shared.classify(points, few, { minima: true, worst: 64 })).candidates
  expect(
    worst
      .filter(cell => cell < 5000)
      .slice(0, 64)
      .filter(cell => !alone?.cells.includes(cell)),
  ).toEqual([])
  expect((await shared.classify(points, few, { minima: true })).candidates).toBeNull()
  await shared.close()
})
