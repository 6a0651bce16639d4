/**
 * One frame as sentences to be heard: "Vertex 3: 1.25, 0.5, -1. Minimum jacdet -0.03 on face 2.
 * Invalid.", and of a degenerate element "Invalid: a wedge stored as a hexahedron. Vertices 4 and 5
 * coincide, and so do 6 and 7."
 */
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import { speakJacdet, speakNumber } from '../../model/decimal'
import { edgeName, vertexOf } from '../../model/hexahedron'
import type { State } from '../../model/state'
import { coincidenceClause, kindName } from '../../views/coincidences'

export function announcement(state: State, report: Report): string {
  const vertex = vertexOf(state.vertices, state.selectedVertex).map(speakNumber).join(', ')
  const { kind, id, value } = report.minimizer
  const minimum = speakJacdet(value, report.exponent, state.referenceCube)
  const inside = lowerInside(report)
  const lower = inside
    ? `, ${speakJacdet(approximation(inside).value, report.exponent, state.referenceCube)} inside`
    : ''
  const at = kind === 'vertex' ? 'at' : 'on'
  const name = kind === 'edge' ? edgeName(id).replace('–', '-') : id
  return `Vertex ${state.selectedVertex}: ${vertex}. Minimum jacdet ${minimum} ${at} ${kind} ${name}${lower}. ${verdict(report)}`
}

function verdict(report: Report): string {
  const kind = kindName(report)
  const coincidence = coincidenceClause(report)
  return `${report.valid ? 'Valid' : 'Invalid'}${kind ? `: ${kind}` : ''}.${coincidence && ` ${coincidence}.`}`
}
