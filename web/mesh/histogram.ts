/** How many cells have which relative minimum. */
import type { MeshCheck } from './mesh-check'

/** Counts of relative minima, of all answered cells whose volume is not 0. */
export interface Histogram {
  /** Bin i is (edges[i], edges[i + 1]], the first with its start: 0, which is invalid, is on the side of what is negative. */
  readonly edges: readonly number[]
  readonly counts: readonly number[]
  /** Relative minima below which 1, 10, 50, 90 and 99 % of the cells are. */
  readonly percentiles: readonly { readonly percent: number; readonly value: number }[]
  /** Cells that are in no bin: of volume 0, or unanswered. */
  readonly beside: number
}

/** Bins between 0 and 1, the greatest relative minimum that there is; below 0 as wide, down to -1. */
const BINS = 40
export const BIN = 1 / BINS
/** What is not above is one bin, which a picture shows as wide as the others. */
export const LEAST = -1
const PERCENTS = [1, 10, 50, 90, 99]

export function histogramOf({ answers: { relativeMinima }, worst, hexahedra }: MeshCheck): Histogram {
  const bins = new Uint32Array(2 * BINS + 1)
  let least = Infinity
  let counted = 0
  for (const value of relativeMinima) {
    if (Number.isNaN(value)) continue
    counted++
    if (value < least) least = value
    const at = binOf(value)
    bins[at] = (bins[at] as number) + 1
  }
  const first = bins.findIndex(count => count > 0)
  if (first < 0) return { edges: [], counts: [], percentiles: [], beside: hexahedra }
  const edges = Array.from({ length: bins.length - first + 1 }, (_, i) => (first + i - 1 - BINS) / BINS)
  if (first === 0) edges[0] = least
  return {
    edges,
    counts: [...bins.subarray(first)],
    percentiles: percentilesOf(relativeMinima, worst, counted),
    beside: hexahedra - counted,
  }
}

/** Bin 0 is all up to -1. */
function binOf(value: number): number {
  return Math.max(0, Math.min(2 * BINS, BINS + Math.ceil(value * BINS)))
}

/** The value of the first cell, from the worst on, that has at least so many per cent up to it. */
function percentilesOf(relativeMinima: Float64Array, worst: Uint32Array, count: number): Histogram['percentiles'] {
  const rising = risingOf(relativeMinima, worst)
  return PERCENTS.map(percent => {
    const rank = Math.max(0, Math.ceil((percent * count) / 100) - 1)
    return { percent, value: rising[rank] as number }
  })
}

/** Where all cells are in order already, they are not sorted again. */
function risingOf(relativeMinima: Float64Array, worst: Uint32Array): Float64Array {
  if (worst.length < relativeMinima.length) return relativeMinima.filter(value => !Number.isNaN(value)).sort()
  const ranked = worst.filter(cell => !Number.isNaN(relativeMinima[cell] as number))
  return Float64Array.from(ranked, cell => relativeMinima[cell] as number)
}
