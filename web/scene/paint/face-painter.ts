/**
 * The coloured faces of one scene: a canvas of its own with a copy of what the page's one renderer drew, and none for a picture
 * that is already there. What is shown is decided elsewhere.
 */
import { type ContextWatcher, type FaceContext, faceContext } from './face-context'
import type { Picture } from './face-renderer'

export interface FacePainter {
  readonly root: HTMLCanvasElement | SVGSVGElement
  /** Whether the context is lost at present: nothing can be painted. */
  readonly isLost: boolean
  /** False where the first picture is some steps away, of which this call takes one: it wants to be called in the next frame, too. */
  isReady(picture: Picture): boolean
  /** False where nothing was to be drawn: the last picture was the same. */
  paint(picture: Picture): boolean
  /** Draw calls of the last picture. */
  readonly drawCalls: number
  dispose(): void
}

/** Null where the browser gives no WebGL2 context. */
export function createFacePainter(watcher: ContextWatcher): FacePainter | null {
  const context = faceContext()
  return context && new CopyingFacePainter(context, watcher)
}

class CopyingFacePainter implements FacePainter, ContextWatcher {
  readonly root = document.createElement('canvas')
  drawCalls = 0
  readonly #context: FaceContext
  readonly #watcher: ContextWatcher
  readonly #copy: () => void
  #painted: readonly unknown[] = []

  constructor(context: FaceContext, watcher: ContextWatcher) {
    this.#context = context
    this.#watcher = watcher
    this.#copy = copier(context.canvas, this.root)
    context.join(this)
  }

  get isLost(): boolean {
    return this.#context.isLost
  }

  isReady(picture: Picture): boolean {
    return this.#context.isReady(picture)
  }

  paint(picture: Picture): boolean {
    if (this.isLost) return false
    const contents = contentsOf(picture)
    const painted = this.#painted
    if (contents.length === painted.length && contents.every((value, i) => Object.is(value, painted[i]))) return false
    this.#painted = contents
    this.drawCalls = this.#context.draw(picture)
    this.#copy()
    return true
  }

  lost(): void {
    this.#painted = []
    this.#watcher.lost()
  }

  restored(): void {
    this.#watcher.restored()
  }

  dispose(): void {
    this.#context.leave(this)
  }
}

/** Hands what was drawn on to the canvas on the page: the picture itself where the browser can, else a copy. */
function copier(from: OffscreenCanvas | HTMLCanvasElement, to: HTMLCanvasElement): () => void {
  const resize = () => {
    if (to.width !== from.width) to.width = from.width
    if (to.height !== from.height) to.height = from.height
  }
  if (from instanceof HTMLCanvasElement) {
    const context = to.getContext('2d')
    return () => {
      resize()
      context?.clearRect(0, 0, to.width, to.height)
      context?.drawImage(from, 0, 0)
    }
  }
  const context = to.getContext('bitmaprenderer')
  return () => {
    resize()
    context?.transferFromImageBitmap(from.transferToImageBitmap())
  }
}

/** Everything that a picture depends on. The scale is the report's. */
export function contentsOf(picture: Picture): unknown[] {
  const { report, ramp, theme, display, section, zeroSurface, regions, width, height, pixelRatio } = picture
  const inside = display === 'inside' ? [section.axis, section.value, zeroSurface] : []
  const contents: unknown[] = [report, ramp, theme, display, ...inside, width, height, pixelRatio]
  for (const { left, top, vertices, camera } of regions) {
    const { projectionMatrix, matrixWorld } = camera.three
    contents.push(left, top, camera.width, camera.height, ...vertices.flat())
    contents.push(...projectionMatrix.elements, ...matrixWorld.elements)
  }
  return contents
}
