/** MATLAB and Octave: matrices as printed, with their common factor and columns in blocks, or as typed, with semicolons. */
import { COORDINATE_COUNT } from '../hexahedron'
import { type Format, type FoundElement, inTwentyFours, isThreeByEight, Refused, readingOf, transposed } from './format'
import { numberPattern, toDouble } from './numbers'
import { Scanner } from './scanner'

const TYPED = /(?:(?<!\w)(\w+)\s*=\s*)?\[([^[\]]*;[^[\]]*)\]/g
const NAME = /^([A-Za-z][\w.(),:]*)\s*=$/
const FACTOR = /^1(?:\.0*)?e([-+]?\d+)\s*\*$/i
const COLUMNS = /^Columns? \d+/i

export const matlab: Format = {
  name: 'MATLAB',
  read(text) {
    const matrices = [...typedMatrices(text), ...printedMatrices(text)]
    if (matrices.length === 0) return null
    const elements = matrices.flatMap(elementsOf)
    if (elements.length > 0) return readingOf(elements)
    const [{ rows }] = matrices as [Matrix]
    throw new Refused(`A matrix of ${rows.length}×${rows[0]?.length} was found; an element is one of 8×3 or 3×8.`)
  },
}

interface Matrix {
  readonly name: string
  readonly rows: readonly (readonly number[])[]
}

function elementsOf({ name, rows }: Matrix): FoundElement[] {
  if (isThreeByEight(rows)) return [{ name, vertices: transposed(rows) }]
  const numbers = rows.flat()
  if (numbers.length === 0 || numbers.length % COORDINATE_COUNT !== 0) return []
  const all = inTwentyFours(numbers)
  return all.map((vertices, i) => ({ name: all.length === 1 ? name : `${name}, ${i + 1}`, vertices }))
}

function typedMatrices(text: string): Matrix[] {
  const code = text.includes('[') ? text.replace(/%.*/g, '').replace(/\.{3}.*\n/g, ' ') : ''
  return Array.from(code.matchAll(TYPED), ([, name, body]) => ({
    name: name ?? 'the matrix',
    rows: (body as string)
      .split(/[;\n]/)
      .map(row => rowOf(row, 0) ?? [])
      .filter(row => row.length > 0),
  }))
}

/** Taken for MATLAB's print only by its marks: a name and "=" on a line, a factor, or numbered columns. */
function printedMatrices(text: string): Matrix[] {
  const marked = /^[ \t]*(?:[A-Za-z][\w.(),:]*\s*=[ \t]*$|1(?:\.0*)?e[-+]?\d+\s*\*[ \t]*$|Columns? \d)/im
  if (!marked.test(text)) return []
  const matrices: Matrix[] = []
  const lines = new Scanner(text)
  let name = 'the matrix'
  let power = 0
  let blocks: number[][][] = [[]]
  const end = () => {
    const rows = sideBySide(blocks)
    if (rows.length > 0) matrices.push({ name, rows })
    blocks = [[]]
    power = 0
  }
  for (let line = lines.line(); line !== null; line = lines.line()) {
    const named = NAME.exec(line)
    const factor = FACTOR.exec(line)
    const row = rowOf(line, power)
    if (named) {
      end()
      name = named[1] as string
    } else if (factor) power = Number(factor[1])
    else if (COLUMNS.test(line)) {
      if (blocks.at(-1)?.length !== 0) blocks.push([])
    } else if (row) blocks.at(-1)?.push(row)
    else end()
  }
  end()
  return matrices
}

/** Blocks of columns joined row by row. */
function sideBySide(blocks: readonly number[][][]): number[][] {
  return (blocks[0] ?? []).map((_, i) => blocks.flatMap(block => block[i] ?? []))
}

/** The numbers of a row times 10^power, moved in the decimal text so that nothing is rounded twice; null for other text. */
function rowOf(line: string, power: number): number[] | null {
  if (!/^[\s,]*$/.test(line.replace(numberPattern(), ''))) return null
  return Array.from(line.matchAll(numberPattern()), ([text]) => {
    const [, digits = '', own = '0'] = /^([^eEdD]*)(?:[eEdD](.*))?$/.exec(text) ?? []
    return toDouble(power === 0 ? text : `${digits}e${Number(own) + power}`)
  })
}
