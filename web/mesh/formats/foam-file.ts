/**
 * A file of OpenFOAM: a header that says what follows and how numbers are written, then one list: its length and its entries in brackets, as
 * text or as the bytes of numbers. Brackets inside a list of text only group numbers that are counted anyway, and are read as blanks.
 */
import { MeshRefusal } from '../mesh'
import { lineAt, NumberRun } from '../number-run'
import type { MeshFile, ReadOptions } from '../source'
import { shown, TextCursor } from '../text-cursor'
import { blanked } from './row-text'
import { type NumberType, putNumbers, sizeOf } from './vtk-numbers'

const [LF, HASH_QUOTE, OPEN, CLOSE, STAR, SLASH, SEMICOLON] = [10, 34, 40, 41, 42, 47, 59] as const
const [ZERO, NINE, OPEN_BRACE, CLOSE_BRACE, SPACE] = [48, 57, 123, 125, 32] as const
/** A header is no longer. */
const LONGEST_HEADER = 16_384
/** Bytes of binary numbers that are read at once; a multiple of the sizes of all numbers. */
const AT_ONCE = 1024 * 1024
const MOST_COUNT_DIGITS = 15

export class FoamFile {
  readonly file: MeshFile
  readonly options: ReadOptions
  readonly className: string
  /** The folder that it says it is in; '' if it does not say. */
  readonly location: string
  readonly isBinary: boolean
  readonly #isLittleEndian: boolean
  readonly #label: NumberType
  readonly #scalar: NumberType
  readonly cursor: TextCursor

  constructor(file: MeshFile, options: ReadOptions) {
    this.file = file
    this.options = options
    const head = String.fromCharCode(...file.read(0, Math.min(file.size, LONGEST_HEADER)))
    const [begin, own = ''] = /^[\s\S]*?\bFoamFile\s*\{([^{}]*)\}/.exec(head) ?? []
    if (begin === undefined)
      throw new MeshRefusal(`${file.name}: the header “FoamFile” was expected, and is not there.`)
    const entry = (name: string) =>
      new RegExp(String.raw`(?:^|[\s;])${name}\s+("[^"]*"|[^\s;]+)\s*;`).exec(own)?.[1] ?? ''
    this.className = entry('class')
    this.location = entry('location').replaceAll('"', '')
    this.isBinary = entry('format') === 'binary'
    const arch = entry('arch')
    this.#isLittleEndian = !/\bMSB\b/.test(arch)
    this.#label = /\blabel=64\b/.test(arch) ? 'Int64' : 'Int32'
    this.#scalar = /\bscalar=32\b/.test(arch) ? 'Float32' : 'Float64'
    this.cursor = new TextCursor(file, begin.length, 1)
  }

  get isFloat32(): boolean {
    return this.isBinary && this.#scalar === 'Float32'
  }

  refuse(what: string, position = this.cursor.position): never {
    const place = this.isBinary ? `byte ${position}` : `line ${lineAt(this.file, position)}`
    throw new MeshRefusal(`${this.file.name}, ${place}: ${what}`)
  }

  progress(position: number): void {
    this.options.throwIfCancelled()
    this.options.onProgress(position / this.file.size)
  }

  /** Passes blanks and comments; the byte that is next, -1 at the end. */
  next(): number {
    const { cursor } = this
    for (;;) {
      cursor.skipBlanks()
      const byte = cursor.peek()
      if (byte !== SLASH) return byte
      const [, second] = cursor.peekLine(2)
      if (second === '*') this.#skipComment()
      else if (second === '/') cursor.skipLine()
      else return byte
    }
  }

  #skipComment(): void {
    const { cursor } = this
    cursor.skip()
    cursor.skip()
    for (let star = false; cursor.peek() !== -1; ) {
      const byte = cursor.peek()
      cursor.skip()
      if (star && byte === SLASH) return
      star = byte === STAR
    }
    this.refuse('a comment does not end.')
  }

  /** The next length of a list of entries of at least `bytes` bytes each; the list begins behind it. */
  count(what: string, bytes: number): number {
    const { cursor } = this
    let digits = ''
    for (
      let byte = this.next();
      byte >= ZERO && byte <= NINE && digits.length <= MOST_COUNT_DIGITS;
      byte = cursor.peek()
    ) {
      digits += String.fromCharCode(byte)
      cursor.skip()
    }
    if (digits === '' || digits.length > MOST_COUNT_DIGITS) this.refuse(`the number of ${what} was expected.`)
    const count = Number(digits)
    if (this.next() !== OPEN_BRACE && bytes * count > this.file.size)
      this.refuse(`the file is too short for ${count} ${what}.`)
    return count
  }

  /** Passes the bracket, brace or semicolon that must be next. */
  expect(byte: number, what: string): void {
    if (this.next() !== byte) this.refuse(`${what} was expected${this.#instead()}.`)
    this.cursor.skip()
  }

  /** Passes the brackets with which a list of text ends, its last entry's and its own; nothing may be behind. */
  end(count: number, what: string): void {
    this.expect(CLOSE, `a bracket behind ${count} ${what}`)
    if (this.next() === CLOSE) this.cursor.skip()
    if (this.next() !== -1) this.refuse(`there is more behind the ${count} ${what} that were declared.`)
  }

  #instead(): string {
    if (this.isBinary) return ''
    const word = this.cursor.word()
    return word === '' ? ', and the file ends' : `, not ${shown(word)}`
  }

  /** The bytes of one number in this file. */
  bytesOf(what: 'label' | 'scalar'): number {
    return this.isBinary ? sizeOf(what === 'label' ? this.#label : this.#scalar) : 2
  }

  /** The next list of labels, with its length in front; all may be the same: 4{0}. */
  labels(what: string): Uint32Array {
    const count = this.count(what, this.bytesOf('label'))
    if (this.next() === OPEN_BRACE) return this.#sameLabels(count, what)
    if (count === 0 && this.next() !== OPEN) return new Uint32Array(0)
    this.expect(OPEN, 'a bracket before the numbers')
    const list = new Uint32Array(count)
    if (this.isBinary) this.#binaryLabels(list, what)
    else {
      const run = this.run()
      const filled = run.indices(list, 0, count)
      if (filled < count) this.#refuseNumber(run, `${filled} of ${count} ${what} are there`)
      this.cursor.goTo({ position: run.position })
    }
    this.expect(CLOSE, `a bracket behind ${count} ${what}`)
    return list
  }

  #sameLabels(count: number, what: string): Uint32Array {
    this.cursor.skip()
    const value = this.isBinary ? this.#binaryLabels(new Uint32Array(1), what)[0] : this.#textLabel()
    this.expect(CLOSE_BRACE, 'a brace')
    // So few bytes may stand for many.
    if (count > this.file.size) this.refuse(`${count} ${what} that are all ${value} are more than a mesh has.`)
    return new Uint32Array(count).fill(value as number)
  }

  #textLabel(): number {
    const run = this.run()
    const list = new Uint32Array(1)
    if (run.indices(list, 0, 1) === 0) this.#refuseNumber(run, 'a label was expected')
    this.cursor.goTo({ position: run.position })
    return list[0] as number
  }

  #binaryLabels(list: Uint32Array, what: string): Uint32Array {
    this.binary(this.#label, list, what)
    return list
  }

  /** Numbers of text from here on, brackets as blanks. */
  run(): NumberRun {
    const { position } = this.cursor
    return new NumberRun(withoutBrackets(this.file), position, this.file.size, this.options.core, at =>
      this.progress(at),
    )
  }

  #refuseNumber(run: NumberRun, has: string): never {
    const word = run.nextWord()
    this.refuse(`${has}; ${word === '' ? 'the file ends there' : `then ${shown(word)}`}.`, run.position)
  }

  /** Fills the list from the bytes from here on. */
  binary(type: NumberType, list: Uint32Array | Float64Array, what: string): void {
    const { position } = this.cursor
    const size = sizeOf(type)
    const end = position + size * list.length
    if (end > this.file.size) this.refuse(`the file ends in the middle of ${list.length} ${what}: it is cut off.`)
    for (let from = position; from < end; from += AT_ONCE) {
      const bytes = this.file.read(from, Math.min(end, from + AT_ONCE))
      const at = (from - position) / size
      const bad = putNumbers(type, bytes, !this.#isLittleEndian, list, at)
      if (bad !== null)
        this.refuse(
          `${bad.value} stands among the ${what}, where a number from 0 on was expected.`,
          from + size * bad.at,
        )
      this.progress(from)
    }
    this.cursor.goTo({ position: end })
  }

  /** Doubles of the bytes from here on. */
  scalars(count: number, what: string): Float64Array {
    const list = new Float64Array(count)
    this.binary(this.#scalar, list, what)
    return list
  }

  /** The next word of a dictionary; a mark of one character is a word, too. '' at the end. */
  word(): string {
    const { cursor } = this
    const first = this.next()
    if (first === -1) return ''
    let word = String.fromCharCode(first)
    cursor.skip()
    if (isMark(first)) return word
    const isQuoted = first === HASH_QUOTE
    for (let byte = cursor.peek(); byte !== -1 && byte !== LF; byte = cursor.peek()) {
      if (!isQuoted && (byte <= SPACE || isMark(byte))) break
      word += String.fromCharCode(byte)
      cursor.skip()
      if (isQuoted && byte === HASH_QUOTE) break
      if (word.length > LONGEST_HEADER) this.refuse('a word is longer than words are.')
    }
    return word
  }
}

function isMark(byte: number): boolean {
  return byte === OPEN || byte === CLOSE || byte === OPEN_BRACE || byte === CLOSE_BRACE || byte === SEMICOLON
}

/** The file with blanks in place of brackets. */
export function withoutBrackets(file: MeshFile): MeshFile {
  return blanked(file, '()')
}
