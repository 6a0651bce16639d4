/** The names of entities on the page. */
import { edgeName, faces } from '../model/hexahedron'
import { say } from '../words/say'
import type { Entity } from './scene-slices'

/** "3", "0–1" or "−ζ". */
export function entityName({ kind, id }: Entity): string {
  if (kind === 'vertex') return String(id)
  if (kind === 'edge') return edgeName(id)
  return faces[id]?.name ?? ''
}

/** "Vertex 3", "Edge 0–1" or "Face −ζ". */
export function entityTitle(entity: Entity): string {
  const name = entityName(entity)
  if (entity.kind === 'vertex') return say('Vertex {name}', { name })
  return entity.kind === 'edge' ? say('Edge {name}', { name }) : say('Face {name}', { name })
}
