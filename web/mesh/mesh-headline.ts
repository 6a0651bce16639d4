/** The sentence on top of a mesh's page. */
import { acceptedInvalid } from './accepted-invalid'
import type { MeshCheck } from './mesh-check'

/** "12 of 88,432 hexahedra are invalid. The eight corners would accept 7 of them, VTK’s scaled Jacobian 9." */
export function headlineOf(check: MeshCheck): string {
  const { hexahedra, invalid, unanswered } = check
  const open = unanswered === 0 ? '' : ` ${grouped(unanswered)} ${unanswered === 1 ? 'is' : 'are'} unanswered.`
  if (invalid === 0) return unanswered === hexahedra ? noneAnswered(hexahedra) : `${noneInvalid(check)}${open}`
  const [are, them] = invalid === 1 ? ['is', 'it'] : ['are', 'them']
  const of = hexahedra === 1 ? 'The hexahedron is' : `${grouped(invalid)} of ${grouped(hexahedra)} hexahedra ${are}`
  const { corners, vtk } = acceptedInvalid(check)
  const others =
    corners + vtk === 0
      ? `The eight corners and VTK’s scaled Jacobian reject ${them}, too.`
      : invalid === 1
        ? oneAccepted(corners === 1, vtk === 1)
        : `The eight corners would accept ${someOf(corners)} of them, VTK’s scaled Jacobian ${someOf(vtk)}.`
  return `${of} invalid. ${others}${open}`
}

function oneAccepted(byCorners: boolean, byVtk: boolean): string {
  if (byCorners && byVtk) return 'The eight corners and VTK’s scaled Jacobian would accept it.'
  return `The eight corners ${byCorners ? 'would accept' : 'reject'} it, VTK’s scaled Jacobian ${byVtk ? 'would accept' : 'rejects'} it.`
}

function someOf(count: number): string {
  return count === 0 ? 'none' : grouped(count)
}

function noneAnswered(hexahedra: number): string {
  if (hexahedra === 0) return ''
  return hexahedra === 1 ? 'The hexahedron is unanswered.' : `All ${grouped(hexahedra)} hexahedra are unanswered.`
}

function noneInvalid({ hexahedra, valid }: MeshCheck): string {
  if (valid < hexahedra) return `None of ${grouped(hexahedra)} hexahedra is known to be invalid.`
  return hexahedra === 1 ? 'The hexahedron is valid.' : `All ${grouped(hexahedra)} hexahedra are valid.`
}

/** 88,432. */
export function grouped(count: number): string {
  return count.toLocaleString('en')
}
