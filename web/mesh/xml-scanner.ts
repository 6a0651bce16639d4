/**
 * The tags of an XML file, one after the other, straight from its bytes: linear in time, constant in memory. No tree is built and no entity
 * resolved but the five that XML itself has; a document type, where others are defined, is refused.
 */
import { MeshRefusal } from './mesh'
import type { MeshFile } from './source'
import { shown } from './text-cursor'
import { wordTable } from './word-table'

/** Bytes that are read at once, and at first: tags may be all that is wanted. */
const CHUNK = 1024 * 1024
const FIRST_CHUNK = 64 * 1024
/** A tag is no longer. */
const LONGEST_TAG = 64 * 1024

const [QUOTE, APOSTROPHE, LESS, GREATER] = [34, 39, 60, 62] as const

/** A document type that defines nothing, as XDMF files have it. */
const PLAIN_DOCTYPE = /^<!DOCTYPE[^<>[\]]*(?:\[\s*\]\s*)?>/
const LONGEST_DOCTYPE = 400

export interface XmlTag {
  readonly kind: 'open' | 'close'
  readonly name: string
  readonly attributes: ReadonlyMap<string, string>
  /** True if it ends itself: <name/>. */
  readonly isEmpty: boolean
  /** The bytes of the tag in the file. */
  readonly from: number
  readonly to: number
}

const ENTITIES: Readonly<Record<string, string>> = wordTable({ amp: '&', lt: '<', gt: '>', quot: '"', apos: "'" })
const decoder = new TextDecoder()

export class XmlScanner {
  readonly #file: MeshFile
  #bytes: Uint8Array = new Uint8Array(0)
  #start = 0
  /** The byte of the file that is next. */
  position = 0

  constructor(file: MeshFile) {
    this.#file = file
  }

  refuse(at: number, what: string): never {
    throw new MeshRefusal(`${this.#file.name}, byte ${at}: ${what}`)
  }

  /** The next tag, or null at the end of the file; comments, instructions and text before it are passed. */
  next(): XmlTag | null {
    for (;;) {
      const from = this.indexOf(LESS, this.position)
      if (from < 0) {
        this.position = this.#file.size
        return null
      }
      const begin = this.#text(from, 9)
      if (begin.startsWith('<!--')) this.#passUntil('-->', from + 4, from)
      else if (begin.startsWith('<?')) this.#passUntil('?>', from + 2, from)
      else if (begin === '<![CDATA[') this.#passUntil(']]>', from + 9, from)
      else if (!begin.startsWith('<!')) return this.#tag(from)
      else if (PLAIN_DOCTYPE.test(this.#text(from, LONGEST_DOCTYPE))) this.#passUntil('>', from + 2, from)
      else this.refuse(from, 'a document type or an entity is not read: a mesh needs none.')
    }
  }

  /** The next index of this byte, from `at` on; -1 if there is none. */
  indexOf(byte: number, at: number): number {
    for (let from = at; from < this.#file.size; from = this.#start + this.#bytes.length) {
      this.#load(from, 1)
      const found = this.#bytes.indexOf(byte, from - this.#start)
      if (found >= 0) return this.#start + found
    }
    return -1
  }

  /** Makes sure that bytes [from, from + count) are held, as far as the file has them. */
  #load(from: number, count: number): void {
    const end = this.#start + this.#bytes.length
    if (from >= this.#start && Math.min(from + count, this.#file.size) <= end) return
    this.#start = from
    const chunk = from === 0 ? FIRST_CHUNK : CHUNK
    this.#bytes = this.#file.read(from, Math.min(this.#file.size, from + Math.max(chunk, count)))
  }

  #text(from: number, count: number): string {
    this.#load(from, count)
    return String.fromCharCode(...this.#bytes.subarray(from - this.#start, from - this.#start + count))
  }

  /** Every one of these ends is a `>` with its bytes before. */
  #passUntil(end: string, at: number, from: number): void {
    for (let found = this.indexOf(GREATER, at); found >= 0; found = this.indexOf(GREATER, found + 1)) {
      if (found - end.length + 1 < at || this.#text(found - end.length + 1, end.length) !== end) continue
      this.position = found + 1
      return
    }
    this.refuse(from, `what begins with “<” here ends nowhere: the file is cut off.`)
  }

  #tag(from: number): XmlTag {
    const end = this.#endOfTag(from, 1) ?? this.#endOfTag(from, LONGEST_TAG)
    const bytes = this.#bytes
    const first = from - this.#start
    if (end === null) {
      const isLong = first + LONGEST_TAG < bytes.length
      this.refuse(from, isLong ? 'a tag is longer than tags of a mesh are.' : 'the file is cut off inside of a tag.')
    }
    if (bytes[end] === LESS) this.refuse(from, 'a tag begins inside of a tag.')
    this.position = this.#start + end + 1
    return this.#parsed(decoder.decode(bytes.subarray(first + 1, end)), from)
  }

  /** The place of a tag's end, or of another's beginning in it, among the bytes that are held, `count` at least; null if there is none. */
  #endOfTag(from: number, count: number): number | null {
    this.#load(from, count)
    const bytes = this.#bytes
    const first = from - this.#start
    const last = Math.min(bytes.length, first + LONGEST_TAG)
    let quote = 0
    for (let end = first + 1; end < last; ++end) {
      const byte = bytes[end]
      if (quote !== 0) {
        if (byte === quote) quote = 0
      } else if (byte === QUOTE || byte === APOSTROPHE) quote = byte
      else if (byte === GREATER || byte === LESS) return end
    }
    return null
  }

  #parsed(text: string, from: number): XmlTag {
    const to = this.position
    const isClose = text.startsWith('/')
    const isEmpty = text.endsWith('/')
    const inner = text.slice(isClose ? 1 : 0, isEmpty ? -1 : undefined)
    const name = /^[^\s"'=/]+/.exec(inner)?.[0]
    if (name === undefined) this.refuse(from, 'a tag has no name.')
    const attributes = new Map<string, string>()
    const one = /\s*([^\s"'=]+)\s*=\s*(?:"([^"]*)"|'([^']*)')/y
    one.lastIndex = name.length
    let end = name.length
    for (let match = one.exec(inner); match !== null; match = one.exec(inner)) {
      end = one.lastIndex
      attributes.set(match[1] as string, unescaped(match[2] ?? match[3] ?? ''))
    }
    if (inner.slice(end).trim() !== '')
      this.refuse(from, `${shown(inner.slice(end).trim())} in <${shown(name).slice(1, -1)}> is no attribute.`)
    return { kind: isClose ? 'close' : 'open', name, attributes, isEmpty, from, to }
  }
}

function unescaped(value: string): string {
  return value.replace(/&([a-z]{2,4});/g, (whole, name) => ENTITIES[name] ?? whole)
}
