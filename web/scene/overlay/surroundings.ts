/** Hexahedra around the element, such as its neighbours in a mesh: thin lines under all other marks, those of invalid ones in their colour. */
import { edgeVertices, type Vertices } from '../../model/hexahedron'
import { sliceOf } from '../../model/state'
import { surroundingsSlice } from '../../views/scene-slices'
import { px, set, svg } from '../paint/svg'
import { verticesInWorld } from '../space/world'
import type { OverlayPicture } from './overlay-picture'

export class SurroundingLines {
  readonly root = svg('g', { class: 'surroundings' })
  readonly #valid = svg('path')
  readonly #invalid = svg('path', { class: 'invalid' })

  constructor() {
    this.root.append(this.#valid, this.#invalid)
  }

  update(picture: OverlayPicture): void {
    const { hexahedra } = sliceOf(surroundingsSlice, picture.state)
    const pathOf = (isInvalid: boolean) =>
      hexahedra
        .filter(each => each.isInvalid === isInvalid)
        .map(({ vertices }) => edgesOf(vertices, picture))
        .join('')
    set(this.#valid, { d: pathOf(false) })
    set(this.#invalid, { d: pathOf(true) })
  }
}

function edgesOf(vertices: Vertices, { world, camera }: OverlayPicture): string {
  const points = verticesInWorld(world, vertices).map(point => camera.project(point))
  return edgeVertices
    .map(([from, to]) => {
      const [a, b] = [points[from], points[to]]
      return a && b && a.depth > 0 && b.depth > 0 ? `M${px(a.x)} ${px(a.y)}L${px(b.x)} ${px(b.y)}` : ''
    })
    .join('')
}
