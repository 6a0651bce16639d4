/**
 * The Python package beside the C library and PyVista: python/bench/bench.py in the environment of npm run test:python, which installs
 * the package there first.   --quick: a tenth of the cells
 */
import { spawnSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { cpus } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../..', import.meta.url))
const python = join(root, 'build', 'package-python', 'bin', 'python')

interface Figures {
  readonly cells: number
  readonly many: number
  readonly vectors: string
  readonly cores: number
  readonly one: Readonly<Record<string, number>>
  readonly threads: Readonly<Record<string, number>>
  readonly shares: { readonly one: number; readonly calling: number; readonly helping: number }
  readonly command: Readonly<Record<string, number>>
  readonly imports: Readonly<Record<string, number>>
  readonly calls: Readonly<Record<string, number>>
}

export async function main(options: readonly string[]): Promise<void> {
  const installed = existsSync(python) && spawnSync(python, ['-c', 'import hexlens'], { cwd: '/' }).status === 0
  if (!installed) throw new Error('The package is not installed in build/package-python: npm run test:python does it.')
  const { status, stdout, stderr } = spawnSync(python, [join(root, 'python', 'bench', 'bench.py'), ...options], {
    encoding: 'utf8',
  })
  if (status !== 0) throw new Error(stderr)
  process.stdout.write(table(JSON.parse(stdout)))
}

function table({ cells, many, vectors, cores, one, threads, shares, command, imports, calls }: Figures): string {
  const beside = (name: string, own: Readonly<Record<string, number>>, other: string) =>
    ((own[name] as number) / (own[other] as number)).toFixed(2)
  const nanoseconds = (name: string) => `${(((one[name] as number) / cells) * 1e9).toFixed(1)} ns`
  const rows = [
    ...Object.keys(one).map(name => {
      const other = name.includes('minima') ? 'hl_classify with minima' : 'hl_classify'
      return [name, nanoseconds(name), `${beside(name, one, other)} of ${other}`]
    }),
    ...Object.entries(threads).map(([name, seconds]) => [
      `classify, ${many} cells, ${name}`,
      `${seconds.toFixed(3)} s`,
      `${beside('1 threads', threads, name)} times as fast as one`,
    ]),
    [
      'the same by processor time, on two free cores',
      `${(shares.calling + shares.helping / 2).toFixed(3)} s`,
      `${(shares.one / (shares.calling + shares.helping / 2)).toFixed(2)} times as fast as one`,
    ],
    ...Object.entries(command).map(([name, seconds]) => [
      name,
      `${seconds.toFixed(2)} s`,
      `${beside(name, command, 'PyVista')} of PyVista`,
    ]),
    ...Object.entries(imports).map(([name, seconds]) => [`import ${name}`, `${(1000 * seconds).toFixed(1)} ms`, '']),
    ...Object.entries(calls).map(([name, seconds]) => [`a call of ${name}`, `${(1000 * seconds).toFixed(2)} us`, '']),
  ]
  const head = `${cpus()[0]?.model}, ${cores} cores, ${vectors}; ${cells} cells that share points, sigma 0.1\n\n`
  return `${head}| what | time | |\n| --- | ---: | --- |\n${rows.map(row => `| ${row.join(' | ')} |\n`).join('')}`
}
