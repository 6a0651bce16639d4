/** Nothing but numbers, with any separators and brackets between: 24 for each element. */
import { COORDINATE_COUNT } from '../hexahedron'
import { type Format, inTwentyFours, isThreeByEight, readingOf, transposed } from './format'
import { numberPattern, numbersIn, toDouble } from './numbers'
import { innermostRows } from './numpy'

/** How NumPy's print wraps its numbers. */
const WRAPPERS = /\b(?:np\.|numpy\.)?(?:float\d*|list|tuple)\b/g
const NO_SEPARATOR = /[^\s,;:|/=()[\]{}<>'"]/
const WITH_DECIMAL_COMMA = /^[-+−]?\d+(?:,\d+)?(?:[eE][-+]?\d+)?$/

export const plainNumbers: Format = {
  name: 'plain numbers',
  read(text) {
    const tokens = text.length < 10_000 ? text.trim().split(/[\s;]+/) : []
    if (
      tokens.length === COORDINATE_COUNT &&
      text.includes(',') &&
      tokens.every(token => WITH_DECIMAL_COMMA.test(token))
    ) {
      const vertices = tokens.map(token => toDouble(token.replace(',', '.')))
      return readingOf([{ name: 'the numbers', vertices }], 'Commas were taken for decimal points.')
    }
    if (NO_SEPARATOR.test(text.replace(numberPattern(), '').replace(WRAPPERS, ''))) return null
    const numbers = numbersIn(text)
    if (numbers.length === 0 || numbers.length % COORDINATE_COUNT !== 0) return null
    const rows = innermostRows(text)
    if (isThreeByEight(rows)) return readingOf([{ name: 'the numbers', vertices: transposed(rows) }])
    const all = inTwentyFours(numbers)
    const lines = text.trim().split('\n').map(numbersIn)
    if (rows.length === 0 && isThreeByEight(lines)) {
      return readingOf([
        { name: 'points are columns', vertices: transposed(lines) },
        { name: 'points one after another', vertices: numbers },
      ])
    }
    return readingOf(
      all.map((vertices, i) => ({
        name: all.length === 1 ? 'the numbers' : `numbers ${COORDINATE_COUNT * i + 1} to ${COORDINATE_COUNT * (i + 1)}`,
        vertices,
      })),
    )
  },
}
