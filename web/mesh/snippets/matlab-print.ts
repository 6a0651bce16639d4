/** Matrices as MATLAB and Octave print them: a name and "=", a common factor, columns in blocks. */
import { numberOf } from '../text-cursor'
import { type NumberTable, numberTable } from './number-table'
import { Tokens } from './tokens'

const NAME = /^([A-Za-z][\w.(),:]{0,60})\s{0,8}=$/
const FACTOR = /^1(?:\.0{0,20})?[eE]([-+]?\d{1,3})\s{0,8}\*$/
const COLUMNS = /^Columns? \d+/i
const LONGEST_LINE = 100_000

/** Empty where the text has none of their marks. */
export function tablesOfMatlab(text: string): NumberTable[] {
  const tables: NumberTable[] = []
  let isMarked = false
  let name: string | null = null
  let power = 0
  let blocks: number[][][] = [[]]
  let digits = 0
  let integers = true
  const end = () => {
    const rows = (blocks[0] ?? []).map((_, i) => blocks.flatMap(block => block[i] ?? []))
    if (rows.length > 0 && name !== null)
      tables.push(numberTable(rows, integers && power === 0, { names: [name], digits, base: 1 }))
    blocks = [[]]
    power = 0
    digits = 0
    integers = true
  }
  for (const raw of text.split('\n')) {
    const line = raw.length < LONGEST_LINE ? raw.trim() : 'x'
    if (line === '') continue
    const named = NAME.exec(line)
    const factor = FACTOR.exec(line)
    if (named) {
      end()
      name = named[1] as string
      isMarked = true
    } else if (factor) {
      power = Number(factor[1])
      isMarked = true
      name ??= 'ans'
    } else if (COLUMNS.test(line)) {
      isMarked = true
      name ??= 'ans'
      if (blocks.at(-1)?.length !== 0) blocks.push([])
    } else {
      const row = rowOf(line, power)
      if (row === null) {
        end()
        name = null
      } else {
        blocks.at(-1)?.push(row.values)
        digits = Math.max(digits, row.digits)
        integers &&= row.areIntegers
      }
    }
  }
  end()
  return isMarked ? tables : []
}

interface Row {
  readonly values: number[]
  readonly digits: number
  readonly areIntegers: boolean
}

/** The numbers of a row times 10^power, moved in the decimal text so that nothing is rounded twice; null for other text. */
function rowOf(line: string, power: number): Row | null {
  const tokens = new Tokens(line)
  const values: number[] = []
  let digits = 0
  let areIntegers = true
  for (let kind = tokens.next(); kind !== 'end'; kind = tokens.next()) {
    if (kind === 'mark' && tokens.word === ',') continue
    if (kind !== 'number') return null
    values.push(power === 0 ? tokens.value : scaled(tokens.word, power))
    digits = Math.max(digits, tokens.digits)
    areIntegers &&= tokens.isInteger
  }
  return { values, digits, areIntegers }
}

function scaled(word: string, power: number): number {
  const [mantissa = '', own = '0'] = word.split(/[eEdD]/)
  return numberOf(`${mantissa}e${Number(own) + power}`) ?? Number.NaN
}
