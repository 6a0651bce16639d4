/** Numbers of an element as exactly as they can be said: a fraction, or that what is shown is rounded. */
import { numbers } from '../../core/quantities'
import type { Report } from '../../core/report'
import type { Condition } from '../../model/condition'
import { isNumberName, type NumberName } from '../../model/condition/names'
import type { Vertices } from '../../model/hexahedron'
import { isAtMost, magnitude, type Rational } from '../../model/rational'
import { numberInWords } from './words'

/** The element's numbers that are in the condition: "Corner minimum = 1/8" or "Boundary minimum ≈ −0.0106". */
export function exactNumbersInWords({ names }: Condition, report: Report, start: Vertices): string {
  const parts = names.map(name =>
    isNumberName(name) ? exactInWords(name, report, start) : report.valid ? 'it is valid' : 'it is invalid',
  )
  return parts.join(', ')
}

/** "Twist ≈ 177.2": one number. */
export function exactInWords(name: NumberName, report: Report, start: Vertices): string {
  const { lower, upper } = numbers[name].exactly(report, start)
  const fraction = isAtMost(upper, lower) ? shortFraction(lower) : null
  return fraction === null
    ? `${numbers[name].name} ≈ ${numberInWords(name, report, start)}`
    : `${numbers[name].name} = ${fraction}`
}

/** More digits are read worse than a rounded decimal. */
const MOST_DIGITS = 24

/** "−1/4", "3": in lowest terms; null if it is longer than people read. */
export function shortFraction({ numerator, denominator }: Rational): string | null {
  const common = greatestCommonDivisor(magnitude(numerator), denominator)
  const digits = [magnitude(numerator) / common, denominator / common].map(String)
  const text = digits[1] === '1' ? (digits[0] as string) : digits.join('/')
  return text.length > MOST_DIGITS ? null : `${numerator < 0n ? '−' : ''}${text}`
}

function greatestCommonDivisor(a: bigint, b: bigint): bigint {
  let [larger, smaller] = [a, b]
  while (smaller !== 0n) [larger, smaller] = [smaller, larger % smaller]
  return larger
}
