/** What the page Mesh says beside the sentences of the mesh itself. */
import type { CheckId } from '../../core/report'
import { formatNames } from '../../mesh/format-names'
import { formatNumber } from '../../model/decimal'
import type { Overview, Row } from '../../survey/survey-jobs'
import { checkNamesOfMeshes } from '../../views/check-names'

/** The name of what came without one. */
const PASTED = 'the text'

/** Names that stand for the others. */
const NAMED = 8

export const NOT_IN_STEPS =
  'A mesh of several time steps is only shown: open the file of one step alone to untangle it.'
export const NOTHING_OPEN = 'Nothing is open. Drop a mesh anywhere here, open its files or paste its text.'
export const MEANS = 'Invalid: the Jacobian determinant, jacdet, is ≤ 0 somewhere in the cell.'
export const STAYS = 'It is read in this browser and sent nowhere.'
export const ALL_FORMATS = `Formats: ${formatNames.join(', ')}.`
export const FORMATS = `Formats: ${formatNames.slice(0, NAMED).join(', ')} and ${formatNames.length - NAMED} others.`

/** A refusal of what was given under a name, and what is on the page now. */
export function refusalWords(given: string, refused: string, open: string | null): string {
  const what = refused.includes(given) || given === PASTED ? refused : `${given}: ${lowerFirst(refused)}`
  return open === null ? what : `${what} ${stillOpen(open)}`
}

export function cancelledWords(open: string | null): string {
  return open === null ? 'Cancelled.' : `Cancelled. ${stillOpen(open)}`
}

/** Of a mesh that another one has taken the place of. */
export function unsavedSentence(name: string, movedCount: number): string {
  const moved = movedCount === 1 ? 'One moved vertex' : `${movedCount.toLocaleString('en')} moved vertices`
  return `${moved} of ${name} ${movedCount === 1 ? 'is' : 'are'} in no file.`
}

/** Of an invalid cell; empty where no check accepts it. */
export function acceptedSentence({ standing, acceptedBy }: Pick<Row, 'standing' | 'acceptedBy'>): string {
  if (standing !== 'invalid' || acceptedBy.length === 0) return ''
  return `Accepted by ${acceptedBy.map(inSentence).join(', ')}.`
}

function stillOpen(name: string): string {
  return `What is below is still ${name === PASTED ? 'what was pasted before' : name}.`
}

/** What to do now, or how near to invalid a mesh is. */
export function nextSentence({ counts, fixes, worst }: Overview): string {
  const [first] = worst
  if (counts.invalid > 0) {
    if (fixes.length > 0) return ''
    return counts.invalid === 1
      ? 'Its id, for the mesher, and a report are under “Take away”.'
      : 'Their ids, for the mesher, and a report are under “Take away”.'
  }
  if (!first || first.why !== null || Number.isNaN(first.relativeMinimum)) return ''
  const minimum = formatNumber(first.relativeMinimum)
  return `The least relative minimum is ${minimum}, of cell ${first.id}: 0 would be invalid, 1 is a parallelepiped.`
}

/** Files of one name in several folders that are no steps: whoever wants one folder alone is told. */
export function namesakeSentence(paths: readonly string[] | undefined): string {
  if (!paths) return ''
  const seen = new Map<string, string>()
  for (const path of paths) {
    const name = path.slice(path.lastIndexOf('/') + 1).toLowerCase()
    const other = seen.get(name)
    if (other !== undefined && other !== path)
      return `Files of several folders are taken as parts of one mesh, ${other} and ${path} among them: for one folder’s, drop that alone.`
    seen.set(name, path)
  }
  return ''
}

function inSentence(check: CheckId): string {
  const name = checkNamesOfMeshes[check]
  return name.startsWith('VTK') ? name : lowerFirst(name)
}

function lowerFirst(sentence: string): string {
  return sentence.slice(0, 1).toLowerCase() + sentence.slice(1)
}
