/** Untangling from wasm: all cells of a noisy grid repaired, by the batch core's verdicts, what is fixed where it was, refusals, cancel. */
import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { loadBatchCore } from '../../web/core/batch/batch-core'
import { reasonsOf } from '../../web/core/repair/held'
import type { PlaceProof } from '../../web/core/repair/place-proof'
import { untangle } from '../../web/core/repair/untangle'
import { MOVES, type PointMesh, type Untangled, type UntangleOptions } from '../../web/core/repair/untangling'
import { noisyGrid } from './grids'
import { limitedProofHolds, repairCore } from './stars'

const batchCore = await loadBatchCore(
  new WebAssembly.Module(readFileSync(new URL('../../build/hexlens-scalar.wasm', import.meta.url))),
)

async function untangled(mesh: PointMesh, options: UntangleOptions): Promise<Untangled> {
  const result = await untangle(repairCore, mesh, options)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

function invalidCount(points: Float64Array, cells: Uint32Array): number {
  return batchCore.classify({ points, cells, firstPoint: 0 }, {}).invalidCount
}

const EDGE = 11

describe('untangle', () => {
  it('repairs a noisy grid to the margin, and leaves its input and the boundary', async () => {
    const { points, cells, isInside } = noisyGrid(EDGE, 0.17, 1)
    const given = points.slice()
    const result = await untangled({ points, cells }, { margin: 0.1 })
    expect(points).toEqual(given)
    expect(result.invalidBefore).toBe(invalidCount(points, cells))
    expect(result.invalidBefore).toBeGreaterThan(3)
    expect(invalidCount(result.points, cells)).toBe(0)
    expect([result.invalidAfter, result.belowAfter, result.heldPoints.length]).toEqual([0, 0, 0])
    expect(result.leastAfter).toBeGreaterThanOrEqual(0.1)
    const moved = movedPoints(given, result.points)
    expect(moved.length).toBe(result.movedCount)
    expect(moved.every(isInside)).toBe(true)
    const distances = moved.map(p => Math.hypot(...[0, 1, 2].map(r => diff(given, result.points, 3 * p + r))))
    expect(result.greatestDistance).toBeCloseTo(Math.max(...distances), 12)
    expect(result.meanDistance).toBeCloseTo(distances.reduce((sum, d) => sum + d, 0) / moved.length, 12)
  })

  it('moves only the points that it is given, freed ones on the boundary too', async () => {
    const { points, cells } = noisyGrid(EDGE, 0.25, 2)
    const moves = new Uint8Array(points.length / 3).fill(MOVES.stays)
    const chosen = [0, 555, 600, 601]
    for (const p of chosen) moves[p] = MOVES.freed
    const result = await untangled({ points, cells }, { margin: 1, moves })
    const moved = movedPoints(points, result.points)
    expect(moved).toContain(0)
    expect(moved.every(p => chosen.includes(p))).toBe(true)
    expect([...result.heldPoints]).toEqual(chosen)
    expect(result.leastAfter).toBeGreaterThanOrEqual(result.leastBefore as number)
  })

  it('takes signed indices, and has nothing to do on a good mesh', async () => {
    const { points, cells } = noisyGrid(4, 0, 1)
    const result = await untangled({ points, cells: Int32Array.from(cells) }, { margin: 0.5 })
    expect(result).toMatchObject({ movedCount: 0, placeCount: 0, sweepCount: 0, leastBefore: 1, leastAfter: 1 })
    expect(result.points).toEqual(points)
    expect((await untangled({ points, cells: new Uint32Array(0) }, { margin: 0 })).leastBefore).toBeNull()
  })

  it('slides in the planes of the boundary, and within a distance', async () => {
    const { points, cells, isInside } = noisyGrid(7, 0.1, 4, 0.35)
    const fixed = await untangled({ points, cells }, { margin: 0.2 })
    const slid = await untangled({ points, cells }, { margin: 0.2, slides: true })
    expect(slid.invalidAfter).toBeLessThan(fixed.invalidAfter / 4)
    const isEnd = (x: number) => x === 0 || x === 6
    const isKept = points.every((x, i) => isInside(Math.floor(i / 3)) || !isEnd(x) || slid.points[i] === x)
    expect(isKept).toBe(true)
    const near = await untangled({ points, cells }, { margin: 0.2, boundaryDistance: 0.1 })
    const moved = movedPoints(points, near.points).filter(p => !isInside(p))
    expect(moved.length).toBeGreaterThan(20)
    for (const p of moved)
      expect(Math.hypot(...[0, 1, 2].map(r => diff(points, near.points, 3 * p + r)))).toBeLessThanOrEqual(0.1)
  })

  it.each([
    { name: 'anywhere', options: { margin: 0.7 } },
    { name: 'in planes', options: { margin: 0.6, slides: true } },
    { name: 'within a distance', options: { margin: 0.75, boundaryDistance: 0.1 } },
    { name: 'both', options: { margin: 0.7, slides: true, boundaryDistance: 0.05 } },
  ])('proves why points are held that may go $name', async ({ options }) => {
    const { points, cells } = noisyGrid(5, 0.25, 5, 0.2)
    const result = await untangled({ points, cells }, options)
    const some = [...result.heldPoints.keys()].filter(held => held % 2 === 0)
    expect(some.length).toBeGreaterThan(5)
    const reason = reasonsOf(repairCore, { cells }, result, options.margin)
    const forbidden = { valid: 0, margin: 0, open: 0 }
    for (const held of some) {
      const { point, cells: around, star, best, proof, forbids } = reason(held)
      expect(around.every(c => cells.subarray(8 * c, 8 * c + 8).includes(point))).toBe(true)
      ++forbidden[forbids ?? 'open']
      if (forbids === null) continue
      expect(limitedProofHolds(star, best, proof)).toBe(true)
      expect(limitedProofHolds(star, best, tampered(proof))).toBe(false)
    }
    expect(forbidden.margin + forbidden.valid).toBeGreaterThan(5)
    expect(forbidden.open).toBe(0)
  })

  it('tells of its progress, and ends with the reason of a signal', async () => {
    const { points, cells } = noisyGrid(21, 0.35, 3)
    const control = new AbortController()
    const told: number[] = []
    const onProgress = ({ belowAfter, placeCount }: { belowAfter: number; placeCount: number }) => {
      told.push(belowAfter)
      if (placeCount > 0) control.abort(new Error('enough'))
    }
    await expect(untangle(repairCore, { points, cells }, { margin: 0.1 }, onProgress, control.signal)).rejects.toThrow(
      'enough',
    )
    expect(told.length).toBeGreaterThan(0)
    await expect(untangle(repairCore, { points, cells }, { margin: 0 }, () => {}, control.signal)).rejects.toThrow(
      'enough',
    )
  })

  it('refuses what is no mesh, in a sentence', async () => {
    const { points, cells } = noisyGrid(4, 0.1, 1)
    const refusal = async (mesh: PointMesh, options: UntangleOptions) => {
      const result = await untangle(repairCore, mesh, options)
      return result.ok ? 'none' : `${result.error.code}: ${result.error.message}`
    }
    expect(await refusal({ points: points.slice(1), cells }, { margin: 0 })).toMatch(/^wrong-count: .* 191 are not\.$/)
    expect(await refusal({ points, cells: cells.slice(1) }, { margin: 0 })).toMatch(/^wrong-count: .* 215 are not\.$/)
    expect(await refusal({ points, cells: cells.map(i => i + 1) }, { margin: 0 })).toMatch(/^no-such-point: /)
    expect(await refusal({ points, cells: Int32Array.from(cells, i => i - 1) }, { margin: 0 })).toMatch(/^no-such-poi/)
    expect(await refusal({ points: points.with(5, Number.NaN), cells }, { margin: 0 })).toMatch(/^not-finite: /)
    expect(await refusal({ points, cells }, { margin: 1.5 })).toMatch(/^no-such-margin: .* not 1\.5\.$/)
    expect(await refusal({ points, cells }, { margin: 0, boundaryDistance: -1 })).toMatch(/^no-such-distance: .*-1\.$/)
    expect(await refusal({ points, cells }, { margin: 0, moves: new Uint8Array(3) })).toMatch(/^wrong-count: .* 3 that/)
  })
})

/** The first weight is greater, by a millionth of itself. */
function tampered(proof: PlaceProof): PlaceProof {
  if (!proof.isProved) return proof
  const [first, ...others] = proof.holds as [(typeof proof.holds)[number]]
  const { numerator, denominator } = first.weight
  const weight = { numerator: numerator * 1_000_001n, denominator: denominator * 1_000_000n }
  // A single hold proves the same with any weight: it is refused for another bound.
  return others.length > 0
    ? { ...proof, holds: [{ ...first, weight }, ...others] }
    : { ...proof, bound: { ...proof.bound, numerator: proof.bound.numerator - proof.bound.denominator } }
}

function diff(a: Float64Array, b: Float64Array, i: number): number {
  return (a[i] as number) - (b[i] as number)
}

function movedPoints(before: Float64Array, after: Float64Array): number[] {
  return Array.from({ length: before.length / 3 }, (_, p) => p).filter(p =>
    [0, 1, 2].some(r => diff(before, after, 3 * p + r) !== 0),
  )
}
