/** The sentence on top of a mesh's page. */
import type { CheckId } from '../core/report'
import { CHECKS } from '../core/unpack'
import type { MeshCheck } from './mesh-check'

/** "12 of 88,432 hexahedra are invalid. The eight corners would accept 7 of them, VTK’s scaled Jacobian 9." */
export function headlineOf(check: MeshCheck): string {
  const { hexahedra, invalid, unanswered } = check
  const open = unanswered === 0 ? '' : ` ${grouped(unanswered)} ${unanswered === 1 ? 'is' : 'are'} unanswered.`
  if (invalid === 0) return unanswered === hexahedra ? noneAnswered(hexahedra) : `${noneInvalid(check)}${open}`
  const [are, them] = invalid === 1 ? ['is', 'it'] : ['are', 'them']
  const of = hexahedra === 1 ? 'The hexahedron is' : `${grouped(invalid)} of ${grouped(hexahedra)} hexahedra ${are}`
  const corners = acceptedInvalid(check, 'corners')
  const vtk = acceptedInvalid(check, 'corners-and-centre')
  const others =
    corners + vtk === 0
      ? `The eight corners and VTK’s scaled Jacobian reject ${them}, too.`
      : `The eight corners would accept ${grouped(corners)} of them, VTK’s scaled Jacobian ${grouped(vtk)}.`
  return `${of} invalid. ${others}${open}`
}

function noneAnswered(hexahedra: number): string {
  if (hexahedra === 0) return ''
  return hexahedra === 1 ? 'The hexahedron is unanswered.' : `All ${grouped(hexahedra)} hexahedra are unanswered.`
}

function noneInvalid({ hexahedra, valid }: MeshCheck): string {
  if (valid < hexahedra) return `None of ${grouped(hexahedra)} hexahedra is known to be invalid.`
  return hexahedra === 1 ? 'The hexahedron is valid.' : `All ${grouped(hexahedra)} hexahedra are valid.`
}

/** Invalid cells that a check accepts. */
export function acceptedInvalid(check: MeshCheck, id: CheckId): number {
  const bit = 1 << CHECKS.indexOf(id)
  const { acceptedBy } = check.answers
  let count = 0
  for (let cell = 0; cell < check.hexahedra; ++cell)
    if (((acceptedBy?.[cell] ?? 0) & bit) !== 0 && check.standingOf(cell) === 'invalid') count++
  return count
}

/** 88,432. */
export function grouped(count: number): string {
  return count.toLocaleString('en')
}
