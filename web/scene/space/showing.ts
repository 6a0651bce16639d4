/** The direction from which a point of the boundary is seen best, and the way of a camera there. */
import type { Vec3 } from '../../model/hexahedron'
import { azimuthOf, DEFAULT_DIRECTION, directionAt, elevationOf, type SceneCamera } from './camera'
import { Sight } from './sight'
import { dot } from './vec3'

/**
 * Even over the sphere, some 14 degrees apart, along a spiral by the golden angle; not from straight above or below, where no
 * line of the picture would be upright.
 */
const TRIED = Array.from({ length: 256 }, (_, i) => directionAt(2.4 * i, Math.asin(0.95 * (1 - (2 * i + 1) / 256))))

/** A direction's worth is the mean cosine at which the point's faces turn to the eye, and this share of the turn's own cosine. */
const NEARNESS = 0.5

/** A point is clear to see if all its faces turn to the eye by this cosine, as the top of a cube does from the default direction. */
const CLEAR = 0.4

/**
 * Of the directions tried, the best one from which the camera, fitted to the element, sees the point; null if faces hide it from
 * all. `isLazy` says that `from` will do if the point is clear to see from there. The camera is left anywhere.
 */
export function directionTo(
  point: Vec3,
  vertices: readonly Vec3[],
  camera: SceneCamera,
  from: Vec3 = DEFAULT_DIRECTION,
  isLazy = false,
): Vec3 | null {
  const normals = new Sight(vertices, camera, 'opaque').normalsAt(point)
  const cosines = (direction: Vec3) => normals.map(normal => Math.abs(dot(normal, direction)))
  const sees = (direction: Vec3) => {
    camera.fit(vertices, direction)
    return !new Sight(vertices, camera, 'opaque').hides(point)
  }
  if (isLazy && Math.min(...cosines(from)) >= CLEAR && sees(from)) return from
  let best: Vec3 | null = null
  let most = -Infinity
  for (const direction of [from, ...TRIED]) {
    const facing = cosines(direction).reduce((sum, cosine) => sum + cosine, 0) / Math.max(normals.length, 1)
    const worth = facing + NEARNESS * dot(direction, from)
    if (worth <= most || !sees(direction)) continue
    best = direction
    most = worth
  }
  return best
}

/** The direction a share of the way from one to another: level where both are, and the shorter way round. */
export function directionBetween(from: Vec3, to: Vec3, share: number): Vec3 {
  const turn = azimuthOf(to) - azimuthOf(from)
  const shorter = Math.atan2(Math.sin(turn), Math.cos(turn))
  const rise = elevationOf(to) - elevationOf(from)
  return directionAt(azimuthOf(from) + share * shorter, elevationOf(from) + share * rise)
}
