/** Setup of all unit tests: arrays of numbers that are equal are found so at once, where `toEqual` takes a second for a million. */
import { expect } from 'vitest'

type Numbers = ArrayLike<number | bigint>

const isTyped = (value: unknown): value is Numbers => ArrayBuffer.isView(value) && !(value instanceof DataView)

/** Undefined for what is not equal, which `toEqual` then describes. */
function equalNumbers(a: unknown, b: unknown): true | undefined {
  if (!isTyped(a) || !isTyped(b) || a.constructor !== b.constructor || a.length !== b.length) return undefined
  for (let i = 0; i < a.length; ++i) if (!Object.is(a[i], b[i])) return undefined
  return true
}

// Files of one worker share `expect`, and this runs for each of them.
const added = globalThis as { hexlensEqualNumbers?: true }
if (!added.hexlensEqualNumbers) expect.addEqualityTesters([equalNumbers])
added.hexlensEqualNumbers = true
