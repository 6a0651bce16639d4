/** One entry of Nastran bulk data, put together from its lines: small, large or free fields, in any mixture. */
import type { PrintedDigits } from '../precision'
import type { TextLines } from './text-lines'

const [STAR, PLUS, DOT, ZERO, NINE] = [42, 43, 46, 48, 57] as const
/** Fields of a CHEXA of 20 nodes; others have fewer. */
const MOST_FIELDS = 64

/** The first field of the coordinates of a GRID. */
export const GRID_X = 2

export interface LineLayout {
  /** True if fields stand between commas, not in columns. */
  readonly isFree: boolean
  /** Values on a line: 8, or 4 wide ones. */
  readonly values: number
}

export class Card {
  readonly values = new Float64Array(MOST_FIELDS)
  /** 1 for a field that is not blank. */
  readonly isGiven = new Uint8Array(MOST_FIELDS)
  /** The first bytes in the file of the coordinates of a GRID, and their lengths. */
  readonly placeFrom = new Float64Array(3)
  readonly placeLength = new Uint16Array(3)
  count = 0
  line = 0
  /** The mnemonic of the next line that belongs here; '' if any that follows does. */
  mnemonic = ''
  isFree = false
  /** Values before those of the last line, and how many a line like it has. */
  #before = 0
  #width = 8

  constructor(public name: string) {}

  reset(name: string, line: number): void {
    this.name = name
    this.line = line
    this.count = 0
    this.mnemonic = ''
    this.isGiven.fill(0)
    this.values.fill(0)
  }

  beginLine({ isFree, values }: LineLayout): void {
    this.#before = this.count
    this.#width = values
    this.isFree = isFree
  }

  /** Makes the fields that the last line leaves out blank, as another line follows. */
  fillUp(): void {
    this.count = Math.max(this.count, Math.min(MOST_FIELDS, this.#before + this.#width))
  }

  id(field: number, what: string, lines: TextLines): number {
    const value = this.values[field] as number
    if (this.isGiven[field] !== 1) lines.refuse(`${this.name}: ${what} is missing.`, this.line)
    if (!Number.isSafeInteger(value) || value < 0) {
      const written = Number.isFinite(value) ? `${value}` : 'what stands there'
      lines.refuse(`${this.name}: ${written} is not ${what}.`, this.line)
    }
    return value
  }

  /** Adds what `other`, a line of its own, has. */
  append(other: Card): void {
    for (let i = 0; i < other.count && this.count < MOST_FIELDS; ++i, ++this.count) {
      this.values[this.count] = other.values[i] as number
      this.isGiven[this.count] = other.isGiven[i] as number
    }
    this.mnemonic = other.mnemonic
  }
}

/** The bytes at which columns begin, in a line with tabs: stops at each eighth column. */
const byteOfColumn = new Int32Array(81)

function mapColumns(lines: TextLines): void {
  let column = 0
  let at = lines.from
  for (; at < lines.to && column <= 80; ++at) {
    const next = lines.bytes[at] === 9 ? 8 * (Math.floor(column / 8) + 1) : column + 1
    byteOfColumn[column] = at
    for (let c = column + 1; c < next && c <= 80; ++c) byteOfColumn[c] = at + 1
    column = next
  }
  for (; column <= 80; ++column) byteOfColumn[column] = at
}

const NARROW: LineLayout = { isFree: false, values: 8 }
const WIDE: LineLayout = { isFree: false, values: 4 }
const FREE: LineLayout = { isFree: true, values: 8 }
const WIDE_FREE: LineLayout = { isFree: true, values: 4 }

/** Fields of the line: the name or mnemonic, the values (8 or 4), the mnemonic of the next line, which is the last. Returns how many values. */
export function splitCard(lines: TextLines): LineLayout {
  if (lines.hasComma) {
    lines.splitAtCommas()
    return hasStar(lines) ? WIDE_FREE : FREE
  }
  lines.startFields()
  if (lines.hasTab) mapColumns(lines)
  addColumns(lines, 0, 8)
  const isLarge = hasStar(lines)
  const width = isLarge ? 16 : 8
  for (let column = 8; column < 72; column += width) addColumns(lines, column, column + width)
  addColumns(lines, 72, 80)
  return isLarge ? WIDE : NARROW
}

function addColumns(lines: TextLines, from: number, to: number): void {
  if (lines.hasTab) lines.addField(byteOfColumn[from] as number, byteOfColumn[to] as number)
  else lines.addField(lines.from + from, lines.from + to)
}

function hasStar(lines: TextLines): boolean {
  for (let at = lines.fieldFrom(0); at < lines.fieldTo(0); ++at) if (lines.bytes[at] === STAR) return true
  return false
}

/** The mnemonic without the sign that begins it: +EL1 and *EL1 are EL1. */
export function plainMnemonic(lines: TextLines, field: number): string {
  let from = lines.fieldFrom(field)
  const to = lines.fieldTo(field)
  if (from < to && (lines.bytes[from] === PLUS || lines.bytes[from] === STAR)) from++
  while (from < to && (lines.bytes[from] as number) <= 32) from++
  return from === to ? '' : shortText(lines, from, to)
}

/** Capitals of a short word in ASCII. */
export function shortText(lines: TextLines, from: number, to: number): string {
  let text = ''
  for (let at = from; at < to; ++at) text += String.fromCharCode(lines.bytes[at] as number)
  return text.toUpperCase()
}

/** Adds the values of the line that has been split to the card, which needs `wanted` of them; `precision` for a GRID. */
export function addFields(
  card: Card,
  lines: TextLines,
  layout: LineLayout,
  wanted: number,
  precision: PrintedDigits | null,
): void {
  const { isFree, values } = layout
  card.beginLine(layout)
  const { last, mnemonic } = isFree ? freeEnd(lines, values) : { last: values, mnemonic: values + 1 }
  for (let field = 1; field <= last; ++field, ++card.count) {
    const at = card.count
    if (at >= wanted) continue
    if (lines.isFieldBlank(field)) continue
    const isCoordinate = precision !== null && at >= GRID_X && at < GRID_X + 3
    card.values[at] = lines.real(field, isCoordinate ? precision : null)
    card.isGiven[at] = 1
    if (isCoordinate) {
      card.placeFrom[at - GRID_X] = lines.placeOf(lines.fieldFrom(field))
      card.placeLength[at - GRID_X] = lines.fieldTo(field) - lines.fieldFrom(field)
    }
  }
  card.mnemonic = plainMnemonic(lines, mnemonic)
}

/**
 * The last value of a free line and the field of its mnemonic. This is the tenth field, or the sixth of wide ones, or what ends a
 * shorter line and is no number; a longer line has values alone.
 */
function freeEnd(lines: TextLines, values: number): { last: number; mnemonic: number } {
  const count = lines.fieldCount
  const final = count - 1
  if (final === values + 1 || (final > 0 && isMnemonic(lines, final))) return { last: final - 1, mnemonic: final }
  return { last: final, mnemonic: count }
}

/** True if the field is a sign, alone or before something other than a number. */
function isMnemonic(lines: TextLines, field: number): boolean {
  const from = lines.fieldFrom(field)
  if (from >= lines.fieldTo(field)) return false
  const first = lines.bytes[from] as number
  if (first === STAR) return true
  if (first !== PLUS) return false
  if (from + 1 === lines.fieldTo(field)) return true
  const second = lines.bytes[from + 1] as number
  return second !== DOT && (second < ZERO || second > NINE)
}
