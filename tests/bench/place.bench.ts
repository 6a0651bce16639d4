/**
 * The best places of seeded vertices of a regular grid with noise, natively and in wasm, beside SciPy's Nelder-Mead and SLSQP on
 * the same stars, in turns. HEXLENS_PYTHON names a python3 with numpy and scipy; without one there are no
 * peers. --quick: a few stars.
 */
import { execFileSync, spawnSync } from 'node:child_process'
import { cpus } from 'node:os'
import { fileURLToPath } from 'node:url'
import { bestOf, cellsAt, noisyStars, type PointStar, presentOf } from '../unit/stars'

const root = fileURLToPath(new URL('../..', import.meta.url))
const library = `${root}/build/native/library`

/** Stars of a family are measured by these methods in turns, so many at once. */
const TURN = 25

const FAMILIES = [
  { name: 'noise 0.1', next: noisyStars(101, 0.1, 0.1) },
  { name: 'noise 0.15, the vertex 0.3', next: noisyStars(102, 0.15, 0.3) },
  { name: 'noise 0.2, the vertex 0.5', next: noisyStars(103, 0.2, 0.5) },
  { name: 'noise 0.1, the vertex thrown 3', next: noisyStars(104, 0.1, 3) },
]

interface Found {
  readonly seconds: number
  readonly value: number
}

interface Measured {
  readonly native: Found & { readonly bound: number }
  readonly wasm: number
  readonly nelderMead: Found | null
  readonly slsqp: Found | null
}

export async function main(options: readonly string[]): Promise<void> {
  const count = options.includes('--quick') ? TURN : 4 * TURN
  execFileSync('make', ['-s', '-C', `${root}/wasm`, '../build/native/place', 'library'])
  console.log(
    `${cpus()[0]?.model}, Node ${process.version}; ${count} stars of 8 cells a row, medians; short of the bound by more than 1e-6`,
  )
  for (const { name, next } of FAMILIES) {
    const measured: Measured[] = []
    while (measured.length < count) measured.push(...measure(Array.from({ length: TURN }, next)))
    print(name, measured)
  }
}

function measure(stars: readonly PointStar[]): Measured[] {
  const blocks = new Float64Array(stars.flatMap(star => cellsAt(star, presentOf(star)).flat()))
  const input = new Uint8Array(blocks.buffer)
  const native = doubles(execFileSync(`${root}/build/native/place`, { input }))
  const shared = execFileSync('find', [library, '-name', 'libhexlens.*so*', '-type', 'f'], { encoding: 'utf8' }).trim()
  const script = `${root}/tests/bench/best_place_peer.py`
  const python = spawnSync(process.env.HEXLENS_PYTHON ?? 'python3', [script, shared], { input })
  if (python.status !== 0) console.log(`  without peers: ${String(python.stderr).trim().split('\n').at(-1)}`)
  const peers = python.status === 0 ? doubles(python.stdout) : null
  const found = (list: Float64Array | null, at: number) =>
    list ? { seconds: list[at] as number, value: list[at + 1] as number } : null
  return stars.map((star, n) => ({
    native: { ...(found(native, 7 * n) as Found), bound: native[7 * n + 2] as number },
    wasm: wasmSeconds(star),
    nelderMead: found(peers, 4 * n),
    slsqp: found(peers, 4 * n + 2),
  }))
}

function doubles(bytes: Buffer): Float64Array {
  return new Float64Array(new Uint8Array(bytes).buffer)
}

function wasmSeconds(star: PointStar): number {
  return Math.min(
    ...Array.from({ length: 15 }, () => {
      const begin = performance.now()
      bestOf(star)
      return (performance.now() - begin) / 1000
    }),
  )
}

function print(name: string, measured: readonly Measured[]): void {
  console.log(name)
  const rows: [string, (m: Measured) => Found | null][] = [
    ['native', m => m.native],
    ['wasm', m => ({ ...m.native, seconds: m.wasm })],
    ['Nelder-Mead', m => m.nelderMead],
    ['SLSQP', m => m.slsqp],
  ]
  for (const [method, of] of rows) {
    const answers = measured.flatMap(m => {
      const found = of(m)
      return found
        ? [
            {
              ...found,
              short: m.native.bound - found.value,
              better: found.value - m.native.value,
              bound: m.native.bound,
            },
          ]
        : []
    })
    if (answers.length === 0) continue
    const sorted = (values: number[]) => values.sort((a, b) => a - b)
    const seconds = sorted(answers.map(answer => answer.seconds))
    const short = answers.filter(answer => answer.short > 1.0001e-6 * Math.abs(answer.bound)).length
    const far = answers.filter(answer => answer.short > 0.01 * Math.abs(answer.bound)).length
    const above = Math.max(...answers.map(answer => answer.better / Math.abs(answer.bound)))
    console.log(
      `  ${method.padEnd(12)} ${(1e6 * (seconds[seconds.length >> 1] as number)).toFixed(0).padStart(8)} us, longest ${(1e6 * (seconds.at(-1) as number)).toFixed(0).padStart(8)}; short ${short} of ${answers.length}, by 1 % ${far}; above the native value by ${above.toExponential(1)} of it at most`,
    )
  }
}
