/**
 * The coloured faces of one scene, on a canvas of its own, drawn by the one WebGL context of the page, since browsers give a
 * page few. Each picture is handed on to its canvas before the next one is drawn.
 */
import type { WebGLRenderer } from 'three'
import { FaceRenderer, rendererOf } from './face-renderer'
import { type FacePainter, LastPicture, type Picture } from './picture'

export interface ContextWatcher {
  lost(): void
  restored(): void
}

/** A canvas that is not on the page. */
type HiddenCanvas = OffscreenCanvas | HTMLCanvasElement

let shared: FaceContext | null = null

/** Asks for the page's context, which takes the browser longest; null if it gives no WebGL2. A later call then asks again. */
export function faceContext(): FaceContext | null {
  shared ??= create()
  return shared
}

/** The context is asked for here rather than by three, which would write to the console when there is none. */
function create(): FaceContext | null {
  const attributes = { antialias: true, alpha: true, premultipliedAlpha: true }
  for (const canvas of hiddenCanvases()) {
    const context = canvas.getContext('webgl2', attributes) as WebGL2RenderingContext | null
    if (context) return new FaceContext(canvas, context)
  }
  return null
}

/** Pictures of the first one, in browsers that have it, reach the page without being read back. */
function* hiddenCanvases(): Generator<HiddenCanvas> {
  if ('OffscreenCanvas' in globalThis) yield new OffscreenCanvas(1, 1)
  yield document.createElement('canvas')
}

/** The context's life, and the steps to its first picture. */
class FaceContext {
  readonly canvas: HiddenCanvas
  readonly #context: WebGL2RenderingContext
  readonly #watchers = new Set<ContextWatcher>()
  #three: WebGLRenderer | null = null
  #renderer: FaceRenderer | null = null
  /** Each takes a frame: all in one would hold the page up. The scene is laid out in the first one. */
  #steps: readonly ((picture: Picture) => void)[] = [
    () => {},
    () => this.#context.getExtension('EXT_color_buffer_float'), // the first one asked for takes longest
    () => {
      this.#three = rendererOf(this.canvas, this.#context)
    },
    () => {
      this.#renderer = new FaceRenderer(this.#three as WebGLRenderer)
    },
    picture => this.#renderer?.resize(picture),
    picture => this.#renderer?.compile(picture),
    () => {
      if (!(this.canvas instanceof HTMLCanvasElement)) this.canvas.transferToImageBitmap().close()
    },
  ]
  /** The fence behind the last step's work in the graphics process: any question to it would wait for that. */
  #fence: WebGLSync | null = null

  constructor(canvas: HiddenCanvas, context: WebGL2RenderingContext) {
    this.canvas = canvas
    this.#context = context
    canvas.addEventListener('webglcontextlost', this.#onLost)
    canvas.addEventListener('webglcontextrestored', this.#onRestored)
  }

  /** True even before its watchers are told. */
  get isLost(): boolean {
    return this.#context.isContextLost()
  }

  /** The watcher is told of the context's loss and return until it leaves. */
  join(watcher: ContextWatcher): void {
    this.#watchers.add(watcher)
  }

  /** After the last one the memory for pictures is released; the context and its programs stay for the next one to join. */
  leave(watcher: ContextWatcher): void {
    this.#watchers.delete(watcher)
    if (this.#watchers.size === 0) this.#renderer?.resize({ width: 1, height: 1, pixelRatio: 1 })
  }

  /** Takes the next step to the first picture, if one is left: then this frame has no time for a picture. */
  isReady(picture: Picture): boolean {
    if (this.#steps.length === 0 || this.isLost) return true
    if (!this.#isBusy) this.#step(picture)
    return false
  }

  /** On `canvas`, which then has the picture's size in pixels. */
  draw(picture: Picture): void {
    while (this.#steps.length > 0) this.#step(picture)
    this.#renderer?.draw(picture)
  }

  get #isBusy(): boolean {
    const context = this.#context
    return this.#fence !== null && context.getSyncParameter(this.#fence, context.SYNC_STATUS) === context.UNSIGNALED
  }

  #step(picture: Picture): void {
    const [step, ...others] = this.#steps
    this.#steps = others
    step?.(picture)
    const context = this.#context
    context.deleteSync(this.#fence)
    this.#fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0)
    context.flush()
  }

  readonly #onLost = (event: Event): void => {
    event.preventDefault() // or it would never be restored
    this.#renderer?.release()
    for (const watcher of this.#watchers) watcher.lost()
  }

  readonly #onRestored = (): void => {
    for (const watcher of this.#watchers) watcher.restored()
  }
}

/** A painter on the page's context; null if the browser gives no WebGL2. */
export function createFacePainter(watcher: ContextWatcher): FacePainter | null {
  const context = faceContext()
  return context && new ContextPainter(context, watcher)
}

class ContextPainter implements FacePainter, ContextWatcher {
  readonly root = document.createElement('canvas')
  readonly #context: FaceContext
  readonly #watcher: ContextWatcher
  readonly #handOn: () => void
  readonly #last = new LastPicture()

  constructor(context: FaceContext, watcher: ContextWatcher) {
    this.#context = context
    this.#watcher = watcher
    this.#handOn = handOver(context.canvas, this.root)
    context.join(this)
  }

  get isLost(): boolean {
    return this.#context.isLost
  }

  isReady(picture: Picture): boolean {
    return this.#context.isReady(picture)
  }

  paint(picture: Picture): boolean {
    if (this.isLost || this.#last.isSame(picture)) return false
    this.#context.draw(picture)
    this.#handOn()
    return true
  }

  lost(): void {
    this.#last.forget()
    this.#watcher.lost()
  }

  restored(): void {
    this.#watcher.restored()
  }

  dispose(): void {
    this.#context.leave(this)
  }
}

/** Hands on the picture itself if the browser can, else a copy. */
function handOver(from: HiddenCanvas, to: HTMLCanvasElement): () => void {
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
