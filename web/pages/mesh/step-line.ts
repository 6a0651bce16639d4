/** The line of the least relative minimum over the steps: where its points are; and a step in words. */
import { type Answers, timeWords } from '../../mesh/step-answers'
import { formatNumber } from '../../model/decimal'
import type { StepList } from '../../survey/survey-jobs'

export interface LinePoint {
  readonly step: number
  /** From 0, the first step or the top, to 1. */
  readonly x: number
  readonly y: number
  readonly isInvalid: boolean
}

export interface StepLine {
  /** From 0 to 1 for every step: by their times where all are known and rise, else evenly. */
  readonly places: readonly number[]
  /** Runs of steps that follow each other and have a number. */
  readonly runs: readonly (readonly LinePoint[])[]
  readonly zero: number
  readonly least: number
  readonly greatest: number
  readonly isByTime: boolean
}

/** Null without a number. */
export function stepLineOf(list: StepList, answers: Answers): StepLine | null {
  const finite = answers.flatMap(answer => (answer?.least != null && answer.least > -Infinity ? [answer.least] : []))
  if (finite.length === 0) return null
  const [least, greatest] = [Math.min(...finite), Math.max(...finite)]
  const [low, high] = [Math.min(0, heightOf(least)), Math.max(0, heightOf(greatest))]
  const span = high - low || 1
  // A cell of volume 0 with a negative minimum is below every number: at the bottom.
  const yOf = (value: number) =>
    value === -Infinity ? 1 : MARGIN + ((high - heightOf(value)) / span) * (1 - 2 * MARGIN)
  const times = timesOf(list, answers)
  const count = list.steps.length
  const [from, to] = [times?.[0] ?? 0, times?.at(-1) ?? count - 1]
  const places = list.steps.map((_, step) => ((times?.[step] ?? step) - from) / (to - from))
  const runs: LinePoint[][] = [[]]
  for (const [step, answer] of answers.entries())
    if (answer?.least == null) runs.push([])
    else {
      const isInvalid = (answer.counts?.invalid ?? 0) > 0
      runs.at(-1)?.push({ step, x: places[step] as number, y: yOf(answer.least), isInvalid })
    }
  return { places, runs: runs.filter(run => run.length > 0), zero: yOf(0), least, greatest, isByTime: times !== null }
}

/** Of the height, above and below what is drawn. */
const MARGIN = 0.08

/** Relative minima are 1 at most and may be -1e6: logarithmic below -1, so that zero and what is about it stay apart. */
function heightOf(value: number): number {
  return value >= -1 ? value : -1 - Math.log10(-value)
}

function timesOf({ steps }: StepList, answers: Answers): readonly number[] | null {
  const times = steps.map(({ time }, step) => {
    const text = time ?? answers[step]?.time ?? ''
    return text.trim() === '' ? Number.NaN : Number(text)
  })
  const isRising = times.every((time, i) => Number.isFinite(time) && time >= (times[i - 1] ?? -Infinity))
  return isRising && (times.at(-1) as number) > (times[0] as number) ? times : null
}

/** A step in words, for the slider: "Step 5 of 7, t = 0.4: 1 of 8 cells is invalid, least relative minimum −0.2". */
export function stepWords(list: StepList, answers: Answers, step: number): string {
  const answer = answers[step]
  const time = list.steps[step]?.time ?? answer?.time ?? null
  const name = `Step ${step + 1} of ${list.steps.length}${time === null ? '' : `, t = ${timeWords(time)}`}`
  if (!answer) return name
  if (!answer.counts) return `${name}: not read`
  const { hexahedra, invalid } = answer.counts
  const counts = `${invalid.toLocaleString('en')} of ${hexahedra.toLocaleString('en')} ${hexahedra === 1 ? 'cell' : 'cells'} ${invalid === 1 || hexahedra === 1 ? 'is' : 'are'} invalid`
  return `${name}: ${counts}${answer.least === null ? '' : `, least relative minimum ${leastWords(answer.least)}`}`
}

function leastWords(least: number): string {
  return least === -Infinity ? 'none, volume 0' : formatNumber(least)
}
