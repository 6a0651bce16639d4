/**
 * Numbers as text, the same on the page and on the command line. A jacdet is a double times 2^exponent (see report.ts) and
 * may lie far outside the doubles, so every rounding here is of the exact value, in integers: half to even unless a side is
 * named, no libm.
 */

import type { Vec3 } from './hexahedron'
import { bitLength, dyadicOf } from './rational'
import type { ReferenceCube } from './state'

/** A value in decimal: its significant digits, none for zero. */
interface Rounded {
  readonly negative: boolean
  readonly digits: string
  /** Decimal exponent of the first digit. */
  readonly power: number
}

/** Rounding to the nearest text, half to even, or never below or never above the value. */
export type Rounding = 'nearest' | 'up' | 'down'

/** Significant digits of a number on the page; it is never rounded coarser than to an integer. */
const SHOWN_DIGITS = 5
/** Significant digits of a bound, which says how large an error may be. */
const BOUND_DIGITS = 2
/** Powers of ten of the first digit that are written without an exponent. */
const PLAIN_POWERS = { least: -4, most: 8 }

/**
 * mantissa * 2^exponent with `digits` significant digits, such as "3.8812762608604486e+450"; zero is "0".
 * `exponent` is any integer. Throws RangeError for a mantissa that is not finite.
 */
export function decimalOf(mantissa: number, exponent: number, digits: number): string {
  const { negative, digits: text, power } = rounded(mantissa, exponent, digits)
  if (text === '') return '0'
  const point = text.length > 1 ? '.' : ''
  return `${negative ? '-' : ''}${text[0]}${point}${text.slice(1)}e${power < 0 ? '-' : '+'}${Math.abs(power)}`
}

/** Far from the ends of the doubles, 2^-1074 and 2^1024. */
const SMALL_EXPONENT = 400
const [SMALL, LARGE] = [2 ** -500, 2 ** 500]

/** mantissa * 2^exponent where that is exactly a double, else null. Throws RangeError for a mantissa that is not finite. */
export function asDouble(mantissa: number, exponent: number): number | null {
  // The product is exact, as neither overflow nor underflow is near.
  if (Math.abs(exponent) < SMALL_EXPONENT && Math.abs(mantissa) < LARGE && Math.abs(mantissa) > SMALL)
    return mantissa * powerOfTwo(exponent)
  const binary = binaryOf(mantissa)
  if (binary.integer === 0n) return mantissa
  let { integer } = binary
  let power = binary.exponent + exponent
  while ((integer & 1n) === 0n) {
    integer >>= 1n
    power++
  }
  if (power < -1074 || power + bitLength(integer) > 1024) return null
  return Math.sign(mantissa) * Number(integer) * powerOfTwo(power)
}

/** A number to be read: "1.25", "−0.02083", "3.88×10⁻¹²"; true minus sign, no trailing zeros, zero has no sign. */
export function formatNumber(value: number): string {
  return shownText(value, 0)
}

/** A bound of an error, in the units of formatJacdet: two significant digits, rounded up, so that it still is one. */
export function formatBound(value: number, exponent: number, cube: ReferenceCube): string {
  return written(rounded(value, exponentOn(cube, exponent), BOUND_DIGITS, 'up'))
}

/** A number to be heard: formatNumber's digits in ASCII, "-0.02083" or "3.88e-12". */
export function speakNumber(value: number): string {
  return spoken(formatNumber(value))
}

/** "(1/2, 1/4, 0.3183)": a point, its coordinates as fractions where they are exact ones. */
export function formatPoint(point: Vec3): string {
  return `(${point.map(value => fractionOf(value) ?? formatNumber(value)).join(', ')})`
}

/**
 * A double that is exactly p/2^k with k from 1 to 6, p odd and |p| < 1000, as "−1/16"; else null. Larger ones read
 * worse than decimals.
 */
export function fractionOf(value: number): string | null {
  if (Number.isInteger(value)) return null
  for (let denominator = 2; denominator <= 64; denominator *= 2) {
    const numerator = value * denominator
    if (Number.isInteger(numerator) && Math.abs(numerator) < 1000) return `${signed(numerator)}/${denominator}`
  }
  return null
}

/** A report's jacdet, value * 2^exponent, on the reference cube chosen: a fraction where it is one, else as formatNumber. */
export function formatJacdet(
  value: number,
  exponent: number,
  cube: ReferenceCube,
  rounding: Rounding = 'nearest',
): string {
  const power = exponentOn(cube, exponent)
  const double = asDouble(value, power)
  return (double === null ? null : fractionOf(double)) ?? shownText(value, power, rounding)
}

/** A report's jacdet to be heard: always a decimal, as speakNumber. */
export function speakJacdet(value: number, exponent: number, cube: ReferenceCube): string {
  return spoken(shownText(value, exponentOn(cube, exponent)))
}

/** A report's jacdet for a program: the shortest text of the double that it is, or 17 digits of what is no double. */
export function jacdetInFull(value: number, exponent: number, cube: ReferenceCube): string {
  const power = exponentOn(cube, exponent)
  const double = asDouble(value, power)
  return double === null ? decimalOf(value, power, 17) : String(double)
}

/** The map from [-1,1]^3 has an eighth of the jacdet. */
function exponentOn(cube: ReferenceCube, exponent: number): number {
  return cube === 'unit' ? exponent : exponent - 3
}

function shownText(mantissa: number, exponent: number, rounding: Rounding = 'nearest'): string {
  return written(shownDigits(mantissa, exponent, rounding))
}

function written({ negative, digits, power }: Rounded): string {
  const text = digits.replace(/0+$/, '')
  if (text === '') return '0'
  const sign = negative ? '−' : ''
  if (power < PLAIN_POWERS.least || power > PLAIN_POWERS.most) {
    const fraction = text.length > 1 ? `.${text.slice(1)}` : ''
    return `${sign}${text[0]}${fraction}×10${superscript(power)}`
  }
  if (power < 0) return `${sign}0.${'0'.repeat(-power - 1)}${text}`
  const whole = text.slice(0, power + 1).padEnd(power + 1, '0')
  const fraction = text.slice(power + 1)
  return `${sign}${whole}${fraction ? `.${fraction}` : ''}`
}

function shownDigits(mantissa: number, exponent: number, rounding: Rounding): Rounded {
  const coarse = rounded(mantissa, exponent, SHOWN_DIGITS, rounding)
  const toUnits = coarse.power + 1
  return toUnits > SHOWN_DIGITS && coarse.power <= PLAIN_POWERS.most
    ? rounded(mantissa, exponent, toUnits, rounding)
    : coarse
}

/** A number as it is printed, in ASCII. */
export function spoken(text: string): string {
  return text
    .replace('×10', 'e')
    .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, digit => String(SUPERSCRIPTS.indexOf(digit)))
    .replace(/[−⁻]/g, '-')
}

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹'

/** "⁻¹²": an exponent to be read. */
export function superscript(power: number): string {
  const digits = [...String(Math.abs(power))].map(digit => SUPERSCRIPTS[Number(digit)]).join('')
  return power < 0 ? `⁻${digits}` : digits
}

function signed(integer: number): string {
  return integer < 0 ? `−${-integer}` : String(integer)
}

function rounded(mantissa: number, exponent: number, count: number, rounding: Rounding = 'nearest'): Rounded {
  const double = rounding === 'nearest' ? asDouble(mantissa, exponent) : null
  const quick = double === null ? null : roundedDouble(double, count)
  if (quick) return quick
  const binary = binaryOf(mantissa)
  const negative = mantissa < 0
  if (binary.integer === 0n) return { negative: false, digits: '', power: 0 }
  const twos = binary.exponent + exponent
  const numerator = binary.integer << BigInt(Math.max(twos, 0))
  const denominator = 1n << BigInt(Math.max(-twos, 0))

  // log10(2) to the digits that a guess needs; the loops correct it.
  let power = Math.floor((bitLength(binary.integer) + twos) * 0.30103)
  while (compareToPowerOfTen(numerator, denominator, power) < 0) power--
  while (compareToPowerOfTen(numerator, denominator, power + 1) >= 0) power++

  const shift = count - 1 - power
  const scaled = numerator * tens(shift)
  const unit = denominator * tens(-shift)
  let digits = scaled / unit
  const rest = scaled % unit
  const isPastHalf = 2n * rest > unit || (2n * rest === unit && (digits & 1n) === 1n)
  if (rounding === 'nearest' ? isPastHalf : rest > 0n && negative === (rounding === 'down')) digits++
  const text = String(digits)
  return text.length > count
    ? { negative, digits: text.slice(0, count), power: power + 1 }
    : { negative, digits: text, power }
}

/** The language's own rounding; null at a possible tie, which it does not round to even. */
function roundedDouble(value: number, count: number): Rounded | null {
  if (value === 0 || Math.abs(value).toExponential(count).includes('5e')) return null
  const [digits = '', power] = Math.abs(value)
    .toExponential(count - 1)
    .split('e')
  return { negative: value < 0, digits: digits.replace('.', ''), power: Number(power) }
}

function compareToPowerOfTen(numerator: bigint, denominator: bigint, power: number): number {
  const left = numerator * tens(-power)
  const right = denominator * tens(power)
  return left < right ? -1 : left > right ? 1 : 0
}

/** 10^power, or 1 where the power belongs on the other side of a quotient. */
function tens(power: number): bigint {
  return power > 0 ? 10n ** BigInt(power) : 1n
}

const words = new DataView(new ArrayBuffer(8))

/** |value| = integer * 2^exponent, exactly. */
function binaryOf(value: number): ReturnType<typeof dyadicOf> {
  if (!Number.isFinite(value)) throw new RangeError(`${value} is not a finite number.`)
  return dyadicOf(Math.abs(value))
}

/** 2^power for power in [-1074, 1023], exactly. */
function powerOfTwo(power: number): number {
  words.setBigUint64(0, power < -1022 ? 1n << BigInt(power + 1074) : BigInt(power + 1023) << 52n)
  return words.getFloat64(0)
}
