/** Words for the class of an element, and for vertices that coincide. */
import type { Report } from '../core/report'
import { type Vec3, vertexReference } from '../model/hexahedron'
import { listed, type PlainWord, say } from '../words/say'

const SHAPES: Readonly<Record<NonNullable<Report['shape']>, PlainWord>> = {
  wedge: 'a wedge stored as a hexahedron',
  pyramid: 'a pyramid stored as a hexahedron',
  tetrahedron: 'a tetrahedron stored as a hexahedron',
}

/** "a wedge stored as a hexahedron", "inverted" or "collapsed"; null if there is no word for it. */
export function kindName(report: Pick<Report, 'class' | 'shape'>): string | null {
  if (report.class === 'inverted') return say('inverted')
  if (report.class === 'collapsed') return say('collapsed')
  return report.shape && say(SHAPES[report.shape])
}

/** "Vertices 4 and 5 coincide, and so do 6 and 7": no full stop, and empty if none coincide. */
export function coincidenceClause({ coincident }: Pick<Report, 'coincident'>): string {
  if (coincident.length === 0) return ''
  const [first, ...others] = coincident.map(group => listed(group.map(String)))
  const clause = say('Vertices {names} coincide', { names: first as string })
  return others.length === 0
    ? clause
    : say('{clause}, and so do {others}', { clause, others: others.join(say(', and ')) })
}

/**
 * The vertices at which jacdet is 0 because vertices coincide: one of them and a neighbour, which
 * makes a column of DF zero, or two of its neighbours, which makes two columns parallel.
 */
export function zerosAtSight({ coincident }: Pick<Report, 'coincident'>): number[] {
  return vertexReference.flatMap((at, vertex) => {
    const isNear = (other: number) => differingAxes(at, vertexReference[other] as Vec3) <= 1
    return coincident.some(group => group.filter(isNear).length > 1) ? [vertex] : []
  })
}

/** "Vertices 4 and 5 coincide: jacdet is 0 there." */
export function coincidenceSentence(report: Pick<Report, 'coincident' | 'class'>): string {
  const clause = coincidenceClause(report)
  const zeros = zerosAtSight(report)
  if (clause === '' || zeros.length === 0 || report.class === 'collapsed')
    return clause && say('{sentence}.', { sentence: clause })
  const isThere = String(zeros) === String(report.coincident.flat().sort())
  return isThere
    ? say('{clause}: jacdet is 0 there.', { clause })
    : say('{clause}: jacdet is 0 at vertices {names}.', { clause, names: listed(zeros.map(String)) })
}

function differingAxes(a: Vec3, b: Vec3): number {
  return a.filter((value, axis) => value !== b[axis]).length
}
