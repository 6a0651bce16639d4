/** Exact fractions of decimals, to compare a report with answers of 40 digits. */
import { magnitude, negated, type Rational, sumOf } from '../../web/model/rational'

/** The value of "-4.7683715820402444311e-7" and the like. */
export function ofDecimal(text: string): Rational {
  const match = /^(-?)(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d+))?$/.exec(text)
  if (!match) throw new Error(`${text} is not a decimal.`)
  const [, sign = '', whole = '', decimals = '', power = '0'] = match
  const numerator = BigInt(`${sign}${whole}${decimals}`)
  const exponent = Number(power) - decimals.length
  const factor = 10n ** BigInt(Math.abs(exponent))
  return exponent < 0 ? { numerator, denominator: factor } : { numerator: numerator * factor, denominator: 1n }
}

export function difference(a: Rational, b: Rational): Rational {
  return sumOf(a, negated(b))
}

export function size({ numerator, denominator }: Rational): Rational {
  return { numerator: magnitude(numerator), denominator }
}
