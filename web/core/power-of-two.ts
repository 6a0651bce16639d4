/** value * 2^exponent for any integer exponent, rounded where it is subnormal. */
export function timesPowerOfTwo(value: number, exponent: number): number {
  // Steps keep each factor among the doubles; beyond 4000 the result is 0 or infinite either way.
  let rest = Math.max(-4000, Math.min(4000, exponent))
  let result = value
  for (; rest > 1000; rest -= 1000) result *= 2 ** 1000
  for (; rest < -1000; rest += 1000) result *= 2 ** -1000
  return result * 2 ** rest
}
