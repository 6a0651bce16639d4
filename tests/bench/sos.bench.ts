/**
 * The boundary minimum beside lower bounds of jacdet by sums of squares, as Marschner, Palmer, Zhang and Solomon (2020) compute them,
 * of degrees 4, 6 and 8: on 200 elements of the sweep and on the hard cases. --quick: degrees 4 and 6.
 */
import { spawnSync } from 'node:child_process'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Vertices } from '../../web/model/hexahedron'
import { cases, core, randomSource, unitCube } from '../unit/core-fixtures'
import { gmshMinima } from './gmsh'

const root = fileURLToPath(new URL('../..', import.meta.url))
const script = fileURLToPath(new URL('sos_minimum.py', import.meta.url))
const requirements = fileURLToPath(new URL('sos-requirements.txt', import.meta.url))
const folder = join(root, 'build', 'bench', 'sos')
const python = join(folder, 'bin', 'python')

const SIGMAS = Array.from({ length: 20 }, (_, i) => (i + 1) / 10)
const PER_SIGMA = 10
/** Shares of the largest Bernstein coefficient up to this count as none: the solver ends at 1e-8 of its own scale. */
const AGREES = 1e-6
const TRIALS = 9

export async function main(options: readonly string[]): Promise<void> {
  const unknown = options.find(option => option !== '--quick')
  if (unknown) throw new Error(`${unknown} is not an option: --quick.`)
  installSolver()
  const displacements = draws(24 * PER_SIGMA * SIGMAS.length)
  const sweep = SIGMAS.flatMap((sigma, s) =>
    Array.from({ length: PER_SIGMA }, (_, n) =>
      unitCube.map((x, i) => x + sigma * (displacements[24 * (PER_SIGMA * s + n) + i] as number)),
    ),
  )
  const hard = cases.map(({ vertices }) => unitScale(vertices.flat()))
  const degrees = options.includes('--quick') ? [4, 6] : [4, 6, 8]
  console.log(
    [
      'Differences are shares of the largest Bernstein coefficient; time is processor time an element.',
      row([
        'elements',
        'degree',
        'valid',
        'differ',
        'by',
        'called invalid',
        'invalid',
        'lower',
        'by',
        'than the cube',
        'unsolved',
        'time',
      ]),
    ].join('\n'),
  )
  for (const [name, elements] of [
    ['sweep', sweep],
    ['hard cases', hard],
  ] as const)
    for (const found of relaxed(elements, degrees)) console.log(compared(name, elements, found))
  const gmsh = gmshMinima(displacements, PER_SIGMA * SIGMAS.length, [0.3], python)?.get(0.3)
  console.log(
    `\nHexlens: ${microseconds(sweep)} for the whole report in WebAssembly, one element at a time. ` +
      `Gmsh minDetJac: ${gmsh === undefined ? 'not here' : `${(gmsh / 1000).toFixed(1)} us`}.`,
  )
}

interface Relaxed {
  readonly degree: number
  readonly bounds: readonly number[]
  readonly statuses: readonly string[]
  readonly seconds: number
}

function installSolver(): void {
  const stamp = join(folder, 'hexlens-stamp')
  const text = readFileSync(requirements, 'utf8')
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === text) return
  process.stderr.write('bench: installing Clarabel and Gmsh into build/bench/sos\n')
  mkdirSync(folder, { recursive: true })
  for (const [command, ...args] of [
    ['python3', '-m', 'venv', folder],
    [python, '-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', '-r', requirements],
  ] as const) {
    const { status, stderr } = spawnSync(command, args, { encoding: 'utf8' })
    if (status !== 0)
      throw new Error(
        `The solver Clarabel is missing, and pip could not install it into build/bench/sos: ${stderr}\n` +
          'Where there is no network, put the packages of tests/bench/sos-requirements.txt there by hand.',
      )
  }
  writeFileSync(stamp, text)
}

/** The sweep's own: standard normal numbers, by Box and Muller. */
function draws(count: number): Float64Array {
  const random = randomSource(20260801)
  return Float64Array.from(
    { length: count },
    () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random()),
  )
}

/** Times a power of two, so that the relaxation's doubles neither overflow nor vanish. */
function unitScale(vertices: readonly number[]): Vertices {
  const exponent = Math.floor(Math.log2(Math.max(...vertices.map(Math.abs))))
  // In two steps: a factor alone may be no double.
  const half = Math.trunc(exponent / 2)
  return vertices.map(x => x * 2 ** -half * 2 ** (half - exponent))
}

function relaxed(elements: readonly Vertices[], degrees: readonly number[]): Relaxed[] {
  const { status, stdout, stderr } = spawnSync(python, [script, String(elements.length), ...degrees.map(String)], {
    input: new Uint8Array(new Float64Array(elements.flat()).buffer),
    encoding: 'utf8',
    maxBuffer: 2 ** 26,
  })
  if (status !== 0) throw new Error(`tests/bench/sos_minimum.py: ${stderr}`)
  return stdout
    .trim()
    .split('\n')
    .map(line => JSON.parse(line) as Relaxed)
}

function compared(name: string, elements: readonly Vertices[], { degree, bounds, statuses, seconds }: Relaxed): string {
  const valid: number[] = []
  const invalid: number[] = []
  let [calledInvalid, belowCube, unsolved] = [0, 0, 0]
  for (const [n, vertices] of elements.entries()) {
    const analysis = core.analyze(vertices)
    if (!analysis.ok) throw new Error(analysis.error.message)
    const report = analysis.value
    const unit = 2 ** report.exponent
    const scale = unit * Math.max(...report.bernstein.map(Math.abs))
    // A scale of 0 is that of a flat element: its jacdet is 0 everywhere.
    const share = (value: number) => (scale === 0 ? 0 : value / scale)
    const bound = bounds[n] as number
    const gap = share(unit * report.boundaryMinimum - bound)
    if (!statuses[n]?.endsWith('Solved')) unsolved++
    if (!report.valid) {
      invalid.push(gap)
      if (share(unit * report.volumeMinimum.lower - bound) > AGREES) belowCube++
    } else {
      valid.push(Math.abs(gap))
      if (bound <= 0) calledInvalid++
    }
  }
  const differ = (gaps: readonly number[]) => gaps.filter(gap => gap > AGREES).length
  const most = (gaps: readonly number[]) => Math.max(0, ...gaps).toExponential(1)
  return row([
    name,
    degree,
    valid.length,
    differ(valid),
    most(valid),
    calledInvalid,
    invalid.length,
    differ(invalid),
    most(invalid),
    belowCube,
    unsolved,
    `${((1000 * seconds) / elements.length).toFixed(1)} ms`,
  ])
}

function row(words: readonly (string | number)[]): string {
  return words.map((word, i) => (i === 0 ? String(word).padEnd(10) : String(word).padStart(13))).join(' ')
}

/** The median of rounds over all elements. */
function microseconds(elements: readonly Vertices[]): string {
  const times = Array.from({ length: TRIALS }, () => {
    const before = process.cpuUsage()
    for (const vertices of elements) core.analyze(vertices)
    const { user, system } = process.cpuUsage(before)
    return (user + system) / elements.length
  }).toSorted((a, b) => a - b)
  return `${(times[TRIALS >> 1] as number).toFixed(1)} us`
}
