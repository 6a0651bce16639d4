/**
 * One frame as sentences to be heard: "Vertex 3: 1.25, 0.5, -1. Minimum jacdet -0.03 on face 2.
 * Invalid.", and of a degenerate element "Invalid: a wedge stored as a hexahedron. Vertices 4 and 5
 * coincide, and so do 6 and 7."
 */
import { approximation, lowerInside } from '../../core/inside'
import type { CandidateKind, Report } from '../../core/report'
import { speakJacdet, speakNumber } from '../../model/decimal'
import { edgeName, vertexOf } from '../../model/hexahedron'
import type { State } from '../../model/state'
import { coincidenceClause, kindName } from '../../views/coincidences'
import { say } from '../../words/say'

export function announcement(state: State, report: Report): string {
  const vertex = vertexOf(state.vertices, state.selectedVertex).map(speakNumber).join(', ')
  const { kind, id, value } = report.minimizer
  const minimum = speakJacdet(value, report.exponent, state.referenceCube)
  const inside = lowerInside(report)
  const place = spokenPlace(kind, id)
  const least = inside
    ? say('Minimum jacdet {minimum} {place}, {lower} inside.', {
        minimum,
        place,
        lower: speakJacdet(approximation(inside).value, report.exponent, state.referenceCube),
      })
    : say('Minimum jacdet {minimum} {place}.', { minimum, place })
  return `${say('Vertex {name}: {coordinates}.', { name: state.selectedVertex, coordinates: vertex })} ${least} ${verdict(report)}`
}

function spokenPlace(kind: CandidateKind, id: number): string {
  if (kind === 'vertex') return say('at vertex {name}', { name: id })
  return kind === 'edge'
    ? say('on edge {name}', { name: edgeName(id).replace('–', '-') })
    : say('on face {name}', { name: id })
}

function verdict(report: Report): string {
  const kind = kindName(report)
  const coincidence = coincidenceClause(report)
  const word = report.valid ? say('Valid') : say('Invalid')
  return `${kind ? say('{verdict}: {kind}.', { verdict: word, kind }) : say('{sentence}.', { sentence: word })}${coincidence && ` ${say('{sentence}.', { sentence: coincidence })}`}`
}
