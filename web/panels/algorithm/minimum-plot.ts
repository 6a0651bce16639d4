/** M over the steps as a staircase, for a small plot in its own units. */
import type { TraceStep } from './trace'

export interface PlotBox {
  readonly width: number
  readonly height: number
}

export interface MinimumPlot {
  /** Path of the staircase; a step is as wide as its share of the box. */
  readonly path: string
  /** M after each step: the middle of its tread. */
  readonly marks: readonly { readonly x: number; readonly y: number }[]
  /** Height of zero, where that is between the greatest and the least M. */
  readonly zero: number | null
}

/** `count` steps share the width: those that a query did not reach stay empty. */
export function minimumPlot(steps: readonly TraceStep[], count: number, { width, height }: PlotBox): MinimumPlot {
  const values = steps.map(({ after }) => after ?? 0)
  // Division by the largest magnitude lets no difference overflow.
  const unit = Math.max(...values.map(Math.abs)) || 1
  const [least, most] = [Math.min(...values) / unit, Math.max(...values) / unit]
  const heightOf = (value: number) =>
    round(most > least ? (height * (most - value / unit)) / (most - least) : height / 2)
  const xOf = (step: number) => round((width * step) / count)
  const treads = values.map((value, i) => `${i === 0 ? 'M0 ' : 'V'}${heightOf(value)}H${xOf(i + 1)}`)
  return {
    path: treads.join(''),
    marks: values.map((value, i) => ({ x: xOf(i + 0.5), y: heightOf(value) })),
    zero: least <= 0 && most >= 0 ? heightOf(0) : null,
  }
}

function round(value: number): number {
  return Math.round(10 * value) / 10
}
