/** Numbers that are rounded into the fields of fixed columns in which they stand, for those who say by how much and read them again. */
import type { FitNumber, Fitted, Line } from './moved-file'

/** From where to where a number may be in its line, and how long it may be. */
interface Field {
  readonly from: number
  readonly to: number
  readonly width: number
}

/** Narrower ones are left: a number there was written with few digits for another reason. */
const NARROWEST = 8

/** Columns of numbers behind columns of an id; in each format those that it may have. */
interface Layout {
  readonly before: number
  readonly width: number
}
const UNV: readonly Layout[] = [{ before: 0, width: 25 }]
const RADIOSS: readonly Layout[] = [{ before: 10, width: 20 }]
const LS_DYNA: readonly Layout[] = [
  { before: 8, width: 16 },
  { before: 10, width: 16 },
  { before: 20, width: 20 },
]

const fieldIn: Readonly<Record<string, (line: Line) => Field | null>> = {
  Nastran: nastranField,
  Ansys: rightField,
  'LS-DYNA': line => (line.text.includes(',') ? betweenCommas(line, 16) : fieldInAll(line, LS_DYNA)),
  UNV: line => fieldInAll(line, UNV),
  Radioss: line => fieldInAll(line, RADIOSS),
}

/** Fits numbers into the fields of files of this format; `onRounded` is told by how much each is off. */
export function fittingOf(format: string, onRounded: (off: number) => void): FitNumber | null {
  const find = fieldIn[format]
  if (!find) return null
  return (line, value): Fitted | null => {
    const field = find(line)
    if (!field || field.width < NARROWEST) return null
    const text = roundedText(value, field.width, format === 'Nastran')
    if (text === null) return null
    onRounded(Math.abs(numberOf(text) - value))
    return { from: field.from, to: field.to, text: text.padStart(field.to - field.from) }
  }
}

/** Fields of eight columns, or of sixteen in lines with a star; numbers between commas are as long as these. */
function nastranField(line: Line): Field | null {
  const { text, from, to } = line
  const width = text.slice(0, 8).includes('*') ? 16 : 8
  if (text.includes(',')) return betweenCommas(line, width)
  if (text.includes('\t') || from < 8) return null
  const first = from - ((from - 8) % width)
  // The line may end before its last field does.
  return to <= first + width ? { from: first, to: Math.min(first + width, text.length), width } : null
}

function betweenCommas({ from, to }: Line, width: number): Field {
  return { from, to, width: Math.max(to - from, width) }
}

/** What all layouts leave in which the number is all that a field has; a blank stays before it. */
function fieldInAll({ text, from, to }: Line, layouts: readonly Layout[]): Field | null {
  const own = text.slice(from, to)
  const fields = layouts.flatMap(({ before, width }) => {
    const first = from - ((from - before) % width)
    const isAlone = from >= before && text.slice(first, first + width).trim() === own
    return isAlone && !/\s/.test(text.slice(0, before).trim()) ? [[first, first + width] as const] : []
  })
  if (fields.length === 0 || text.includes('\t')) return null
  return behindBlank(
    { text, from },
    Math.max(...fields.map(([first]) => first)),
    Math.min(...fields.map(([, end]) => end)),
  )
}

/** Fortran writes numbers at the right ends of their fields, so that all from the end of the one before is the field. */
function rightField({ text, from, to }: Line): Field | null {
  return behindBlank({ text, from }, text.slice(0, from).trimEnd().length, to)
}

/** The field without the blank that parts it from what is before, if there is one. */
function behindBlank(own: Pick<Line, 'text' | 'from'>, first: number, end: number): Field {
  const isBehindWord = first > 0 && first < own.from && /\S/.test(own.text[first - 1] as string)
  const from = isBehindWord ? first + 1 : first
  // The line may end before its last field does.
  return { from, to: Math.min(end, own.text.length), width: end - from }
}

/** The text of at most so many characters that is nearest to the value, the shortest of several; null if there is none. */
function roundedText(value: number, width: number, hasBareExponents: boolean): string | null {
  let best: { readonly text: string; readonly off: number } | null = null
  for (const text of spellings(value, hasBareExponents)) {
    if (text.length > width) continue
    const off = Math.abs(numberOf(text) - value)
    if (!best || off < best.off || (off === best.off && text.length < best.text.length)) best = { text, off }
  }
  return best?.text ?? null
}

/** With a point, which numbers in columns need, and without zeros at the ends that say nothing. */
function* spellings(value: number, hasBareExponents: boolean): Generator<string> {
  for (let digits = 17; digits > 0; --digits) {
    const [mantissa = '', exponent = ''] = value.toExponential(digits - 1).split('e')
    const power = hasBareExponents ? exponent : `E${exponent}`
    yield `${withPoint(mantissa)}${power}`
    const places = digits - 1 - Number(exponent)
    if (places >= 0 && places <= 100) yield withPoint(value.toFixed(places))
  }
}

function withPoint(text: string): string {
  const pointed = text.includes('.') ? text.replace(/0+$/, '') : `${text}.`
  return pointed.replace(/^(-?)0(\.\d)/, '$1$2')
}

function numberOf(text: string): number {
  return Number(text.replace(/^(-?[\d.]+)([-+]\d+)$/, '$1e$2'))
}
