/**
 * Times core.analyze on cubes whose coordinates are displaced by up to 0.3 and by up to 1, and its
 * share in wasm; cores in turn, a few cubes at a time, and of each few the median of rounds: also a
 * busy machine lets so short a time pass undisturbed. `--beside=FOLDER`, any number of times:
 * another tree of this project, built, measured in the same run.
 */
import { readFileSync } from 'node:fs'
import { cpus } from 'node:os'
import { join } from 'node:path'
import { runInThisContext } from 'node:vm'
import { buildSync } from 'esbuild'
import { root } from '../../tools/run.mjs'
import type { CoreExports, loadCore } from '../../web/core/core'
import { randomSource, unitCube } from '../unit/core-fixtures'

const ROUNDS = 101
const ELEMENTS = 500
const AT_A_TIME = 25
const DISPLACEMENTS = [0.3, 1]

interface Row {
  readonly name: string
  readonly run: (vertices: number[]) => void
  readonly hexahedra: readonly number[][]
  /** Times of each few cubes in each round. */
  readonly times: number[][]
}

function displacedCubes(displacement: number): number[][] {
  const random = randomSource(1)
  return Array.from({ length: ELEMENTS }, () => unitCube.map(x => x + displacement * (2 * random() - 1)))
}

/** Each tree's own, bundled, and compiled apart from the others'. */
function coreLoader(tree: string): typeof loadCore {
  const entryPoints = [join(tree, 'web/core/core.ts')]
  const { outputFiles } = buildSync({ entryPoints, bundle: true, globalName: 'core', write: false })
  return runInThisContext(`${outputFiles[0]?.text};core.loadCore`)
}

function timesOf(hexahedra: readonly number[][]): number[][] {
  return Array.from({ length: hexahedra.length / AT_A_TIME }, () => [])
}

async function rowsOf(tree: string): Promise<Row[]> {
  const bytes = readFileSync(join(tree, 'build/hexlens.wasm'))
  const core = await coreLoader(tree)(bytes)
  const { instance } = await WebAssembly.instantiate(bytes, {})
  const wasm = instance.exports as unknown as CoreExports
  wasm._initialize?.()
  const input = new Float64Array(wasm.memory.buffer, wasm.input_address(), 24)
  return DISPLACEMENTS.flatMap(displacement => {
    const hexahedra = displacedCubes(displacement)
    const inWasm = (vertices: number[]) => {
      input.set(vertices)
      wasm.analyze()
    }
    const name = `displaced by ${displacement}, ${tree === root ? 'here' : tree}`
    return [
      { name: `analyze, ${name}`, run: core.analyze, hexahedra, times: timesOf(hexahedra) },
      { name: `in wasm, ${name}`, run: inWasm, hexahedra, times: timesOf(hexahedra) },
    ]
  })
}

export async function main(options: readonly string[]): Promise<void> {
  const others = options.map(option => /^--beside=(.+)$/.exec(option)?.[1])
  const unknown = others.indexOf(undefined)
  if (unknown >= 0) throw new Error(`${options[unknown]} is not an option: --beside=FOLDER.`)
  const trees = [root, ...(others as string[])]
  const rows = (await Promise.all(trees.map(rowsOf))).flat()
  for (let round = 0; round < ROUNDS; ++round)
    for (const { run, hexahedra, times } of rows)
      for (const [few, list] of times.entries()) {
        const begin = performance.now()
        for (let n = few * AT_A_TIME; n < (few + 1) * AT_A_TIME; ++n) run(hexahedra[n] as number[])
        list.push(performance.now() - begin)
      }
  console.log(
    `${cpus()[0]?.model}, Node ${process.version}: ${ROUNDS} rounds of ${ELEMENTS} cubes; us, median and least`,
  )
  for (const { name, times } of rows) {
    for (const list of times) list.sort((x, y) => x - y)
    const [median, least] = [ROUNDS >> 1, 0].map(
      rank => (times.reduce((sum, list) => sum + (list[rank] as number), 0) / ELEMENTS) * 1000,
    )
    console.log(`${median?.toFixed(2).padStart(8)} ${least?.toFixed(2).padStart(8)}  ${name}`)
  }
}
