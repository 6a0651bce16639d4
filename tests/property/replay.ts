/**
 * Every property here is run from one seed, which HEXLENS_SEED overrides, as in
 *     HEXLENS_SEED=7 npx vitest run tests/property
 * A failure prints fast-check's seed and path, and the doubles themselves; `replayed(runs, path)` with both goes there at once.
 */
import type fc from 'fast-check'
import type { Vertices } from '../../web/model/hexahedron'

const DEFAULT_SEED = 20260505

export const seed = Number(process.env.HEXLENS_SEED ?? DEFAULT_SEED)
if (!Number.isInteger(seed)) throw new Error(`HEXLENS_SEED is ${process.env.HEXLENS_SEED}, which is no integer.`)

/** Parameters of `fc.assert`. */
export function replayed<T>(numRuns: number, path?: string): fc.Parameters<T> {
  return { seed, numRuns, ...(path === undefined ? {} : { path }) }
}

/** Runs `law`, and names the very hexahedron in the message when it does not hold. */
export function holdsFor<T>(vertices: Vertices, law: () => T): T {
  try {
    return law()
  } catch (error) {
    const shown = vertices.map(x => (Object.is(x, -0) ? '-0' : `${x}`)).join(', ')
    throw new Error(`${error instanceof Error ? error.message : error}\nfor the hexahedron [${shown}]`, {
      cause: error,
    })
  }
}
