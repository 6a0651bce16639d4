/** Abaqus: nodes and elements C3D8 as text that gives the same doubles, and sets of the invalid and of the unanswered elements. */
import type { Standing } from '../../mesh/mesh-check'
import type { MeshWriter } from './mesh-form'
import { cellIn, type MeshPart } from './mesh-part'
import { numbering } from './numbering'

/** Abaqus has no larger numbers of elements. */
const MOST_NUMBER = 999_999_999
/** Abaqus reads so many characters of a coordinate. */
const MOST_CHARACTERS = 20
const ENTRIES_A_LINE = 16
/** Lines of a piece. */
const LINES = 4096

const SETS: readonly (readonly [name: string, standing: Standing])[] = [
  ['HEXLENS_INVALID', 'invalid'],
  ['HEXLENS_UNANSWERED', 'unanswered'],
]

export const abaqus: MeshWriter = {
  chunks,
  count: ({ points, cells }) => Math.ceil((points + cells) / LINES) + 4,
}

function* chunks(part: MeshPart, say: (sentence: string) => void): Generator<string> {
  const { points, cells } = part
  const [pointCount, cellCount] = [points.length / 3, cells.length / 8]
  const said: string[] = []
  const numberOf = numbering(part, MOST_NUMBER, sentence => said.push(sentence))
  let areAllFinite = true
  let isAnyLong = false
  const coordinate = (value: number) => {
    areAllFinite &&= Number.isFinite(value)
    const text = Object.is(value, -0) ? '-0' : String(value)
    isAnyLong ||= text.length > MOST_CHARACTERS
    return text
  }
  yield '** Hexahedra, decided by Hexlens\n*NODE\n'
  yield* lines(pointCount, i => {
    const [x, y, z] = [0, 1, 2].map(axis => coordinate(points[3 * i + axis] as number))
    return `${i + 1}, ${x}, ${y}, ${z}\n`
  })
  yield '*ELEMENT, TYPE=C3D8\n'
  yield* lines(cellCount, cell => {
    let line = String(numberOf(cell))
    for (let v = 8 * cell; v < 8 * cell + 8; ++v) line += `, ${(cells[v] as number) + 1}`
    return `${line}\n`
  })
  for (const [name, standing] of SETS) yield* set(name, numbersOf(part, standing, numberOf))
  if (!areAllFinite) said.push('Coordinates that are not finite are NaN or Infinity, which Abaqus has not.')
  if (isAnyLong)
    said.push(
      `Some coordinates have more than ${MOST_CHARACTERS} characters, of which Abaqus and CalculiX read no more: others get the same doubles.`,
    )
  for (const sentence of said) {
    say(sentence)
    yield `** ${sentence}\n`
  }
}

function* lines(count: number, line: (i: number) => string): Generator<string> {
  for (let from = 0; from < count; from += LINES) {
    let text = ''
    for (let i = from; i < Math.min(from + LINES, count); ++i) text += line(i)
    yield text
  }
}

function numbersOf(part: MeshPart, standing: Standing, numberOf: (cell: number) => number): number[] {
  const numbers: number[] = []
  for (let cell = 0; cell < part.cells.length / 8; ++cell)
    if (part.check.standingOf(cellIn(part, cell)) === standing) numbers.push(numberOf(cell))
  return numbers
}

function* set(name: string, numbers: readonly number[]): Generator<string> {
  if (numbers.length === 0) return
  yield `*ELSET, ELSET=${name}\n`
  const rows = Math.ceil(numbers.length / ENTRIES_A_LINE)
  yield* lines(rows, row => `${numbers.slice(row * ENTRIES_A_LINE, (row + 1) * ENTRIES_A_LINE).join(', ')}\n`)
}
