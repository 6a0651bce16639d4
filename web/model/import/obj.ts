/** Wavefront OBJ: eight `v` lines are an element, in the order of the file. */
import { type Format, type FoundElement, Refused, readingOf } from './format'
import { toDouble } from './numbers'
import { Scanner } from './scanner'

export const obj: Format = {
  name: 'OBJ',
  read(text) {
    if (!/^v[ \t]+[-+.\d]/m.test(text) || !/^f[ \t]+\d/m.test(text)) return null
    const lines = new Scanner(text)
    const elements: FoundElement[] = []
    let name = ''
    let points = 0
    let vertices: number[] = []
    for (let line = lines.line(); line !== null; line = lines.line()) {
      const [keyword, ...fields] = line.split(/\s+/)
      if (keyword === 'o') name = fields.join(' ')
      if (keyword !== 'v') continue
      points++
      vertices.push(...fields.slice(0, 3).map(toDouble))
      if (vertices.length < 24) continue
      elements.push({ name: name || `points ${points - 7} to ${points}`, vertices })
      vertices = []
    }
    if (vertices.length > 0) {
      throw new Refused(`The OBJ text has ${points} points; hexahedra of eight points each need a multiple of eight.`)
    }
    return readingOf(elements, 'Points are taken in the order of the text.')
  },
}
