/** The straight way from one element to another: every coordinate of A + tau (B - A), in doubles. */
import type { Vertices } from './hexahedron'

/** The elements themselves at 0 and 1, bit for bit; equal coordinates stay. `tau` is in [0,1]. */
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

/** The tau of an element on the way, bit for bit; `guess` is tried first. Null if there is none. */
export function tauOf(a: Vertices, b: Vertices, element: Vertices, guess: number): number | null {
  const moves = a.map((from, i) => Math.abs((b[i] as number) - from))
  const most = moves.indexOf(Math.max(...moves))
  const [from, to, at] = [a[most] as number, b[most] as number, element[most] as number]
  const solved = Math.max(0, Math.min(1, (at - from) / (to - from))) || 0
  const isHere = (tau: number) => elementAt(a, b, tau).every((value, i) => Object.is(value, element[i]))
  return [guess, 0, 1, solved].find(isHere) ?? null
}
