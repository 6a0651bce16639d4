/**
 * Counts the errors of other checks: over random elements, the invalid ones each accepts and the
 * valid ones each rejects; and the valid ones that tangents do not certify, by their number.
 */
import { readFileSync } from 'node:fs'
import type { CoreExports } from '../../web/core/core'
import type { Check, Report } from '../../web/core/report'
import { core, randomHexahedron, randomSource } from '../unit/core-fixtures'

const ELEMENTS = 20000
const SIGMAS = [0.1, 0.2, 0.3, 0.5, 1]
const MOST_TANGENTS = 8

export async function main(): Promise<void> {
  console.log(`${ELEMENTS} elements a column: the unit cube with normal displacements`)
  const columns = SIGMAS.map(sigma => reports(sigma))
  row('sigma', SIGMAS)
  row(
    'invalid',
    columns.map(column => column.filter(({ valid }) => !valid).length),
  )
  for (const id of (columns[0]?.[0]?.checks ?? []).map(check => check.id)) {
    row(`accepted by ${id}`, count(columns, id, false))
    row(`${id === 'tangents' ? 'not certified' : 'rejected'} by ${id}`, count(columns, id, true))
  }
  await byTangents(columns)
}

interface TangentExports extends CoreExports {
  tangent_bound(vertices: number, tangents: number): number
}

async function byTangents(columns: readonly Report[][]): Promise<void> {
  const bytes = readFileSync(new URL('../../build/hexlens-scalar.wasm', import.meta.url))
  const imports = { env: { emscripten_notify_memory_growth() {} } }
  const wasm = (await WebAssembly.instantiate(bytes, imports)).instance.exports as unknown as TangentExports
  wasm._initialize?.()
  const input = new Float64Array(wasm.memory.buffer, wasm.input_address(), wasm.input_length())
  console.log('\nvalid elements not certified, by the number of tangents; microseconds an element')
  row(
    'valid',
    columns.map(column => column.filter(({ valid }) => valid).length),
  )
  for (let tangents = 1; tangents <= MOST_TANGENTS; ++tangents) {
    const start = performance.now()
    const missed = columns.map(
      column =>
        column.filter(({ valid, vertices }) => {
          input.set(vertices)
          return !(wasm.tangent_bound(wasm.input_address(), tangents) > 0) && valid
        }).length,
    )
    const each = ((performance.now() - start) * 1000) / (ELEMENTS * SIGMAS.length)
    row(`${tangents} (${each.toFixed(1)} us)`, missed)
  }
}

function reports(sigma: number): Report[] {
  const random = randomSource(1)
  return Array.from({ length: ELEMENTS }, () => {
    const result = core.analyze(randomHexahedron(random, sigma))
    if (!result.ok) throw new Error(result.error.message)
    return result.value
  })
}

/** The number of valid, or of invalid, elements on which the check is wrong. */
function count(columns: readonly Report[][], id: Check['id'], valid: boolean): number[] {
  const isWrong = (report: Report) => report.checks.some(check => check.id === id && check.passes !== valid)
  return columns.map(column => column.filter(report => report.valid === valid && isWrong(report)).length)
}

function row(name: string, values: readonly number[]): void {
  console.log(name.padEnd(32) + values.map(value => String(value).padStart(9)).join(''))
}
