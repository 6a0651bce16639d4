/** Records of bytes, all of one size, in chunks. */
import { PIECE } from './mesh-part'

/** Puts a number where it begins. */
export type PutNumber = (view: DataView, at: number, value: number) => void

/** `put` writes a record, counted from 0, where it begins. */
export function* records(
  count: number,
  size: number,
  put: (view: DataView, at: number, record: number) => void,
): Generator<Uint8Array> {
  const most = Math.ceil((8 * PIECE) / size)
  for (let from = 0; from < count; from += most) {
    const own = Math.min(most, count - from)
    const bytes = new Uint8Array(own * size)
    const view = new DataView(bytes.buffer)
    for (let i = 0; i < own; ++i) put(view, i * size, from + i)
    yield bytes
  }
}
