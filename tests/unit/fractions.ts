/** Exact fractions of decimals and of doubles, to compare a report with answers of 40 digits. */

export interface Fraction {
  readonly numerator: bigint
  readonly denominator: bigint
}

/** The fraction of "-4.7683715820402444311e-7" and the like. */
export function ofDecimal(text: string): Fraction {
  const match = /^(-?)(\d+)(?:\.(\d*))?(?:[eE]([+-]?\d+))?$/.exec(text)
  if (!match) throw new Error(`${text} is not a decimal.`)
  const [, sign = '', whole = '', decimals = '', power = '0'] = match
  const integer = BigInt(`${sign}${whole}${decimals}`)
  return timesPower({ numerator: integer, denominator: 1n }, 10n, Number(power) - decimals.length)
}

/** The fraction value * 2^exponent. */
export function ofDouble(value: number, exponent = 0): Fraction {
  let mantissa = value
  let power = exponent
  while (!Number.isInteger(mantissa)) {
    mantissa *= 2
    power--
  }
  return timesPower({ numerator: BigInt(mantissa), denominator: 1n }, 2n, power)
}

function timesPower({ numerator, denominator }: Fraction, base: bigint, power: number): Fraction {
  const factor = base ** BigInt(Math.abs(power))
  return power < 0 ? { numerator, denominator: denominator * factor } : { numerator: numerator * factor, denominator }
}

export function difference(a: Fraction, b: Fraction): Fraction {
  return {
    numerator: a.numerator * b.denominator - b.numerator * a.denominator,
    denominator: a.denominator * b.denominator,
  }
}

export function size({ numerator, denominator }: Fraction): Fraction {
  return { numerator: numerator < 0n ? -numerator : numerator, denominator }
}

export function isAtMost(a: Fraction, b: Fraction): boolean {
  return a.numerator * b.denominator <= b.numerator * a.denominator
}

export function times({ numerator, denominator }: Fraction, factor: number): Fraction {
  const { numerator: n, denominator: d } = ofDouble(factor)
  return { numerator: numerator * n, denominator: denominator * d }
}
