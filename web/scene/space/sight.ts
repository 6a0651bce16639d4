/** Lines of sight from one eye: the points at which they meet bilinear patches, and so the points that faces hide. */
import { type FaceTopology, faces, type Vec3 } from '../../model/hexahedron'
import { drawnFaces, type FaceDisplay } from '../../views/scene-slices'
import type { SceneCamera } from './camera'
import { type Corners, elementPoint, faceCorners, patchNormal } from './patches'
import { at, cross, dot, map3, mix, way } from './vec3'

export interface PatchHit {
  readonly s: number
  readonly t: number
  /** From the eye, in lengths of the direction. */
  readonly distance: number
}

/** A patch whose corners are relative to the eye, and what all lines of sight to it have in common. */
export interface SeenPatch {
  readonly corners: Corners
  readonly products: readonly [Vec3, Vec3, Vec3]
}

/** A point this little outside a face still is on it, so that no line of sight slips between two; far less than a pixel. */
const OVERLAP = 1e-6

/**
 * With the eye as the origin, the patch's lines of constant s run from A(s) to B(s), both linear in s. One of them meets the line
 * of sight along d iff det(A(s), B(s), d) = 0: a quadratic in s, whose Bernstein coefficients are the products times d.
 */
export function seenPatch(eye: Vec3, corners: Corners): SeenPatch {
  const own = corners.map(corner => way(eye, corner)) as unknown as Corners
  const [a0, a1, b0, b1] = own
  return { corners: own, products: [cross(a0, b0), mix(cross(a0, b1), cross(a1, b0), 0.5), cross(a1, b1)] }
}

/** Every point of a patch on the line of sight, at most two. */
export function hitsOf({ corners: [a0, a1, b0, b1], products: [p0, p1, p2] }: SeenPatch, direction: Vec3): PatchHit[] {
  const hits: PatchHit[] = []
  const [c0, c1, c2] = [dot(p0, direction), dot(p1, direction), dot(p2, direction)]
  // Of one sign: no root between 0 and 1, nor within the overlap, at whose end the quadratic is c0 - 2 OVERLAP c1 or so.
  if (Math.min(c0 * c1, c2 * c1) > 4 * OVERLAP * c1 * c1) return hits
  for (const root of bernsteinRoots(c0, c1, c2)) {
    const s = onFace(root)
    if (s === null) continue
    const a = mix(a0, a1, s)
    const along = way(a, mix(b0, b1, s))
    const across = cross(along, direction)
    const square = dot(across, across)
    const aside = cross(a, direction)
    const t = square > 0 ? onFace(-dot(aside, across) / square) : isOnSight(aside, a, direction) ? 0 : null
    if (t === null) continue
    const distance = (dot(a, direction) + t * dot(along, direction)) / dot(direction, direction)
    if (distance > 0) hits.push({ s, t, distance })
  }
  return hits
}

/** What the faces hide from a camera's eye. */
export class Sight {
  readonly #vertices: readonly Vec3[]
  readonly #camera: SceneCamera
  readonly #eye: Vec3
  readonly #patches: readonly SeenPatch[]

  /** The vertices in world space. Nothing is hidden by faces that one can look through. */
  constructor(vertices: readonly Vec3[], camera: SceneCamera, display: FaceDisplay, hidden: readonly number[] = []) {
    const { x, y, z } = camera.three.position
    this.#vertices = vertices
    this.#camera = camera
    this.#eye = [x, y, z]
    this.#patches = drawnFaces(display, hidden)
      .filter(face => display === 'opaque' || display === face)
      .map(face => seenPatch(this.#eye, faceCorners(vertices, face)))
  }

  /** The position of (xi, eta, zeta) in world space. */
  positionOf(point: Vec3): Vec3 {
    return elementPoint(this.#vertices, point)
  }

  /**
   * True if a face lies between the eye and the point (xi, eta, zeta), by more than the length of a pixel: less cannot be told from
   * the picture. The point's own faces meet its line of sight there, but for rounding, which is worst where the line touches a
   * face: at distances up to R the coefficients of the quadratic are off by 2^-51 R^2, and a double root by R 2^-25 / sqrt(k), where
   * k is the face's twist across the line. A pixel is R / 2^11 long or more, so that is less for every k above 2^-27.
   */
  hides(point: Vec3): boolean {
    const position = this.positionOf(point)
    const direction = way(this.#eye, position)
    const pixel = this.#camera.lengthPerPixel(this.#camera.depth(position))
    const nearest = 1 - pixel / Math.sqrt(dot(direction, direction))
    return this.#patches.some(patch => hitsOf(patch, direction).some(({ distance }) => distance < nearest))
  }

  /** The normals, of length 1, of the faces that a point of the boundary lies on; none where a face is a point or a line. */
  normalsAt(point: Vec3): Vec3[] {
    const normals: Vec3[] = []
    for (const [face, { axis, side, s, t }] of faces.entries() as Iterable<[number, FaceTopology]>) {
      if (point[axis] !== side) continue
      const normal = patchNormal(faceCorners(this.#vertices, face), point[s], point[t])
      const length = Math.sqrt(dot(normal, normal))
      if (length > 0) normals.push(map3(k => at(normal, k) / length))
    }
    return normals
  }
}

/**
 * True if a is on the line of sight, but for the overlap. A line from A(s) to B(s) that is a point, as between coincident vertices, or
 * parallel to the line of sight, makes the quadratic 0 for every line of sight, also for those that do not meet it.
 */
function isOnSight(aside: Vec3, a: Vec3, direction: Vec3): boolean {
  return dot(aside, aside) <= OVERLAP * OVERLAP * dot(a, a) * dot(direction, direction)
}

function onFace(x: number): number | null {
  return x >= -OVERLAP && x <= 1 + OVERLAP ? Math.max(0, Math.min(1, x)) : null
}

/**
 * Roots of c0 (1-s)^2 + 2 c1 s (1-s) + c2 s^2 without cancellation: with p = c0 - c1 and the discriminant c1^2 - c0 c2, one root is
 * q / (c0 - 2 c1 + c2) and the other c0 / q, q = p + sign(p) sqrt(discriminant). None where all coefficients vanish: the face
 * is seen edge on.
 */
export function bernsteinRoots(c0: number, c1: number, c2: number): number[] {
  const discriminant = c1 * c1 - c0 * c2
  if (!(discriminant >= 0)) return []
  const p = c0 - c1
  const q = p + (p < 0 ? -1 : 1) * Math.sqrt(discriminant)
  const roots = [q / (c0 - 2 * c1 + c2), c0 / q]
  return roots.filter(Number.isFinite)
}
