/** Sorts cells by a number each, many at once. */

const DIGITS = 1 << 16
const PASSES = 4

/**
 * The cells by rising keys, those with equal keys in the order in which they are given; -0 is 0, NaN comes last. Least digit first, 16
 * bits of the keys at a time: a million take a tenth of the time of a comparing sort.
 */
export function byRisingKey(cells: Uint32Array, keyOf: Float64Array): Uint32Array {
  const count = cells.length
  const keys = new Float64Array(count)
  for (let i = 0; i < count; ++i) keys[i] = (keyOf[cells[i] as number] as number) + 0
  const words = new Uint32Array(keys.buffer)
  // Bits that rise as unsigned integers do: all turned for negative numbers, the sign alone for others.
  for (let i = 0; i < count; ++i) {
    if (Number.isNaN(keys[i] as number)) {
      words[2 * i + LOW] = 0xffffffff
      words[2 * i + HIGH] = 0xffffffff
      continue
    }
    const high = words[2 * i + HIGH] as number
    const isNegative = high >>> 31 === 1
    words[2 * i + HIGH] = isNegative ? ~high : high ^ 0x80000000
    if (isNegative) words[2 * i + LOW] = ~(words[2 * i + LOW] as number)
  }
  const halves = new Uint16Array(keys.buffer)
  const half = (pass: number) => (HIGH === 1 ? pass : PASSES - 1 - pass)

  let places = new Uint32Array(count)
  for (let i = 0; i < count; ++i) places[i] = i
  let sorted = new Uint32Array(count)
  const starts = new Uint32Array(DIGITS + 1)
  for (let pass = 0; pass < PASSES; ++pass) {
    const at = half(pass)
    starts.fill(0)
    for (let i = 0; i < count; ++i) {
      const digit = halves[PASSES * i + at] as number
      starts[digit + 1] = (starts[digit + 1] as number) + 1
    }
    if (starts.includes(count, 1)) continue
    for (let digit = 1; digit <= DIGITS; ++digit)
      starts[digit] = (starts[digit] as number) + (starts[digit - 1] as number)
    for (let i = 0; i < count; ++i) {
      const place = places[i] as number
      const digit = halves[PASSES * place + at] as number
      const to = starts[digit] as number
      sorted[to] = place
      starts[digit] = to + 1
    }
    ;[places, sorted] = [sorted, places]
  }
  for (let i = 0; i < count; ++i) places[i] = cells[places[i] as number] as number
  return places
}

/** Words of a double, the low one first where the machine has it so. */
const LOW = new Uint8Array(Uint16Array.of(1).buffer)[0] === 1 ? 0 : 1
const HIGH = 1 - LOW
