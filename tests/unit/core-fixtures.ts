/** The real core and real elements for the unit tests. */
import { readFileSync } from 'node:fs'
import { loadCore } from '../../web/core/core'

export { randomSource } from './random'

export const wasmBytes = readFileSync(new URL('../../build/hexlens.wasm', import.meta.url))

export const core = await loadCore(wasmBytes)

export interface Case {
  readonly name: string
  readonly family: string
  readonly vertices: readonly (readonly [number, number, number])[]
  readonly bits: readonly string[]
  readonly answer: {
    readonly valid: boolean
    readonly sign: -1 | 0 | 1
    readonly boundary_min: string
    readonly corner_min: string
    readonly edge_min: string
    readonly scale: string
    readonly volume_min: { readonly lower: string; readonly upper: string }
  }
}

/** Hard cases with answers from exact arithmetic; each one's doubles are checked against its bits when loaded. */
export const cases: readonly Case[] = JSON.parse(
  readFileSync(new URL('../vectors/public_cases.json', import.meta.url), 'utf8'),
)

/** Valid elements, proved by exact subdivision, that a subdivision which gives up past depth 4 rejects. */
export const depthGuardCases: readonly Pick<Case, 'name' | 'vertices'>[] = JSON.parse(
  readFileSync(new URL('../vectors/depth_guard_false_negatives.json', import.meta.url), 'utf8'),
)

for (const { name, vertices, bits } of cases) {
  const words = new BigUint64Array(new Float64Array(vertices.flat()).buffer)
  for (const [i, word] of words.entries())
    if (word.toString(16).padStart(16, '0') !== bits[i])
      throw new Error(`${name}: coordinate ${i} was not read bit for bit`)
}

export const unitCube = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]

/** The unit cube with independent normal displacements. */
export function randomHexahedron(random: () => number, sigma: number): number[] {
  return unitCube.map(x => x + sigma * Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random()))
}

/** The element at an index that must exist. */
export function entry<T>(list: readonly T[], index: number): T {
  const found = list[index]
  if (found === undefined) throw new Error(`There is no entry ${index}.`)
  return found
}

export function caseVertices(name: string): number[] {
  const found = cases.find(candidate => candidate.name === name)
  if (!found) throw new Error(`There is no case ${name}.`)
  return found.vertices.flat()
}

/** Every number in it, at any depth. */
export function numbersIn(report: object): number[] {
  const numbers: number[] = []
  JSON.stringify(report, (_, value) => {
    if (typeof value === 'number') numbers.push(value)
    return value
  })
  return numbers
}
