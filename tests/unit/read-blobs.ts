/** Files whose bytes a test can read at once, as workers of a browser do: slices of them are real ones. */
import { vi } from 'vitest'

export class ReadFile extends File {
  readonly content: Uint8Array<ArrayBuffer>

  constructor(bytes: Uint8Array<ArrayBuffer>, name = 'made.vtu') {
    super([bytes], name)
    this.content = bytes
  }

  override slice(from = 0, to = this.size): ReadFile {
    return new ReadFile(this.content.slice(from, to), this.name)
  }
}

/** Takes the place of the browser's; returns how often, and how many bytes, it has read. */
export function stubFileReaderSync(): { times: number; bytes: number } {
  const read = { times: 0, bytes: 0 }
  vi.stubGlobal(
    'FileReaderSync',
    class {
      readAsArrayBuffer({ content }: ReadFile): ArrayBuffer {
        read.times++
        read.bytes += content.length
        return content.slice().buffer
      }
    },
  )
  return read
}
