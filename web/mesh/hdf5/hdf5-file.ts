/** An open HDF5 file as readers of meshes see it: groups, attributes, numbers. Whatever is wrong in it is refused with its place. */
import type { H5Module, Metadata } from '../../../node_modules/h5wasm/dist/esm/hdf5_util.js'
import { type NumberList, type NumberType, putNumbers, sizeOf } from '../formats/vtk-numbers'
import { MeshRefusal } from '../mesh'
import { shown, withoutControls } from '../shown'
import type { MeshFile } from '../source'
import { Complaint, type Hdf5Library } from './library'

/** H5T_class_t */
const [INTEGER, FLOAT, STRING, ENUM, ARRAY] = [0, 1, 3, 8, 10] as const
/** Deflate makes no more than this of a byte; files without filters have every byte. */
const MOST_GROWTH = 1032
/** Bytes that are read at once, unless a row or a chunk has more. */
const AT_ONCE = 4 * 1024 * 1024
/** Characters of a reason that are said. */
const MOST_REASON = 200
/** Filters beyond these are other libraries': H5Z_FILTER_DEFLATE to H5Z_FILTER_SCALEOFFSET. */
const LAST_FILTER = 6
/** Texts of a file are short. */
const MOST_TEXT = 16 * 1024 * 1024

export type Kind = 'group' | 'dataset' | 'other'

export class Hdf5File {
  readonly name: string
  readonly #library: Hdf5Library
  readonly #size: number
  readonly #path: string
  /** Negative while it is not open. */
  #id = -1n
  readonly #names = new Map<string, readonly string[]>()
  readonly #datasets = new Map<string, Hdf5Dataset>()

  constructor(library: Hdf5Library, file: MeshFile) {
    this.#library = library
    this.name = file.name
    this.#size = file.size
    this.#path = library.mount(file)
  }

  /** Throws a MeshRefusal. */
  open(): void {
    this.#id = this.call(null, m =>
      m.open(this.#path, m.H5F_ACC_RDONLY, false, m.H5F_LIBVER_EARLIEST, m.H5F_LIBVER_LATEST),
    )
    if (this.#id < 0n) this.refuse('the HDF5 library cannot open it.')
  }

  refuse(what: string): never {
    throw new MeshRefusal(`${this.name}: ${what}`)
  }

  close(): void {
    for (const dataset of this.#datasets.values()) dataset.free()
    if (!this.#library.isWhole) return
    try {
      if (this.#id >= 0n) this.#library.call(m => m.close_file(this.#id))
    } catch (error) {
      // Nothing was written: what is wrong with it has been said by then.
      if (!(error instanceof Complaint)) throw error
    }
    this.#library.unmount(this.#path)
  }

  /** Calls the library; its complaints are about this path. */
  call<T>(path: string | null, work: (module: H5Module, id: bigint) => T): T {
    try {
      return this.#library.call(m => work(m, this.#id))
    } catch (error) {
      if (!(error instanceof Complaint)) throw error
      const what = path === null ? 'it' : shown(path)
      return this.refuse(`${what} cannot be read as HDF5: ${withoutControls(error.message).slice(0, MOST_REASON)}.`)
    }
  }

  /** The names in a group, in the file's order. */
  names(group: string): readonly string[] {
    const known = this.#names.get(group)
    if (known) return known
    const names = this.call(group, (m, id) => m.get_names(id, group, false))
    this.#names.set(group, names)
    return names
  }

  /** Null if there is no such thing in the group. */
  kind(group: string, name: string): Kind | null {
    if (!this.names(group).includes(name)) return null
    const path = within(group, name)
    return this.call(path, (m, id) => {
      const type = m.get_type(id, path)
      return type === m.H5G_GROUP ? 'group' : type === m.H5G_DATASET ? 'dataset' : 'other'
    })
  }

  /** True if there is a group under this path, each part of which is looked up. */
  hasGroup(group: string, name: string): boolean {
    return this.kind(group, name) === 'group'
  }

  groups(group: string): readonly string[] {
    return this.names(group).filter(name => this.kind(group, name) === 'group')
  }

  /** Null if there is none of that name. */
  findDataset(group: string, name: string): Hdf5Dataset | null {
    return this.kind(group, name) === 'dataset' ? this.#dataset(within(group, name)) : null
  }

  dataset(group: string, name: string): Hdf5Dataset {
    return this.findDataset(group, name) ?? this.refuse(`${shown(group)} has no dataset ${shown(name)}.`)
  }

  #dataset(path: string): Hdf5Dataset {
    const known = this.#datasets.get(path)
    if (known) return known
    const made = new Hdf5Dataset(this, path, this.#size)
    this.#datasets.set(path, made)
    return made
  }

  /** Text or numbers of an attribute; null if there is none of that name. */
  attribute(path: string, name: string): string | readonly number[] | null {
    if (!this.call(path, (m, id) => m.get_attribute_names(id, path)).includes(name)) return null
    const place = `${path}@${name}`
    const metadata = this.call(place, (m, id) => m.get_attribute_metadata(id, path, name))
    if (metadata.shape === null) return null
    const bytes = metadata.size * metadata.total_size
    if (!(bytes <= this.#size)) this.refuse(`${shown(place)} has ${bytes} bytes, more than the file.`)
    const type = numberTypeOf(metadata)
    return this.withMemory(bytes, pointer => {
      this.call(place, (m, id) => m.get_attribute_data(id, path, name, BigInt(pointer)))
      if (metadata.type === STRING) return this.texts(pointer, metadata)[0] ?? ''
      if (type === null) return null
      const list = new Float64Array(metadata.total_size)
      putNumbers(type, this.heap(pointer, bytes), false, list, 0)
      return Array.from(list)
    })
  }

  textAttribute(path: string, name: string): string | null {
    const value = this.attribute(path, name)
    return typeof value === 'string' ? value : null
  }

  /** The first number of an attribute; null if it has none. */
  numberAttribute(path: string, name: string): number | null {
    const value = this.attribute(path, name)
    return typeof value === 'object' ? (value?.[0] ?? null) : null
  }

  allocate(bytes: number): number {
    const pointer = bytes < 2 ** 31 ? this.#library.module._malloc(Math.max(1, bytes)) : 0
    if (pointer === 0) this.refuse(`reading it needs ${bytes} bytes at once, which there are not.`)
    return pointer
  }

  free(pointer: number): void {
    if (this.#library.isWhole) this.#library.module._free(pointer)
  }

  withMemory<T>(bytes: number, work: (pointer: number) => T): T {
    const pointer = this.allocate(bytes)
    try {
      return work(pointer)
    } finally {
      this.free(pointer)
    }
  }

  /** The library's memory: it holds until the next call. */
  heap(pointer: number, bytes: number): Uint8Array {
    return this.#library.module.HEAPU8.subarray(pointer, pointer + bytes)
  }

  /** Strings that have been read into memory: of one length, or pointers to them. Those are the library's and go with it. */
  texts(pointer: number, { size, total_size: count, vlen }: Metadata): string[] {
    if (!vlen) {
      const bytes = this.heap(pointer, size * count)
      return Array.from({ length: count }, (_, i) => textOf(bytes.subarray(size * i, size * (i + 1))))
    }
    const pointers = new Uint32Array(this.heap(pointer, size * count).slice().buffer)
    const { module } = this.#library
    return Array.from({ length: count }, (_, i) => (pointers[i] ? module.UTF8ToString(pointers[i] as number) : ''))
  }
}

/** A dataset: numbers in rows. */
export class Hdf5Dataset {
  readonly path: string
  readonly shape: readonly number[]
  /** Null if it has no numbers. */
  readonly type: NumberType | null
  /** All its numbers, those of a row's arrays among them. */
  readonly count: number
  readonly #file: Hdf5File
  readonly #metadata: Metadata
  readonly #rowBytes: number
  /** The name of a filter that the library does not have; null if there is none. */
  readonly #strange: string | null
  /** Rows that are read at once: whole chunks, so that none is unpacked twice. */
  readonly #rowsAtOnce: number
  /** Rows in the library's memory. */
  #kept: { readonly pointer: number; readonly from: number; readonly to: number } | null = null

  constructor(file: Hdf5File, path: string, fileSize: number) {
    this.#file = file
    this.path = path
    const metadata = file.call(path, (m, id) => m.get_dataset_metadata(id, path))
    this.#metadata = metadata
    const array = metadata.array_type
    this.shape = [...(metadata.shape ?? [0]), ...(metadata.type === ARRAY ? (array?.shape ?? []) : [])]
    this.type = metadata.virtual_sources === undefined ? numberTypeOf(metadata) : null
    this.count = this.shape.reduce((product, length) => product * length, 1)
    const bytes = metadata.size * metadata.total_size
    if (metadata.virtual_sources !== undefined)
      file.refuse(`the numbers of ${shown(path)} are in other files (a virtual dataset).`)
    const filters = file.call(path, (m, id) => m.get_dataset_filters(id, path))
    this.#strange = filters.find(({ id }) => id > LAST_FILTER)?.name ?? null
    const most = filters.length > 0 ? MOST_GROWTH * fileSize : fileSize
    const chunk = (metadata.chunks ?? []).reduce((product, length) => product * length, metadata.size)
    if (!(bytes <= most) || (bytes > 0 && metadata.chunks !== null && !(chunk <= most)))
      file.refuse(`${shown(path)} has ${bytes} bytes by its shape, more than the file can hold.`)
    const rows = metadata.shape?.[0] ?? 1
    this.#rowBytes = rows === 0 ? 0 : bytes / rows
    const step = metadata.chunks?.[0] ?? 1
    this.#rowsAtOnce = Math.max(1, Math.floor(AT_ONCE / Math.max(1, this.#rowBytes) / step)) * step
  }

  get isFloat32(): boolean {
    return this.type === 'Float32'
  }

  /** All its numbers as coordinates, or as whole numbers from 0 on; others are refused. */
  all<T extends NumberList>(List: new (length: number) => T): T {
    const list = new List(this.count)
    this.read(0, list)
    return list
  }

  /** Fills the list with numbers from `from` on, which must be there. */
  read(from: number, list: NumberList): void {
    const { type } = this
    if (type === null) this.#file.refuse(`${shown(this.path)} has no numbers.`)
    const size = sizeOf(type)
    for (let done = 0; done < list.length; ) {
      const at = size * (from + done)
      const { pointer, from: start, to } = this.#rows(Math.floor(at / this.#rowBytes))
      const begin = at - start * this.#rowBytes
      const bytes = this.#file.heap(
        pointer + begin,
        Math.min((to - start) * this.#rowBytes - begin, size * (list.length - done)),
      )
      // The library has put them in the order of its own memory.
      const bad = putNumbers(type, bytes, false, list, done)
      if (bad !== null)
        this.#file.refuse(
          `number ${from + done + bad.at} of ${shown(this.path)} is ${bad.value}; a whole number from 0 on was expected.`,
        )
      done += bytes.length / size
    }
  }

  /** Strings: characters along the last dimension, or one of a fixed or any length each. */
  strings(): readonly string[] {
    const { size, type, total_size: count, vlen } = this.#metadata
    const bytes = size * count
    if (bytes > MOST_TEXT) this.#file.refuse(`${shown(this.path)} has ${bytes} bytes of text.`)
    if (count === 0 || this.#metadata.shape === null) return []
    return this.#file.withMemory(bytes, pointer => {
      this.#readInto(null, pointer)
      if (type === STRING && (vlen || size > 1)) return this.#file.texts(pointer, this.#metadata)
      if (!(type === STRING || this.type === 'Int8' || this.type === 'UInt8')) return []
      const width = this.shape.at(-1) ?? bytes
      const all = this.#file.heap(pointer, bytes)
      return Array.from({ length: bytes / width }, (_, i) => textOf(all.subarray(width * i, width * (i + 1))))
    })
  }

  free(): void {
    if (this.#kept) this.#file.free(this.#kept.pointer)
    this.#kept = null
  }

  /** Rows in memory, `row` among them. */
  #rows(row: number): { readonly pointer: number; readonly from: number; readonly to: number } {
    if (this.#kept && row >= this.#kept.from && row < this.#kept.to) return this.#kept
    const rows = this.#metadata.shape?.[0] ?? 1
    const from = row - (row % this.#rowsAtOnce)
    const to = Math.min(rows, from + this.#rowsAtOnce)
    const pointer = this.#kept?.pointer ?? this.#file.allocate(Math.min(rows, this.#rowsAtOnce) * this.#rowBytes)
    this.#kept = { pointer, from, to: from }
    this.#readInto({ from, to }, pointer)
    this.#kept = { pointer, from, to }
    return this.#kept
  }

  #readInto(rows: { readonly from: number; readonly to: number } | null, pointer: number): void {
    if (this.#strange !== null)
      this.#file.refuse(`${shown(this.path)} is packed by the filter ${shown(this.#strange)}, which is not read.`)
    const shape = this.#metadata.shape ?? []
    const isWhole = rows === null || shape.length === 0
    const count = isWhole ? null : [rows.to - rows.from, ...shape.slice(1)].map(BigInt)
    const offset = isWhole ? null : [rows.from, ...shape.slice(1).map(() => 0)].map(BigInt)
    const strides = isWhole ? null : shape.map(() => 1n)
    const status = this.#file.call(this.path, (m, id) =>
      m.get_dataset_data(id, this.path, count, offset, strides, BigInt(pointer)),
    )
    if (status < 0) this.#file.refuse(`${shown(this.path)} cannot be read.`)
  }
}

export function within(group: string, name: string): string {
  return group === '/' ? `/${name}` : `${group}/${name}`
}

const INTEGERS = new Map<string, NumberType>([
  ['1true', 'Int8'],
  ['1false', 'UInt8'],
  ['2true', 'Int16'],
  ['2false', 'UInt16'],
  ['4true', 'Int32'],
  ['4false', 'UInt32'],
  ['8true', 'Int64'],
  ['8false', 'UInt64'],
])

function numberTypeOf({ type, size, signed, enum_type, array_type }: Metadata): NumberType | null {
  const own = type === ENUM ? enum_type?.type : type === ARRAY ? array_type?.type : type
  const bytes = type === ARRAY ? (array_type?.size ?? 0) : size
  if (own === INTEGER) return INTEGERS.get(`${bytes}${signed}`) ?? null
  if (own === FLOAT) return bytes === 8 ? 'Float64' : bytes === 4 ? 'Float32' : null
  return null
}

const decoder = new TextDecoder()

/** Up to the first zero, without blanks at the end. */
function textOf(bytes: Uint8Array): string {
  const end = bytes.indexOf(0)
  return decoder.decode(end < 0 ? bytes : bytes.subarray(0, end)).trimEnd()
}
