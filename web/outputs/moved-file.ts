/**
 * A mesh whose points have moved, in the file that it was read from: the coordinates that are others are replaced, every other byte stays.
 * A number in text becomes the shortest one that reads back as the same double; in single precision it is rounded.
 */
import type { CoordinatePlaces, Mesh } from '../mesh/mesh'
import type { MeshFile } from '../mesh/source'
import { Refusal } from '../model/result'

/** Bytes that are copied at once. */
const CHUNK = 1024 * 1024

/** Formats with fields of fixed columns: a number there may not be longer than the one that it replaces, and has a decimal point. */
const IN_COLUMNS: ReadonlySet<string> = new Set(['Nastran', 'Ansys', 'LS-DYNA', 'UNV', 'Radioss'])

/** A line of text, and where in it a number is. */
export interface Line {
  readonly text: string
  readonly from: number
  readonly to: number
}

/** What takes the place of these characters of a line. */
export interface Fitted {
  readonly from: number
  readonly to: number
  readonly text: string
}

/** Puts a number into its field of fixed columns; null where that is not possible. */
export type FitNumber = (line: Line, value: number) => Fitted | null

/** Why there is no such file; null if there is one. */
export function whyNotInPlace({ format, coordinatePlaces, points }: Mesh): string | null {
  if (coordinatePlaces === null || countOf(coordinatePlaces, points.length) !== points.length)
    return `In this file (${format}) the coordinates are packed, in several files, sums of several numbers, or not written one by one, so they cannot be replaced there.`
  return null
}

/** All coordinates as that file will have them: those that have moved are rounded where it has single precision. */
export function asStored({ points, coordinatePlaces }: Mesh, moved: Float64Array): Float64Array {
  const stored = moved.slice()
  if (isSingle(coordinatePlaces))
    for (let i = 0; i < stored.length; ++i)
      if (!Object.is(points[i], stored[i])) stored[i] = Math.fround(stored[i] as number)
  return stored
}

/**
 * The bytes of the file from which `mesh` was read, with all coordinates of `moved` that are not those of the mesh. Throws a Refusal where
 * `whyNotInPlace` has a reason, a number does not fit in, by `fitting` if that is given, or the file is another one by now.
 */
export function* movedFile(
  whole: MeshFile,
  mesh: Mesh,
  moved: Float64Array,
  fitting: FitNumber | null = null,
): Generator<Uint8Array<ArrayBuffer>> {
  const file = inChunks(whole)
  const { points, format, coordinatePlaces: places } = mesh
  const why = whyNotInPlace(mesh)
  if (why !== null || places === null) throw new Refusal(why ?? '')
  const write = places.kind === 'block' || places.kind === 'blocks' ? binaryWriter(places) : textWriter(format)
  let done = 0
  for (const { coordinate, from, length } of spansOf(file, places, changed(points, moved))) {
    const own = file.read(from, from + length)
    const [before, after] = [points[coordinate] as number, moved[coordinate] as number]
    const line = fitting && lineAround(file, from, length)
    const fitted = line && fitting(line, after)
    if (fitted) {
      refuseOther(latin1.decode(own), before)
      const lineFrom = from - line.from
      yield* copied(file, done, lineFrom + fitted.from)
      yield new TextEncoder().encode(fitted.text)
      done = lineFrom + fitted.to
    } else {
      yield* copied(file, done, from)
      yield write(own, before, after)
      done = from + length
    }
  }
  yield* copied(file, done, file.size)
}

/** Fields of fixed columns are in the first 80 bytes of a line, wide ones in some 200. */
const LONGEST_LINE = 512

/** Null for a line that is longer. */
function lineAround(file: MeshFile, from: number, length: number): Line | null {
  const first = Math.max(0, from - LONGEST_LINE)
  const text = latin1.decode(file.read(first, Math.min(file.size, from + length + LONGEST_LINE)))
  const begin = text.lastIndexOf('\n', from - first) + 1
  if (begin === 0 && first > 0) return null
  const own = { from: from - first - begin, to: from - first - begin + length }
  return { text: text.slice(begin).split(/[\r\n]/)[0] as string, ...own }
}

/** The same file, read in chunks: a call for each number would take long. */
function inChunks(file: MeshFile): MeshFile {
  let [start, chunk] = [0, new Uint8Array(0)]
  const read = (from: number, to: number) => {
    if (from < start || to > start + chunk.length) {
      start = from
      chunk = new Uint8Array(file.read(from, Math.min(file.size, Math.max(to, from + CHUNK))))
    }
    return chunk.slice(from - start, to - start)
  }
  return { name: file.name, size: file.size, read }
}

interface Span {
  readonly coordinate: number
  readonly from: number
  readonly length: number
}

type Writer = (own: Uint8Array, before: number, after: number) => Uint8Array<ArrayBuffer>

function changed(before: Float64Array, after: Float64Array): Uint32Array {
  const list: number[] = []
  for (let i = 0; i < before.length; ++i) if (!Object.is(before[i], after[i])) list.push(i)
  return Uint32Array.from(list)
}

function countOf(places: CoordinatePlaces, count: number): number {
  if (places.kind === 'tokens') return places.from.length
  return places.kind === 'blocks' ? 3 * places.blocks.reduce((sum, block) => sum + block.count, 0) : count
}

/** Where the coordinates of these indices are, in the order of the file. */
function spansOf(file: MeshFile, places: CoordinatePlaces, coordinates: Uint32Array): Iterable<Span> {
  switch (places.kind) {
    case 'run':
      return spansInRun(file, places, coordinates)
    case 'tokens':
      return inOrder(
        coordinates,
        i => places.from[i] as number,
        i => places.lengths[i] as number,
      )
    case 'block': {
      const size = sizeOf(places)
      return inOrder(
        coordinates,
        i => places.from + size * i,
        () => size,
      )
    }
    case 'blocks': {
      const size = sizeOf(places)
      const froms = fromsInBlocks(places, coordinates)
      return inOrder(
        coordinates,
        i => froms.get(i) as number,
        () => size,
      )
    }
  }
}

function* inOrder(
  coordinates: Uint32Array,
  fromOf: (coordinate: number) => number,
  lengthOf: (coordinate: number) => number,
): Generator<Span> {
  const sorted = coordinates.slice().sort((a, b) => fromOf(a) - fromOf(b))
  for (const coordinate of sorted) yield { coordinate, from: fromOf(coordinate), length: lengthOf(coordinate) }
}

function fromsInBlocks(
  { blocks }: Extract<CoordinatePlaces, { kind: 'blocks' }>,
  coordinates: Uint32Array,
): Map<number, number> {
  const froms = new Map<number, number>()
  let [block, first] = [0, 0]
  for (const coordinate of coordinates) {
    const point = Math.floor(coordinate / 3)
    for (; point >= first + (blocks[block]?.count ?? Infinity); ++block) first += blocks[block]?.count ?? 0
    const own = blocks[block]
    if (own) froms.set(coordinate, (own.from[coordinate % 3] as number) + (point - first) * own.stride)
  }
  return froms
}

const isBlank = (byte: number) => byte === 32 || (byte >= 9 && byte <= 13) || byte === 44

/** Words between blanks or commas, counted as they come. */
function* spansInRun(
  file: MeshFile,
  { from, to }: Extract<CoordinatePlaces, { kind: 'run' }>,
  coordinates: Uint32Array,
): Generator<Span> {
  let [next, word, begin] = [0, 0, -1]
  for (let start = from; start < to && next < coordinates.length; start += CHUNK) {
    const bytes = file.read(start, Math.min(to, start + CHUNK))
    for (let i = 0; i < bytes.length; ++i) {
      const at = start + i
      const isInWord = !isBlank(bytes[i] as number)
      if (isInWord && begin < 0) begin = at
      if (begin < 0 || (isInWord && at + 1 < to)) continue
      const end = isInWord ? to : at
      if (coordinates[next] === word)
        yield { coordinate: coordinates[next++] as number, from: begin, length: end - begin }
      word++
      begin = -1
    }
  }
  if (next < coordinates.length) throw new Refusal(OTHER_FILE)
}

const latin1 = new TextDecoder('latin1')

const OTHER_FILE = 'The file is another one than when it was read: open it again.'

function* copied(file: MeshFile, from: number, to: number): Generator<Uint8Array<ArrayBuffer>> {
  for (let at = from; at < to; at += CHUNK) yield new Uint8Array(file.read(at, Math.min(to, at + CHUNK)))
}

type Binary = Extract<CoordinatePlaces, { kind: 'block' | 'blocks' }>

function sizeOf({ type }: Binary): 4 | 8 {
  return type === 'float32' ? 4 : 8
}

function isSingle(places: CoordinatePlaces | null): boolean {
  return places !== null && 'type' in places && places.type === 'float32'
}

function binaryWriter(places: Binary): Writer {
  const { isLittleEndian } = places
  const isShort = sizeOf(places) === 4
  return (own, before, after) => {
    const view = new DataView(own.buffer, own.byteOffset, own.length)
    const present = isShort ? view.getFloat32(0, isLittleEndian) : view.getFloat64(0, isLittleEndian)
    if (present !== before) throw new Refusal(OTHER_FILE)
    if (isShort && !Number.isFinite(Math.fround(after)))
      throw new Refusal(`The file has single precision, in which there is no ${after}.`)
    const bytes = new Uint8Array(own.length)
    const into = new DataView(bytes.buffer)
    if (isShort) into.setFloat32(0, after, isLittleEndian)
    else into.setFloat64(0, after, isLittleEndian)
    return bytes
  }
}

function textWriter(format: string): Writer {
  const isInColumns = IN_COLUMNS.has(format)
  const encoder = new TextEncoder()
  return (own, before, after) => {
    const present = latin1.decode(own)
    refuseOther(present, before)
    const shortest = isInColumns ? withPoint(numberText(after)) : numberText(after)
    if (isInColumns && shortest.length > own.length)
      throw new Refusal(
        `${format} has fields of fixed columns, and ${shortest} is longer than ${present}, which stands there.`,
      )
    return encoder.encode(isInColumns ? shortest.padStart(own.length) : shortest)
  }
}

function refuseOther(present: string, before: number): void {
  if (doubleOf(present) !== before) throw new Refusal(OTHER_FILE)
}

/** JavaScript writes the shortest number that reads back the same, but for the sign of zero. */
function numberText(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value)
}

/** "5" is a whole number to programs with fixed columns. */
function withPoint(text: string): string {
  return text.includes('.') ? text : text.replace(/^(-?\d+)/, '$1.')
}

/** Also "1.5D+3" and "1.5-3". */
function doubleOf(word: string): number {
  const plain = word.trim().replace(/[dD]/, 'e')
  return Number(plain.replace(/^([-+]?[\d.]+)([-+]\d+)$/, '$1e$2'))
}
