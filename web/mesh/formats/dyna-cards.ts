/** Data lines of LS-DYNA: fields in columns of each width or between commas, and lines that belong to the one before. */
import type { TextLines } from './text-lines'

const [SPACE, DOLLAR, STAR] = [32, 36, 42] as const

/** Columns of an integer and of a coordinate. */
export interface Widths {
  readonly integer: number
  readonly real: number
}
export const STANDARD: Widths = { integer: 8, real: 16 }
export const TEN: Widths = { integer: 10, real: 16 }
export const LONG: Widths = { integer: 20, real: 20 }

/** "*NODE +" is wide, "*NODE %" has integers of ten columns, "*NODE -" is as usual for the code. */
export function widthsOf(text: string, name: string, usual: Widths): Widths {
  const sign = text.slice(name.length).trim()[0]
  if (sign === '+') return LONG
  if (sign === '%') return TEN
  return sign === '-' ? STANDARD : usual
}

/** Splits the line at commas, or in columns, or, if a word crosses these, at blanks. */
export function splitCard(lines: TextLines, widths: Widths, integers: number, reals = 0): void {
  lines.scan()
  if (lines.hasComma) {
    lines.splitAtCommas()
    return
  }
  // As many words as fields are these, though a program writes them beside their columns.
  lines.splitAtBlanks()
  if (lines.fieldCount === integers + reals) return
  if (lines.hasTab || !areColumns(lines, widths, integers, reals)) lines.splitAtBlanks()
}

function areColumns(lines: TextLines, { integer, real }: Widths, integers: number, reals: number): boolean {
  lines.startFields()
  let at = lines.from
  for (let i = 0; i < integers + reals && at < lines.to; ++i) {
    const next = at + (i < integers ? integer : real)
    lines.addField(at, next)
    if (hasBlankInside(lines, i)) return false
    at = next
  }
  return true
}

function hasBlankInside(lines: TextLines, field: number): boolean {
  const to = lines.fieldTo(field)
  for (let at = lines.fieldFrom(field); at < to; ++at) if ((lines.bytes[at] as number) <= SPACE) return true
  return false
}

/** The next line that belongs to the element; refuses with `fault` if there is none. */
export function nextCard(lines: TextLines, fault: string): void {
  const line = lines.number
  while (lines.next()) {
    if (lines.at(0) === DOLLAR || lines.isBlank) continue
    if (lines.at(0) === STAR) break
    return
  }
  lines.refuse(fault, line)
}

export function skipCards(lines: TextLines, count: number, fault: string): void {
  for (let i = 0; i < count; ++i) nextCard(lines, fault)
}
