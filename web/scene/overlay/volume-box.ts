/**
 * The volume box at the probe: a little cube, and its image by the linear part of the map there. Its signed volume over the little
 * cube's is jacdet. If that is negative the box is inside out: the hatched insides of its faces are outside.
 */
import { timesPowerOfTwo } from '../../core/power-of-two'
import type { JacobianReport } from '../../core/report'
import { edgeVertices, type FaceTopology, faces, type Vec3, vertexReference } from '../../model/hexahedron'
import { HATCH_PERIOD } from '../paint/colour-map'
import { px, set, show, svg } from '../paint/svg'
import type { Point } from '../space/layout'
import { at, map3 } from '../space/vec3'
import { toWorld, type World } from '../space/world'

/**
 * The little cube's side, large enough to be seen. A column of DF is a mean of four edge vectors, so no side of the box is longer than
 * a quarter of the element's longest edge.
 */
export const SIDE = 1 / 4

/**
 * The corners in world space, in the order of the vertices. The little cube is [0,1]^3 shrunk towards the point, so it is inside at any
 * point, and on the same face.
 */
export function boxCorners(
  { point, position, columns, axisExponents }: Omit<JacobianReport, 'jacdet' | 'exponent'>,
  world: World,
): readonly Vec3[] {
  const middle = toWorld(world, position)
  // A column may be twice the greatest double; a quarter of it never overflows.
  const sides = columns.map(column =>
    map3(axis => timesPowerOfTwo(SIDE * at(column, axis), at(axisExponents, axis)) / world.size),
  )
  return vertexReference.map(corner =>
    map3(axis =>
      sides.reduce((sum, side, k) => sum + at(side, axis) * (at(corner, k) - at(point, k)), at(middle, axis)),
    ),
  )
}

/** The faces seen from outside, or of a box inside out from inside: of a convex body, by their turn on the screen. */
export function facesSeen(corners: readonly Point[], isInsideOut: boolean): readonly FaceTopology[] {
  return faces.filter(({ axis, side, vertices }) => {
    const [a, b, c, d] = vertices.map(v => corners[v]) as unknown as Quad
    // s, t and the outward normal are right-handed on +xi, -eta and +zeta; y is downwards.
    const isRightHanded = (axis === 1) !== (side === 1)
    return (isRightHanded !== isInsideOut ? 1 : -1) * turn(a, d, b, c) < 0
  })
}

export class VolumeBox {
  readonly root = svg('g', { class: 'volume-box' })
  readonly #halo = svg('path', { class: 'halo' })
  readonly #faces = svg('path', { class: 'faces' })
  /** Dashed: solid where the outline of a face is under them. */
  readonly #edges = svg('path', { class: 'hidden' })
  readonly #hatch = svg('path', { class: 'hatch' })

  constructor() {
    this.root.append(this.#halo, this.#faces, this.#edges, this.#hatch)
  }

  /** Returns whether an edge, given by its corners, is hidden. */
  update(corners: readonly Point[], colour: string, isInsideOut: boolean): (edge: readonly number[]) => boolean {
    const seen = facesSeen(corners, isInsideOut)
    const quads = seen.map(({ vertices }) => vertices.map(v => corners[v]) as unknown as Quad)
    const outlines = quads.map(([a, b, c, d]) => `M${[a, b, d, c].map(place).join('L')}Z`).join('')
    set(this.root, { color: colour })
    for (const mark of [this.#halo, this.#faces]) set(mark, { d: outlines })
    set(this.#edges, {
      d: edgeVertices.map(([from, to]) => line(corners[from] as Point, corners[to] as Point)).join(''),
    })
    show(this.#hatch, isInsideOut)
    if (isInsideOut) set(this.#hatch, { d: quads.map(stripesOn).join('') })
    return edge => !seen.some(({ vertices }) => edge.every(v => vertices.includes(v)))
  }
}

/** A face's corners, by s and t: 00, 10, 01, 11. */
type Quad = readonly [Point, Point, Point, Point]

function place({ x, y }: Point): string {
  return `${px(x)} ${px(y)}`
}

function line(from: Point, to: Point): string {
  return `M${place(from)}L${place(to)}`
}

/** Stripes along which s + t is the same, as far from each other as those on the faces of the element. */
function stripesOn([a, b, c, d]: Quad): string {
  const between = (p: Point, q: Point, way: number) => ({ x: p.x + (q.x - p.x) * way, y: p.y + (q.y - p.y) * way })
  const across = Math.abs(turn(a, d, b, c)) / (Math.hypot(c.x - b.x, c.y - b.y) || 1)
  const count = Math.max(1, Math.round(across / HATCH_PERIOD))
  return Array.from({ length: count }, (_, i) => {
    const sum = (2 * i + 1) / count
    return sum <= 1
      ? line(between(a, b, sum), between(a, c, sum))
      : line(between(b, d, sum - 1), between(c, d, sum - 1))
  }).join('')
}

/** The cross product of the ways from a to b and from c to d. */
function turn(a: Point, b: Point, c: Point, d: Point): number {
  return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x)
}
