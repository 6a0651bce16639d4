/** NumPy's repr, and code that makes an array: array([[…]]) of 8×3, 3×8, 24, or any number of elements. */
import { COORDINATE_COUNT } from '../hexahedron'
import { type Format, type FoundElement, inTwentyFours, isThreeByEight, Refused, readingOf, transposed } from './format'
import { numbersIn } from './numbers'

const OPENING = /(?:(?<!\w)(\w+)\s*=\s*)?(?<![\w.])(?:\w+\.)*array\(/g

export const numpy: Format = {
  name: 'NumPy',
  read(text) {
    if (!text.includes('array(')) return null
    const code = text.replace(/#.*/g, '')
    const bodies: { readonly name: string | undefined; readonly body: string }[] = []
    const opening = new RegExp(OPENING)
    for (let match = opening.exec(code); match; match = opening.exec(code)) {
      const body = bracketed(code, opening.lastIndex)
      opening.lastIndex += body.length
      bodies.push({ name: match[1], body })
    }
    if (bodies.length === 0) return null
    const counts = bodies.map(({ body }) => numbersIn(body).length)
    const elements = bodies.flatMap(({ name, body }) => elementsOf(body, name ?? 'the array'))
    if (elements.length === 0) {
      throw new Refused(`The array has ${counts.join(', then ')} numbers; an element needs 24.`)
    }
    return readingOf(elements)
  },
}

/** What the brackets that open here enclose; up to the end where they do not close. */
function bracketed(text: string, from: number): string {
  let depth = 0
  for (let at = from; at < text.length; at++) {
    if (text[at] === '[') depth++
    else if (text[at] === ']' && --depth === 0) return text.slice(from, at + 1)
    else if (text[at] === ')' && depth === 0) return text.slice(from, at)
  }
  return text.slice(from)
}

function elementsOf(body: string, name: string): FoundElement[] {
  const rows = innermostRows(body)
  if (isThreeByEight(rows)) return [{ name, vertices: transposed(rows) }]
  const numbers = numbersIn(body)
  if (numbers.length === 0 || numbers.length % COORDINATE_COUNT !== 0) return []
  const all = inTwentyFours(numbers)
  return all.map((vertices, i) => ({ name: all.length === 1 ? name : `${name}[${i}]`, vertices }))
}

/** The lists of numbers that hold no list. */
export function innermostRows(text: string): number[][] {
  return Array.from(text.matchAll(/\[([^[\]]*)\]/g), ([, row]) => numbersIn(row as string))
}
