/**
 * UGRID (AFLR): seven counts, then all coordinates, the points of the faces of the boundary, their numbers, and the points of tetrahedra, pyramids,
 * wedges and hexahedra, from 1 on. As text, or in bytes, with Fortran's lengths of records around them or without.
 */
import { BinaryCursor } from '../binary-cursor'
import { type CoordinatePlaces, MeshRefusal } from '../mesh'
import { MeshBuilder } from '../mesh-builder'
import { lineAt, NumberRun } from '../number-run'
import { float32Note } from '../precision'
import { headText, isText } from '../snippet-text'
import { type MeshFile, type MeshFormat, progressOf, type ReadOptions } from '../source'
import { shown } from '../text-cursor'

const COUNTS = ['points', 'triangles', 'quadrilaterals', 'tetrahedra', 'pyramids', 'wedges', 'hexahedra'] as const
/** Nodes of each of these but the points. */
const SIZES = [3, 4, 4, 5, 6, 8] as const
const AT_ONCE = 65_536
/** meshio writes the types of NumPy 2 around the numbers. */
const NUMPY = /np\.(?:int|float)(?:32|64)\(/
const LEAST_BYTES = 28

interface Kind {
  readonly isLittleEndian: boolean
  readonly floatBytes: 4 | 8
  readonly intBytes: 4 | 8
  readonly hasRecords: boolean
}

/** "wing.lb8l.ugrid": little-endian, a stream (b) or records (r), bytes of a coordinate, long integers. */
const KIND_IN_NAME = /\.(l?)([br])([48])(l?)\.ugrid$/
const KINDS: readonly Kind[] = [true, false].flatMap(isLittleEndian =>
  ([8, 4] as const).flatMap(floatBytes =>
    ([4, 8] as const).flatMap(intBytes =>
      [false, true].map(hasRecords => ({ isLittleEndian, floatBytes, intBytes, hasRecords })),
    ),
  ),
)

export const ugrid: MeshFormat = {
  name: 'UGRID',
  recognizes: (head, name) => {
    if (/\.ugrid$/.test(name) && head.length > 0) return 'yes'
    if (isText(head)) return 'no'
    return KINDS.some(kind => isLikely(head, kind)) ? 'maybe' : 'no'
  },
  read(file, options) {
    const head = file.read(0, Math.min(file.size, AT_ONCE))
    const builder = new MeshBuilder('UGRID', file.name)
    const numbers =
      isText(head) && !KIND_IN_NAME.test(file.name.toLowerCase())
        ? new TextNumbers(file, options, builder)
        : new BinaryNumbers(file, options, kindOf(file, head))
    read(numbers, builder)
    return [builder.mesh()]
  },
}

/** True if the seven counts are of a mesh that is not larger than a file may be. */
function isLikely(head: Uint8Array, kind: Kind): boolean {
  const counts = countsOf(head, kind)
  return counts !== null && counts[0] !== 0 && counts.every(count => count < 2 ** 31) && (counts[6] as number) > 0
}

/** The counts; null where they cannot be. */
function countsOf(head: Uint8Array, { intBytes, isLittleEndian, hasRecords }: Kind): readonly number[] | null {
  if (head.length < 2 * LEAST_BYTES + 16) return null
  const view = new DataView(head.buffer, head.byteOffset, head.length)
  const at = hasRecords ? 4 : 0
  if (hasRecords && view.getInt32(0, isLittleEndian) !== 7 * intBytes) return null
  const counts = COUNTS.map((_, i) =>
    intBytes === 8 ? Number(view.getBigInt64(at + 8 * i, isLittleEndian)) : view.getInt32(at + 4 * i, isLittleEndian),
  )
  return counts.every(count => count >= 0) ? counts : null
}

function bytesOf(counts: readonly number[], { floatBytes, intBytes, hasRecords }: Kind): number {
  const [points = 0, triangles = 0, quadrilaterals = 0] = counts
  const cells = SIZES.reduce((sum, size, i) => sum + size * (counts[i + 1] as number), 0)
  return (
    7 * intBytes + 3 * points * floatBytes + (cells + triangles + quadrilaterals) * intBytes + (hasRecords ? 16 : 0)
  )
}

/** The kind that the name says, or the one that fits the size of the file. */
function kindOf(file: MeshFile, head: Uint8Array): Kind {
  const [, little, stream, bytes, long] = KIND_IN_NAME.exec(file.name.toLowerCase()) ?? []
  if (stream !== undefined)
    return {
      isLittleEndian: little === 'l',
      floatBytes: bytes === '4' ? 4 : 8,
      intBytes: long === 'l' ? 8 : 4,
      hasRecords: stream === 'r',
    }
  const fitting = KINDS.filter(kind => {
    const counts = countsOf(head, kind)
    return counts !== null && bytesOf(counts, kind) === file.size
  })
  const [kind] = fitting
  if (kind === undefined || fitting.length > 1)
    throw new MeshRefusal(
      `${file.name}: its bytes are those of no kind of UGRID: the name says the kind, as in wing.b8.ugrid or wing.lb8.ugrid.`,
    )
  return kind
}

interface Numbers {
  count(what: string): number
  /** Refuses if there cannot be so many more numbers. */
  need(count: number, what: string): void
  coordinates(into: Float64Array): void
  indices(into: Float64Array, what: string): void
  refuse(what: string): never
  begin(): void
  end(): void
  /** The places of the coordinates, which have been read last. */
  places(): CoordinatePlaces | null
  /** Notes about their precision, and about their records. */
  notes(): readonly (string | null)[]
}

function read(numbers: Numbers, builder: MeshBuilder): void {
  numbers.begin()
  const counts = COUNTS.map(what => numbers.count(`the number of ${what}`))
  numbers.end()
  const [points = 0, triangles = 0, quadrilaterals = 0, tetrahedra = 0, pyramids = 0, wedges = 0, hexahedra = 0] =
    counts
  numbers.begin()
  numbers.need(3 * points, 'coordinates')
  builder.reserve(points, 0)
  inChunks(3 * points, 3, (_, some) => {
    const values = new Float64Array(some)
    numbers.coordinates(values)
    for (let i = 0; i < some; i += 3)
      builder.point(values[i] as number, values[i + 1] as number, values[i + 2] as number)
  })
  builder.coordinatePlaces = numbers.places()
  for (const note of numbers.notes()) if (note !== null) builder.note(note)
  pass(numbers, 3 * triangles + 4 * quadrilaterals, 'points of faces')
  pass(numbers, triangles + quadrilaterals, 'numbers of the boundary')
  pass(numbers, 4 * tetrahedra + 5 * pyramids + 6 * wedges, 'points of cells')
  numbers.need(8 * hexahedra, 'points of hexahedra')
  builder.reserve(0, hexahedra)
  // Cells are counted in the order of the file.
  const before = tetrahedra + pyramids + wedges
  const nodes = new Float64Array(Math.min(AT_ONCE, 8 * hexahedra))
  const ids = new Float64Array(nodes.length / 8)
  inChunks(8 * hexahedra, 8, (from, some) => {
    const own = nodes.subarray(0, some)
    numbers.indices(own, 'points of hexahedra')
    for (let i = 0; i < some; ++i)
      if (!((own[i] as number) >= 1 && (own[i] as number) <= points))
        numbers.refuse(
          `hexahedron ${Math.floor((from + i) / 8) + 1} names point ${own[i]}; the points are 1 to ${points}.`,
        )
    for (let i = 0; i < some / 8; ++i) ids[i] = before + from / 8 + i + 1
    builder.hexahedra(own, 1, ids)
  })
  builder.otherCell('triangle', triangles)
  builder.otherCell('quadrilateral', quadrilaterals)
  builder.otherCell('tetrahedron', tetrahedra)
  builder.otherCell('pyramid', pyramids)
  builder.otherCell('wedge', wedges)
}

function inChunks(count: number, width: number, one: (from: number, count: number) => void): void {
  const most = Math.floor(AT_ONCE / width) * width
  for (let from = 0; from < count; from += most) one(from, Math.min(most, count - from))
}

function pass(numbers: Numbers, count: number, what: string): void {
  numbers.need(count, what)
  const scratch = new Float64Array(Math.min(count, AT_ONCE))
  inChunks(count, 1, (_, some) => numbers.indices(scratch.subarray(0, some), what))
}

class TextNumbers implements Numbers {
  readonly #run: NumberRun
  readonly #file: MeshFile
  readonly #builder: MeshBuilder
  readonly #one = new Float64Array(1)
  readonly #isPlain: boolean
  /** The bytes of all coordinates. */
  #from = -1
  #to = 0

  constructor(given: MeshFile, options: ReadOptions, builder: MeshBuilder) {
    // All is read in one go: counts, coordinates and indices are numbers between blanks.
    const isNumpy = NUMPY.test(headText(given.read(0, Math.min(given.size, 1024))))
    this.#file = isNumpy ? withoutTypes(given) : given
    this.#builder = builder
    const progress = progressOf(given, options)
    this.#run = new NumberRun(this.#file, 0, given.size, options.core, progress)
    this.#isPlain = !isNumpy
  }

  refuse(what: string): never {
    throw new MeshRefusal(`${this.#file.name}, line ${lineAt(this.#file, this.#run.position)}: ${what}`)
  }

  need(count: number, what: string): void {
    if (2 * count > this.#file.size + 1) this.refuse(`the file is too short for ${count} ${what}.`)
  }

  #all(into: Float64Array, what: string): void {
    const filled = this.#run.numbers(into, 0, into.length)
    if (filled === into.length) return
    const word = this.#run.nextWord()
    this.refuse(word === '' ? `the file ends among the ${what}.` : `${shown(word)} stands among the ${what}.`)
  }

  count(what: string): number {
    this.#all(this.#one, 'counts')
    const [value = 0] = this.#one
    if (!Number.isSafeInteger(value) || value < 0) this.refuse(`${what} is no whole number from 0 on.`)
    return value
  }

  coordinates(into: Float64Array): void {
    if (this.#from < 0) this.#from = this.#run.position
    this.#all(into, 'coordinates')
    this.#to = this.#run.position
    for (const value of into) this.#builder.digits.see(value, this.#run.mostDigits)
  }

  indices(into: Float64Array, what: string): void {
    this.#all(into, what)
    if (!into.every(Number.isSafeInteger)) this.refuse(`a number that is not whole stands among the ${what}.`)
  }

  begin(): void {}

  end(): void {}

  places(): CoordinatePlaces | null {
    return this.#isPlain && this.#from >= 0 ? { kind: 'run', from: this.#from, to: this.#to } : null
  }

  notes(): readonly (string | null)[] {
    return [] // the builder has seen the digits
  }
}

/** The file with blanks in place of `np.float64(` and of the bracket behind. */
function withoutTypes(file: MeshFile): MeshFile {
  const margin = 16
  return {
    name: file.name,
    size: file.size,
    read(from, to) {
      const start = Math.max(0, from - margin)
      const bytes = file.read(start, Math.min(file.size, to + margin))
      let text = ''
      for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192))
      const plain = text.replace(/np\.(?:int|float)(?:32|64)\(|\)/g, word => ' '.repeat(word.length))
      const own = new Uint8Array(to - from)
      for (let i = 0; i < own.length; ++i) own[i] = plain.charCodeAt(from - start + i)
      return own
    },
  }
}

class BinaryNumbers implements Numbers {
  readonly #cursor: BinaryCursor
  readonly #kind: Kind
  readonly #onSome: (position: number) => void
  #recordLength = 0
  #recordEnd = 0
  /** True if a record has the same length in front and behind, and another one in between. */
  #hasWrongLengths = false
  #largest = 0
  /** The byte of the first coordinate. */
  #from = -1

  constructor(file: MeshFile, options: ReadOptions, kind: Kind) {
    this.#cursor = new BinaryCursor(file, 0, kind.isLittleEndian)
    this.#kind = kind
    this.#onSome = position => {
      options.throwIfCancelled()
      options.onProgress(position / file.size)
    }
  }

  refuse(what: string): never {
    return this.#cursor.refuse(what)
  }

  need(count: number, what: string): void {
    const { floatBytes, intBytes } = this.#kind
    this.#cursor.need(count, what === 'coordinates' ? floatBytes : intBytes, what)
  }

  count(what: string): number {
    return this.#cursor.count(this.#kind.intBytes, what)
  }

  begin(): void {
    if (!this.#kind.hasRecords) return
    const length = this.#cursor.int32('the length of a record')
    this.#recordLength = length
    this.#recordEnd = this.#cursor.position + length
  }

  end(): void {
    if (!this.#kind.hasRecords) return
    const isRight = this.#cursor.position === this.#recordEnd
    const length = this.#cursor.int32('the length of a record')
    if (isRight) return
    if (length !== this.#recordLength) this.refuse('the record ends elsewhere than its length says.')
    this.#hasWrongLengths = true
  }

  coordinates(into: Float64Array): void {
    if (this.#from < 0) this.#from = this.#cursor.position
    if (this.#kind.floatBytes === 8) into.set(this.#cursor.float64s(into.length, 'coordinates'))
    else for (let i = 0; i < into.length; ++i) into[i] = this.#cursor.float32('a coordinate')
    for (const value of into) this.#largest = Math.max(this.#largest, Math.abs(value))
    this.#onSome(this.#cursor.position)
  }

  places(): CoordinatePlaces | null {
    const { floatBytes, isLittleEndian } = this.#kind
    if (this.#from < 0) return null
    return { kind: 'block', from: this.#from, type: floatBytes === 8 ? 'float64' : 'float32', isLittleEndian }
  }

  notes(): readonly (string | null)[] {
    return [
      this.#kind.floatBytes === 4 ? float32Note(this.#largest) : null,
      this.#hasWrongLengths
        ? 'The lengths of its records are wrong, as meshio writes them; they were passed over.'
        : null,
    ]
  }

  indices(into: Float64Array, what: string): void {
    into.set(this.#cursor.ints(into.length, this.#kind.intBytes, what))
    this.#onSome(this.#cursor.position)
  }
}
