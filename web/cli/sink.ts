/** Files that are written: whole, or not at all. */
import { accessSync, closeSync, constants, openSync, renameSync, statSync, unlinkSync, writeSync } from 'node:fs'
import { dirname } from 'node:path'
import { cannotWrite } from './streams'

/** Small texts go to the disk together. */
const CHUNK = 1024 * 1024

/**
 * Writes to a file beside the one that is meant, which takes its place in the end, so that whoever looks never sees a part; what is no
 * plain file, such as a pipe, is written as it is. A failure is a Refusal, and leaves nothing behind.
 */
export class FileSink {
  readonly #path: string
  readonly #isReplaced: boolean
  readonly #partial: string
  #descriptor: number | null = null
  #pending: Uint8Array[] = []
  #pendingLength = 0
  readonly #discard = () => this.discard()
  readonly #interrupted = () => process.exit(130)

  /** Refuses a folder that is not there before a mesh is read in vain. */
  constructor(path: string) {
    this.#path = path
    try {
      this.#isReplaced = statSync(path, { throwIfNoEntry: false })?.isFile() ?? true
      accessSync(this.#isReplaced ? dirname(path) : path, constants.W_OK)
    } catch (error) {
      throw cannotWrite(path, error)
    }
    this.#partial = this.#isReplaced ? `${path}.${process.pid}.part` : path
  }

  write(chunk: string | Uint8Array): void {
    const bytes = typeof chunk === 'string' ? Buffer.from(chunk) : chunk
    this.#pending.push(bytes)
    this.#pendingLength += bytes.length
    if (this.#pendingLength >= CHUNK) this.#flush()
  }

  /** The file is there. */
  close(): void {
    this.#flush()
    this.#attempt(() => {
      if (this.#descriptor !== null) closeSync(this.#descriptor)
      this.#descriptor = null
      if (this.#isReplaced) renameSync(this.#partial, this.#path)
    })
    this.#forget()
  }

  /** Nothing is there; for what is closed, nothing changes. */
  discard(): void {
    if (this.#descriptor === null) return
    closeSync(this.#descriptor)
    this.#descriptor = null
    this.#forget()
    if (this.#isReplaced) unlinkSync(this.#partial)
  }

  #flush(): void {
    this.#attempt(() => {
      if (this.#descriptor === null) {
        this.#descriptor = openSync(this.#partial, 'w')
        process.on('exit', this.#discard)
        process.on('SIGINT', this.#interrupted)
      }
      const bytes = Buffer.concat(this.#pending)
      this.#pending = []
      this.#pendingLength = 0
      for (let done = 0; done < bytes.length; ) done += writeSync(this.#descriptor, bytes, done)
    })
  }

  #attempt(action: () => void): void {
    try {
      action()
    } catch (error) {
      this.discard()
      throw cannotWrite(this.#path, error)
    }
  }

  #forget(): void {
    process.off('exit', this.#discard)
    process.off('SIGINT', this.#interrupted)
  }
}
