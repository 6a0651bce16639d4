/**
 * Times exact arithmetic, natively and in wasm, beside ordinary random cells, against its bounds,
 * and counts the multiplications of integers of an answer. Medians in one run, sets interleaved.
 * --quick: three rounds.
 */
import { execFileSync, spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { cpus } from 'node:os'
import { fileURLToPath } from 'node:url'
import fc from 'fast-check'
import { coplanarCorner, SHAPES, spanning } from '../exact/families'
import { seed } from '../property/replay'
import { cases, core, depthGuardCases, randomHexahedron, randomSource } from '../unit/core-fixtures'
import { endThreads, nodeClassifier } from '../unit/node-workers'

const root = fileURLToPath(new URL('../..', import.meta.url))

/** Numbers of the queries of exact.c: one by one, then as a batch. */
const QUESTIONS = { verdict: 0, minimum: 1, report: 2, verdicts: 3, minima: 4 }
type Question = keyof typeof QUESTIONS

const ROUNDS = 15

interface Set {
  /** The name of a single element, if it has one. */
  readonly name?: string
  readonly question: Question
  readonly hexahedra: readonly (readonly number[])[]
}

/** Nanoseconds for one element. */
interface Measured {
  readonly native: number
  readonly wasm: number
  readonly multiplications: number
  readonly products: number
}

/** Several sets count by their median, or by the greatest; bounds are in nanoseconds. */
interface Row {
  readonly name: string
  readonly sets: readonly Set[]
  readonly by: 'median' | 'greatest'
  readonly bounds?: { readonly native?: number; readonly wasm: number }
}

const MICRO = 1e3
const MILLI = 1e6

/** The cells of a batch of exact.c. */
const CELLS = 512

export async function main(options: readonly string[]): Promise<void> {
  const rounds = options.includes('--quick') ? 3 : ROUNDS
  const rows = rowsOf()
  const sets = rows.flatMap(row => row.sets)
  const native = inNative(sets, rounds)
  const wasm = await inWasm(sets, rounds)
  const measured = new Map(sets.map((set, i) => [set, { ...(native[i] as Measured), wasm: wasm[i] as number }]))
  const cc = execFileSync('cc', ['--version'], { encoding: 'utf8' }).split('\n')[0]
  console.log(`${cpus()[0]?.model}, ${cc}, Node ${process.version}: medians of ${rounds} rounds, seed ${seed}`)
  console.log(
    ['native'.padStart(22), 'wasm'.padStart(22), 'multiplications'.padStart(16), 'of limbs'.padStart(12)].join(' '),
  )
  for (const row of rows)
    show(
      row,
      row.sets.map(set => measured.get(set) as Measured),
    )
  await aMillion(rounds)
}

function rowsOf(): Row[] {
  const random = randomSource(seed)
  const cells = (sigma: number) => Array.from({ length: CELLS }, () => randomHexahedron(random, sigma))
  const shaped = (places: readonly number[]) =>
    cells(0.1).map(hexahedron => places.flatMap(v => hexahedron.slice(3 * v, 3 * v + 3)))
  const degenerate = Object.entries(SHAPES).map(([shape, places]) => [shape, shaped(places)] as const)
  const coplanar = fc.sample(coplanarCorner, { seed, numRuns: CELLS }).filter(isLeftOpen)
  const corner = ['four coplanar points at a corner, 53 bits', coplanar] as const
  const leftOpen = degenerate.map(([shape, hexahedra]) => [shape, hexahedra.filter(isLeftOpen)] as const)
  const ordinary = [0.1, 0.5].map(sigma => [`ordinary, sigma ${sigma}`, cells(sigma)] as const)
  const apart = fc.sample(spanning, { seed, numRuns: 200 }).filter(isLeftOpen)
  const all = [...cases, ...depthGuardCases].map(({ name, vertices }) => ({ name, vertices: vertices.flat() }))
  const alone = (question: Question, elements: readonly { name: string; vertices: readonly number[] }[]): Set[] =>
    elements.map(({ name, vertices }) => ({ name, question, hexahedra: [vertices] }))
  const together = (
    question: Question,
    lists: readonly (readonly [string, readonly (readonly number[])[]])[],
    bounds?: Row['bounds'],
  ): Row[] =>
    lists.map(([name, hexahedra]) => ({
      name: `${question}, ${name}`,
      sets: [{ question, hexahedra }],
      by: 'median',
      ...(bounds && { bounds }),
    }))
  // Those of the vectors that span hundreds of powers of ten are in the rows that say so.
  const isWide = ({ vertices }: { vertices: readonly number[] }) => spread(vertices) >= MOST_SPREAD
  const vectors = all.filter(element => !isWide(element))
  const wide = [...apart.map((vertices, n) => ({ name: `drawn ${n}`, vertices })), ...all.filter(isWide)]
  return [
    ...together('verdict', ordinary),
    ...together('minimum', ordinary),
    ...together('report', ordinary),
    ...together('verdict', degenerate, { native: 0.2 * MICRO, wasm: 0.5 * MICRO }),
    ...together('verdict', [corner], { native: 2 * MICRO, wasm: 4 * MICRO }),
    ...together('minimum', [...leftOpen, corner], { native: 40 * MICRO, wasm: 80 * MICRO }),
    {
      name: 'verdict, the hardest vector',
      sets: alone('verdict', vectors),
      by: 'greatest',
      bounds: { native: 100 * MICRO, wasm: 200 * MICRO },
    },
    {
      name: 'minimum, the hardest vector',
      sets: alone('minimum', vectors),
      by: 'greatest',
      bounds: { native: 500 * MICRO, wasm: MILLI },
    },
    ...(['median', 'greatest'] as const).flatMap((by): Row[] => [
      {
        name: `verdict, hundreds of powers of ten, ${by}`,
        sets: alone('verdict', wide),
        by,
        bounds: { native: 0.2 * MILLI, wasm: 0.4 * MILLI },
      },
      {
        name: `report, hundreds of powers of ten, ${by}`,
        sets: alone('report', wide),
        by,
        bounds: { native: 5 * MILLI, wasm: 10 * MILLI },
      },
    ]),
    ...together('verdicts', [['a batch at sigma 0.1', cells(0.1)]]),
    ...together(
      'minima',
      [0, 0.1].map(sigma => [`a batch at sigma ${sigma}`, cells(sigma)] as const),
      { wasm: 75 },
    ),
  ]
}

/** True if integers decide it: doubles do for most. */
function isLeftOpen(vertices: readonly number[]): boolean {
  const result = core.analyze(vertices)
  return result.ok && result.value.decidedBy === 'exact'
}

/** Bits between the least and the greatest coordinate of an axis. */
const MOST_SPREAD = 300

function spread(vertices: readonly number[]): number {
  const powers = [0, 1, 2].map(axis =>
    vertices.filter((x, i) => i % 3 === axis && x !== 0).map(x => Math.log2(Math.abs(x))),
  )
  return Math.max(...powers.map(list => Math.max(...list) - Math.min(...list)))
}

/** Keeps a wasm sample long enough for the clock. */
const SAMPLE = 2

function inNative(sets: readonly Set[], rounds: number): Measured[] {
  const input = new Float64Array(
    sets.flatMap(({ question, hexahedra }) => [QUESTIONS[question], hexahedra.length, ...hexahedra.flat()]),
  )
  const { status, stdout, stderr } = spawnSync(`${root}build/native/exact`, [String(rounds)], {
    input: new Uint8Array(input.buffer),
    encoding: 'utf8',
  })
  if (status !== 0) throw new Error(`build/native/exact ended with status ${status}. ${stderr}`)
  return stdout
    .trim()
    .split('\n')
    .map(line => {
      const [native = Number.NaN, multiplications = 0, products = 0] = line.split(' ').map(Number)
      return { native, wasm: Number.NaN, multiplications, products }
    })
}

/** Milliseconds of this process alone, as exact.c measures. */
function cpuTime(): number {
  const { user, system } = process.cpuUsage()
  return (user + system) / 1000
}

interface Exports {
  readonly memory: WebAssembly.Memory
  _initialize?(): void
  elements_address(): number
  ask(question: number, count: number, repeats: number): void
}

async function inWasm(sets: readonly Set[], rounds: number): Promise<number[]> {
  const { instance } = await WebAssembly.instantiate(readFileSync(`${root}build/exact.wasm`), {})
  const wasm = instance.exports as unknown as Exports
  wasm._initialize?.()
  const timed = ({ question, hexahedra }: Set, repeats: number) => {
    const begin = cpuTime()
    wasm.ask(QUESTIONS[question], hexahedra.length, repeats)
    return cpuTime() - begin
  }
  const load = ({ hexahedra }: Set) =>
    new Float64Array(wasm.memory.buffer, wasm.elements_address(), 24 * hexahedra.length).set(hexahedra.flat())
  const repeats = sets.map(set => {
    load(set)
    let count = 1
    while (timed(set, count) < SAMPLE) count *= 2
    return count
  })
  const times = sets.map(() => [] as number[])
  for (let round = 0; round < rounds; ++round)
    for (const [i, set] of sets.entries()) {
      const count = repeats[i] as number
      load(set)
      times[i]?.push((timed(set, count) * MILLI) / (count * set.hexahedra.length))
    }
  return times.map(median)
}

function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1] as number
}

function show({ name, sets, by, bounds }: Row, measured: readonly Measured[]): void {
  const value = (what: keyof Measured) => {
    const values = measured.map(one => one[what])
    return by === 'median' ? median(values) : Math.max(...values)
  }
  const greatest = measured.findIndex(({ native }) => native === value('native'))
  const which = by === 'greatest' ? ` (natively ${sets[greatest]?.name})` : ''
  const [multiplications, products] = [value('multiplications'), value('products')].map(x => x.toFixed(0))
  console.log(
    [
      against(value('native'), bounds?.native).padStart(22),
      against(value('wasm'), bounds?.wasm).padStart(22),
      multiplications?.padStart(16),
      products?.padStart(12),
      ` ${name}${which}`,
    ].join(' '),
  )
}

function against(nanoseconds: number, bound: number | undefined): string {
  if (bound === undefined) return inUnits(nanoseconds)
  return `${inUnits(nanoseconds)} ${nanoseconds <= bound ? 'met' : 'NOT MET'} (${inUnits(bound)})`
}

function inUnits(nanoseconds: number): string {
  if (nanoseconds < MICRO) return `${nanoseconds.toFixed(0)} ns`
  return nanoseconds < MILLI ? `${(nanoseconds / MICRO).toFixed(1)} us` : `${(nanoseconds / MILLI).toFixed(2)} ms`
}

const MANY = 1_000_000
const MANY_BOUND = 300 * MILLI

/** A mesh of single cells, a third of them wedges, on one worker. */
async function aMillion(rounds: number): Promise<void> {
  const random = randomSource(seed)
  const ordinary = Array.from({ length: 1000 }, () => randomHexahedron(random, 0.1))
  const wedges = ordinary.map(hexahedron => SHAPES.wedge.flatMap(v => hexahedron.slice(3 * v, 3 * v + 3)))
  const meshes = [
    { name: 'a million cells, a third of them wedges, verdicts, one worker', bound: MANY_BOUND, every: 3 },
    { name: 'a million ordinary cells', bound: undefined, every: Number.POSITIVE_INFINITY },
  ].map(mesh => {
    const points = new Float64Array(24 * MANY)
    for (let c = 0; c < MANY; ++c) points.set((c % mesh.every === 2 ? wedges : ordinary)[c % 1000] as number[], 24 * c)
    return { ...mesh, points, times: [] as number[] }
  })
  const classifier = await nodeClassifier(1)
  for (let round = 0; round <= rounds; ++round)
    for (const { points, times } of meshes) {
      const begin = performance.now()
      const result = await classifier.classify(points, null)
      if (!result.ok) throw new Error(result.error.message)
      if (round > 0) times.push((performance.now() - begin) * MILLI)
    }
  classifier.close()
  await endThreads()
  for (const { name, bound, times } of meshes)
    console.log(`${''.padStart(22)} ${against(median(times), bound).padStart(22)} ${''.padStart(29)} ${name}`)
}
