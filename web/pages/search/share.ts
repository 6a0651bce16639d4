/**
 * How large a share of a distribution's elements has the property, judged by the elements that were
 * drawn: bounds with 95 % confidence.
 *
 * Each of n elements has the property with probability p, independently. None has it with
 * probability (1 - p)^n. Were p above 1 - 0.05^(1/n), that would happen in less than 5 % of all
 * searches: where none was found, this is the bound. Since 0.05^(1/n) = exp(ln(0.05)/n) and
 * 1 - exp(-x) < x, it is below -ln(0.05)/n = 2.9957.../n, the rule of three. It holds whenever the
 * reader stops: for a given p, it is wrong for the first time at one n, and to get there without a
 * find has a probability below 5 %.
 *
 * Where k were found, the bounds are those of C. Clopper and E. Pearson (1934): so many finds or
 * more have a probability of 2.5 % at the lower bound, so many or fewer at the upper one. They hold
 * for a number of elements that does not depend on the finds.
 */

/** Both are shares, from 0 to 1. */
export interface ShareBounds {
  readonly least: number
  readonly greatest: number
}

const DOUBT = 0.05

/** `found` of `drawn` elements, one at least. */
export function shareBounds(found: number, drawn: number): ShareBounds {
  if (found === 0) return { least: 0, greatest: boundOfNone(drawn, DOUBT) }
  if (found === drawn) return { least: 1 - boundOfNone(drawn, DOUBT), greatest: 1 }
  const rest = drawn - found
  const share = found / drawn
  return {
    least: bisected(share, 0, p => probabilityOfAtMost(rest, drawn, 1 - p, p) > DOUBT / 2),
    greatest: bisected(share, 1, p => probabilityOfAtMost(found, drawn, p, 1 - p) > DOUBT / 2),
  }
}

/** The p with (1 - p)^n = doubt. */
function boundOfNone(drawn: number, doubt: number): number {
  return -Math.expm1(Math.log(doubt) / drawn)
}

/** The number next to where a claim ends that holds at `inside` and not at `outside`: the first beyond. */
function bisected(inside: number, outside: number, holds: (p: number) => boolean): number {
  for (;;) {
    const middle = (inside + outside) / 2
    if (middle === inside || middle === outside) return outside
    if (holds(middle)) inside = middle
    else outside = middle
  }
}

/**
 * Of probability p, and q = 1 - p, for p > k/n. Terms fall from the one of k on, each by the factor i q / ((n - i + 1) p) < 1,
 * which falls with i: what is left out is below the last term times 1 / (1 - factor).
 */
function probabilityOfAtMost(found: number, drawn: number, p: number, q: number): number {
  let sum = 1
  let term = 1
  for (let i = found; i > 0; --i) {
    const factor = (i * q) / ((drawn - i + 1) * p)
    term *= factor
    sum += term
    if (term < 1e-12 * sum * (1 - factor)) break
  }
  return sum * binomial(found, drawn, p, q)
}

/**
 * The probability of k among n, 0 < k < n. With n! = sqrt(2 pi n) n^n exp(s(n) - n) the powers
 * collect into n times the divergence of k/n from p, so that no large numbers are subtracted
 * (C. Loader, 2000).
 */
function binomial(k: number, n: number, p: number, q: number): number {
  const rest = n - k
  const exponent =
    stirlingError(n) - stirlingError(k) - stirlingError(rest) - deviance(k, n * p) - deviance(rest, n * q)
  return Math.sqrt(n / (2 * Math.PI * k * rest)) * Math.exp(exponent)
}

/** x ln(x/m) + m - x. */
function deviance(x: number, mean: number): number {
  return x * Math.log(x / mean) + mean - x
}

/** s(n) = ln(n!) - ln(sqrt(2 pi n) n^n exp(-n)): by its definition, and from 16 on by its series to 1e-13. */
function stirlingError(n: number): number {
  if (n < 16) {
    let logarithm = 0
    for (let i = 2; i <= n; ++i) logarithm += Math.log(i)
    return logarithm - (n + 0.5) * Math.log(n) + n - 0.5 * Math.log(2 * Math.PI)
  }
  const square = n * n
  return (1 / 12 - (1 / 360 - (1 / 1260 - 1 / (1680 * square)) / square) / square) / n
}

/** "At most 1 in 1,000,000 elements of this distribution has the property, with 95 % confidence." */
export function shareInWords(found: number, drawn: number): string {
  const { least, greatest } = shareBounds(found, drawn)
  const confidence = 'with 95 % confidence'
  if (found === 0)
    return `At most ${rounded(greatest, 'up')} of the elements of this distribution have the property, ${confidence}.`
  if (found === drawn)
    return `At least ${rounded(least, 'down')} of the elements of this distribution have the property, ${confidence}.`
  return `Of the elements of this distribution, ${rounded(least, 'down')} to ${rounded(greatest, 'up')} have the property, ${confidence}.`
}

/** Shares below this are written as "1 in so many". */
const SMALL = 1e-3
const DIGITS = 3

/** With three digits, rounded so that a bound stays one. */
function rounded(share: number, way: 'up' | 'down'): string {
  if (share === 0) return 'none'
  const isSmall = share < SMALL
  const value = isSmall ? 1 / share : 100 * share
  const unit = 10 ** (Math.floor(Math.log10(value)) + 1 - DIGITS)
  const isUp = (way === 'up') !== isSmall
  const digits = isUp ? Math.ceil(value / unit) : Math.floor(value / unit)
  const text = (unit < 1 ? digits / Math.round(1 / unit) : digits * unit).toLocaleString('en', {
    maximumSignificantDigits: DIGITS + 1,
  })
  return isSmall ? `1 in ${text}` : `${text} %`
}
