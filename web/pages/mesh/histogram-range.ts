/** The range of relative minima that a histogram is brushed to, and how keys move its ends from bar to bar. */

/** Both ends are within; null is all of it. */
export type Range = readonly [number, number] | null
export type End = 'lower' | 'upper'

/** Bars that a page of keys goes on. */
const PAGE = 8

/** What is below the first bar has no end: cells of volume 0 with a negative minimum are there. */
export function endsOf(range: Range, edges: readonly number[]): readonly [number, number] {
  return range ?? [Number.NEGATIVE_INFINITY, edges.at(-1) as number]
}

/** The whole of it is no range. */
export function rangeOf(lower: number, upper: number, edges: readonly number[]): Range {
  return lower <= (edges[0] as number) && upper >= (edges.at(-1) as number)
    ? null
    : [lower <= (edges[0] as number) ? Number.NEGATIVE_INFINITY : lower, upper]
}

/** The range once a key has moved an end; the same if it has nowhere to go, undefined if the key is for others. */
export function rangeAfter(key: string, end: End, range: Range, edges: readonly number[]): Range | undefined {
  const steps: Record<string, number> = {
    ArrowLeft: -1,
    ArrowDown: -1,
    ArrowRight: 1,
    ArrowUp: 1,
    PageDown: -PAGE,
    PageUp: PAGE,
    Home: -edges.length,
    End: edges.length,
  }
  const step = steps[key]
  if (step === undefined) return undefined
  const [lower, upper] = endsOf(range, edges)
  const last = edges.length - 1
  // At least one bar is left between the two.
  if (end === 'lower') {
    const most = Math.max(0, indexBelow(upper, edges))
    const to = Math.max(0, Math.min(most, moved(lower, step, edges)))
    return rangeOf(edges[to] as number, upper, edges)
  }
  const least = Math.min(last, indexAbove(lower, edges))
  const to = Math.max(least, Math.min(last, moved(upper, step, edges)))
  return rangeOf(lower, edges[to] as number, edges)
}

/** The edge so many further on; a value between two has one on either side. */
function moved(value: number, step: number, edges: readonly number[]): number {
  return step > 0 ? indexAbove(value, edges) + step - 1 : indexBelow(value, edges) + step + 1
}

/** Of the last edge below. */
function indexBelow(value: number, edges: readonly number[]): number {
  return edges.findLastIndex(edge => edge < value)
}

function indexAbove(value: number, edges: readonly number[]): number {
  // The first edge is the end that lies without bounds.
  const at = edges.findIndex((edge, i) => i > 0 && edge > value)
  return at < 0 ? edges.length : at
}
