import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { loadReadingCore } from '../../web/core/reading-core'
import { doubleOfDigits } from '../../web/mesh/decimal'
import { lineAt, NumberRun } from '../../web/mesh/number-run'
import { fileOfBytes } from '../../web/mesh/source'

const ways = [
  ['JavaScript', null],
  ['wasm', await loadReadingCore(readFileSync(new URL('../../build/hexlens-reading.wasm', import.meta.url)))],
] as const

const bytesOf = (text: string) => new TextEncoder().encode(text)
const fileOf = (text: string) => fileOfBytes('t', bytesOf(text))

/** Repeatable numbers from 0 to 1. */
function* randoms(seed: number): Generator<number, never> {
  for (let state = seed; ; ) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    yield state / 2 ** 32
  }
}

/** Numbers as text, of all lengths and sizes, and such that lie just beside the middle between two doubles. */
function hardNumbers(count: number, seed: number): string[] {
  const random = randoms(seed)
  const next = () => random.next().value
  const view = new DataView(new ArrayBuffer(8))
  return Array.from({ length: count }, (_, i) => {
    const value = (next() + next() * 2 ** -32) * 10 ** Math.floor(next() * 40 - 20)
    if (i % 4 === 0) return String(value)
    if (i % 4 === 1) return value.toExponential(Math.floor(next() * 21))
    if (i % 4 === 2) return `-${value.toFixed(Math.floor(next() * 20))}`
    // The middle between 1 + k 2^-52 and the next double, cut after 17 to 22 digits.
    view.setFloat64(0, 1 + Math.floor(next() * 2 ** 20) * 2 ** -52)
    const twice = 2n * (view.getBigUint64(0) & (2n ** 52n - 1n)) + 1n + 2n ** 53n
    const decimals = ((twice * 10n ** 30n) / 2n ** 53n).toString()
    const digits = 17 + Math.floor(next() * 6)
    return `${decimals.slice(0, 1)}.${decimals.slice(1, digits)}`
  })
}

test.each(ways)('doubles are those of Number, bit for bit, in %s', (_, core) => {
  const words = hardNumbers(100_000, 7)
  const list = new Float64Array(words.length)
  const run = new NumberRun(fileOf(words.join(' ')), 0, words.join(' ').length, core)
  expect(run.numbers(list, 0, list.length)).toBe(words.length)
  const wrong = words.filter((word, i) => !Object.is(Number(word), list[i]))
  expect(wrong).toEqual([])
})

test('what is not certain in two doubles is said to be so, and is rare', () => {
  const words = hardNumbers(40_000, 11).filter((_, i) => i % 4 === 1)
  const open = words.filter(word => {
    const [mantissa, exponent] = word.split('e') as [string, string]
    const power = Number(exponent) - (mantissa.split('.')[1]?.length ?? 0)
    const value = doubleOfDigits(bytesOf(mantissa), 0, mantissa.length, power)
    expect(Number.isNaN(value) || value === Number(word), word).toBe(true)
    return Number.isNaN(value)
  })
  expect(open.length).toBeLessThan(words.length / 100)
})

test.each(ways)(
  'a run ends before the word that does not fit, wherever the pieces of the file end, in %s',
  (_, core) => {
    const words = Array.from({ length: 400_000 }, (_, i) => String(i % 977))
    const text = `${words.join(' ')} nonsense`
    const file = fileOf(text)
    const indices = new NumberRun(file, 0, file.size, core)
    const list = new Uint32Array(words.length + 1)
    expect(indices.indices(list, 0, list.length)).toBe(words.length)
    expect(indices.nextWord()).toBe('nonsense')
    expect([...list.subarray(0, -1)].every((value, i) => value === i % 977)).toBe(true)
    const numbers = new NumberRun(file, 0, file.size, core)
    expect(numbers.numbers(new Float64Array(words.length + 1), 0, words.length + 1)).toBe(words.length)
    expect(numbers.position).toBe(text.length - 'nonsense'.length)
  },
)

test.each(ways)('signs, exponents in D and what is not finite, in %s', (_, core) => {
  const text = '+1 -2. .5 1d3 -1.5E-3 nan -inf 1e999 -nan(ind) 1.#INF 0x10'
  const list = new Float64Array(12)
  expect(new NumberRun(fileOf(text), 0, text.length, core).numbers(list, 0, 12)).toBe(10)
  expect([...list.subarray(0, 10)]).toEqual([1, -2, 0.5, 1000, -0.0015, NaN, -Infinity, Infinity, NaN, Infinity])
})

test.each(['1,5', '--1', '1e', '.', '1.2.3', 'e5', '1_000', '٣'])('%s is no number', word => {
  for (const [, core] of ways)
    expect(new NumberRun(fileOf(word), 0, bytesOf(word).length, core).numbers(new Float64Array(1), 0, 1)).toBe(0)
})

test.each(['-1', '1.0', '4294967296', '1e3'])('%s is no index', word => {
  for (const [, core] of ways)
    expect(new NumberRun(fileOf(word), 0, word.length, core).indices(new Uint32Array(1), 0, 1)).toBe(0)
})

test('lines are counted from 1', () => {
  const file = fileOf('a\nb\r\nc')
  expect([0, 1, 2, 5].map(at => lineAt(file, at))).toEqual([1, 1, 2, 3])
})
