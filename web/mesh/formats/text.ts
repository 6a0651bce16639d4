/**
 * Texts as people post them: code, tables, logs, numbers. What no other format claims comes here. Each reader says what it finds, or that
 * it is nothing of its kind; the first that finds elements answers.
 */
import { type Mesh, MeshRefusal } from '../mesh'
import { isText, LARGEST_STRING, snippetText } from '../snippet-text'
import { tablesOfAssignments, tablesOfSetIds, tablesOfVectors } from '../snippets/assigned'
import { meshOfTables } from '../snippets/interpret'
import { meshOfJson } from '../snippets/json'
import { tablesOfLines, withDecimalPoints, withoutThousands } from '../snippets/lines'
import { tablesOfLists } from '../snippets/lists'
import { withoutTags } from '../snippets/markup'
import { tablesOfMatlab } from '../snippets/matlab-print'
import { withPlainNumbers } from '../snippets/number-forms'
import { numberTable } from '../snippets/number-table'
import { meshOfNumbers } from '../snippets/plain-numbers'
import { Tokens } from '../snippets/tokens'
import type { MeshFile, MeshFormat, ReadOptions } from '../source'
import { shown } from '../text-cursor'

/** A point whose x, y and z stand on a line each: YAML, and structures as debuggers and languages print them. */
const POINT_ON_LINES =
  /(?<![\w.])(["']?x["']?\s?[:=]\s?[-+\d.e]{1,40},?)\s{1,80}(["']?y["']?\s?[:=]\s?[-+\d.e]{1,40},?)\s{1,80}(["']?z["']?\s?[:=])/gi

/** A list with a sign before it, or one times a factor or by it. */
const OPERATION =
  /=\s{0,9}-\s{0,9}\[|[)\]}]\s{0,9}(?:\.?\*\s{0,9}(?:[[({]|\d[\d.e+-]{0,30})|\.?\/\s{0,9}\d[\d.e+-]{0,30})|(?<![\w.\])])\d[\d.e+-]{0,30}\s{0,9}\*\s{0,9}(?:\w{0,9}\.?array\(\s{0,9})?[[{]/i

export const text: MeshFormat = {
  name: 'text',
  recognizes: head => (isText(head) ? 'maybe' : 'no'),
  read(file, options) {
    if (file.size > LARGEST_STRING) return [meshOfNumbers(file, options)]
    const whole = snippetText(file)
    if (whole === null) throw new MeshRefusal(`${file.name}: this is binary, and in no format that is known here.`)
    const plain = withPlainNumbers(withoutTags(whole)).replace(POINT_ON_LINES, '$1 $2 $3')
    const mesh = meshOfText(plain, file, options)
    const operation = OPERATION.exec(whole)?.[0]
    if (operation === undefined) return [mesh]
    const note = `The text calculates with its numbers at ${shown(operation.trim())}: this was not done here.`
    return [{ ...mesh, notes: [...mesh.notes, note] }]
  },
}

function meshOfText(whole: string, file: MeshFile, { throwIfCancelled }: ReadOptions): Mesh {
  const fileName = file.name
  const json = meshOfJson(whole, fileName)
  if (json !== null) return json
  throwIfCancelled()
  const hasOwnOrder = /\bskfem\b|\bmesh\.t\b|\bMeshHex\b|\bdolfinx\b|\bcreate_mesh\(|\bCellData<|\bdealii\b/.test(whole)
  const isScikitFem = /\bskfem\b|\bmesh\.t\b|\bMeshHex/.test(whole)
  const decimal = withDecimalPoints(whole)
  const text = decimal ?? withoutThousands(whole) ?? whole
  let refusal: MeshRefusal | null = null
  const orRefused = (reading: () => Mesh | null): Mesh | null => {
    try {
      return reading()
    } catch (error) {
      if (!(error instanceof MeshRefusal)) throw error
      refusal ??= error
      return null
    }
  }
  const lists = orRefused(() =>
    meshOfTables(
      [...tablesOfAssignments(text), ...tablesOfVectors(text), ...tablesOfLists(text), ...tablesOfSetIds(text)],
      {
        format: languageOf(text),
        fileName,
        hasOwnOrder,
        isScikitFem,
      },
    ),
  )
  if (lists?.isOrderStated || (lists !== null && hasOwnOrder)) return lists
  throwIfCancelled()
  const matlab = lists ?? meshOfTables(tablesOfMatlab(text), { format: 'MATLAB', fileName })
  if (matlab?.isOrderStated) return matlab
  throwIfCancelled()
  const { tables: found, mixed, numbers, points } = tablesOfLines(text)
  const tables = [...found, ...tablesOfSetIds(text)]
  // A text whose lines have cells of their own is read by these, and refused if they are not understood.
  if (matlab !== null && refusal === null && !tables.some(hasWideIntegers)) return matlab
  if (mixed !== null && refusal === null) throw new MeshRefusal(`${fileName}: ${mixed}`)
  const lines = orRefused(() => meshOfTables(tables, { format: 'points in text', fileName }))
  if (refusal !== null && !lines?.isOrderStated) throw refusal
  if (matlab !== null) return lines?.isOrderStated ? lines : matlab
  const mesh = lines ?? flatNumbers(text, fileName)
  if (mesh === null) throw new MeshRefusal(`${fileName}: ${nothingIn(text, numbers, points)}`)
  return decimal === null ? mesh : { ...mesh, notes: [...mesh.notes, 'Commas were taken for decimal points.'] }
}

function hasWideIntegers({
  rows,
  integers,
}: {
  rows: readonly (readonly number[])[]
  integers: readonly boolean[]
}): boolean {
  return (
    integers.length >= 8 &&
    integers.every(isInteger => isInteger) &&
    rows.every(row => new Set(row.slice(-8)).size === 8)
  )
}

/** The name of the language of a text with lists. */
function languageOf(text: string): string {
  const head = text.slice(0, 100_000)
  if (head.includes('array(') || /\bimport numpy\b/.test(head)) return 'NumPy'
  if (/\b(?:double|float|Eigen|std::)/.test(head)) return 'C'
  if (/\b(?:const|let|var) \w/.test(head)) return 'JavaScript'
  if (/Vector\{|Matrix\{|\bNode\(\(/.test(head)) return 'Julia'
  if (/\bimport (?:meshio|pyvista)\b|>>>/.test(head)) return 'Python'
  return /\[[^[\]]{0,1000};/.test(head.slice(0, 5000)) ? 'MATLAB' : 'lists of numbers'
}

const SEPARATORS = ',;:|/=()[]{}<>\'"&-'
const MOST_NUMBERS = 24 * 100_000

/** Nothing but numbers, in lines of the same length but for the last; null for other texts. */
function flatNumbers(text: string, fileName: string): Mesh | null {
  const tokens = new Tokens(text)
  const values: number[] = []
  const widths: number[] = []
  let onLine = 0
  let digits = 0
  for (let kind = tokens.next(); ; kind = tokens.next()) {
    if (kind === 'number') {
      values.push(tokens.value)
      digits = Math.max(digits, tokens.digits)
      onLine++
      if (values.length > MOST_NUMBERS) return null
    } else if (kind === 'line' || kind === 'end') {
      if (onLine > 0) widths.push(onLine)
      onLine = 0
      if (kind === 'end') break
    } else if (kind === 'word' && values.length === 0 && onLine === 0 && isHeading(text, tokens.from)) {
      tokens.to = text.indexOf('\n', tokens.to)
    } else if (kind === 'word' || !SEPARATORS.includes(tokens.word)) return null
  }
  const [width = 0] = widths
  const odd = widths.findIndex((own, i) => own !== width && (i < widths.length - 1 || own > width))
  if (odd >= 0 && widths.length > 3 && values.length >= 24)
    throw new MeshRefusal(
      `${fileName}: row ${odd + 1} of the numbers has ${widths[odd]} of them, the first has ${width}.`,
    )
  if (values.length === 0 || values.length % 24 !== 0) return null
  return meshOfTables([numberTable([values], false, { digits })], { format: 'numbers', fileName })
}

/** A line before all numbers that has words and no digit. */
function isHeading(text: string, from: number): boolean {
  return /^[^\n\d]{1,80}\n/.test(text.slice(from, from + 100))
}

function nothingIn(text: string, numbers: number, points: number): string {
  if (text.trim() === '') return 'there is no text in it.'
  const need = numbers < 24 ? 'an element needs 24' : 'but no eight points of three numbers that belong together'
  const seen = `${numbers} ${numbers === 1 ? 'number was' : 'numbers were'} found${numbers < 24 ? ';' : ','} ${need}.`
  return points > 0 && 3 * points !== numbers
    ? `${seen} ${points} ${points === 1 ? 'point' : 'points'} of three coordinates ${points === 1 ? 'is' : 'are'} among them; an element has 8.`
    : seen
}
