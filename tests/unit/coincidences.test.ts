/** The words about coincident vertices, against the report of elements that have them. */
import { describe, expect, it } from 'vitest'
import type { Report } from '../../web/core/report'
import { coincidenceSentence, kindName, zerosAtSight } from '../../web/views/coincidences'
import { core, unitCube } from './core-fixtures'

/** Vertex v where vertex places[v] of the unit cube is, or of one whose vertices are in general position. */
function reportOf(places: string, cube: readonly number[] = unitCube): Report {
  const vertices = [...places].flatMap(v => cube.slice(3 * Number(v), 3 * Number(v) + 3))
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

describe('the sentence about coincident vertices', () => {
  const sentences: [string, string][] = [
    ['01234567', ''],
    ['01234467', 'Vertices 4 and 5 coincide: jacdet is 0 there.'],
    ['01234466', 'Vertices 4 and 5 coincide, and so do 6 and 7: jacdet is 0 there.'],
    [
      '01214466',
      'Vertices 1 and 3 coincide, and so do 4 and 5, and 6 and 7: jacdet is 0 at vertices 0, 2, 4, 5, 6 and 7.',
    ],
    ['01234444', 'Vertices 4, 5, 6 and 7 coincide: jacdet is 0 there.'],
    ['01224444', 'Vertices 2 and 3 coincide, and so do 4, 5, 6 and 7: jacdet is 0 there.'],
    ['01234447', 'Vertices 4, 5 and 6 coincide: jacdet is 0 at vertices 4, 5, 6 and 7.'],
    // The ends of a face's diagonal: parallel columns at the two others.
    ['01214567', 'Vertices 1 and 3 coincide: jacdet is 0 at vertices 0 and 2.'],
    // The ends of a diagonal of the cube make nothing zero.
    ['01234507', 'Vertices 0 and 6 coincide.'],
    ['00000000', 'Vertices 0, 1, 2, 3, 4, 5, 6 and 7 coincide.'],
  ]
  for (const [places, sentence] of sentences)
    it(`of ${places}: ${sentence}`, () => expect(coincidenceSentence(reportOf(places))).toBe(sentence))

  it('names the vertices at which jacdet is 0, and no others', () => {
    const general = [0, 0, 0, 7, 1, -1, 8, 9, 2, -1, 6, 1, 1, -2, 9, 6, 1, 7, 9, 8, 9, 2, 7, 8]
    const lists = ['01234567', '01234467', '01214567', '01234507', '01234447', '01234444', '51234567', '01232327']
    for (const places of lists) {
      const report = reportOf(places, general)
      const zeros = report.candidates.filter(({ kind, value }) => kind === 'vertex' && value === 0).map(({ id }) => id)
      expect(zerosAtSight(report), places).toEqual(zeros)
    }
  })
})

it('a word for what is neither just valid nor just invalid', () => {
  const names: [string, string | null][] = [
    ['01234567', null],
    ['01234467', null],
    ['01234466', 'a wedge stored as a hexahedron'],
    ['01234444', 'a pyramid stored as a hexahedron'],
    ['01224444', 'a tetrahedron stored as a hexahedron'],
    ['45670123', 'inverted'],
    ['01230123', 'collapsed'],
  ]
  for (const [places, name] of names) expect(kindName(reportOf(places)), places).toBe(name)
})
