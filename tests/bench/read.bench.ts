/**
 * One mesh of a million hexahedra in every format, read here and by VTK, meshio and Gmsh: each reading in a process of its own, in turns,
 * by the clock without the start of the process; and the memory beyond it. First all of the files go through `hexlens check`.
 *
 *     --quick   27,000 hexahedra, one round;  --check   no timings;  --rounds=N;  --formats=NAME,...   files whose names have one of these
 */
import { spawnSync } from 'node:child_process'
import { readdirSync, statSync } from 'node:fs'
import { availableParallelism, cpus, loadavg } from 'node:os'
import { join } from 'node:path'
import { build } from 'esbuild'
import { main as hexlens } from '../../web/cli/from-sources'
import { folder, installPeers, must, python, script, versionsOf } from './peers'

const ROUNDS = 5
/** A reading that takes longer is not measured again. */
const LONG = 30_000
/** Formats of boxes along the axes: their cells are implied, and all are valid. */
const BOXES = new Set(['rectilinear.vtk'])

type Reader = 'Hexlens' | 'VTK' | 'meshio' | 'Gmsh'
const READERS: readonly Reader[] = ['Hexlens', 'VTK', 'meshio', 'Gmsh']

interface Reading {
  readonly milliseconds: number
  readonly megabytes: number
  readonly hexahedra: number
  /** Points, cells and ids, of Hexlens alone. */
  readonly arrays?: number
}

export async function main(options: readonly string[]): Promise<void> {
  const isQuick = options.includes('--quick')
  installPeers()
  const perSide = isQuick ? 30 : 100
  const files = join(folder, `read-${perSide}`)
  const wanted = options
    .find(option => option.startsWith('--formats='))
    ?.slice('--formats='.length)
    .split(',') ?? ['']
  const names = writtenFiles(files, perSide, wanted)
  await checkAll(files, names, perSide ** 3)
  if (options.includes('--check')) return
  await bundleReader()
  const readings = new Map<string, Reading[]>()
  const rounds = Number(options.find(option => option.startsWith('--rounds='))?.slice('--rounds='.length))
  for (let round = 0; round < (rounds || (isQuick ? 1 : ROUNDS)); ++round)
    for (const name of names)
      for (let i = 0; i < READERS.length; ++i) {
        // Each goes first in turn.
        const reader = READERS[(i + round) % READERS.length] as Reader
        const key = `${name} ${reader}`
        const own = readings.get(key) ?? []
        if (!canRead(reader, name) || own.some(({ milliseconds }) => milliseconds > LONG)) continue
        const reading = read(reader, join(files, name), perSide ** 3)
        if (reading !== null) readings.set(key, [...own, reading])
      }
  printTable(names, files, readings)
}

/** Their names, which have one of the parts that are wanted; those that are there are not written again. */
function writtenFiles(into: string, perSide: number, wanted: readonly string[]): string[] {
  process.stderr.write(`bench: writing what is missing in ${into}\n`)
  return must(python, [script('read_files.py'), into, String(perSide), ...wanted])
    .trim()
    .split('\n')
}

async function bundleReader(): Promise<void> {
  await build({
    entryPoints: [script('read-process.ts')],
    outfile: join(folder, 'read-process.mjs'),
    bundle: true,
    platform: 'node',
    format: 'esm',
    target: 'es2022',
  })
}

function canRead(reader: Reader, name: string): boolean {
  if (reader === 'Hexlens') return true
  if (name.endsWith('.gz')) return false
  const type = name.slice(name.lastIndexOf('.') + 1)
  if (reader === 'VTK') return ['vtu', 'pvtu', 'vtk', 'vtkhdf', 'exo', 'cgns', 'foam'].includes(type)
  if (reader === 'Gmsh') return ['msh', 'mesh', 'bdf', 'vtk', 'cgns', 'med'].includes(type) && name !== 'mfem.mesh'
  return ['vtu', 'vtk', 'msh', 'mesh', 'meshb', 'inp', 'bdf', 'exo', 'med'].includes(type) && name !== 'mfem.mesh'
}

/** Null where the reader does not read the file, or reads something else. */
function read(reader: Reader, path: string, hexahedra: number): Reading | null {
  const [command, args] =
    reader === 'Hexlens'
      ? [process.execPath, [join(folder, 'read-process.mjs')]]
      : [python, [script('read_peer.py'), reader]]
  const { status, stdout, stderr } = spawnSync(command, [...args, path], { encoding: 'utf8', timeout: 300_000 })
  const last = stdout?.trim().split('\n').at(-1) ?? ''
  if (status === 0 && last.startsWith('{')) {
    const reading = JSON.parse(last) as Reading
    if (reading.hexahedra === hexahedra) return reading
  }
  if (reader === 'Hexlens') throw new Error(`${path} was not read: ${stdout} ${stderr}`)
  return null
}

/** Throws unless every file gives as many invalid cells, and the boxes none. */
async function checkAll(files: string, names: readonly string[], hexahedra: number): Promise<void> {
  let expected: number | undefined
  for (const name of names) {
    let text = ''
    const output = { write: (piece: string) => (text += piece) }
    await hexlens(['check', '--json', '--worst', '1', join(files, name)], {
      input: process.stdin,
      output,
      errors: { write: () => {}, isTTY: false },
    } as unknown as Parameters<typeof hexlens>[1])
    const [answer] = JSON.parse(text).files
    const { invalid, valid, error } = answer
    const isRight = BOXES.has(name) ? invalid === 0 : invalid > 0 && invalid === (expected ?? invalid)
    if (!isRight || invalid + valid !== hexahedra || answer.hexahedra !== hexahedra)
      throw new Error(`${name}: ${error ?? `${invalid} of ${answer.hexahedra} are invalid, not ${expected}.`}`)
    if (!BOXES.has(name)) expected = invalid
    process.stderr.write(`bench: ${name}: ${invalid} of ${hexahedra} are invalid\n`)
  }
}

function printTable(names: readonly string[], files: string, readings: ReadonlyMap<string, Reading[]>): void {
  const load = loadavg()[0]?.toFixed(1)
  console.log(
    `${cpus()[0]?.model.trim()}, ${availableParallelism()} cores, load ${load}; Node ${process.version}; ${versionsOf(['gmsh', 'meshio', 'vtk'])}\n`,
  )
  const columns = READERS.flatMap(reader => [reader, 'MB'])
  console.log(`| file | MB | ${columns.join(' | ')} | arrays |`)
  console.log(`| --- | ${columns.map(() => '---: |').join(' ')} ---: | ---: |`)
  for (const name of names) {
    const cells = READERS.flatMap(reader => {
      const own = readings.get(`${name} ${reader}`) ?? []
      if (own.length === 0) return ['', '']
      const seconds = median(own.map(({ milliseconds }) => milliseconds)) / 1000
      return [seconds.toFixed(2), Math.round(median(own.map(({ megabytes }) => megabytes)))]
    })
    const [first] = readings.get(`${name} Hexlens`) ?? []
    const size = Math.round(bytesOf(join(files, name)) / 1e6)
    console.log(`| ${name} | ${size} | ${cells.join(' | ')} | ${Math.round(first?.arrays ?? 0)} |`)
  }
}

/** The bytes of a file, or of all files in a folder. */
function bytesOf(path: string): number {
  const status = statSync(path)
  if (!status.isDirectory()) return status.size
  return readdirSync(path).reduce((sum, name) => sum + bytesOf(join(path, name)), 0)
}

function median(list: readonly number[]): number {
  return list.toSorted((a, b) => a - b)[list.length >> 1] as number
}
