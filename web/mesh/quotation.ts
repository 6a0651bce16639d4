/** Texts as mails and issues hold them: lines that are quoted with ">", and code between fences. */
import { LARGEST_SNIPPET, LARGEST_STRING, utf16Of } from './snippet-text'
import { fileOfBytes, type MeshFile } from './source'

const [TAB, LF, CR, SPACE, ZERO, NINE, LESS, GREATER, BACKTICK, TILDE] = [
  9, 10, 13, 32, 48, 57, 60, 62, 96, 126,
] as const
/** A fence and what follows it, such as "```text", is no longer; a longer line has code behind its fence. */
const LONGEST_FENCE = 40
/** A row of so many marks is a ruler in a log. */
const RULER = 6
const FEWEST_QUOTED = 3
const [ESCAPE, BRACKET] = [27, 91] as const

/** A line is the bytes [from, to). */
interface Line {
  readonly from: number
  readonly to: number
}

/**
 * The text without what mail and Markdown put around it. Marks of quotation, fences, the words outside of them, terminals' colours, no-break
 * spaces and a byte order mark become blanks, so that lines and bytes keep their places; UTF-16 becomes UTF-8, and a CR alone the end of a line. The file itself where there is nothing of that, or
 * where it is binary or large.
 */
export function withoutQuotation(file: MeshFile): MeshFile {
  if (file.size > LARGEST_STRING) return file
  const original = file.read(0, file.size)
  const encoding = utf16Of(original)
  const bytes = encoding === null ? original : new TextEncoder().encode(new TextDecoder(encoding).decode(original))
  if (bytes.includes(0)) return file
  const isOfOldMac = bytes.includes(CR) && !bytes.includes(LF)
  if (isOfOldMac) for (let at = bytes.indexOf(CR); at >= 0; at = bytes.indexOf(CR, at)) bytes[at] = LF
  const isUncoloured = blankColours(bytes)
  const isUnquoted = blankQuotation(bytes)
  const isUnfenced = blankFences(bytes)
  const isPlain = blankOddSpaces(bytes)
  const isSame = !(isOfOldMac || isUncoloured || isUnquoted || isUnfenced || isPlain) && encoding === null
  return isSame ? file : fileOfBytes(file.name, bytes)
}

/**
 * Marks of quotation, and, where most lines are quoted, the lines that are not, which are somebody's words around them. No quotation are
 * Python's ">>>", and ends of tags at the beginning of a few lines.
 */
function blankQuotation(bytes: Uint8Array): boolean {
  if (!bytes.includes(GREATER)) return false
  let full = 0
  let quoted = 0
  let hasTags = false
  for (const { from, to } of linesOf(bytes)) {
    const begin = skipBlanks(bytes, from, to)
    if (begin < to) full++
    if (bytes[begin] === LESS) hasTags = true
    if (quoteEnd(bytes, from, to) > from) quoted++
  }
  const areOthersWords = 2 * quoted >= full
  if (quoted < FEWEST_QUOTED || (hasTags && !areOthersWords)) return false
  for (const { from, to } of linesOf(bytes)) {
    const end = quoteEnd(bytes, from, to)
    if (end > from) bytes.fill(SPACE, from, end)
    else if (areOthersWords) bytes.fill(SPACE, from, to)
  }
  return true
}

/** The end of the marks of quotation with which a line begins; `from` if there are none. */
function quoteEnd(bytes: Uint8Array, from: number, to: number): number {
  let end = from
  for (let at = skipBlanks(bytes, from, to); at < to && bytes[at] === GREATER; at = skipBlanks(bytes, at, to)) {
    if (bytes[at + 1] === GREATER && bytes[at + 2] === GREATER) break
    end = ++at
  }
  return end
}

const MOST_BLOCKS = 16

export interface FencedBlock {
  /** The whole text with all blank but the block, so that lines and bytes keep their places. */
  readonly file: MeshFile
  readonly text: Uint8Array
}

/** The contents of several fences; none if there is but one. */
export function fencedBlocks(file: MeshFile): FencedBlock[] {
  if (file.size > LARGEST_SNIPPET) return []
  const bytes = file.read(0, file.size)
  if (utf16Of(bytes) !== null || bytes.includes(0)) return []
  blankColours(bytes)
  blankQuotation(bytes)
  const fences = fencesOf(bytes)
  const blocks: FencedBlock[] = []
  for (let i = 0; i < fences.length && blocks.length < MOST_BLOCKS; i += 2) {
    const [from, to] = [(fences[i] as Line).to, fences[i + 1]?.from ?? bytes.length]
    if (!hasDigit(bytes, from, to)) continue
    const own = bytes.slice()
    blank(own, 0, from)
    blank(own, to, own.length)
    blocks.push({ file: fileOfBytes(file.name, own), text: bytes.subarray(from, to) })
  }
  return blocks.length > 1 ? blocks : []
}

function fencesOf(bytes: Uint8Array): Line[] {
  if (!bytes.includes(BACKTICK) && !bytes.includes(TILDE)) return []
  const fences: Line[] = []
  for (const { from, to } of linesOf(bytes)) {
    const at = skipBlanks(bytes, from, to)
    const mark = bytes[at]
    if (mark !== BACKTICK && mark !== TILDE) continue
    let end = at
    while (bytes[end] === mark) end++
    if (end - at < 3 || end - at >= RULER) continue
    fences.push({ from, to: to - at <= LONGEST_FENCE ? to : at + 3 })
  }
  return fences
}

/** Fences, and what stands outside of them if there are numbers inside. A fence that does not end goes to the end. */
function blankFences(bytes: Uint8Array): boolean {
  const fences = fencesOf(bytes)
  if (fences.length === 0) return false
  // One fence alone may end a block whose beginning was not copied.
  const isBegun = fences.length > 1 || !hasDigit(bytes, 0, (fences[0] as Line).from)
  const ends = [...fences.map(({ from }) => from), bytes.length]
  const starts = [0, ...fences.map(({ to }) => to)]
  const isInside = (part: number) => part % 2 === 1
  if (isBegun && starts.some((from, part) => isInside(part) && hasDigit(bytes, from, ends[part] as number)))
    for (const [part, from] of starts.entries()) if (!isInside(part)) blank(bytes, from, ends[part] as number)
  for (const { from, to } of fences) bytes.fill(SPACE, from, to)
  return true
}

/** Blanks colours of terminals, an escape, bracket, numbers and letter, if one ends another. */
function blankColours(bytes: Uint8Array): boolean {
  const found: Line[] = []
  let hasEnds = false
  for (let at = bytes.indexOf(ESCAPE); at >= 0; at = bytes.indexOf(ESCAPE, at + 1)) {
    if (bytes[at + 1] !== BRACKET) continue
    let end = at + 2
    // Digits, colons and semicolons.
    while (end < at + LONGEST_FENCE && (bytes[end] as number) >> 4 === 3) end++
    hasEnds ||= end === at + 2 || (bytes[at + 2] === ZERO && end === at + 3)
    found.push({ from: at, to: Math.min(end + 1, bytes.length) })
  }
  if (!hasEnds) return false
  for (const { from, to } of found) bytes.fill(SPACE, from, to)
  return true
}

function blankOddSpaces(bytes: Uint8Array): boolean {
  let hasAny = bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf
  if (hasAny) bytes.fill(SPACE, 0, 3)
  for (let at = bytes.indexOf(0xc2); at >= 0; at = bytes.indexOf(0xc2, at + 1)) {
    if (bytes[at + 1] !== 0xa0) continue
    bytes.fill(SPACE, at, at + 2)
    hasAny = true
  }
  return hasAny
}

/** All lines, without their ends. */
function* linesOf(bytes: Uint8Array): Generator<Line> {
  for (let from = 0; from < bytes.length; ) {
    const found = bytes.indexOf(LF, from)
    const end = found < 0 ? bytes.length : found
    yield { from, to: end > from && bytes[end - 1] === CR ? end - 1 : end }
    from = end + 1
  }
}

/** All but the ends of lines. */
function blank(bytes: Uint8Array, from: number, to: number): void {
  for (let at = from; at < to; ++at) if (bytes[at] !== LF && bytes[at] !== CR) bytes[at] = SPACE
}

function hasDigit(bytes: Uint8Array, from: number, to: number): boolean {
  for (let at = from; at < to; ++at) if ((bytes[at] as number) >= ZERO && (bytes[at] as number) <= NINE) return true
  return false
}

/** Blanks within a line. */
function skipBlanks(bytes: Uint8Array, from: number, end: number): number {
  let at = from
  while (at < end && (bytes[at] === SPACE || bytes[at] === TAB)) at++
  return at
}
