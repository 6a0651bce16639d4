/** Times one call from TypeScript, report and all, on random elements; medians of rounds. */
import { readFileSync } from 'node:fs'
import { cpus } from 'node:os'
import { loadCore } from '../../web/core/core'
import type { Core } from '../../web/core/report'
import { cases, randomHexahedron, randomSource } from '../unit/core-fixtures'

const ROUNDS = 15
const ELEMENTS = 2000

function median(values: number[]): number {
  return values.sort((x, y) => x - y)[values.length >> 1] as number
}

export async function main(): Promise<void> {
  const bytes = readFileSync(new URL('../../build/hexlens.wasm', import.meta.url))
  const starts: number[] = []
  for (let round = 0; round < ROUNDS; ++round) {
    const begin = performance.now()
    const fresh = await loadCore(bytes)
    fresh.isValid([...Array(24).keys()])
    starts.push(performance.now() - begin)
  }
  const core = await loadCore(bytes)
  const random = randomSource(1)
  const hexahedra = Array.from({ length: ELEMENTS }, (_, n) => randomHexahedron(random, 0.1 * (1 + (n % 20))))
  const queries = {
    'analyze, the whole report': (hexahedron: number[]) => core.analyze(hexahedron),
    'boundary minimum, Roots': (hexahedron: number[]) => core.boundaryMinimum(hexahedron, 'roots'),
    'boundary minimum, Roots+B': (hexahedron: number[]) => core.boundaryMinimum(hexahedron, 'roots-b'),
    validity: (hexahedron: number[]) => core.isValid(hexahedron),
  }
  const times = new Map(Object.keys(queries).map(name => [name, [] as number[]]))
  for (let round = 0; round < ROUNDS; ++round)
    for (const [name, query] of Object.entries(queries)) {
      const begin = performance.now()
      for (const hexahedron of hexahedra) query(hexahedron)
      times.get(name)?.push(((performance.now() - begin) / ELEMENTS) * 1000)
    }
  console.log(
    `${cpus()[0]?.model}, Node ${process.version}: median of ${ROUNDS} rounds of ${ELEMENTS} elements, sigma 0.1 to 2`,
  )
  for (const [name, values] of times) console.log(`${median(values).toFixed(2).padStart(8)} us  ${name}`)
  console.log(`${median(starts).toFixed(2).padStart(8)} ms  from the module's bytes to the first verdict`)
  const byIntegers = cases
    .map(({ vertices }) => vertices.flat())
    .filter(hexahedron => decidedBy(core, hexahedron) === 'exact')
  const exactTimes = byIntegers.map(hexahedron =>
    median(
      Array.from({ length: ROUNDS }, () => {
        const begin = performance.now()
        core.analyze(hexahedron)
        return performance.now() - begin
      }),
    ),
  )
  const worst = Math.max(...exactTimes)
  console.log(
    `${median(exactTimes).toFixed(2).padStart(8)} ms  analyze, a hard case that integers decide; the worst of ${byIntegers.length}: ${worst.toFixed(2)} ms`,
  )
}

function decidedBy(core: Core, hexahedron: readonly number[]): string {
  const result = core.analyze(hexahedron)
  return result.ok ? result.value.decidedBy : 'refused'
}
