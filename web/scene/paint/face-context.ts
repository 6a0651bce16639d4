/**
 * The one WebGL context of the page, for every scene on it, since browsers give a page few: its life, and the steps to its first
 * picture. Each picture is handed on before the next one is drawn.
 */
import type { WebGLRenderer } from 'three'
import { FaceRenderer, type Picture, rendererOf } from './face-renderer'

export interface ContextWatcher {
  lost(): void
  restored(): void
}

/** Where pictures are drawn: not on the page. */
type Drawing = OffscreenCanvas | HTMLCanvasElement

let shared: FaceContext | null = null

/** Null where the browser gives no WebGL2 context; a later call then asks again. */
export function faceContext(): FaceContext | null {
  shared ??= create()
  return shared
}

/** The context is asked for here rather than by three, which would write to the console when there is none. */
function create(): FaceContext | null {
  const attributes = { antialias: true, alpha: true, premultipliedAlpha: true }
  for (const canvas of drawings()) {
    const context = canvas.getContext('webgl2', attributes) as WebGL2RenderingContext | null
    if (context) return new FaceContext(canvas, context)
  }
  return null
}

/** The first one whose pictures reach the page without being read back, where the browser has it. */
function* drawings(): Generator<Drawing> {
  if ('OffscreenCanvas' in globalThis) yield new OffscreenCanvas(1, 1)
  yield document.createElement('canvas')
}

export class FaceContext {
  readonly canvas: Drawing
  readonly #context: WebGL2RenderingContext
  readonly #watchers = new Set<ContextWatcher>()
  #three: WebGLRenderer | null = null
  #renderer: FaceRenderer | null = null
  /** To the first picture, a frame each: in one they would hold the page up. The scene is laid out in the first one. */
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
  /** Behind what the last step left for the graphics process to do: until that is done, any question to it would have to wait. */
  #fence: WebGLSync | null = null

  constructor(canvas: Drawing, context: WebGL2RenderingContext) {
    this.canvas = canvas
    this.#context = context
    canvas.addEventListener('webglcontextlost', this.#onLost)
    canvas.addEventListener('webglcontextrestored', this.#onRestored)
  }

  /** Before its watchers are told, too. */
  get isLost(): boolean {
    return this.#context.isContextLost()
  }

  /** Told of the context's loss and return, until it leaves. */
  join(watcher: ContextWatcher): void {
    this.#watchers.add(watcher)
  }

  /** The last one to leave lets go of the memory for pictures; the context and its programs stay, for who may come. */
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

  /** On `canvas`, which then has the picture's size in pixels. Returns the number of draw calls. */
  draw(picture: Picture): number {
    while (this.#steps.length > 0) this.#step(picture)
    return (this.#renderer as FaceRenderer).draw(picture)
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
