/** What parts of the element are called on the page. */
import { edgeName, faces } from '../model/hexahedron'
import type { ElementPart } from '../model/state'

/** "3", "0–1" or "−ζ". */
export function partName({ kind, id }: ElementPart): string {
  if (kind === 'vertex') return String(id)
  if (kind === 'edge') return edgeName(id)
  return faces[id]?.name ?? ''
}

/** "Vertex 3", "Edge 0–1" or "Face −ζ". */
export function partTitle(part: ElementPart): string {
  return `${part.kind[0]?.toUpperCase()}${part.kind.slice(1)} ${partName(part)}`
}

/** "1", "1 and 2", "1, 2 and 3". */
export function listed(names: readonly string[]): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`
}
