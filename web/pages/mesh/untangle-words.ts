/** What the panel that untangles says. */
import { grouped } from '../../mesh/mesh-headline'
import { formatNumber } from '../../model/decimal'
import type { GhostLines, HeldVertex, PartUntangled } from '../../survey/untangled-part'

export function ringWords(count: number): string {
  if (count === 0) return 'The chosen cell'
  return `The chosen cell and ${count} ${count === 1 ? 'ring' : 'rings'} around it`
}

export function linesWords({ ends, wanted }: GhostLines): string {
  const drawn = ends.length / 6
  return drawn === wanted
    ? ''
    : `: the ${drawn.toLocaleString('en')} that move farthest, of ${wanted.toLocaleString('en')}`
}

/** Why no place of the vertex helps. */
export function heldWords({ vertex, id, cellCount, forbids, bound, pointCount }: HeldVertex): string {
  const own = cellCount === 1 ? 'its cell' : `its ${cellCount} cells`
  const proved = `: ${pointCount} ${pointCount === 1 ? 'point forbids' : 'points forbid'} it, proved.`
  const which = `Vertex ${vertex} of cell ${id}`
  if (forbids === 'valid') return `${which}: no place makes ${own} valid${proved}`
  if (forbids === 'margin') return `${which}: no place makes ${own} better than ${formatNumber(bound)}${proved}`
  return `${which}: no better place was found for ${own}; that there is none is not proved.`
}

export function allProofsWords(heldCount: number): string {
  return heldCount === 1 ? 'The proof as a file' : `The proofs of all ${grouped(heldCount)} vertices as a file`
}

export function certificatesSentence(file: string, count: number, heldCount: number): string {
  return `${file} has certificates of ${grouped(count)} of ${many(heldCount, 'vertex', 'vertices')}.`
}

type Result = Pick<PartUntangled, 'counts' | 'heldCount'>

/** What would be repaired, what moves and how far, what is left and why. */
export function resultSentences(result: Result, margin: string): string[] {
  const { invalidBefore, invalidAfter, belowBefore, belowAfter, movedCount, greatestDistance, meanDistance } =
    result.counts
  if (belowBefore === 0) return [`All relative minima are ${margin} at least: there is nothing to do.`]
  if (movedCount === 0) return ['No vertex has a better place.', leftSentence(result, margin)]
  const first =
    invalidBefore === 0
      ? `${many(belowBefore - belowAfter, 'cell would reach', 'cells would reach')} ${margin}.`
      : `${grouped(invalidBefore - invalidAfter)} of ${many(invalidBefore, 'invalid cell', 'invalid cells')} would be valid.`
  const far = `${many(movedCount, 'vertex moves', 'vertices move')}, by ${formatNumber(meanDistance)} on average and ${formatNumber(greatestDistance)} at most.`
  return [first, far, leftSentence(result, margin)]
}

/** The same once it is in the mesh. */
export function takenSentences(result: Result, margin: string): string[] {
  const { movedCount } = result.counts
  return [
    `${many(movedCount, 'vertex has moved', 'vertices have moved')}: one step to undo.`,
    leftSentence(result, margin),
  ]
}

function leftSentence(
  { counts: { belowAfter, invalidAfter, tooManyCount }, heldCount }: Result,
  margin: string,
): string {
  if (belowAfter === 0) return `All reach ${margin}.`
  const left = `${many(belowAfter, 'cell stays', 'cells stay')} below ${margin}, ${grouped(invalidAfter)} of them invalid`
  const why =
    heldCount === 0
      ? 'none of their vertices may move'
      : `${many(heldCount, 'vertex that may move holds', 'vertices that may move hold')} them`
  const others =
    tooManyCount === 0 ? '' : ` ${many(tooManyCount, 'vertex has', 'vertices have')} more cells than are looked at.`
  return `${left}: ${why}.${others}`
}

function many(count: number, one: string, more: string): string {
  return `${grouped(count)} ${count === 1 ? one : more}`
}
