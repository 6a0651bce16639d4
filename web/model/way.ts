/** The straight way from one element to another: every coordinate of A + tau (B - A), in doubles. */
import type { Vertices } from './hexahedron'

/** At 0 and 1 the two elements themselves, bit for bit; what is the same in both stays. `tau` is in [0,1]. */
export function elementAt(a: Vertices, b: Vertices, tau: number): Vertices {
  if (tau === 0) return a
  if (tau === 1) return b
  return a.map((from, i) => {
    const to = b[i] as number
    const difference = to - from
    // The difference of two huge numbers may not be a double.
    return Number.isFinite(difference) ? from + tau * difference : (1 - tau) * from + tau * to
  })
}

/** Where an element is on the way, bit for bit; `guess` is looked at first. Null where it is not found on it. */
export function placeOnWay(a: Vertices, b: Vertices, element: Vertices, guess: number): number | null {
  const moves = a.map((from, i) => Math.abs((b[i] as number) - from))
  const most = moves.indexOf(Math.max(...moves))
  const [from, to, at] = [a[most] as number, b[most] as number, element[most] as number]
  const solved = Math.max(0, Math.min(1, (at - from) / (to - from))) || 0
  const isHere = (tau: number) => elementAt(a, b, tau).every((value, i) => Object.is(value, element[i]))
  return [guess, 0, 1, solved].find(isHere) ?? null
}
