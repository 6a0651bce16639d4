/** Native, wasm and its twin in JavaScript give the same bits: the native program's output against the others' own memory. */
import { execFileSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import * as twin from '../../build/hexlens-twin.js'
import { emptyLists } from '../../web/core/batch/lists'
import { type CoreExports, coreOf } from '../../web/core/core'
import { isWhole } from '../exact/scale'
import { ALL_LISTS, expectAsReports } from './batch-answers'
import { cases, core, depthGuardCases, randomHexahedron, randomSource, unitCube, wasmBytes } from './core-fixtures'
import { batchCores } from './node-workers'

const POINT = [0.25, 0.625, 0.8125]

/**
 * The order of wasm/src/pack.c: verdict, whether integers gave it, exponent, minimizer, error,
 * volume minimum, checks, maximizer, three minima and 27 coefficients come before the faces; after
 * the candidates class, shape, coincidences, volume with its exponent, relative minimum.
 */
const FACES_AT = 3 + 9 + 1 + 8 + 8 + 9 + 3 + 27
const AFTER_CANDIDATES = 2 + 8 + 3

/** The last of the list: exact arithmetic takes longest for random bits, since they have all exponents. */
const FROM_BITS = 300

/** The twin takes hundreds of times as long for one of these as for another: npm run test:exact compares all. */
const TWIN_FROM_BITS = isWhole ? FROM_BITS : FROM_BITS / 5

function hexahedra(): number[][] {
  const random = randomSource(20260505)
  const list = [...cases, ...depthGuardCases].map(({ vertices }) => vertices.flat())
  for (let n = 0; n < 5700; ++n) list.push(randomHexahedron(random, 0.1 * (1 + (n % 20))))
  for (let n = 0; n < 2000; ++n) list.push(randomHexahedron(random, 0.5).map(x => Math.round(x * 4) / 4))
  list.push(unitCube.with(5, Number.NaN))
  const bits = new BigUint64Array(24)
  for (let n = 0; n < FROM_BITS; ++n) {
    for (let i = 0; i < 24; ++i)
      bits[i] = (BigInt(Math.floor(random() * 2 ** 32)) << 32n) | BigInt(Math.floor(random() * 2 ** 32))
    list.push([...new Float64Array(bits.buffer.slice(0))])
  }
  return list
}

function answersOf(core: CoreExports, list: readonly number[][]): Float64Array {
  core._initialize?.()
  const input = new Float64Array(core.memory.buffer, core.input_address(), core.input_length())
  const output = new Float64Array(core.memory.buffer, core.output_address(), core.output_length())
  const answers: number[] = []
  const take = (count: number) => answers.push(...output.subarray(0, count))
  for (const vertices of list) {
    input.set(vertices)
    input.set(POINT, 24)
    const status = core.analyze()
    answers.push(status)
    if (status !== 0) continue
    take(packedReportLength(output))
    for (const variant of [0, 1]) {
      core.boundary_minimum(variant)
      take(11)
    }
    core.decide()
    take(1)
    core.jacobian_at()
    take(17)
  }
  return new Float64Array(answers)
}

/** Lists are preceded by their counts. */
function packedReportLength(packed: Float64Array): number {
  let at = FACES_AT
  for (let face = 0; face < 6; ++face) {
    at += 9 + 4 + 5 + 2
    at += 1 + 4 * (packed[at] as number)
  }
  return at + 1 + 9 * (packed[at] as number) + AFTER_CANDIDATES
}

const wasmFolder = fileURLToPath(new URL('../../wasm', import.meta.url))

function native(list: readonly number[][], ...words: string[]): Buffer {
  execFileSync('make', ['-s', '-C', wasmFolder, 'parity'])
  return execFileSync(`${wasmFolder}/../build/native/parity`, words, {
    input: new Uint8Array(new Float64Array(list.flat()).buffer),
    maxBuffer: 2 ** 28,
  })
}

it('agrees bit for bit on the exact cases, random elements and random bits', async () => {
  const list = hexahedra()
  const answers = native(list)
  const { instance } = await WebAssembly.instantiate(wasmBytes, {})
  const wasm = answersOf(instance.exports as unknown as CoreExports, list)
  expect(answers.byteLength).toBe(wasm.byteLength)
  expect(Buffer.from(wasm.buffer).equals(answers)).toBe(true)
  expect(wasm.length).toBeGreaterThan(400 * 7000)
  const twins = answersOf(twin, list.slice(0, list.length - FROM_BITS + TWIN_FROM_BITS))
  expect(twins.length).toBeGreaterThan(400 * 7000)
  expect(Buffer.from(twins.buffer).equals(answers.subarray(0, twins.byteLength))).toBe(true)
})

/** Bytes, so that NaN equals NaN: all lists have it for a cell that is not finite. */
function bytesOf(list: ArrayBufferView | undefined): Buffer {
  return list ? Buffer.from(list.buffer, list.byteOffset, list.byteLength) : Buffer.alloc(0)
}

it('classifies with the same bits natively and in wasm, and as the reports say', () => {
  const list = hexahedra()
  const all = native(list, 'batch')
  const piece = { points: new Float64Array(list.flat()), cells: null, firstPoint: 0 }
  for (const batchCore of Object.values(batchCores)) {
    const lists = emptyLists(list.length, ALL_LISTS)
    const answers = batchCore.classify(piece, ALL_LISTS, { into: () => lists })
    // The verdicts, which come first, are 1 and 0 where the native ones tell what is invalid from what is unanswered.
    const valid = all.subarray(0, list.length).map(verdict => verdict & 1)
    expect(bytesOf(answers.valid).equals(valid)).toBe(true)
    let at = list.length
    for (const one of lists.slice(1)) {
      const bytes = bytesOf(one ?? undefined)
      expect(bytes.equals(all.subarray(at, at + bytes.length))).toBe(true)
      at += bytes.length
    }
    expect(at).toBe(all.length)
    expect([answers.unansweredCount, answers.firstUnanswered]).toEqual([
      list.filter(isNotFinite).length,
      list.findIndex(isNotFinite),
    ])
  }
})

function isNotFinite(vertices: readonly number[]): boolean {
  return vertices.some(x => !Number.isFinite(x))
}

it.each([
  { by: 'wasm', analyze: core.analyze },
  { by: 'its twin', analyze: coreOf(twin).analyze },
])('classifies as reports of $by say, in every list', ({ analyze }) => {
  const list = hexahedra()
    .filter(vertices => !isNotFinite(vertices))
    .filter((_, n) => n < 1000 || n % 4 === 0)
  const reports = list.map(vertices => {
    const result = analyze(vertices)
    if (!result.ok) throw new Error(result.error.message)
    return result.value
  })
  const piece = { points: new Float64Array(list.flat()), cells: null, firstPoint: 0 }
  for (const batchCore of Object.values(batchCores)) expectAsReports(reports, batchCore.classify(piece, ALL_LISTS))
})
