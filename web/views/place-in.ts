/**
 * Where a pointer is in a box, and how large the box is seen, whatever transforms, perspective and zoom its ancestors have, and
 * while they are animated: all is measured when it is asked for.
 *
 * Four empty children stand in the corners of the box, and the browser says where they are on the screen: P00 at the upper left,
 * P10 at the upper right, P01 at the lower left, P11. Transforms are projective, so the point (u, v) of the box, each in [0,1],
 * is seen at (A u + B v + P00) / (g u + h v + 1) with A = P10 - P00 + g P10 and B = P01 - P00 + h P01. At (1, 1) that is P11:
 * g (P10 - P11) + h (P01 - P11) = P00 - P10 - P01 + P11, two linear equations for g and h; both are 0 for an affine map. For a
 * point Q of the screen the same is linear in u and v: u (A - g Q) + v (B - h Q) = Q - P00.
 */

interface Vector {
  readonly x: number
  readonly y: number
}

type Pointed = Pick<MouseEvent, 'clientX' | 'clientY'>

const CORNERS = ['left:0;top:0', 'left:100%;top:0', 'left:0;top:100%', 'left:100%;top:100%']
const corners = new WeakMap<HTMLElement, readonly HTMLElement[]>()

/** Shares of the width and the height from the upper left of a positioned box; null if it is seen from its edge, or not at all. */
export function placeIn(box: HTMLElement, { clientX, clientY }: Pointed): Vector | null {
  const [p00, p10, p01, p11] = cornersOf(box)
  const [across, down] = [plus(p10, -1, p11), plus(p01, -1, p11)]
  const [g, h] = solved(across, down, plus(plus(p00, -1, p10), 1, plus(p11, -1, p01)))
  const q = { x: clientX, y: clientY }
  const a = plus(plus(p10, -1, p00), g, plus(p10, -1, q))
  const b = plus(plus(p01, -1, p00), h, plus(p01, -1, q))
  const [x, y] = solved(a, b, plus(q, -1, p00))
  return Number.isFinite(x) && Number.isFinite(y) ? { x, y } : null
}

/** CSS pixels of the screen to one of the box, along the side that is stretched most; 1 for a box that has just been hidden. */
export function stretchOf(box: HTMLElement): number {
  const [p00, p10, p01, p11] = cornersOf(box)
  const length = (from: Vector, to: Vector) => Math.hypot(to.x - from.x, to.y - from.y)
  const { clientWidth, clientHeight } = box
  if (clientWidth === 0 || clientHeight === 0) return 1
  const most = Math.max(length(p00, p10), length(p01, p11)) / clientWidth
  return Math.max(most, Math.max(length(p00, p01), length(p10, p11)) / clientHeight)
}

function cornersOf(box: HTMLElement): readonly [Vector, Vector, Vector, Vector] {
  let made = corners.get(box)
  if (!made) {
    made = CORNERS.map(place => {
      const corner = document.createElement('span')
      corner.style.cssText = `position:absolute;${place}`
      return corner
    })
    corners.set(box, made)
  }
  if (made[0]?.parentNode !== box) box.append(...made)
  return made.map(corner => corner.getBoundingClientRect()) as unknown as [Vector, Vector, Vector, Vector]
}

function plus(p: Vector, factor: number, q: Vector): Vector {
  return { x: p.x + factor * q.x, y: p.y + factor * q.y }
}

/** Solves u a + v b = c by Cramer's rule; not finite if a and b are parallel. */
function solved(a: Vector, b: Vector, c: Vector): readonly [number, number] {
  const det = a.x * b.y - a.y * b.x
  return [(c.x * b.y - c.y * b.x) / det, (a.x * c.y - a.y * c.x) / det]
}
