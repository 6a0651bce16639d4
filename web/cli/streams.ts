/** The streams of a command. Whatever fails there becomes a Refusal. */
import { Refusal } from '../model/result'

export interface Streams {
  readonly input: AsyncIterable<Buffer | string>
  /** A promise that it returns is waited for. */
  readonly output: { write(text: string): unknown }
  readonly errors: { write(text: string): unknown; readonly isTTY?: boolean }
}

export function processStreams(): Streams {
  const { stdin, stdout, stderr } = process
  // Callers of `write` learn of the error.
  stdout.on('error', () => {})
  stderr.on('error', () => {})
  const write = (text: string) =>
    new Promise<void>((resolve, reject) => {
      stdout.write(text, error => (error ? reject(cannotWrite('Standard output', error)) : resolve()))
    })
  return { input: stdin, output: { write }, errors: stderr }
}

const REASONS: Readonly<Record<string, string>> = {
  EACCES: 'permission is denied',
  EDQUOT: 'the disk quota is used up',
  EISDIR: 'it is a folder',
  ENOENT: 'it is not there',
  ENOSPC: 'the disk is full',
  ENOTDIR: 'there is no such folder',
  EPIPE: 'whoever read it has closed it',
}

export function cannotWrite(what: string, error: unknown): Refusal {
  const isMissing = (error as NodeJS.ErrnoException).code === 'ENOENT'
  return new Refusal(`${what} cannot be written: ${isMissing ? REASONS.ENOTDIR : reasonOf(error)}.`)
}

export function reasonOf(error: unknown): string {
  const { code, message } = error as NodeJS.ErrnoException
  return (code === undefined ? undefined : REASONS[code]) ?? code ?? message.replace(/\s+/g, ' ')
}

/** Text goes out in pieces of this size. */
const CHUNK = 1024 * 1024

/** Holds text back until there is enough of it; what is not flushed is never written. */
export class Buffered {
  readonly #output: { write(text: string): unknown }
  #texts: string[] = []
  #length = 0

  constructor(output: { write(text: string): unknown }) {
    this.#output = output
  }

  async write(text: string): Promise<void> {
    this.#texts.push(text)
    this.#length += text.length
    if (this.#length >= CHUNK) await this.flush()
  }

  async flush(): Promise<void> {
    if (this.#length === 0) return
    const text = this.#texts.join('')
    this.#texts = []
    this.#length = 0
    await this.#output.write(text)
  }
}
