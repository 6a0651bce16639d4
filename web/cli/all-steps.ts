/** `check --step all`: every time step of a file is decided, and one is told of: the first with an invalid cell, or else that of the least minimum. */
import { type ExitStatus, exitOf, gravestExit } from '../mesh/check'
import { type Mesh, MeshRefusal } from '../mesh/mesh'
import type { MeshCheck } from '../mesh/mesh-check'
import {
  besideSentences,
  firstInvalid,
  lineSentence,
  type StepAnswer,
  type StepNames,
  shownTime,
  stepAnswerOf,
  stepName,
} from '../mesh/step-answers'
import { haveSameCells } from '../mesh/step-files'
import type { CheckedSteps } from '../outputs/output'

export interface StepWork {
  read(step: number): Promise<Mesh>
  /** With one worst cell at least. */
  check(mesh: Mesh): Promise<MeshCheck>
  readonly allowsUnchecked: boolean
}

interface Result {
  /** Of the step that is told of. */
  readonly check: MeshCheck
  readonly exit: ExitStatus
  /** Null for a file with one mesh. */
  readonly steps: CheckedSteps | null
}

/** Throws a MeshRefusal that says which step was refused. */
export async function checkAllSteps(work: StepWork): Promise<Result> {
  const first = await work.read(0)
  const { length } = first.steps
  let told = await work.check(first)
  let shown = 0
  const exits = [exitOf(told, work)]
  if (length < 2 || first.isSteady) return { check: told, exit: exits[0] as ExitStatus, steps: null }
  const names = { steps: first.steps.map(time => ({ name: '', time: shownTime(time) })) }
  const answerOf = (check: MeshCheck, step: number) => {
    const isOther = !haveSameCells(first, check.mesh)
    return stepAnswerOf(check, { step, time: names.steps[step]?.time ?? null, isOther })
  }
  const answers = [answerOf(told, 0)]
  for (let step = 1; step < length; ++step) {
    const check = await work.check(await readStep(work, { step, length, names, answers }))
    exits.push(exitOf(check, work))
    answers.push(answerOf(check, step))
    if (!isWorse({ check, answer: answers[step] }, { check: told, answer: answers[shown] })) continue
    told = check
    shown = step
  }
  const notes = [...sentencesOf(names, answers, shown), ...told.notes]
  return { check: { ...told, notes }, exit: gravestExit(exits), steps: { answers, shown } }
}

async function readStep(
  { read }: StepWork,
  {
    step,
    length,
    names,
    answers,
  }: {
    readonly step: number
    readonly length: number
    readonly names: StepNames
    readonly answers: readonly StepAnswer[]
  },
): Promise<Mesh> {
  try {
    return await read(step)
  } catch (error) {
    if (!(error instanceof MeshRefusal)) throw error
    const before = firstInvalid(answers) === null ? '' : ` ${lineSentence(names, answers)}`
    throw new MeshRefusal(`Time step ${step + 1} of ${length}: ${error.message}${before}`)
  }
}

interface Told {
  readonly check: MeshCheck
  readonly answer: StepAnswer | undefined
}

/** True if the later step is to be told of in place of the earlier one. */
function isWorse(later: Told, earlier: Told): boolean {
  const [own, other] = [later, earlier].map(({ check }) => (check.invalid > 0 ? 0 : check.below > 0 ? 1 : 2)) as [
    number,
    number,
  ]
  if (own !== other) return own < other
  return own === 2 && (later.answer?.least ?? Infinity) < (earlier.answer?.least ?? Infinity)
}

function sentencesOf(names: StepNames, answers: readonly StepAnswer[], shown: number): string[] {
  const invalid = answers.filter(({ counts }) => (counts?.invalid ?? 0) > 0).length
  const name = stepName(names, answers, shown)
  const which = invalid > 1 ? `, and ${invalid} have invalid cells` : ''
  return [
    lineSentence(names, answers),
    ...besideSentences(names, answers),
    `All ${answers.length} time steps were checked${which}. What follows is of ${name.slice(0, 1).toLowerCase()}${name.slice(1)}.`,
  ].filter(sentence => sentence !== '')
}
