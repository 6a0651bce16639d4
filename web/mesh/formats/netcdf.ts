/**
 * netCDF's classic files, with offsets of 32 or 64 bits or data of 64 bits: a header in big-endian numbers, then the variables. A fixed one is
 * one run of numbers; those along the record dimension lie together, one record of each after another.
 */
import { BinaryCursor } from '../binary-cursor'
import { copySwappedIndices, copySwappedToThirds } from '../endian'
import { FileChunk } from '../file-chunk'
import type { MeshFile } from '../source'
import { shown } from '../text-cursor'
import { lengthOf, type Variable, type Variables } from './netcdf-variables'
import { type NumberType, putNumbers, sizeOf } from './vtk-numbers'

/** Types by their number, from 1 on; characters are bytes. */
const TYPES: readonly NumberType[] = [
  'Int8',
  'UInt8',
  'Int16',
  'Int32',
  'Float32',
  'Float64',
  'UInt8',
  'UInt16',
  'UInt32',
  'Int64',
  'UInt64',
]
const CHARACTERS = 2
const [DIMENSIONS, VARIABLES, ATTRIBUTES] = [10, 11, 12] as const
const LONGEST_NAME = 65_536
const MOST_DIMENSIONS = 1024
/** Strings of a variable are no longer than this, all together. */
const LONGEST_STRINGS = 16 * 1024 * 1024
const NOTHING = new Uint8Array(0)
const decoder = new TextDecoder()

/** True if a file is in one of the classic formats. */
export function isClassicNetcdf(head: Uint8Array): boolean {
  const [c, d, f, version = 0] = head
  return c === 67 && d === 68 && f === 70 && [1, 2, 5].includes(version)
}

export class ClassicVariables implements Variables {
  readonly #file: MeshFile
  readonly #cursor: BinaryCursor
  /** Bytes of a count. */
  readonly #bytes: 4 | 8
  readonly #offsetBytes: 4 | 8
  readonly #variables = new Map<string, ClassicVariable>()
  readonly #chunk = new FileChunk()
  /** The byte up to which the file has been read last. */
  position = 0

  constructor(file: MeshFile) {
    this.#file = file
    const version = file.read(3, 4)[0]
    this.#bytes = version === 5 ? 8 : 4
    this.#offsetBytes = version === 1 ? 4 : 8
    this.#cursor = new BinaryCursor(file, 4, false)
    this.#readHeader()
  }

  get names(): readonly string[] {
    return [...this.#variables.keys()]
  }

  variable(name: string): Variable | null {
    return this.#variables.get(name) ?? null
  }

  refuse(what: string): never {
    return this.#cursor.refuse(what)
  }

  /** Bytes of the file, up to the next call. */
  bytes(from: number, count: number, name: string): Uint8Array {
    const to = from + count
    if (to > this.#file.size) {
      this.#cursor.jumpTo(from)
      this.refuse(`${shown(name)} needs ${count} bytes from here on, and the file ends at byte ${this.#file.size}.`)
    }
    this.position = to
    return this.#chunk.next(this.#file, NOTHING, from, to)
  }

  #count(what: string): number {
    return this.#cursor.count(this.#bytes, what)
  }

  #readHeader(): void {
    // A file that is still written to has -1 in place of the number of records.
    const records = this.#cursor.int(this.#bytes, 'the number of records')
    const lengths: number[] = []
    this.#list(DIMENSIONS, 'dimensions', () => {
      this.#name()
      lengths.push(this.#count('the length of a dimension'))
    })
    this.#list(ATTRIBUTES, 'attributes', () => this.#attribute())
    const found: Declared[] = []
    this.#list(VARIABLES, 'variables', () => found.push(this.#declared(lengths)))
    const recordVariables = found.filter(({ isRecord }) => isRecord)
    // The records of one variable alone are not padded.
    const [only] = recordVariables
    const stride =
      recordVariables.length === 1
        ? bytesOf(only as Declared)
        : recordVariables.reduce((sum, one) => sum + padded(bytesOf(one)), 0)
    const first = Math.min(...recordVariables.map(({ begin }) => begin))
    const written = stride === 0 ? 0 : Math.floor((this.#file.size - first) / stride)
    const count = records >= 0 && records < 2 ** 32 - 1 ? records : Math.max(0, written)
    for (const one of found) this.#variables.set(one.name, new ClassicVariable(this, one, count, stride))
  }

  /** Reads a list that has its mark in front, or is absent. */
  #list(mark: number, what: string, read: () => void): void {
    const found = this.#cursor.int32(`the mark of ${what}`)
    const count = this.#count(`the number of ${what}`)
    if (found === 0 && count === 0) return
    if (found !== mark) this.refuse(`the list of ${what} was expected, with the mark ${mark}, not ${found}.`)
    // A name has a length and four characters at least.
    this.#cursor.need(count, 8, what)
    for (let i = 0; i < count; ++i) read()
  }

  #name(): string {
    const length = this.#count('the length of a name')
    if (length > LONGEST_NAME) this.refuse(`a name of ${length} characters is longer than names are.`)
    return decoder.decode(this.#cursor.bytes(padded(length), 'a name').subarray(0, length))
  }

  #type(): number {
    const type = this.#cursor.int32('a type')
    if (TYPES[type - 1] === undefined) this.refuse(`${type} is no type of netCDF.`)
    return type
  }

  /** Its name and text; null in place of numbers. */
  #attribute(): readonly [string, string | null] {
    const name = this.#name()
    const type = this.#type()
    const length = this.#count('the length of an attribute')
    const bytes = padded(length * sizeOf(TYPES[type - 1] as NumberType))
    this.#cursor.need(1, bytes, 'an attribute')
    if (type !== CHARACTERS || length > LONGEST_NAME) {
      this.#cursor.jumpTo(this.#cursor.position + bytes)
      return [name, null]
    }
    return [name, textOf(this.#cursor.bytes(bytes, 'an attribute').subarray(0, length))]
  }

  #declared(lengths: readonly number[]): Declared {
    const name = this.#name()
    const count = this.#count('the number of dimensions')
    if (count > MOST_DIMENSIONS) this.refuse(`${shown(name)} has ${count} dimensions.`)
    const all = Array.from({ length: count }, () => {
      const dimension = this.#count('the number of a dimension')
      const length = lengths[dimension]
      if (length === undefined)
        this.refuse(`${shown(name)} has dimension ${dimension}; the file has ${lengths.length}, from 0 on.`)
      return length
    })
    const texts = new Map<string, string | null>()
    this.#list(ATTRIBUTES, 'attributes', () => {
      const [attribute, text] = this.#attribute()
      texts.set(attribute, text)
    })
    const type = this.#type()
    this.#count('the size of a variable') // which its shape says again, and without a limit
    const begin = this.#cursor.count(this.#offsetBytes, 'the place of a variable')
    const isRecord = all[0] === 0
    return { name, texts, type: TYPES[type - 1] as NumberType, begin, isRecord, own: isRecord ? all.slice(1) : all }
  }
}

/** A variable as the header has it; `own` are its dimensions but that of the records. */
interface Declared {
  readonly name: string
  readonly own: readonly number[]
  readonly isRecord: boolean
  readonly texts: ReadonlyMap<string, string | null>
  readonly type: NumberType
  readonly begin: number
}

class ClassicVariable implements Variable {
  readonly shape: readonly number[]
  readonly isFloat32: boolean
  readonly floatsFrom: number | null
  readonly #variables: ClassicVariables
  readonly #declared: Declared
  readonly #stride: number

  constructor(variables: ClassicVariables, declared: Declared, records: number, stride: number) {
    this.#variables = variables
    this.#declared = declared
    this.#stride = stride
    this.shape = declared.isRecord ? [records, ...declared.own] : declared.own
    this.isFloat32 = declared.type === 'Float32'
    this.floatsFrom = !declared.isRecord && declared.type.startsWith('Float') ? declared.begin : null
    const bytes = lengthOf(this) * sizeOf(declared.type)
    if (!Number.isSafeInteger(bytes)) variables.refuse(`${shown(declared.name)} has more numbers than a file can have.`)
  }

  text(attribute: string): string | null {
    return this.#declared.texts.get(attribute) ?? null
  }

  numbers(from: number, into: Float64Array): void {
    this.#read(from, into.length, (bytes, at) => {
      putNumbers(this.#declared.type, bytes, true, into, at)
    })
  }

  indices(from: number, into: Uint32Array): { readonly at: number; readonly value: string } | null {
    let none: ReturnType<typeof putNumbers> = null
    this.#read(from, into.length, (bytes, at) => {
      const bad = none === null ? putNumbers(this.#declared.type, bytes, true, into, at) : null
      if (bad !== null) none = { ...bad, at: at + bad.at }
    })
    return none
  }

  axis(from: number, into: Float64Array, axis: number): boolean {
    if (this.#declared.type !== 'Float64') return false
    const words = new Uint32Array(into.buffer, into.byteOffset, 2 * into.length)
    this.#read(from, into.length / 3, (bytes, at) => {
      copySwappedToThirds(wordsOf(bytes), words.subarray(2 * (3 * at + axis)))
    })
    return true
  }

  indicesFrom1(from: number, into: Uint32Array, count: number): boolean {
    if (this.#declared.type !== 'Int32') return false
    let areAll = true
    this.#read(from, into.length, (bytes, at) => {
      areAll = copySwappedIndices(wordsOf(bytes), into.subarray(at), count - 1) && areAll
    })
    return areAll
  }

  strings(): readonly string[] {
    const { name } = this.#declared
    const count = lengthOf(this)
    if (count > LONGEST_STRINGS) this.#variables.refuse(`${shown(name)} has ${count} characters.`)
    const width = this.shape.at(-1) ?? 0
    const characters = new Uint8Array(count)
    this.#read(0, count, (bytes, at) => characters.set(bytes, at))
    return Array.from({ length: width === 0 ? 0 : count / width }, (_, i) =>
      textOf(characters.subarray(width * i, width * (i + 1))),
    )
  }

  /** Calls `put` with the bytes of `count` numbers, in one piece or one for each record, and the place of each piece among them. */
  #read(from: number, count: number, put: (bytes: Uint8Array, at: number) => void): void {
    const { name, type, begin, isRecord } = this.#declared
    const size = sizeOf(type)
    const perRecord = isRecord ? lengthOf({ shape: this.#declared.own }) : lengthOf(this)
    for (let done = 0; done < count; ) {
      const at = from + done
      const record = Math.floor(at / perRecord)
      const inRecord = at - record * perRecord
      const some = Math.min(count - done, perRecord - inRecord)
      put(this.#variables.bytes(begin + record * this.#stride + inRecord * size, some * size, name), done)
      done += some
    }
  }
}

function wordsOf({ buffer, byteOffset, length }: Uint8Array): Uint32Array {
  return new Uint32Array(buffer, byteOffset, length / 4)
}

function bytesOf({ own, type }: Declared): number {
  return lengthOf({ shape: own }) * sizeOf(type)
}

/** What is shorter than four bytes is filled up. */
function padded(bytes: number): number {
  return 4 * Math.ceil(bytes / 4)
}

/** Up to the first zero. */
function textOf(bytes: Uint8Array): string {
  const end = bytes.indexOf(0)
  return decoder.decode(end < 0 ? bytes : bytes.subarray(0, end))
}
