/** The names of entities on the page. */
import { edgeName, faces } from '../model/hexahedron'
import type { Entity } from './scene-slices'

/** "3", "0–1" or "−ζ". */
export function entityName({ kind, id }: Entity): string {
  if (kind === 'vertex') return String(id)
  if (kind === 'edge') return edgeName(id)
  return faces[id]?.name ?? ''
}

/** "Vertex 3", "Edge 0–1" or "Face −ζ". */
export function entityTitle(entity: Entity): string {
  return `${entity.kind[0]?.toUpperCase()}${entity.kind.slice(1)} ${entityName(entity)}`
}

/** "1", "1 and 2", "1, 2 and 3". */
export function listed(names: readonly string[]): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`
}
