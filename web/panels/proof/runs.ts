/** The intervals of a face, for reading: neighbours with one reason are taken together. */
import type { CertifiedInterval } from '../../core/exact/certificate'

export interface Run extends CertifiedInterval {
  /** The number of intervals that it is made of. */
  readonly count: number
}

export function runsOf(intervals: readonly CertifiedInterval[]): Run[] {
  const runs: Run[] = []
  for (const interval of intervals) {
    const last = runs.at(-1)
    if (last?.by === interval.by) runs[runs.length - 1] = { ...last, to: interval.to, count: last.count + 1 }
    else runs.push({ ...interval, count: 1 })
  }
  return runs
}
