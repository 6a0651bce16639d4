/** What is said of a file with several time steps. */
import { shown } from './shown'

/** Of the step that was read; for people they are counted from 1. */
export function stepNote(times: readonly string[], step: number | 'last'): string {
  const at = step === 'last' ? times.length - 1 : step
  const time = times[at] ?? ''
  return `Time step ${at + 1} of ${times.length} was read${time === '' ? '' : `: ${shown(time)}`}.`
}

/** Of a file whose steps differ in results alone. */
export function sameMeshNote(count: number): string {
  return `The mesh is the same at all ${count} time steps of the file.`
}

/** Why a step cannot be read, for people; a file that has no steps counts as one with one. */
export function missingStep(count: number, step: number | 'last'): string {
  const has = count === 1 ? 'one time step' : `${count} time steps`
  return `it has ${has}, and ${step === 'last' ? 'the last' : `step ${step + 1}`} was asked for.`
}
