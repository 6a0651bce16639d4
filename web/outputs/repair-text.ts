/** What `repair` has done, for people. */
import type { Reason } from '../core/repair/held'
import type { Untangled } from '../core/repair/untangling'
import { formatPoint, speakNumber } from '../model/decimal'
import type { Vec3 } from '../model/hexahedron'
import type { NodeOrder } from '../model/node-orders'
import { counted, withoutControls } from './output'

/** Another order of nodes than the file's, in which a mesh is repaired. */
export type MeantOrder = (
  | { readonly kind: 'whole'; readonly order: NodeOrder }
  /** Some cells are numbered the other way round. */
  | { readonly kind: 'reversed'; readonly count: number }
) & { readonly cells: Uint32Array }

export interface Repaired {
  readonly result: Untangled
  /** Null where it is the file's. */
  readonly meantOrder: MeantOrder | null
  /** True if the mesh is written in that order. */
  readonly isReordered: boolean
  /** By how much coordinates are off that had no room for all their digits. */
  readonly mostRounded: number
  /** Of the held points, by their place among them. */
  reason(held: number): Reason
  readonly margin: number
  /** Neither its planes nor a distance were given to it. */
  readonly isBoundaryFixed: boolean
  readonly input: string
  readonly output: string
  readonly format: string
  /** The format in which the hexahedra alone are written; null where the file stays as it was but for coordinates. */
  readonly form: string | null
  /** The file of certificates, and how many are in it; null where none was wanted. */
  readonly certificates: { readonly file: string; readonly count: number } | null
}

/** Points whose reasons are said: a proof takes milliseconds. */
const MOST_REASONS = 10

export function* repairLines(repaired: Repaired): Generator<string> {
  const { result, input, output, format, form, mostRounded } = repaired
  const how =
    form === null ? 'where every byte but those of coordinates is as it was' : `its hexahedra alone, as ${form}`
  yield `${withoutControls(input)} (${format}) is written to ${withoutControls(output)}, ${how}.`
  yield* orderLines(repaired)
  yield* countLines(repaired)
  if (mostRounded > 0)
    yield `  The fields of the file have no room for all digits: moved coordinates are rounded by up to ${speakNumber(mostRounded)}.`
  if (result.tooManyCount > 0)
    yield `  ${counted(result.tooManyCount, 'point has', 'points have')} more cells than can be dealt with, and stay.`
  yield* reasonLines(repaired)
  const { certificates } = repaired
  if (certificates && result.heldPoints.length > 0)
    yield `  ${withoutControls(certificates.file)} has certificates of ${certificates.count} of these ${counted(result.heldPoints.length, 'point', 'points')}.`
}

function* orderLines({ meantOrder, isReordered }: Repaired): Generator<string> {
  if (!meantOrder) return
  const asWas = '--reorder writes the hexahedra so, as VTU, VTK, Gmsh or Abaqus.'
  if (meantOrder.kind === 'whole') {
    const { name, usedBy } = meantOrder.order
    const all = `  The nodes of all hexahedra are in the order “${name}”${usedBy === null ? '' : ` (${usedBy})`}`
    yield isReordered
      ? `${all}; they are written in that of VTK_HEXAHEDRON.`
      : `${all}. They are repaired in it, and written as they were; ${asWas}`
    return
  }
  const { count } = meantOrder
  const mirrored = counted(count, 'hexahedron', 'hexahedra')
  if (isReordered)
    yield `  ${mirrored} ${count === 1 ? 'was' : 'were'} mirrored: nodes 0 to 3 and 4 to 7 are exchanged.`
  else if (count === 1)
    yield `  ${mirrored} is mirrored, its nodes are numbered the other way round: it is repaired as if they were not, and written as it was; ${asWas}`
  else
    yield `  ${mirrored} are mirrored, their nodes are numbered the other way round: they are repaired as if they were not, and written as they were; ${asWas}`
}

function* countLines({ result, margin, meantOrder }: Repaired): Generator<string> {
  const { invalidBefore, invalidAfter, belowBefore, belowAfter } = result
  const invalid = `${invalidBefore - invalidAfter} of ${counted(invalidBefore, 'invalid hexahedron', 'invalid hexahedra')}`
  const below = margin > 0 ? `, ${belowBefore - belowAfter} of ${belowBefore} below ${margin}` : ''
  if (belowBefore > 0) yield `  Repaired: ${invalid}${below}.`
  else yield meantOrder ? '  There was nothing else to repair.' : '  There was nothing to repair.'
  const { movedCount, greatestDistance, meanDistance } = result
  if (movedCount === 0) yield '  No point has moved.'
  else
    yield `  ${counted(movedCount, 'point has', 'points have')} moved, by ${speakNumber(greatestDistance)} at most and ${speakNumber(meanDistance)} on average.`
}

function* reasonLines({ result, reason, margin, isBoundaryFixed }: Repaired): Generator<string> {
  const count = result.heldPoints.length
  if (count === 0) {
    if (result.belowAfter > 0)
      yield `  What is left has no point that may move${isBoundaryFixed ? '; --slide or --free-boundary D frees those of the boundary' : ''}.`
    return
  }
  yield `  What is left is held at ${counted(count, 'point', 'points')} that may move (counted from 0):`
  for (let held = 0; held < Math.min(count, MOST_REASONS); ++held) {
    const { point, cells, best, proof, forbids } = reason(held)
    const at = [0, 1, 2].map(r => result.points[3 * point + r]) as unknown as Vec3
    const own = counted(cells.length, 'cell', 'cells')
    const by = proof.isProved
      ? `: ${counted(proof.holds.length, 'point of the cells forbids', 'points of the cells forbid')} it, proved`
      : ''
    const place = `    point ${point} at ${formatPoint(at).replaceAll('−', '-')}: no place makes its ${own}`
    if (forbids === 'valid') yield `${place} valid${by}.`
    else if (forbids === 'margin') yield `${place} better than ${speakNumber(best.bound)}, below ${margin}${by}.`
    else yield `    point ${point}: no better place was found for its ${own}; that there is none is not proved.`
  }
  if (count > MOST_REASONS) yield `    and ${count - MOST_REASONS} more.`
}
