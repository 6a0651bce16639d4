/**
 * The volume box at the probe: a little cube, and its image by the linear part of the map there. Its signed volume over the little
 * cube's is jacdet. If that is negative the box is inside out: the hatched insides of its faces are outside.
 */
import type { JacobianReport } from '../../core/report'
import { edgeVertices, faces, type Vec3, vertexReference } from '../../model/hexahedron'
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
  // Columns are numbers times 2^exponent of any size, so sizes are divided by a number from 1 to 2.
  const exponent = Math.floor(Math.log2(world.size))
  const size = timesPower(world.size, -exponent)
  const sides = columns.map(column =>
    map3(axis => timesPower((SIDE * at(column, axis)) / size, at(axisExponents, axis) - exponent)),
  )
  return vertexReference.map(corner =>
    map3(axis =>
      sides.reduce((sum, side, k) => sum + at(side, axis) * (at(corner, k) - at(point, k)), at(middle, axis)),
    ),
  )
}

/** x * 2^power, in two steps: 2^power alone may be no double though the product is. */
function timesPower(x: number, power: number): number {
  const half = Math.trunc(power / 2)
  return x * 2 ** half * 2 ** (power - half)
}

/** True for each face that is seen from outside, or of a box inside out from inside: of a convex body, by its turn on the screen. */
export function facesSeen(corners: readonly Point[], isInsideOut: boolean): readonly boolean[] {
  return faces.map(({ axis, side, vertices }) => {
    const [a, b, c, d] = vertices.map(v => corners[v]) as unknown as Quad
    const diagonals = turn(a, d, b, c)
    // s, t and the outward normal are right-handed on +xi, -eta and +zeta; y is downwards.
    const isRightHanded = (axis === 1) !== (side === 1)
    return (isRightHanded !== isInsideOut ? diagonals : -diagonals) < 0
  })
}

export class VolumeBox {
  readonly root = svg('g', { class: 'volume-box' })
  readonly #hidden = svg('path', { class: 'hidden' })
  readonly #faces = svg('path', { class: 'faces' })
  readonly #hatch = ['light', 'dark'].map(tone => svg('path', { class: `hatch ${tone}` }))
  readonly #halo = svg('path', { class: 'halo' })
  readonly #edges = svg('path', { class: 'visible' })

  constructor() {
    this.root.append(this.#faces, this.#hidden, ...this.#hatch, this.#halo, this.#edges)
  }

  /** Returns whether an edge, given by its corners, is hidden. */
  update(corners: readonly Point[], colour: string, isInsideOut: boolean): (edge: readonly number[]) => boolean {
    const seen = facesSeen(corners, isInsideOut)
    const isHidden = (edge: readonly number[]) =>
      !faces.some(({ vertices }, face) => seen[face] && edge.every(v => vertices.includes(v)))
    const path = (edges: typeof edgeVertices) =>
      edges.map(([from, to]) => line(corners[from] as Point, corners[to] as Point)).join('')
    const outlines = faces
      .filter((_, face) => seen[face])
      .map(({ vertices }) => vertices.map(v => corners[v]) as unknown as Quad)
    set(this.root, { color: colour })
    set(this.#faces, { d: outlines.map(([a, b, c, d]) => `M${[a, b, d, c].map(place).join('L')}Z`).join('') })
    set(this.#hidden, { d: path(edgeVertices.filter(isHidden)) })
    const edges = path(edgeVertices.filter(edge => !isHidden(edge)))
    for (const mark of [this.#halo, this.#edges]) set(mark, { d: edges })
    const stripes = isInsideOut ? outlines.map(stripesOn).join('') : ''
    for (const mark of this.#hatch) {
      show(mark, isInsideOut)
      set(mark, { d: stripes })
    }
    return isHidden
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
