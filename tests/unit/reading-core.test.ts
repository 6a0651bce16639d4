/** Numbers in text by hexlens-reading.wasm: bit for bit what Number() makes of them. */
import { readFileSync } from 'node:fs'
import { deflateSync } from 'node:zlib'
import { describe, expect, test } from 'vitest'
import { loadReadingCore } from '../../web/core/reading-core'
import { KNOWN_OF_PART, PART, RowPattern } from '../../web/core/reading-interface'
import { randomSource } from './core-fixtures'

const core = await loadReadingCore(readFileSync(new URL('../../build/hexlens-reading.wasm', import.meta.url)))
const bytesOf = (text: string) => new TextEncoder().encode(text)

/** The doubles that wasm reads from words. */
function read(words: readonly string[]): Float64Array {
  const bytes = bytesOf(`${words.join('\n')}\n`)
  const list = new Float64Array(words.length)
  const taken = core.numbers(bytes, 0, bytes.length, list, 0, list.length)
  expect(taken).toMatchObject({ count: words.length, bytes: bytes.length - 1 })
  return list
}

/** JavaScript has no D. */
function expectNumbers(words: readonly string[]): void {
  const list = read(words)
  const wrong = words.findIndex((word, i) => !Object.is(list[i], Number(word.replace(/d/i, 'e'))))
  expect(wrong < 0 ? '' : `${words[wrong]} became ${list[wrong]}`).toBe('')
}

/** The exact decimal number in the middle between a positive double and the next one. */
function middleAfter(value: number): string {
  const bits = new BigInt64Array(new Float64Array([value]).buffer)[0] as bigint
  const exponent = Number((bits >> 52n) & 2047n)
  const mantissa = (bits & (2n ** 52n - 1n)) + (exponent > 0 ? 2n ** 52n : 0n)
  const power = Math.max(exponent, 1) - 1075 - 1
  const middle = 2n * mantissa + 1n
  return power >= 0 ? `${middle * 2n ** BigInt(power)}` : `${middle * 5n ** BigInt(-power)}e${power}`
}

/** The same with one more or less in the last of many more places. */
function besides(middle: string): string[] {
  const [digits = '', exponent = '0'] = middle.split('e')
  return [1, 20, 200].flatMap(zeros => {
    const power = Number(exponent) - zeros
    const long = BigInt(digits) * 10n ** BigInt(zeros)
    return [`${long + 1n}e${power}`, `${long - 1n}e${power}`]
  })
}

describe('numbers', () => {
  test('as programs print them', () => {
    expectNumbers([
      ...[
        '0',
        '-0',
        '0.0',
        '-0.000e5',
        '1',
        '+1',
        '1.',
        '.5',
        '-.5',
        '1e5',
        '1E+05',
        '1.5D-3',
        '1d0',
        '1e-400',
        '-1e-400',
        '1e400',
      ],
      ...[
        '-1e400',
        '1e99999',
        '1e-99999',
        '1e999999999999',
        '0e999999999999',
        '00000000000000000000000000001',
        '0.1',
        '0.2',
        '0.3',
      ],
      ...['1.7976931348623157e308', '1.7976931348623158e308', '1.7976931348623159e308', '2.2250738585072014e-308'],
      ...['2.2250738585072011e-308', '4.9406564584124654e-324', '2.4703282292062327e-324', '2.4703282292062328e-324'],
      ...[
        '9007199254740993',
        '9007199254740992.99999999999999999999',
        '9007199254740993.00000000000000000001',
        '1e22',
        '1e23',
      ],
      ...[
        '123456789012345678901234567890',
        '0.000000000000000000000000000000000012345678901234567890',
        `0.${'0'.repeat(400)}1e400`,
      ],
      ...[
        `1${'0'.repeat(400)}e-400`,
        '9999999999999999999',
        '10000000000000000000',
        '18446744073709551615',
        '18446744073709551616',
      ],
    ])
  })

  test('in the middle of two doubles and beside it', () => {
    const random = randomSource(7)
    const words: string[] = []
    const bits = new BigUint64Array(1)
    const value = new Float64Array(bits.buffer)
    for (let i = 0; i < 400; ++i) {
      // Every fourth is subnormal.
      const exponent = BigInt(i % 4 === 0 ? 0 : Math.floor(random() * 2046))
      bits[0] =
        (exponent << 52n) | (BigInt(Math.floor(random() * 2 ** 26)) << 26n) | BigInt(Math.floor(random() * 2 ** 26))
      const middle = middleAfter(value[0] as number)
      words.push(middle, ...besides(middle))
    }
    for (const edge of [5e-324, 0, 2.2250738585072009e-308, 2.2250738585072014e-308, 1, 2 ** 53 - 1, Number.MAX_VALUE])
      words.push(middleAfter(edge), ...besides(middleAfter(edge)))
    expectNumbers(words)
  })

  test('of 1 to 800 digits', () => {
    const random = randomSource(8)
    const digits = (count: number) => Array.from({ length: count }, () => Math.floor(10 * random())).join('')
    const words = Array.from({ length: 3000 }, () => {
      const count = random() < 0.1 ? 1 + Math.floor(800 * random()) : 1 + Math.floor(24 * random())
      const power = Math.floor(700 * random() - 350) - (random() < 0.5 ? count : 0)
      const text = digits(count)
      const point = Math.floor(random() * (count + 1))
      return `${random() < 0.5 ? '-' : ''}${text.slice(0, point)}.${text.slice(point)}e${power}`
    })
    expectNumbers(words)
  })

  const count = Number(process.env.HEXLENS_NUMBERS ?? 200_000)
  test(`${count} of random bits, printed in 17 digits and in fewest`, () => {
    const random = randomSource(9)
    const bits = new Uint32Array(2)
    const value = new Float64Array(bits.buffer)
    for (let done = 0; done < count; done += 10_000) {
      const words = Array.from({ length: 10_000 }, (_, i) => {
        bits[0] = random() * 2 ** 32
        bits[1] = random() * 2 ** 32
        const number = Number.isFinite(value[0]) ? (value[0] as number) : 1 / 3
        const size = i % 3 === 0 ? number : (random() - 0.5) * 1000
        return i % 2 === 0 ? size.toPrecision(17) : String(size)
      })
      expectNumbers(words)
    }
  })

  test('end before a word that is none', () => {
    for (const word of ['nan', '1x', '1e', '-', '.', 'e5', '1e+', '--1', '1-3', '1,5', '0x10']) {
      const bytes = bytesOf(`1 2 ${word} 4`)
      const list = new Float64Array(4)
      expect(core.numbers(bytes, 0, bytes.length, list, 0, 4), word).toMatchObject({ count: 2, bytes: 3 })
    }
  })

  test('of a thousand bytes and more are left to others, where they begin', () => {
    const long = `1.${'0'.repeat(1500)}`
    for (const text of [`1 ${long} 3`, `1 ${long}${' 3'.repeat(5000)}`]) {
      const bytes = bytesOf(text)
      expect(core.numbers(bytes, 0, bytes.length, new Float64Array(3), 0, 3)).toMatchObject({ count: 1, bytes: 1 })
      expect(core.numbers(bytes, 2, bytes.length, new Float64Array(3), 0, 3)).toMatchObject({ count: 0, bytes: 0 })
    }
  })

  test('know how many digits they have', () => {
    const bytes = bytesOf('0.5 0.1250 12345678 0.30 00012.5')
    const taken = core.numbers(bytes, 0, bytes.length, new Float64Array(5), 0, 5)
    expect(taken).toMatchObject({ mostDigits: 4, mostRounded: 2 })
  })
})

test('whole numbers up to the largest of the list', () => {
  const bytes = bytesOf('0 255 256 4294967295 4294967296')
  expect(core.indices(bytes, 0, bytes.length, new Uint8Array(5), 0, 5)).toMatchObject({ count: 2, bytes: 5 })
  const list = new Uint32Array(5)
  expect(core.indices(bytes, 0, bytes.length, list, 0, 5)).toMatchObject({ count: 4 })
  expect([...list]).toEqual([0, 255, 256, 4294967295, 0])
})

describe('rows', () => {
  const read = (text: string, pattern: string) => {
    const bytes = bytesOf(text)
    const row = new RowPattern(pattern.split(' '))
    const { count, bytes: used, numbers, places } = core.rows(bytes, 0, bytes.length, row)
    const words = Array.from(places.subarray(0, count * row.realCount), place =>
      text.slice(place & 0xffffff, (place & 0xffffff) + (place >>> 24)),
    )
    return { numbers: [...numbers.subarray(0, count * row.numberCount)], rest: text.slice(used), words }
  }

  test('between blanks', () => {
    expect(read('1 0.5 2\n 7\t1e3 -4 \r\n8 1 2 3\n', 'whole real real end')).toEqual({
      numbers: [1, 0.5, 2, 7, 1000, -4],
      rest: '8 1 2 3\n',
      words: ['0.5', '2', '1e3', '-4'],
    })
  })

  test('between commas', () => {
    expect(read('1, 0.5,2\n 2 ,3., 4\n3, 5\n', 'whole , real , real end')).toMatchObject({
      numbers: [1, 0.5, 2, 2, 3, 4],
      rest: '3, 5\n',
    })
  })

  test('in columns, whose exponents may have no letter', () => {
    const text = 'GRID           1           1.0-3-1.5    .25\nGRID    2                      1       2\n'
    expect(read(text, '=GRID blank4 whole8 blank8 real8 real8 real8 end')).toEqual({
      numbers: [1, 0.001, -1.5, 0.25],
      rest: 'GRID    2                      1       2\n',
      words: ['1.0-3', '-1.5', '.25'],
    })
    expect(read(text.slice(0, -1), '=GRID blank4 whole8 blank8 real8 real8 real8 end').rest).toBe(text.slice(44, -1))
  })

  test('that the text cuts are not taken', () => {
    expect(read('1 2\n3 4', 'whole real end')).toMatchObject({ numbers: [1, 2], rest: '3 4' })
  })

  test('with a whole number that has a point, a sign or sixteen digits are not taken', () => {
    for (const word of ['1.', '-1', '+1', '1e2', '1234567890123456'])
      expect(read(`${word} 2\n`, 'whole real end').numbers, word).toEqual([])
  })
})

describe('integers of 64 bits', () => {
  /** As little-endian bytes at an odd place in memory with others around. */
  function bytesOfLong(list: ArrayLike<bigint>): Uint8Array {
    const own = new Uint8Array(BigUint64Array.from(list, value => BigInt.asUintN(64, value)).buffer)
    const memory = new Uint8Array(own.length + 9).fill(255)
    memory.set(own, 3)
    return memory.subarray(3, 3 + own.length)
  }

  function expectHalves(list: readonly bigint[], into?: Uint32Array<ArrayBuffer>): void {
    const { list: low, high, parts } = core.lowHalves(bytesOfLong(list), into)
    const signed = list.map(value => Number(BigInt.asIntN(32, value)))
    expect(Buffer.compare(Buffer.from(low.slice().buffer), Buffer.from(Int32Array.from(signed).buffer))).toBe(0)
    expect(high !== 0).toBe(list.some(value => BigInt.asUintN(64, value) >= 2n ** 32n))
    const expected: number[] = []
    for (let from = 0; from < signed.length; from += PART) {
      const own = signed.slice(from, from + PART)
      const steps = new Set(own.slice(1).map((value, i) => (value - (own[i] as number)) | 0))
      const step = steps.size === 1 ? ([...steps][0] as number) : 0
      expected.push(
        own.reduce((a, b) => Math.min(a, b)),
        own.reduce((a, b) => Math.max(a, b)),
        step,
      )
    }
    expect([...parts]).toEqual(expected)
    expect(parts.length).toBe(KNOWN_OF_PART * Math.ceil(list.length / PART))
  }

  const random = randomSource(12)
  const whole = (most: number) => BigInt(Math.floor(most * random()))
  /** Parts, and more than what goes into the memory at once, whole and not. */
  const lengths = [
    ...Array.from({ length: 41 }, (_, i) => i),
    PART,
    PART + 1,
    3 * PART - 5,
    2 ** 17,
    2 ** 17 + PART + 1,
  ]
  const kinds: Readonly<Record<string, (i: number) => bigint>> = {
    'below 2^31': () => whole(2 ** 31),
    'below 2^32': () => whole(2 ** 32),
    'with high halves': i => (i % 37 === 36 ? whole(2 ** 32) << 32n : whole(100)),
    negative: i => -1n - BigInt(i % 5),
    'in steps of 8': i => 8n * BigInt(i + 1),
    'in falling steps': i => 2n ** 31n - 1n - 3n * BigInt(i),
    alike: () => 2n ** 31n - 1n,
  }
  test.each(Object.entries(kinds))('%s', (_, value) => {
    for (const length of lengths) expectHalves(Array.from({ length }, (_, i) => value(i)))
  })

  test('one that is another in each place', () => {
    for (let length = 1; length <= 20; ++length)
      for (let at = 0; at < length; ++at)
        for (const other of [0n, 2n ** 31n - 1n, 2n ** 31n, 2n ** 32n, 2n ** 63n, -1n])
          expectHalves(Array.from({ length }, (_, i) => (i === at ? other : 8n * BigInt(i + 1))))
  })

  test('go into a part of a list that is there', () => {
    const memory = new Uint32Array(100).fill(9)
    expectHalves(
      Array.from({ length: 50 }, (_, i) => BigInt(i)),
      memory.subarray(20, 70),
    )
    expect([memory[19], memory[20], memory[69], memory[70]]).toEqual([9, 0, 49, 9])
  })
})

describe('zlib streams', () => {
  const random = randomSource(10)
  const kinds = {
    zeros: () => 0,
    text: () => 48 + Math.floor(10 * random()),
    noise: () => Math.floor(256 * random()),
    skewed: () => Math.floor(256 * random() ** 6),
  }
  test.each(Object.entries(kinds))('of %s, at all levels, and cut or damaged', (_, byte) => {
    for (const length of [0, 1, 300, 32_768, 200_000])
      for (const level of [0, 1, 6, 9]) {
        const bytes = Uint8Array.from({ length }, byte)
        const packed = new Uint8Array(deflateSync(bytes, { level, strategy: length === 300 ? 4 : 0 }))
        const output = new Uint8Array(length)
        expect(core.unzlib(packed, output)).toBe(true)
        expect(Buffer.compare(output, bytes)).toBe(0)
        expect(core.unzlib(packed, new Uint8Array(length + 1))).toBe(false)
        expect(core.unzlib(packed.subarray(0, -1), output)).toBe(false)
        if (length > 0) expect(core.unzlib(packed, new Uint8Array(length - 1))).toBe(false)
        for (let i = 0; i < 20; ++i) {
          const damaged = packed.slice()
          const at = Math.floor(random() * damaged.length)
          damaged[at] = (damaged[at] as number) ^ (1 << Math.floor(8 * random()))
          const isTaken = core.unzlib(damaged, output)
          if (isTaken) expect(Buffer.compare(output, bytes)).toBe(0)
        }
      }
  })
})
