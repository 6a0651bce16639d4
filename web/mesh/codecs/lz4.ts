/** LZ4 blocks, as VTK writes them: without a frame around. */
import { DamagedStream } from './inflate'

/** Fills `output` from a block that must have just so many bytes. */
export function unlz4(input: Uint8Array, output: Uint8Array): void {
  let at = 0
  let length = 0
  /** A length of 15 goes on in bytes, as long as these are 255. */
  const lengthFrom = (nibble: number): number => {
    let value = nibble
    if (nibble === 15) {
      for (let byte = 255; byte === 255; value += byte) {
        if (at >= input.length) throw new DamagedStream('ends early')
        byte = input[at++] as number
      }
    }
    return value
  }
  const checkRoom = (count: number): void => {
    if (length + count > output.length)
      throw new DamagedStream(`holds more than the ${output.length} bytes that are declared`)
  }
  while (at < input.length) {
    const token = input[at++] as number
    const literals = lengthFrom(token >> 4)
    if (at + literals > input.length) throw new DamagedStream('ends early')
    checkRoom(literals)
    if (literals > 0) output.set(input.subarray(at, at + literals), length)
    at += literals
    length += literals
    // The last sequence has literals alone.
    if (at === input.length) break
    if (at + 2 > input.length) throw new DamagedStream('ends early')
    const distance = (input[at] as number) | ((input[at + 1] as number) << 8)
    at += 2
    if (distance === 0 || distance > length) throw new DamagedStream('repeats what is before its beginning')
    const count = lengthFrom(token & 15) + 4
    checkRoom(count)
    for (const to = length + count; length < to; ++length) output[length] = output[length - distance] as number
  }
  if (length < output.length) throw new DamagedStream(`holds ${length} of the ${output.length} bytes that are declared`)
}
