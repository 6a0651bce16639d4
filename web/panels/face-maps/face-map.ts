/** One face of the net: a button with the face's picture, which reports the point pointed at. */
import { type FaceTopology, faces } from '../../model/hexahedron'
import { type FaceRaster, paintFace } from '../../scene/paint/face-raster'
import { placeIn } from '../../views/place-in'
import { inUnit, isForeign, pointStep } from '../../views/point-steps'
import { say } from '../../words/say'

export interface FaceMapActions {
  /** A place in the cell, from its upper left, each in [0,1]. */
  point(face: number, x: number, y: number): void
  leave(): void
  /** A step of the point by keys, in cells, to the right and down. */
  step(face: number, right: number, down: number): void
  /** True if there was a probe to remove. */
  clear(face: number): boolean
  select(face: number): void
}

const DIRECTIONS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
}

export class FaceMap {
  readonly root = document.createElement('button')
  readonly face: number
  readonly #actions: FaceMapActions
  readonly #canvas = document.createElement('canvas')
  readonly #context = this.#canvas.getContext('2d', { willReadFrequently: true })
  #image: ImageData | null = null
  #painted: FaceRaster | null = null

  constructor(face: number, actions: FaceMapActions, describedBy: string) {
    this.face = face
    this.#actions = actions
    const { name, vertices } = faces[face] as FaceTopology
    this.root.type = 'button'
    this.root.className = 'face-map on-paper'
    this.root.dataset.face = String(face)
    this.root.setAttribute(
      'aria-label',
      say('Face {name}, vertices {vertices}', { name, vertices: vertices.toSorted((a, b) => a - b).join(', ') }),
    )
    this.root.setAttribute('aria-describedby', describedBy)
    this.root.append(this.#canvas)
    this.#listen()
  }

  /** Paints what is not yet in the picture; true if there was anything. */
  paint(raster: FaceRaster): boolean {
    const painted = this.#painted
    if (painted && isSamePicture(painted, raster)) return false
    this.#painted = raster
    const { size } = raster
    if (this.#image?.width !== size) {
      this.#canvas.width = size
      this.#canvas.height = size
      this.#image = new ImageData(size, size)
    }
    paintFace(new Int32Array(this.#image.data.buffer), raster)
    this.#context?.putImageData(this.#image, 0, 0)
    return true
  }

  #listen(): void {
    const { root, face } = this
    const actions = this.#actions
    const point = (event: PointerEvent) => {
      const place = placeIn(root, event)
      if (place) actions.point(face, inUnit(place.x), inUnit(place.y))
    }
    root.addEventListener('pointermove', point)
    root.addEventListener('pointerdown', event => {
      root.focus({ preventScroll: true }) // not every browser focuses a button that is pressed
      point(event)
    })
    root.addEventListener('pointerleave', event => {
      if (event.pointerType !== 'touch') actions.leave()
    })
    root.addEventListener('blur', () => actions.leave())
    root.addEventListener('click', () => actions.select(face))
    root.addEventListener('keydown', event => this.#onKey(event))
  }

  #onKey(event: KeyboardEvent): void {
    const direction = DIRECTIONS[event.key]
    if (isForeign(event)) return
    if (direction) {
      const step = pointStep(event)
      this.#actions.step(this.face, direction[0] * step, direction[1] * step)
      event.preventDefault()
    } else if (event.key === 'Escape' && this.#actions.clear(this.face)) event.preventDefault()
  }
}

function isSamePicture(a: FaceRaster, b: FaceRaster): boolean {
  return (
    a.palette === b.palette &&
    a.size === b.size &&
    a.pixelRatio === b.pixelRatio &&
    a.scale.greatest === b.scale.greatest &&
    a.scale.negativeExtent === b.scale.negativeExtent &&
    a.scale.positiveExtent === b.scale.positiveExtent &&
    a.bernstein.every((value, i) => value === b.bernstein[i])
  )
}
