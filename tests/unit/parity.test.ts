/** Native, wasm and its twin in JavaScript give the same bits: the native program's output against the others' own memory. */
import { execFileSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import * as twin from '../../build/hexlens-twin.js'
import type { CoreExports } from '../../web/core/core'
import { cases, depthGuardCases, randomHexahedron, randomSource, unitCube, wasmBytes } from './core-fixtures'

const POINT = [0.25, 0.625, 0.8125]

/** By the order of wasm/src/pack.c: verdict, exponent, minimizer, error, volume minimum, checks, maximizer, three minima. */
const BERNSTEIN_AT = 2 + 9 + 1 + 8 + 8 + 9 + 3

function hexahedra(): number[][] {
  const random = randomSource(20260505)
  const list = [...cases, ...depthGuardCases].map(({ vertices }) => vertices.flat())
  for (let n = 0; n < 5000; ++n) list.push(randomHexahedron(random, 0.1 * (1 + (n % 20))))
  for (let n = 0; n < 2000; ++n) list.push(randomHexahedron(random, 0.5).map(x => Math.round(x * 4) / 4))
  const bits = new BigUint64Array(24)
  for (let n = 0; n < 2000; ++n) {
    for (let i = 0; i < 24; ++i)
      bits[i] = (BigInt(Math.floor(random() * 2 ** 32)) << 32n) | BigInt(Math.floor(random() * 2 ** 32))
    list.push([...new Float64Array(bits.buffer.slice(0))])
  }
  list.push(unitCube.with(5, Number.NaN))
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
    const bernstein = [...output.subarray(BERNSTEIN_AT, BERNSTEIN_AT + 27)]
    take(packedReportLength(output))
    for (const variant of [0, 1]) {
      core.boundary_minimum(variant)
      take(10)
    }
    core.decide()
    take(1)
    input.set([...bernstein, -7, 2 ** -53, 0], 24)
    core.analyze_coefficients()
    take(packedReportLength(output))
    input.set(POINT, 24)
    core.jacobian_at()
    take(17)
  }
  return new Float64Array(answers)
}

/** Lists are preceded by their counts. */
function packedReportLength(packed: Float64Array): number {
  let at = BERNSTEIN_AT + 27
  for (let face = 0; face < 6; ++face) {
    at += 9 + 4 + 5 + 2
    at += 1 + 4 * (packed[at] as number)
  }
  return at + 1 + 9 * (packed[at] as number)
}

it('agrees bit for bit on the exact cases, random elements and random bits', async () => {
  const wasmFolder = fileURLToPath(new URL('../../wasm', import.meta.url))
  execFileSync('make', ['-s', '-C', wasmFolder, 'parity'])
  const list = hexahedra()
  const native = execFileSync(`${wasmFolder}/../build/native/parity`, {
    input: new Uint8Array(new Float64Array(list.flat()).buffer),
    maxBuffer: 2 ** 28,
  })
  const { instance } = await WebAssembly.instantiate(wasmBytes, {})
  const wasm = answersOf(instance.exports as unknown as CoreExports, list)
  expect(native.byteLength).toBe(wasm.byteLength)
  expect(Buffer.from(wasm.buffer).equals(native)).toBe(true)
  expect(wasm.length).toBeGreaterThan(400 * 7000)
  expect(Buffer.from(answersOf(twin, list).buffer).equals(native)).toBe(true)
})
