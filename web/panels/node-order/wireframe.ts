/** A small picture of the edges of eight points in an order, seen as the scene is at first. */
import { edgeVertices, type Vertices } from '../../model/hexahedron'
import { seen } from '../../scene/paint/plain-view'
import { verticesInWorld, worldOf } from '../../scene/space/world'

export interface Wireframe {
  /** Vertices 0 to 7, in a square from -1 to 1, y downwards. */
  readonly points: readonly { readonly x: number; readonly y: number }[]
  /** The edges as one path, in hundredths. */
  readonly path: string
}

export function wireframe(vertices: Vertices): Wireframe {
  const flat = verticesInWorld(worldOf(vertices), vertices).map(seen)
  const size = Math.max(...flat.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)])) || 1
  const points = flat.map(({ x, y }) => ({ x: x / size, y: y / size }))
  const path = edgeVertices.map(edge => `M${edge.map(v => pair(points[v] ?? { x: 0, y: 0 })).join('L')}`).join('')
  return { points, path }
}

function pair({ x, y }: { readonly x: number; readonly y: number }): string {
  return `${Math.round(100 * x)} ${Math.round(100 * y)}`
}
