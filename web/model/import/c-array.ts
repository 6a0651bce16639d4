/** An array in C, C++ or Java code: double vertices[24] = {…}, any brackets inside. */
import { COORDINATE_COUNT } from '../hexahedron'
import { type Format, type FoundElement, inTwentyFours, Refused, readingOf } from './format'
import { numbersIn } from './numbers'

const DECLARATION = /\b(?:double|float|real)\b[^={;]{0,40}?\b(\w+)\s*(?:\[[^\]]*\]\s*)+=\s*(\{[^;]*)/g

export const cArray: Format = {
  name: 'C',
  read(text) {
    const code = text.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, ' ')
    const arrays = Array.from(code.matchAll(DECLARATION), ([, name, body]) => ({
      name: name as string,
      numbers: numbersIn(body as string),
    }))
    if (arrays.length === 0) return null
    const elements = arrays.flatMap(({ name, numbers }): FoundElement[] => {
      if (numbers.length % COORDINATE_COUNT !== 0) return []
      const all = inTwentyFours(numbers)
      return all.map((vertices, i) => ({ name: all.length === 1 ? name : `${name}, ${i}`, vertices }))
    })
    if (elements.length === 0) {
      throw new Refused(`The array ${arrays[0]?.name} has ${arrays[0]?.numbers.length} numbers; an element needs 24.`)
    }
    return readingOf(elements)
  },
}
