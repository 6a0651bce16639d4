/** The words and lists of numbers that VTK's legacy files are made of, as text or in big-endian binary; and what nobody needs in them. */
import { MeshRefusal } from '../mesh'
import { lineAt, NumberRun } from '../number-run'
import { isEllipsis } from '../snippet-text'
import type { MeshFile, ReadOptions } from '../source'
import { shown, type TextCursor } from '../text-cursor'
import { wordTable } from '../word-table'
import { alignedTo, type NumberList, type NumberType, putNumbers, sizeOf } from './vtk-numbers'

const CHUNK = 256 * 1024
const FIRST_CHUNK = 4096

/** Types of arrays as these files name them. */
const TYPES: Readonly<Record<string, NumberType>> = wordTable({
  char: 'Int8',
  signed_char: 'Int8',
  unsigned_char: 'UInt8',
  short: 'Int16',
  unsigned_short: 'UInt16',
  int: 'Int32',
  unsigned_int: 'UInt32',
  long: 'Int64',
  unsigned_long: 'UInt64',
  long_long: 'Int64',
  unsigned_long_long: 'UInt64',
  vtktypeint64: 'Int64',
  vtktypeuint64: 'UInt64',
  // The ids of VTK are written as 32 bits whatever they have in memory.
  vtkidtype: 'Int32',
  float: 'Float32',
  double: 'Float64',
})

export class LegacyStream {
  readonly file: MeshFile
  readonly cursor: TextCursor
  readonly #options: ReadOptions
  isBinary = false
  /** The most significant digits with which a number is printed. */
  digits = 0

  constructor(file: MeshFile, options: ReadOptions, cursor: TextCursor) {
    this.file = file
    this.#options = options
    this.cursor = cursor
  }

  refuseAt(position: number, what: string): never {
    const place = this.isBinary ? `byte ${position}` : `line ${lineAt(this.file, position)}`
    throw new MeshRefusal(`${this.file.name}, ${place}: ${what}`)
  }

  refuse(what: string): never {
    this.refuseAt(this.cursor.position, what)
  }

  progress(position: number): void {
    this.#options.throwIfCancelled()
    this.#options.onProgress(position / this.file.size)
  }

  count(): number {
    const word = this.cursor.word()
    if (!/^\d{1,15}$/.test(word)) this.refuse(`${shown(word)} stands where a count was expected.`)
    return Number(word)
  }

  triple(): [number, number, number] {
    const three = new Float64Array(3)
    const run = new NumberRun(this.file, this.cursor.position, this.file.size, this.#options.core)
    if (run.numbers(three, 0, 3) < 3)
      this.refuseAt(run.position, `${shown(run.nextWord())} stands where a number was expected.`)
    this.cursor.goTo({ position: run.position })
    return [...three] as [number, number, number]
  }

  type(): NumberType {
    return this.typeOf(this.cursor.word())
  }

  typeOf(word: string): NumberType {
    const type = TYPES[word.toLowerCase()]
    if (type === undefined) this.refuse(`${shown(word)} stands where a type like double or int was expected.`)
    return type
  }

  /**
   * The next `count` numbers. Of a text that leaves some out there may be fewer; then what is left out has been passed.
   */
  list<T extends NumberList>(count: number, type: NumberType, List: new (length: number) => T, what: string): T {
    if (this.isBinary) return this.#binaryList(count, type, List, what)
    const from = this.cursor.position
    const list = new List(Math.min(count, Math.ceil((this.file.size - from) / 2)))
    const run = new NumberRun(this.file, from, this.file.size, this.#options.core, position => this.progress(position))
    const filled = list instanceof Float64Array ? run.numbers(list, 0, list.length) : run.indices(list, 0, list.length)
    this.digits = Math.max(this.digits, run.mostDigits)
    if (filled < count) {
      const word = run.nextWord()
      if (!isEllipsis(word))
        this.refuseAt(
          run.position,
          `${word === '' ? 'the file is cut off: it ends' : `${shown(word)} stands`} where ${what} ${filled + 1} of ${count} was expected.`,
        )
    }
    this.cursor.goTo({ position: run.position })
    if (filled === count) return list
    this.passElision()
    return list.slice(0, filled) as T
  }

  #binaryList<T extends NumberList>(count: number, type: NumberType, List: new (length: number) => T, what: string): T {
    this.cursor.skipLine()
    const size = sizeOf(type)
    let at = this.cursor.position
    const end = at + size * count
    if (end > this.file.size) {
      const has = `${count} times ${what} in ${size} bytes were expected, ${this.file.size - at} bytes are left`
      this.refuseAt(at, `${has}: the file is cut off.`)
    }
    const list = new List(count)
    const chunk = new Uint8Array(Math.min(CHUNK, size * count))
    for (let filled = 0; filled < count; ) {
      const bytes = this.file.read(at, Math.min(end, at + CHUNK), chunk)
      const bad = putNumbers(type, alignedTo(size, bytes), true, list, filled)
      if (bad !== null)
        this.refuseAt(
          at + size * bad.at,
          `${what} ${filled + bad.at + 1} is ${bad.value}, where a whole number from 0 on was expected.`,
        )
      filled += bytes.length / size
      at += bytes.length
      this.progress(at)
    }
    this.cursor.goTo({ position: at })
    return list
  }

  /** Goes to the next line that begins with a letter or #. */
  passElision(): void {
    this.cursor.skipLine()
    for (this.cursor.skipBlanks(); !this.cursor.isAtEnd; this.cursor.skipBlanks()) {
      const byte = this.cursor.peek() | 32
      if ((byte >= 97 && byte <= 122) || this.cursor.peek() === 35) return
      this.cursor.skipLine()
    }
  }

  /** Lines up to an empty one. */
  passMetadata(): void {
    this.cursor.skipLine()
    for (let line = this.cursor.nextLine(); line !== null; line = this.cursor.nextLine()) if (line.trim() === '') return
  }

  /** The next word in capitals; "" at the end. */
  nextKeyword(): string {
    this.cursor.skipBlanks()
    return this.cursor.isAtEnd ? '' : this.cursor.word().toUpperCase()
  }

  /** The words that follow on this line, which stays the one the cursor is on. */
  restOfLine(): string[] {
    const words: string[] = []
    while (this.cursor.hasMoreOnLine()) words.push(this.cursor.word())
    return words
  }

  /** Goes behind the word with which a line begins; false, at the end, where none does. */
  skipToLine(word: string): boolean {
    const at = lineThatBegins(this.file, word, this.cursor.position)
    this.cursor.goTo({ position: at < 0 ? this.file.size : at + word.length })
    return at >= 0
  }

  /** The arrays of a FIELD, whose numbers `take` must pass or read. */
  field(take: (name: string, components: number, tuples: number, type: string) => void): void {
    this.cursor.word()
    const count = this.count()
    for (let i = 0; i < count; ++i) {
      let name = this.cursor.word()
      if (name.toUpperCase() === 'METADATA') {
        this.passMetadata()
        name = this.cursor.word()
      }
      take(decoded(name), this.count(), this.count(), this.cursor.word())
    }
  }

  /** Passes so many numbers or texts, which begin on the next line. */
  pass(numbers: number, word: string): void {
    const type = word.toLowerCase()
    if (type === 'string') this.#passStrings(numbers)
    else if (!this.isBinary) this.#passNumbers(numbers)
    else {
      this.cursor.skipLine()
      const bytes = type === 'bit' ? Math.ceil(numbers / 8) : numbers * sizeOf(this.typeOf(type))
      if (!(this.cursor.position + bytes <= this.file.size))
        this.refuse(`an array of ${bytes} bytes was expected: the file is cut off.`)
      this.cursor.goTo({ position: this.cursor.position + bytes })
    }
  }

  #passNumbers(count: number): void {
    const run = new NumberRun(this.file, this.cursor.position, this.file.size, this.#options.core)
    const some = new Float64Array(1024)
    for (let left = count; left > 0; left -= some.length) {
      const wanted = Math.min(left, some.length)
      if (run.numbers(some, 0, wanted) === wanted) continue
      this.refuseAt(run.position, `${shown(run.nextWord())} stands where a number of a field was expected.`)
    }
    this.cursor.goTo({ position: run.position })
  }

  /** Passes strings: lines, or lengths of 1 to 8 bytes, by their highest two bits, and bytes. */
  #passStrings(count: number): void {
    this.cursor.skipLine()
    if (!this.isBinary) {
      for (let i = 0; i < count && !this.cursor.isAtEnd; ++i) this.cursor.skipLine()
      return
    }
    let at = this.cursor.position
    for (let i = 0; i < count; ++i) {
      const head = this.file.read(Math.min(at, this.file.size), Math.min(at + 8, this.file.size))
      const kind = (head[0] ?? 0) >> 6
      const bytes = [8, 4, 2, 1][kind] as number
      let length = (head[0] ?? 0) & 63
      for (let k = 1; k < bytes; ++k) length = 256 * length + (head[k] ?? 0)
      at += bytes + length
      if (at > this.file.size) this.refuse('a text of a field goes on behind the end of the file: it is cut off.')
    }
    this.cursor.goTo({ position: at })
  }
}

/** The first line from byte `from` on that begins so, in any case of letters; -1 if none does. */
export function lineThatBegins(file: MeshFile, words: string, from: number): number {
  const first = words.charCodeAt(0)
  let chunk = FIRST_CHUNK
  for (let start = from; start < file.size; start += chunk, chunk = Math.min(CHUNK, 2 * chunk)) {
    // The words may go on, and the end of the line before lie, beyond the chunk.
    const begin = Math.max(0, start - 1)
    const bytes = file.read(begin, Math.min(file.size, start + chunk + words.length))
    for (let at = bytes.indexOf(first, start - begin); at >= 0; at = bytes.indexOf(first, at + 1)) {
      const isLineStart = at === 0 || (bytes[at - 1] as number) <= 32 || begin + at === 3
      if (!isLineStart) continue
      const text = String.fromCharCode(...bytes.subarray(at, at + words.length))
      if (text.toLowerCase() === words.toLowerCase()) return begin + at
    }
  }
  return -1
}

/** A name's blanks and signs stand as %20 in the file. */
export function decoded(name: string): string {
  return name.replace(/%([\da-fA-F]{2})/g, (_, code) => String.fromCharCode(Number.parseInt(code, 16)))
}
