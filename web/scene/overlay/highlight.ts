/** The entity that the page speaks of: a vertex with a ring around it, an edge drawn thick, a face outlined. */
import { edgeVertices, faces, type Vec3, vertexReference } from '../../model/hexahedron'
import type { Entity } from '../../views/scene-slices'
import { px, set, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import { at, map3 } from '../space/vec3'
import type { OverlayPicture } from './overlay-picture'

/** Radius of the ring: around the handle, and around the minimizer's ring if that is there too. */
const RING = 17

export class Highlight {
  readonly root = svg('g', { class: 'highlight' })
  readonly #halo = svg('path', { class: 'halo' })
  readonly #line = svg('path', { class: 'line' })

  constructor() {
    this.root.append(this.#halo, this.#line)
  }

  update(entity: Entity | null, { handles, sight }: OverlayPicture): void {
    const vertices = entity ? cornersOf(entity) : []
    const corners = vertices.map(v => handles[v] as ScreenPoint)
    const isShown = entity !== null && corners.every(({ depth }) => depth > 0)
    show(this.root, isShown)
    if (!isShown) return
    this.root.classList.toggle('behind', sight.hides(middleOf(vertices)))
    this.root.setAttribute('data-part', `${entity.kind}-${entity.id}`)
    const path = entity.kind === 'vertex' ? ring(corners[0] as ScreenPoint) : polygon(corners)
    set(this.#halo, { d: path })
    set(this.#line, { d: path })
  }
}

/** The entity's vertices, a face's in turn. */
function cornersOf({ kind, id }: Entity): readonly number[] {
  if (kind === 'vertex') return [id]
  if (kind === 'edge') return edgeVertices[id] ?? []
  const [a, b, c, d] = faces[id]?.vertices ?? [0, 0, 0, 0]
  return [a, b, d, c]
}

function middleOf(vertices: readonly number[]): Vec3 {
  return map3(axis => vertices.reduce((sum, v) => sum + at(vertexReference[v] as Vec3, axis), 0) / vertices.length)
}

function ring({ x, y }: ScreenPoint): string {
  return `M${px(x - RING)} ${px(y)}a${RING} ${RING} 0 1 0 ${2 * RING} 0a${RING} ${RING} 0 1 0 ${-2 * RING} 0Z`
}

function polygon(corners: readonly ScreenPoint[]): string {
  return `M${corners.map(({ x, y }) => `${px(x)} ${px(y)}`).join('L')}Z`
}
