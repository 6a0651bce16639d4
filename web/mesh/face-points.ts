/**
 * The four points of a face in an order of their own, whichever of them is named first and whichever way round they are. Of points in cyclic
 * order the two diagonals are pairs without an order, and so are the two together: the least point lies on one of them with its opposite, the
 * lesser and the greater on the other. If the lesser is the least point as well, the opposite is the lesser of the two that may be.
 *
 * Exchanges are without branches, which no processor foretells in a mesh out of order: (x - y) >> 31 is -1 if x < y, else 0. Engines put
 * these functions into the loops that call them, and what they have in common is reckoned once.
 */

export function leastOf(a: number, b: number, c: number, d: number): number {
  return least(least(a, c), least(b, d))
}

export function lesserOf(a: number, b: number, c: number, d: number): number {
  const p = least(a, c)
  const q = least(b, d)
  return p ^ q ^ least(p, q)
}

export function oppositeOf(a: number, b: number, c: number, d: number): number {
  const p = least(a, c)
  const q = least(b, d)
  const r = a ^ c ^ p
  const s = b ^ d ^ q
  if (p === q) return least(r, s)
  return r ^ ((r ^ s) & ((q - p) >> 31))
}

function least(x: number, y: number): number {
  return y ^ ((x ^ y) & ((x - y) >> 31))
}
