/** The point of the faces, or of the section, that a line of sight meets first. */
import { pointOn } from '../../core/section'
import { type FaceTopology, faces, type Vec3, vertexReference } from '../../model/hexahedron'
import type { State } from '../../model/state'
import { drawnFaces, type FaceDisplay, type SceneState, type ScriptState } from '../../views/scene-slices'
import type { Ray, SceneCamera, ScreenPoint } from '../space/camera'
import { faceCorners, sectionCorners } from '../space/patches'
import { hitsOf, type PatchHit, seenPatch } from '../space/sight'
import { dot, map3 } from '../space/vec3'
import { pickHandle, pickRadius } from './picking'

export interface FaceHit extends PatchHit {
  readonly face: number
}

/** The side of [-1,1]^3 in world space, which the element fills. */
const ELEMENT_SIZE = 2
/** Faces of a collapsed element this close coincide, and the first one is painted. */
const COINCIDENT = 1e-9

/** The nearest hit of the faces that are shown; null if the ray meets none. */
export function hitFaces(
  vertices: readonly Vec3[],
  display: FaceDisplay,
  ray: Ray,
  hidden: readonly number[] = [],
): FaceHit | null {
  let first: FaceHit | null = null
  for (const face of drawnFaces(display, hidden)) {
    for (const hit of hitsOf(seenPatch(ray.origin, faceCorners(vertices, face)), ray.direction)) {
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
  readonly state: Pick<SceneState, 'faceDisplay' | 'section'> &
    Partial<Pick<ScriptState, 'hiddenFaces'>> &
    Pick<State, 'selectedVertex'>
}

/**
 * (xi, eta, zeta) of the point under a pointer: the vertex whose handle is there, or else the first point of a face (of the section
 * if the inside is shown), its coordinates to the power of ten at or below the share of the element that is one pixel.
 */
export function pointUnder({ camera, vertices, handles, state }: Seen, x: number, y: number): Vec3 | null {
  const vertex = pickHandle(handles, { x, y }, pickRadius('mouse'), state.selectedVertex)
  if (vertex !== null) return vertexReference[vertex] as Vec3
  const ray = camera.ray(x, y)
  const { faceDisplay, hiddenFaces, section } = state
  const isInside = faceDisplay === 'inside'
  const hit = isInside
    ? nearest(hitsOf(seenPatch(ray.origin, sectionCorners(vertices, section)), ray.direction))
    : hitFaces(vertices, faceDisplay, ray, hiddenFaces)
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
