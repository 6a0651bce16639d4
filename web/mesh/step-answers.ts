/** What is answered of each step of a mesh, and said of all of them. */
import { CLASSES } from '../core/unpack'
import { formatNumber } from '../model/decimal'
import type { MeshCheck } from './mesh-check'
import { shown } from './shown'

export interface StepAnswer {
  readonly step: number
  /** As the file has it; null if it has none. */
  readonly time: string | null
  /** Null where the step could not be read. */
  readonly counts: { readonly hexahedra: number; readonly invalid: number; readonly unanswered: number } | null
  /** The relative minimum of the worst cell; -Infinity where its volume is 0 and its minimum negative, null where none is answered. */
  readonly least: number | null
  readonly worst: { readonly cell: number; readonly id: string } | null
  /** True if its cells are others than those of the step that was read first. */
  readonly isOther: boolean
  /** Why it could not be read; null if it was. */
  readonly refused: string | null
}

/** Answers by step; null for one that has not been read. */
export type Answers = readonly (StepAnswer | null)[]

/** What steps are called, where that is known before they are read; safe to show. */
export interface StepNames {
  readonly steps: readonly { readonly name: string; readonly time: string | null }[]
}

/** The answer of a step with `check`, whose worst cell is the first in its list; without a time of its own the mesh may have one. */
export function stepAnswerOf(
  check: MeshCheck,
  { step, time, isOther }: Pick<StepAnswer, 'step' | 'time' | 'isOther'>,
): StepAnswer {
  const { hexahedra, invalid, unanswered, mesh } = check
  const [worst] = check.worst
  return {
    step,
    time: time ?? (mesh.steps.length === 1 ? shownTime(mesh.steps[0] as string) : null),
    counts: { hexahedra, invalid, unanswered },
    least: worst === undefined || !check.isAnswered(worst) ? null : leastOf(check, worst),
    worst: worst === undefined ? null : { cell: worst, id: shown(check.idOf(worst) ?? String(worst)).slice(1, -1) },
    isOther,
    refused: null,
  }
}

/** Null for a time that is not said. */
export function shownTime(time: string): string | null {
  return time === '' ? null : shown(time).slice(1, -1)
}

/** As the list of the worst has it: a cell of volume 0 is below everything, or 0 if all of it is flat. */
function leastOf({ answers: { relativeMinima, classes } }: MeshCheck, cell: number): number {
  const relative = relativeMinima[cell] as number
  if (!Number.isNaN(relative)) return relative
  return CLASSES[classes[cell] as number] === 'collapsed' ? 0 : -Infinity
}

const SHORT = 8

/** A time as it is said: of a long number the seven digits of single precision, which many files hold; another text as it is. */
export function timeWords(time: string): string {
  const value = Number(time)
  const short = String(Number(value.toPrecision(7)))
  return Number.isFinite(value) && time.length > SHORT ? short : time
}

/** "Step 5 (t = 0.4)", or with the name of its file where it has no time, or neither. */
export function stepName({ steps }: StepNames, answers: Answers, step: number): string {
  const { name = '', time = null } = steps[step] ?? {}
  const known = time ?? answers[step]?.time ?? null
  const beside = known === null ? name : `t = ${timeWords(known)}`
  return `Step ${step + 1}${beside === '' ? '' : ` (${beside})`}`
}

/** The first step with an invalid cell among those that have been read; null if none has. */
export function firstInvalid(answers: Answers): StepAnswer | null {
  return answers.find(answer => (answer?.counts?.invalid ?? 0) > 0) ?? null
}

/** When it inverts, and where. */
export function lineSentence(list: StepNames, answers: Answers): string {
  const read = answers.filter(answer => answer !== null)
  const first = firstInvalid(answers)
  if (first) {
    const before = answers.slice(0, first.step)
    const isOpen = before.includes(null)
    const areRefused = before.some(answer => answer !== null && answer.refused !== null)
    const which = isOpen ? ' so far' : areRefused ? ' of those that could be read' : ''
    const name = stepName(list, answers, first.step)
    const invalid = first.counts?.invalid ?? 0
    if (invalid === 1) return `${name} is the first${which} with an invalid cell: cell ${first.worst?.id}.`
    return `${name} is the first${which} with invalid cells, ${invalid.toLocaleString('en')} of them: the worst is cell ${first.worst?.id}.`
  }
  const answered = read.filter(({ least }) => least !== null)
  if (answered.length === 0) return ''
  if (read.length < answers.length) return `${read.length} of ${answers.length} steps are read: no cell is invalid.`
  const worst = answered.reduce((a, b) => ((b.least as number) < (a.least as number) ? b : a))
  const isSure = read.every(({ counts }) => counts?.unanswered === 0)
  const where = `${lowerFirst(stepName(list, answers, worst.step))}, cell ${worst.worst?.id}`
  return `No step ${isSure ? 'has' : 'is known to have'} an invalid cell. The least relative minimum is ${formatNumber(worst.least as number)}: ${where}.`
}

/** Steps that could not be read, are not wholly answered, or have other cells. */
export function besideSentences(list: StepNames, answers: Answers): string[] {
  const read = answers.filter(answer => answer !== null)
  const about = (found: readonly StepAnswer[], one: string, many: string) => {
    const [first] = found
    if (!first) return []
    const name = stepName(list, answers, first.step)
    return [found.length === 1 ? `${name} ${one}` : `${found.length} steps ${many}, first ${lowerFirst(name)}`]
  }
  const refused = read.filter(answer => answer.refused !== null)
  return [
    ...about(refused, 'could not be read', 'could not be read').map(start => `${start}: ${refused[0]?.refused}`),
    ...about(
      read.filter(({ counts }) => (counts?.unanswered ?? 0) > 0),
      'has unanswered cells',
      'have unanswered cells',
    ).map(start => `${start}.`),
    ...about(
      read.filter(({ isOther }) => isOther),
      'has other cells than the step that was opened first',
      'have other cells than the step that was opened first',
    ).map(start => `${start}.`),
  ]
}

function lowerFirst(sentence: string): string {
  return sentence.slice(0, 1).toLowerCase() + sentence.slice(1)
}
