/**
 * The HDF5 library in wasm, h5wasm: started, given a file of which it reads the parts that it wants, and called so that whatever goes wrong
 * in it becomes a reason in words. Loaded when an HDF5 file comes.
 */
import type { H5Module, Stream } from '../../../node_modules/h5wasm/dist/esm/hdf5_util.js'
import type { MeshFile } from '../source'
import { EndlessPart, FilePages } from './file-pages'

/** The library cannot do what it was asked: the reason is a clause. */
export class Complaint extends Error {}

/** The reasons that the library has written, the deepest last. */
const REASON = /^\s*#\d+: .*? in \S+\(\): (.+)$/
const CUT_OFF = /^truncated file: eof = (\d+), .*stored_eof = (\d+)/
const MOST_LINES = 500

export class Hdf5Library {
  readonly module: H5Module
  readonly #lines: string[]
  #files = 0
  /** The error of a file that could not be read in the middle of a call. */
  #thrown: { readonly error: unknown } | null = null
  /** False once it has crashed: its memory may be damaged then. */
  isWhole = true

  private constructor(module: H5Module, lines: string[]) {
    this.module = module
    this.#lines = lines
  }

  static async start(): Promise<Hdf5Library> {
    const lines: string[] = []
    const note = (line: string) => {
      if (lines.length < MOST_LINES) lines.push(line)
    }
    // A chunk without imports of its own: workers of a page share it.
    const { default: startModule } = await import('../../../node_modules/h5wasm/dist/esm/hdf5_util.js')
    return new Hdf5Library(await startModule({ noInitialRun: true, print: note, printErr: note }), lines)
  }

  /** Throws a Complaint, or what the file has thrown. */
  call<T>(work: (module: H5Module) => T): T {
    if (!this.isWhole) throw new Complaint('the library has failed before')
    this.#lines.length = 0
    let result: T
    try {
      result = work(this.module)
    } catch (error) {
      const thrown = this.#thrown
      this.#thrown = null
      // Errors of its own leave it whole; all others end it in the middle of something.
      if (thrown === null && error instanceof Error && error.name === 'Error')
        throw new Complaint(this.#reason() ?? 'the library gives no reason')
      this.isWhole = false
      if (thrown?.error instanceof EndlessPart) throw new Complaint(thrown.error.message)
      if (thrown !== null) throw thrown.error
      throw new Complaint(this.#reason() ?? 'the library fails on it')
    }
    if (this.#lines.length > 0) throw new Complaint(this.#reason() ?? 'the library gives no reason')
    return result
  }

  /** The path under which the library finds the file. */
  mount(file: MeshFile): string {
    const name = `file${this.#files++}`
    const pages = new FilePages(file)
    const node = this.module.FS.createFile('/', name, {}, true, false)
    Object.defineProperty(node, 'usedBytes', { value: file.size })
    node.stream_ops = {
      open() {},
      close() {},
      read: (_: Stream, heap: Int8Array, at: number, length: number, position: number) => {
        const count = Math.max(0, Math.min(length, file.size - position))
        try {
          pages.read(position, new Uint8Array(heap.buffer, at, count))
        } catch (error) {
          this.#thrown = { error }
          throw error
        }
        return count
      },
      llseek: (stream: Stream, offset: number, whence: number) =>
        offset + (whence === 1 ? stream.position : whence === 2 ? file.size : 0),
    }
    return `/${name}`
  }

  unmount(path: string): void {
    if (this.isWhole) this.module.FS.unlink(path)
  }

  #reason(): string | null {
    const reason = this.#lines.flatMap(line => REASON.exec(line)?.[1] ?? []).at(-1) ?? null
    const [, is, was] = CUT_OFF.exec(reason ?? '') ?? []
    return is === undefined ? reason : `it is cut off: of ${was} bytes it has ${is}`
  }
}
