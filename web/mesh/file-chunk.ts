/** A chunk of a file after another, in memory that is used again. */
import type { MeshFile } from './source'

export class FileChunk {
  #memory = new Uint8Array(0)

  /** The bytes `kept`, which are the end of what came last or others, and behind them those of the file from `from` to `to`. */
  next(file: MeshFile, kept: Uint8Array, from: number, to: number): Uint8Array<ArrayBuffer> {
    const length = kept.length + to - from
    const memory = length > this.#memory.length ? new Uint8Array(length + (length >> 3)) : this.#memory
    memory.set(kept)
    const room = memory.subarray(kept.length, length)
    const read = file.read(from, to, room)
    if (read.buffer !== memory.buffer) room.set(read)
    this.#memory = memory
    return memory.subarray(0, length)
  }
}
