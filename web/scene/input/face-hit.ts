/** The point of the faces, or of the section, that a line of sight meets first. */
import { pointOn } from '../../core/section'
import { type FaceTopology, faces, type Vec3, vertexReference } from '../../model/hexahedron'
import type { State } from '../../model/state'
import type { FaceDisplay, SceneState } from '../../views/scene-slices'
import type { Ray, SceneCamera, ScreenPoint } from '../space/camera'
import { type Corners, faceCorners, patchPoint, sectionCorners } from '../space/patches'
import { at, dot, map3 } from '../space/vec3'
import { pickHandle, pickRadius } from './picking'

export interface PatchHit {
  readonly s: number
  readonly t: number
  /** Along the ray, from its origin. */
  readonly distance: number
}

export interface FaceHit extends PatchHit {
  readonly face: number
}

/** A point this little outside a face still is on it, so that no line of sight slips between two; far less than a pixel. */
const OVERLAP = 1e-6
/** The side of [-1,1]^3 in world space, which the element fills. */
const ELEMENT_SIZE = 2
/** Faces of a collapsed element this close coincide, and the first one is painted. */
const COINCIDENT = 1e-9

/** The nearest hit of the faces that are shown; null if the ray meets none. */
export function hitFaces(vertices: readonly Vec3[], display: FaceDisplay, ray: Ray): FaceHit | null {
  let first: FaceHit | null = null
  for (let face = 0; face < faces.length; face++) {
    if (typeof display === 'number' && face !== display) continue
    for (const hit of hitsOf(faceCorners(vertices, face), ray)) {
      if (first === null || hit.distance < first.distance - COINCIDENT) first = { face, ...hit }
    }
  }
  return first
}

/** An element as it is seen: its vertices in world space, and on the screen. */
export interface Seen {
  readonly camera: SceneCamera
  readonly vertices: readonly Vec3[]
  readonly handles: readonly ScreenPoint[]
  readonly state: Pick<SceneState, 'faceDisplay' | 'section'> & Pick<State, 'selectedVertex'>
}

/**
 * (xi, eta, zeta) of the point under a pointer: the vertex whose handle is there, or else the first point of a face (of the section
 * if the inside is shown), its coordinates to the power of ten at or below the share of the element that is one pixel.
 */
export function pointUnder({ camera, vertices, handles, state }: Seen, x: number, y: number): Vec3 | null {
  const vertex = pickHandle(handles, { x, y }, pickRadius('mouse'), state.selectedVertex)
  if (vertex !== null) return vertexReference[vertex] as Vec3
  const ray = camera.ray(x, y)
  const { faceDisplay, section } = state
  const isInside = faceDisplay === 'inside'
  const hit = isInside ? nearest(hitsOf(sectionCorners(vertices, section), ray)) : hitFaces(vertices, faceDisplay, ray)
  if (hit === null) return null
  const depth = -hit.distance * dot(ray.direction, camera.axes()[2])
  const steps = 10 ** Math.max(0, Math.ceil(Math.log10(ELEMENT_SIZE / camera.lengthPerPixel(depth))))
  const rounded = (x: number) => Math.round(x * steps) / steps
  const [s, t] = [rounded(hit.s), rounded(hit.t)]
  return isFaceHit(hit) ? referenceOf({ face: hit.face, s, t }) : pointOn(section.axis, section.value, s, t)
}

function isFaceHit(hit: PatchHit | FaceHit): hit is FaceHit {
  return 'face' in hit
}

function nearest(hits: readonly PatchHit[]): PatchHit | null {
  return hits.reduce<PatchHit | null>((first, hit) => (first && first.distance <= hit.distance ? first : hit), null)
}

/** (xi, eta, zeta) of a point of a face. */
export function referenceOf({ face, s, t }: Pick<FaceHit, 'face' | 's' | 't'>): Vec3 {
  const { axis, side, s: sAxis } = faces[face] as FaceTopology
  return map3(k => (k === axis ? side : k === sAxis ? s : t))
}

/**
 * Every point of a bilinear patch on a ray, at most two. In the plane across the ray, with the ray as its origin, the lines of
 * constant s run from A(s) to B(s), both linear in s. One of them passes through the origin iff A(s) x B(s) = 0, a quadratic in s.
 */
function hitsOf(corners: Corners, ray: Ray): PatchHit[] {
  const [u, v] = across(ray.direction)
  const [a0, a1, b0, b1] = corners.map((corner): Point2 => {
    const offset = map3(axis => at(corner, axis) - at(ray.origin, axis))
    return [dot(offset, u), dot(offset, v)]
  }) as [Point2, Point2, Point2, Point2]
  const hits: PatchHit[] = []
  for (const root of bernsteinRoots(cross(a0, b0), (cross(a0, b1) + cross(a1, b0)) / 2, cross(a1, b1))) {
    const a = mix(a0, a1, root)
    const b = mix(b0, b1, root)
    const t = nearestToOrigin(a, b)
    const s = onFace(root)
    const tOn = onFace(t)
    if (s === null || tOn === null) continue
    const point = patchPoint(corners, s, tOn)
    const distance = dot(
      map3(axis => at(point, axis) - at(ray.origin, axis)),
      ray.direction,
    )
    if (distance > 0) hits.push({ s, t: tOn, distance })
  }
  return hits
}

type Point2 = readonly [number, number]

/** Two unit vectors at right angles to a unit vector and to each other. */
function across(d: Vec3): readonly [Vec3, Vec3] {
  const axis = d.reduce((least, x, k) => (Math.abs(x) < Math.abs(at(d, least)) ? k : least), 0)
  const along = at(d, axis)
  const length = Math.sqrt(1 - along * along)
  const u = map3(k => ((k === axis ? 1 : 0) - along * at(d, k)) / length)
  return [u, [d[1] * u[2] - d[2] * u[1], d[2] * u[0] - d[0] * u[2], d[0] * u[1] - d[1] * u[0]]]
}

function cross([ax, ay]: Point2, [bx, by]: Point2): number {
  return ax * by - ay * bx
}

function mix(a: Point2, b: Point2, share: number): Point2 {
  return [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share]
}

/** The parameter of the line's point nearest to the origin, from a to b; 0 if the line is a point. */
function nearestToOrigin(a: Point2, b: Point2): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]]
  const square = dx * dx + dy * dy
  return square > 0 ? -(a[0] * dx + a[1] * dy) / square : 0
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
