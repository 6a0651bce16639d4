/** The coordinates of what the gallery shows. */
import type { Vertices } from '../../model/hexahedron'
import { presets, presetVertices } from '../../model/presets'
import type { GalleryElement } from './gallery'

export function elementVertices({ element }: Pick<GalleryElement, 'element'>): Vertices {
  if (typeof element !== 'string') return element.flat()
  const preset = presets.find(({ id }) => id === element)
  if (!preset) throw new Error(`There is no preset ${element}.`)
  return presetVertices(preset)
}
