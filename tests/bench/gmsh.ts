/** Gmsh's minDetJac on the same elements, where python3 has the gmsh package: what the paper's second table compares with. */
import { spawnSync } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import type { GmshTimes } from './tables'

/** It takes microseconds an element. */
const MOST_ELEMENTS = 20_000

/** Null if this Python has no such package. HEXLENS_PYTHON names another python3. */
export function gmshMinima(
  displacements: Float64Array,
  elements: number,
  sigmas: readonly number[],
  python = process.env.HEXLENS_PYTHON ?? 'python3',
): GmshTimes | null {
  const count = Math.min(elements, MOST_ELEMENTS)
  const script = fileURLToPath(new URL('gmsh_minimum.py', import.meta.url))
  const { status, stdout } = spawnSync(python, [script, String(count), ...sigmas.map(String)], {
    input: new Uint8Array(displacements.buffer, 0, 8 * 24 * count),
    encoding: 'utf8',
  })
  if (status !== 0) return null
  const times = stdout.trim().split('\n').map(Number)
  return new Map(sigmas.map((sigma, i) => [sigma, times[i] as number]))
}
