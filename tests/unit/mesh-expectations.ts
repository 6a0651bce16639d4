/** Expectations of the files of ../shared/meshes and ../shared/pastes. */
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { expect } from 'vitest'
import type { Mesh } from '../../web/mesh/mesh'
import { readMeshes } from '../../web/mesh/read-mesh'
import { fileOfBytes, type MeshFile } from '../../web/mesh/source'
import { core } from './core-fixtures'

const shared = new URL('../../../shared/', import.meta.url)

interface Wanted {
  readonly name: string
  readonly valid: boolean
  readonly min_lower: number
  readonly min_upper: number
}

interface MadeFile {
  readonly file: string
  readonly counts: Readonly<Record<string, number>>
  readonly coordinates_exact: boolean
}

interface Paste {
  readonly file: string
  readonly hexahedra: number | null
  readonly invalid: number | null
  readonly expect: readonly (readonly [string, readonly number[]])[] | null
}

const manifest = JSON.parse(readFileSync(new URL('meshes/made/manifest.json', shared), 'utf8')) as {
  linear: readonly Wanted[]
  quadratic: readonly Wanted[]
  files: readonly MadeFile[]
}
export const { linear, quadratic } = manifest
const pastes = JSON.parse(readFileSync(new URL('pastes/expected.json', shared), 'utf8')) as readonly Paste[]

export function sharedFile(path: string): MeshFile {
  return fileOfBytes(path.slice(path.lastIndexOf('/') + 1), new Uint8Array(readFileSync(new URL(path, shared))))
}

export function readShared(path: string): Mesh {
  return readMeshes(sharedFile(path))[0] as Mesh
}

export function textFile(name: string, text: string): MeshFile {
  return fileOfBytes(name, new TextEncoder().encode(text))
}

export function readText(name: string, text: string, others: Readonly<Record<string, string>> = {}): Mesh {
  const find = (wanted: string) => (others[wanted] === undefined ? null : textFile(wanted, others[wanted]))
  return readMeshes(textFile(name, text), { find })[0] as Mesh
}

export function madeFile(name: string): MadeFile {
  return manifest.files.find(({ file }) => file === name) as MadeFile
}

export function paste(prefix: string): Paste {
  return pastes.find(({ file }) => file.startsWith(prefix)) as Paste
}

export function filesIn(folder: string): string[] {
  const url = new URL(folder, shared)
  return existsSync(url) ? readdirSync(url) : []
}

/** The 24 coordinates of a cell. */
export function verticesOf(mesh: Mesh, cell: number, cells = mesh.cells): number[] {
  return Array.from(cells.subarray(8 * cell, 8 * cell + 8)).flatMap(point =>
    Array.from(mesh.points.subarray(3 * point, 3 * point + 3)),
  )
}

export function reportOf(mesh: Mesh, cell: number, cells = mesh.cells) {
  const result = core.analyze(verticesOf(mesh, cell, cells))
  if (!result.ok) throw new Error(`cell ${cell} is not answered`)
  return { valid: result.value.valid, minimum: result.value.boundaryMinimum * 2 ** result.value.exponent }
}

export function validity(mesh: Mesh): { valid: number; invalid: number; least: number } {
  const answer = { valid: 0, invalid: 0, least: Number.POSITIVE_INFINITY }
  for (let cell = 0; cell < mesh.cells.length / 8; ++cell) {
    const { valid, minimum } = reportOf(mesh, cell)
    if (valid) answer.valid++
    else answer.invalid++
    answer.least = Math.min(answer.least, minimum)
  }
  return answer
}

/** Cells `from`, `from + 1`, ... are those of the manifest: verdicts, and minima up to what printing lost. */
export function expectCells(mesh: Mesh, wanted: readonly Wanted[], tolerance = 0, from = 0, cells = mesh.cells): void {
  for (const [i, { name, valid, min_lower, min_upper }] of wanted.entries()) {
    const report = reportOf(mesh, from + i, cells)
    expect([name, report.valid]).toEqual([name, valid])
    expect(report.minimum, name).toBeGreaterThanOrEqual(min_lower - tolerance)
    expect(report.minimum, name).toBeLessThanOrEqual(min_upper + tolerance)
  }
}

/** Reads a paste: its elements have the coordinates expected. */
export function expectPaste(prefix: string): Mesh {
  const { file, hexahedra, invalid, expect: elements } = paste(prefix)
  const mesh = readShared(`pastes/${file}`)
  if (hexahedra !== null) expect(mesh.cells.length / 8).toBe(hexahedra)
  if (invalid !== null) expect(validity(mesh).invalid).toBe(invalid)
  for (const [i, [, vertices]] of (elements ?? []).entries()) expect(verticesOf(mesh, i)).toEqual(vertices)
  return mesh
}
