/**
 * The entries of a JSON list one by one, from bytes as they come: each is cut out by its brackets and strings and parsed alone, so that
 * neither the list nor its text is ever whole in memory. Linear in time.
 */
import { Refusal } from '../model/result'

/** An entry is no longer, in bytes. */
const LONGEST_ENTRY = 64 * 1024 * 1024

const [QUOTE, COMMA, BACKSLASH, OPEN_LIST, CLOSE_LIST, OPEN_OBJECT, CLOSE_OBJECT] = [34, 44, 92, 91, 93, 123, 125]
const [SPACE, TAB, LF, CR] = [32, 9, 10, 13]
const BYTE_ORDER_MARK = [0xef, 0xbb, 0xbf]

/** Throws a Refusal for what is not a list, or not JSON. */
export async function* jsonEntries(chunks: AsyncIterable<Buffer | string>): AsyncGenerator<unknown> {
  const list = new ListScanner()
  for await (const chunk of chunks) yield* list.take(typeof chunk === 'string' ? Buffer.from(chunk) : chunk)
  list.end()
}

class ListScanner {
  #stage: 'before' | 'list' | 'other' | 'after' = 'before'
  /** The entry so far, or whatever is no list. */
  #pending: Buffer[] = []
  #pendingLength = 0
  /** Bytes of the byte order mark. */
  #passed = 0
  #depth = 0
  #isInString = false
  #isEscaped = false
  #count = 0

  /** The entries that end in this chunk. */
  take(chunk: Buffer): unknown[] {
    const entries: unknown[] = []
    let at = this.#stage === 'before' ? this.#begin(chunk) : 0
    while (this.#stage === 'list' && at < chunk.length) {
      const end = this.#endOfEntry(chunk, at)
      this.#keep(chunk.subarray(at, end))
      at = end + 1
      if (end === chunk.length) break
      const text = this.#taken()
      const isClosed = chunk[end] === CLOSE_LIST
      if (isClosed) this.#stage = 'after'
      if (isClosed && this.#count === 0 && text.trim() === '') break
      entries.push(parsed(text, `entry ${this.#count++}`))
    }
    if (this.#stage === 'other') this.#keep(chunk.subarray(at))
    if (this.#stage === 'after' && chunk.subarray(at).toString('latin1').trim() !== '')
      throw new Refusal('The input is not JSON: there is more after the end of the list.')
    return entries
  }

  /** The index of the comma or bracket after the entry, or the length of the chunk. */
  #endOfEntry(chunk: Buffer, from: number): number {
    for (let at = from; at < chunk.length; ++at) {
      const byte = chunk[at] as number
      if (this.#isInString) {
        if (this.#isEscaped) this.#isEscaped = false
        else if (byte === BACKSLASH) this.#isEscaped = true
        else if (byte === QUOTE) this.#isInString = false
      } else if (byte === QUOTE) this.#isInString = true
      else if (byte === OPEN_LIST || byte === OPEN_OBJECT) this.#depth++
      else if (this.#depth > 0) {
        if (byte === CLOSE_LIST || byte === CLOSE_OBJECT) this.#depth--
      } else if (byte === COMMA || byte === CLOSE_LIST) return at
    }
    return chunk.length
  }

  end(): void {
    if (this.#stage === 'after') return
    if (this.#stage === 'list')
      throw new Refusal(`The input is not JSON: it ends in entry ${this.#count}, before the end of the list.`)
    const value = parsed(this.#taken())
    throw new Refusal(`The input is ${described(value)}, not a list of hexahedra.`)
  }

  /** Skips the list's bracket, which may come in a later chunk; returns where to go on. */
  #begin(chunk: Buffer): number {
    for (let at = 0; at < chunk.length; ++at) {
      const byte = chunk[at] as number
      if (this.#passed < 3 && byte === BYTE_ORDER_MARK[this.#passed]) this.#passed++
      else if (byte !== SPACE && byte !== TAB && byte !== LF && byte !== CR) {
        this.#stage = byte === OPEN_LIST ? 'list' : 'other'
        return byte === OPEN_LIST ? at + 1 : at
      }
    }
    return chunk.length
  }

  #keep(bytes: Buffer): void {
    if (bytes.length === 0) return
    this.#pending.push(bytes)
    this.#pendingLength += bytes.length
    if (this.#pendingLength <= LONGEST_ENTRY) return
    const what = this.#stage === 'list' ? `Entry ${this.#count} is` : 'The input is no list, and'
    throw new Refusal(`${what} longer than ${LONGEST_ENTRY / 2 ** 20} MB.`)
  }

  #taken(): string {
    const text = Buffer.concat(this.#pending).toString('utf8')
    this.#pending = []
    this.#pendingLength = 0
    return text
  }
}

function parsed(text: string, where?: string): unknown {
  try {
    return JSON.parse(text)
  } catch (error) {
    // The engine quotes the text it stumbles on, line breaks and all.
    const reason = (error as Error).message.replace(/\s+/g, ' ')
    throw new Refusal(`The input is not JSON: ${where === undefined ? '' : `${where}: `}${reason}`)
  }
}

export function described(value: unknown): string {
  if (value === undefined) return 'missing'
  if (value === null) return 'null'
  if (Array.isArray(value)) return 'a list'
  return typeof value === 'object' ? 'an object' : `a ${typeof value}`
}
