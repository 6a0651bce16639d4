/** A small picture of eight points joined as their order says: the twelve edges, seen as the scene is at first. */
import { edgeVertices, type Vec3, type Vertices } from '../../model/hexahedron'
import { at, frameOf, verticesInView } from '../scene/view-frame'

export interface Wireframe {
  /** Where vertices 0 to 7 are, in a square from -1 to 1, y downwards. */
  readonly points: readonly { readonly x: number; readonly y: number }[]
  /** The edges as one path, in hundredths. */
  readonly path: string
}

/** The directions to the right and up, of a view from azimuth -58 and elevation 24 degrees. */
const [AZIMUTH, ELEVATION] = [-58, 24].map(degrees => (degrees * Math.PI) / 180) as [number, number]
const RIGHT: Vec3 = [-Math.sin(AZIMUTH), Math.cos(AZIMUTH), 0]
const UP: Vec3 = [
  -Math.sin(ELEVATION) * Math.cos(AZIMUTH),
  -Math.sin(ELEVATION) * Math.sin(AZIMUTH),
  Math.cos(ELEVATION),
]

export function wireframe(vertices: Vertices): Wireframe {
  const flat = verticesInView(frameOf(vertices), vertices).map(point => ({ x: dot(point, RIGHT), y: -dot(point, UP) }))
  const size = Math.max(...flat.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)])) || 1
  const points = flat.map(({ x, y }) => ({ x: x / size, y: y / size }))
  const path = edgeVertices.map(edge => `M${edge.map(v => pair(points[v] ?? { x: 0, y: 0 })).join('L')}`).join('')
  return { points, path }
}

function pair({ x, y }: { readonly x: number; readonly y: number }): string {
  return `${Math.round(100 * x)} ${Math.round(100 * y)}`
}

function dot(a: Vec3, b: Vec3): number {
  return at(a, 0) * at(b, 0) + at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2)
}
