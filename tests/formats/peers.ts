/** npm run peers: asks VTK, meshio and Gmsh for what they make of files, those of ../shared and those that Hexlens writes; writes peers.json. */
import { spawnSync } from 'node:child_process'
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { MESH_FORMS } from '../../web/outputs/meshes/list'
import { cellArrays, wholeMesh } from '../../web/outputs/meshes/mesh-part'
import { installPeers, python } from '../bench/peers'
import { randomHexahedron, randomSource } from '../unit/core-fixtures'
import { checked, meshOf } from '../unit/mesh-fixtures'
import { type Answer, cornersOf, made, madeFiles, readMade, type Standing, standingsOf } from './made-mesh'

export const PEERS = ['VTK', 'meshio', 'Gmsh'] as const
export type Peer = (typeof PEERS)[number]

export interface PeerRecord {
  readonly versions: Readonly<Record<Peer, string>>
  /** For each file of the mesh that was made what each finds in it; null without a reader. */
  readonly made: Readonly<Record<string, Readonly<Record<Peer, MadeRecord>>>>
  /** For each format that Hexlens writes what each reads back. */
  readonly written: Readonly<Record<string, Readonly<Record<Peer, WrittenRecord>>>>
}

export type MadeRecord =
  | { readonly refused: string }
  | {
      readonly counts: Readonly<Record<string, number>>
      readonly standings: Partial<Readonly<Record<Standing, number>>>
    }
  | null

export type WrittenRecord =
  | { readonly refused: string }
  | {
      /** All coordinates of all hexahedra are the same doubles. */
      readonly areHexahedraSame: boolean
      /** Cell arrays that have the same numbers. */
      readonly arrays: readonly string[]
    }
  | null

type WithArrays = Answer & { readonly arrays?: Readonly<Record<string, readonly (number | null)[]>> }

const recordFile = fileURLToPath(new URL('peers.json', import.meta.url))

export async function main(): Promise<void> {
  installPeers()
  const folder = mkdtempSync(join(tmpdir(), 'hexlens-peers-'))
  try {
    cpSync(made, folder, { recursive: true })
    writeFileSync(join(folder, 'foam/case.foam'), '')
    const wanted = await writeAll(folder)
    const paths = [...madeFiles.map(({ path }) => path), ...wanted.keys()]
    const answers = PEERS.map(peer => asked(peer, folder, paths))
    const of = <T>(path: string, record: (answer: WithArrays | null) => T) =>
      Object.fromEntries(PEERS.map((peer, i) => [peer, record(answers[i]?.files[join(folder, path)] ?? null)]))
    const record = {
      versions: Object.fromEntries(PEERS.map((peer, i) => [peer, answers[i]?.version])),
      made: Object.fromEntries(madeFiles.map(({ path }) => [path, of(path, recordOf)])),
      written: Object.fromEntries([...wanted].map(([path, own]) => [path, of(path, back => writtenRecord(back, own))])),
    }
    writeFileSync(recordFile, `${JSON.stringify(record, null, 1)}\n`)
  } finally {
    rmSync(folder, { recursive: true })
  }
}

interface PeerAnswers {
  readonly version: string
  readonly files: Readonly<Record<string, WithArrays | null>>
}

function asked(peer: Peer, folder: string, paths: readonly string[]): PeerAnswers {
  process.stderr.write(`peers: ${peer} reads ${paths.length} files\n`)
  const script = fileURLToPath(new URL('peers.py', import.meta.url))
  const args = [script, peer, ...paths.map(path => join(folder, path))]
  const { status, stdout, stderr } = spawnSync(python, args, { encoding: 'utf8', maxBuffer: 2 ** 28 })
  if (status !== 0) throw new Error(`${peer}: ${stderr}`)
  return JSON.parse(stdout)
}

/** What is kept of an answer to a file of the mesh that was made. */
export function recordOf(answer: Answer): MadeRecord {
  if (answer === null || 'refused' in answer) return answer
  return { counts: answer.counts, standings: standingsOf(answer.hexahedra) }
}

interface Written {
  readonly hexahedra: readonly (readonly number[])[]
  readonly arrays: ReadonlyMap<string, readonly number[]>
}

/** The mesh that was made and elements with all digits in each format, by the names of the files. */
async function writeAll(folder: string): Promise<Map<string, Written>> {
  const next = randomSource(22)
  const random = meshOf(Array.from({ length: 200 }, () => randomHexahedron(next, 0.3)))
  const own = readMade('vtk-raw-none.vtu')
  const points = Float64Array.of(...own.points, ...random.points)
  const cells = Uint32Array.of(...own.cells, ...random.cells.map(point => point + own.points.length / 3))
  const mesh = { ...random, points, cells, ids: null }
  const check = await checked(mesh, { worst: Infinity, lists: { minima: true, volumes: true } })
  const part = wholeMesh(check)
  const indices = Array.from({ length: cells.length / 8 }, (_, cell) => cell)
  const written = {
    hexahedra: cornersOf(mesh, cells),
    arrays: new Map(cellArrays(part).map(({ name, numberOf }) => [name, indices.map(numberOf)])),
  }
  return new Map(
    MESH_FORMS.map(({ id, chunks }) => {
      const path = `written.${id}`
      const parts = [...chunks(part, () => {})].map(chunk => Buffer.from(chunk as string))
      writeFileSync(join(folder, path), Buffer.concat(parts))
      return [path, written]
    }),
  )
}

function writtenRecord(back: WithArrays | null, { hexahedra, arrays }: Written): WrittenRecord {
  if (back === null || 'refused' in back) return back
  const isSame = (a: readonly (number | null)[], b: readonly number[]) =>
    a.length === b.length && a.every((x, i) => (x === null ? !Number.isFinite(b[i]) : x === b[i]))
  return {
    areHexahedraSame:
      back.hexahedra.length === hexahedra.length && back.hexahedra.every((cell, i) => isSame(cell, hexahedra[i] ?? [])),
    arrays: [...arrays].filter(([name, numbers]) => isSame(back.arrays?.[name] ?? [], numbers)).map(([name]) => name),
  }
}
