/**
 * The paper's two tables: Roots, Roots+B and Hexlens on 100,000 elements a sigma, the same draws for all, natively and in wasm.
 * --quick: five rows of 20,000. --json: as data. --save: into docs/benchmarks.md.
 */
import { execFileSync, spawnSync } from 'node:child_process'
import { readFileSync, writeFileSync } from 'node:fs'
import { cpus } from 'node:os'
import { fileURLToPath } from 'node:url'
import { exactBoundarySign } from '../../web/core/exact/exact-sign'
import { entry, randomSource, unitCube } from '../unit/core-fixtures'
import { gmshMinima } from './gmsh'
import { plot } from './plot'
import { markdown, type Row, text } from './tables'

const root = fileURLToPath(new URL('../..', import.meta.url))

const FULL = { sigmas: Array.from({ length: 21 }, (_, i) => i / 10), elements: 100_000 }
const QUICK = { sigmas: [0, 0.1, 0.3, 1, 2], elements: 20_000 }
const TRIALS = 9

const QUERIES = ['validity', 'minimum'] as const
/** The number of methods in sweep.c. */
const METHODS = 6
const HEXLENS = 2
const ROOTS_B = 1
const HL_VALID = 1

export async function main(options: readonly string[]): Promise<void> {
  const unknown = options.find(option => !['--quick', '--json', '--save'].includes(option))
  if (unknown) throw new Error(`${unknown} is not an option: --quick, --json, --save.`)
  const { sigmas, elements } = options.includes('--quick') ? QUICK : FULL
  const displacements = draws(24 * elements)
  const wasm = await wasmSweep(displacements)
  const rows: Row[] = []
  let vectors = ''
  for (const sigma of sigmas) {
    const native = nativeSweep(displacements, elements, sigma)
    vectors = native.vectors
    const inWasm = wasm.row(elements, sigma)
    const judged = wasm.judge(elements, displacements, sigma)
    for (const [q, query] of QUERIES.entries()) {
      const [own, other] = [entry(native.queries, q), entry(inWasm, q)]
      const wrong = query === 'validity' ? judged.wrong : other.farMinima
      // Nothing is known if the bits differ from the other target's.
      const disagreements = own.fingerprint === other.fingerprint ? wrong : elements
      const common = { query, sigma, elements, invalid: judged.invalid, undecided: other.undecided, disagreements }
      rows.push({ ...common, target: 'native', ...times(own.times), after_lanes: own.afterLanes })
      rows.push({ ...common, target: 'wasm', ...times(other.times), after_lanes: other.afterLanes })
    }
    if (!options.includes('--json')) process.stderr.write(`sigma ${sigma.toFixed(1)} is measured\n`)
  }
  const gmsh = options.includes('--json') ? null : gmshMinima(displacements, elements, sigmas)
  const about = machine(vectors, elements)
  if (options.includes('--json')) console.log(JSON.stringify({ ...about, rows }))
  else console.log(text(about, rows, gmsh))
  if (options.includes('--save')) save(markdown(about, rows, gmsh), plot(rows))
}

function machine(vectors: string, elements: number) {
  const compiler = execFileSync('cc', ['--version'], { encoding: 'utf8' }).split('\n')[0] as string
  return {
    machine: cpus()[0]?.model.trim() ?? '',
    compiler,
    vectors,
    node: process.version,
    elements,
    trials: TRIALS,
  }
}

function times([roots, rootsB, hexlens, determinants, lanes, loads]: readonly number[]) {
  const ns = (value: number | undefined) => Number((value as number).toFixed(1))
  return {
    roots_ns: ns(roots),
    roots_b_ns: ns(rootsB),
    hexlens_ns: ns(hexlens),
    determinants_ns: ns(determinants),
    lanes_ns: ns(lanes),
    loads_ns: ns(loads),
  }
}

/** Standard normal numbers, by Box and Muller. */
function draws(count: number): Float64Array {
  const random = randomSource(20260801)
  return Float64Array.from(
    { length: count },
    () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random()),
  )
}

interface Measured {
  readonly times: readonly number[]
  readonly afterLanes: number
  readonly undecided: number
  readonly fingerprint: number
  readonly farMinima: number
}

function nativeSweep(displacements: Float64Array, elements: number, sigma: number) {
  const { status, stdout, stderr } = spawnSync(
    `${root}build/native/sweep`,
    [String(elements), String(TRIALS), String(sigma)],
    { input: new Uint8Array(displacements.buffer), encoding: 'utf8' },
  )
  if (status !== 0) throw new Error(`build/native/sweep ended with status ${status}: ${stderr}`)
  const queries = stdout
    .trim()
    .split('\n')
    .map((line): Measured => {
      const numbers = line.split(' ').map(Number)
      const [afterLanes, undecided, fingerprint, farMinima] = numbers.slice(2 + METHODS) as [
        number,
        number,
        number,
        number,
      ]
      return { times: numbers.slice(2, 2 + METHODS), afterLanes, undecided, fingerprint, farMinima }
    })
  return { vectors: stderr.trim(), queries }
}

interface SweepExports {
  readonly memory: WebAssembly.Memory
  _initialize?(): void
  displacements_address(): number
  verdicts_address(): number
  roots_valid_address(): number
  set_sigma(elements: number, sigma: number): void
  run_method(query: number, method: number): void
  after_lanes(): number
  undecided(): number
  fingerprint_of(query: number): number
  far_minima_count(): number
}

async function wasmSweep(displacements: Float64Array) {
  const { instance } = await WebAssembly.instantiate(readFileSync(`${root}build/sweep.wasm`), {})
  const wasm = instance.exports as unknown as SweepExports
  wasm._initialize?.()
  new Float64Array(wasm.memory.buffer, wasm.displacements_address(), displacements.length).set(displacements)

  /** Nanoseconds an element, of this process alone. */
  function timed(query: number, method: number, elements: number): number {
    const before = process.cpuUsage()
    wasm.run_method(query, method)
    const { user, system } = process.cpuUsage(before)
    return (1000 * (user + system)) / elements
  }

  /** Lets the engine's optimizing compiler finish. */
  wasm.set_sigma(1000, 0.3)
  for (let n = 0; n < 200; ++n) for (const q of [0, 1]) for (let m = 0; m < METHODS; ++m) wasm.run_method(q, m)

  function row(elements: number, sigma: number): Measured[] {
    wasm.set_sigma(elements, sigma)
    return QUERIES.map((_, query) => {
      const all: number[][] = Array.from({ length: METHODS }, () => [])
      for (let trial = 0; trial < TRIALS; ++trial)
        for (let m = 0; m < METHODS; ++m) {
          const method = (m + trial) % METHODS
          all[method]?.push(timed(query, method, elements))
        }
      wasm.run_method(query, HEXLENS)
      wasm.run_method(query, ROOTS_B)
      return {
        times: all.map(values =>
          entry(
            values.toSorted((a, b) => a - b),
            TRIALS >> 1,
          ),
        ),
        afterLanes: wasm.after_lanes(),
        undecided: wasm.undecided(),
        fingerprint: wasm.fingerprint_of(query) >>> 0,
        farMinima: query === 1 ? wasm.far_minima_count() : 0,
      }
    })
  }

  /** Exact arithmetic of the oracle says who is right where Roots+B says otherwise. */
  function judge(elements: number, all: Float64Array, sigma: number) {
    wasm.run_method(0, HEXLENS)
    wasm.run_method(0, ROOTS_B)
    const verdicts = new Uint8Array(wasm.memory.buffer, wasm.verdicts_address(), elements)
    const roots = new Uint8Array(wasm.memory.buffer, wasm.roots_valid_address(), elements)
    let [wrong, invalid] = [0, 0]
    for (const [n, verdict] of verdicts.entries()) {
      const isValid = verdict === HL_VALID
      if (isValid === (roots[n] === 1)) {
        if (!isValid) invalid += 1
        continue
      }
      const vertices = unitCube.map((x, i) => x + sigma * (all[24 * n + i] as number))
      const isExactlyValid = exactBoundarySign(vertices) > 0
      if (!isExactlyValid) invalid += 1
      if (isExactlyValid !== isValid) wrong += 1
    }
    return { wrong, invalid }
  }

  return { row, judge }
}

const BEGIN = '<!-- From here to the end marker: npm run bench -- --save -->'
const END = '<!-- end -->'

function save(tables: string, svg: string): void {
  const path = `${root}docs/benchmarks.md`
  const [before, rest] = readFileSync(path, 'utf8').split(BEGIN)
  const after = rest?.split(END)[1]
  if (before === undefined || after === undefined) throw new Error(`${path} has lost its markers.`)
  writeFileSync(path, `${before}${BEGIN}\n\n${tables}\n\n${END}${after}`)
  writeFileSync(`${root}docs/benchmarks.svg`, svg)
}
