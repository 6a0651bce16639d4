/** What the page speaks of: a vertex or a point with a ring around it, an edge drawn thick, a face outlined. */
import { edgeVertices, faces, type Vec3, vertexReference } from '../../model/hexahedron'
import { type Entity, type SpokenPoint, spokenOf } from '../../views/scene-slices'
import { px, set, show, svg } from '../paint/svg'
import type { ScreenPoint } from '../space/camera'
import { at, map3 } from '../space/vec3'
import type { OverlayPicture, Seen } from './overlay-picture'

/** Radius of the ring: around the handle, and around the minimizer's ring if that is there too. */
const RING = 17

export class Highlights {
  readonly root = svg('g')
  readonly #pool: Highlight[] = []

  update(picture: OverlayPicture): void {
    const spoken = spokenOf(picture.state)
    while (this.#pool.length < spoken.length) {
      const another = new Highlight()
      this.#pool.push(another)
      this.root.append(another.root)
    }
    this.#pool.forEach((each, i) => {
      each.update(spoken[i] ?? null, picture)
    })
  }
}

class Highlight {
  readonly root = svg('g', { class: 'highlight' })
  readonly #halo = svg('path', { class: 'halo' })
  readonly #line = svg('path', { class: 'line' })

  constructor() {
    this.root.append(this.#halo, this.#line)
  }

  update(spoken: Entity | SpokenPoint | null, { camera, sight }: Seen): void {
    const points = spoken ? pointsOf(spoken) : []
    const corners = points.map(point => camera.project(sight.positionOf(point)))
    const isShown = spoken !== null && corners.every(({ depth }) => depth > 0)
    show(this.root, isShown)
    if (!isShown) return
    this.root.classList.toggle('behind', sight.hides(middleOf(points)))
    this.root.setAttribute('data-part', spoken.kind === 'point' ? 'point' : `${spoken.kind}-${spoken.id}`)
    const path = corners.length === 1 ? ring(corners[0] as ScreenPoint) : polygon(corners)
    set(this.#halo, { d: path })
    set(this.#line, { d: path })
  }
}

/** The point, or the entity's corners, a face's in turn. */
function pointsOf(spoken: Entity | SpokenPoint): readonly Vec3[] {
  if (spoken.kind === 'point') return [spoken.point]
  const { kind, id } = spoken
  const [a, b, c, d] = faces[id]?.vertices ?? [0, 0, 0, 0]
  const vertices = { vertex: [id], edge: edgeVertices[id] ?? [], face: [a, b, d, c] }[kind]
  return vertices.map(v => vertexReference[v] as Vec3)
}

function middleOf(points: readonly Vec3[]): Vec3 {
  return map3(axis => points.reduce((sum, point) => sum + at(point, axis), 0) / points.length)
}

function ring({ x, y }: ScreenPoint): string {
  return `M${px(x - RING)} ${px(y)}a${RING} ${RING} 0 1 0 ${2 * RING} 0a${RING} ${RING} 0 1 0 ${-2 * RING} 0Z`
}

function polygon(corners: readonly ScreenPoint[]): string {
  return `M${corners.map(({ x, y }) => `${px(x)} ${px(y)}`).join('L')}Z`
}
