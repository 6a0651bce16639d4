/** The scene's picture as it is on the page: painted in the host's colours when it differs, for the screen, a figure or paper. */
import { timesPowerOfTwo } from '../../core/power-of-two'
import type { Report } from '../../core/report'
import { type State, sliceOf } from '../../model/state'
import { stretchOf } from '../../views/place-in'
import { drawnFaces, sceneSlice, scriptSlice } from '../../views/scene-slices'
import type { Frame, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import type { Layout } from '../space/layout'
import {
  type ColourScale,
  colourScaleInside,
  colourScaleOf,
  cssColour,
  type Ramp,
  rampColour,
  rampOf,
  rampPosition,
  type Theme,
} from './colour-map'
import { createFacePainter } from './face-painter'
import { copyOf } from './figure'
import { FlatPainter } from './flat-painter'
import type { FacePainter, Viewport } from './picture'
import { ThemeReader } from './theme'

/** Device pixels of a CSS pixel of the screen: more are not worth their time. */
const MOST_ON_SCREEN = 2
/** An element that is seen larger than this is not drawn finer: the picture's memory grows with the square. */
const MOST_STRETCH = 4
/** Stretches to an eighth are one, so that an animated one seldom takes a canvas of another size. */
const STRETCH_STEP = 1 / 8
/** Corners of a box are measured to 1/64 of a pixel, so that a stretch of 1 may seem a little more. */
const STRETCH_ERROR = 1 / 64
/** Fine enough for paper, and no screen's, so that a figure is surely painted anew. */
const FINE = 3

const NO_WEBGL =
  'This browser gives no WebGL2, so the faces are coloured in coarse tiles. Everything else is as it should be, and the verdict holds.'
const CONTEXT_LOST =
  'The graphics context was lost, so the faces are not coloured until the browser gives it back. Everything else goes on.'

export class Painting {
  /** True if the first picture is some frames away. */
  isLoading = true
  picturesDrawn = 0
  ramp: Ramp | null = null
  readonly #scene: HTMLElement
  readonly #host: ViewContext
  readonly #painter: FacePainter
  readonly #themes: ThemeReader
  readonly #listening = new AbortController()
  #theme: Theme | null = null
  #isLost = false
  /** Stands in for the canvas while the page is printed, when that may be cleared before the pages are made. */
  #paperCopy: HTMLCanvasElement | null = null
  #picturesCopied = 0

  constructor(scene: HTMLElement, host: ViewContext) {
    this.#scene = scene
    this.#host = host
    const painter = createFacePainter({ lost: () => this.#onContext(true), restored: () => this.#onContext(false) })
    if (painter === null) host.raise({ code: 'no-webgl', message: say(NO_WEBGL) })
    else host.clear('no-webgl')
    this.#painter = painter ?? new FlatPainter()
    if (this.#painter.isLost) this.#onContext(true)
    this.#themes = new ThemeReader(scene, () => host.requestFrame())
    watchPixelRatio(() => host.requestFrame(), this.#listening.signal)
  }

  get root(): HTMLCanvasElement | SVGSVGElement {
    return this.#painter.root
  }

  readTheme(): void {
    const theme = this.#themes.read()
    if (theme === this.#theme) return
    this.#theme = theme
    this.ramp = rampOf(theme)
  }

  /** Returns whether there is another picture now; true if nobody can tell. */
  paint(frame: Frame, layout: Layout, viewports: readonly Viewport[], isFigure: boolean): boolean {
    const isOther = this.#isLost || this.#paint(frame, layout, viewports, isFigure || frame.isForPaper)
    if (!(frame.isForPaper && this.#paperCopy && this.picturesDrawn === this.#picturesCopied)) {
      this.#paperCopy?.remove()
      this.#paperCopy = frame.isForPaper ? this.#copy() : null
      this.#picturesCopied = this.picturesDrawn
    }
    return isOther
  }

  /** The colour of jacdet at the probe; none without one. */
  colourAt({ state, report, probe }: Frame): string {
    const scale = scaleOf(state, report)
    if (probe === null || report === null || scale === null || this.ramp === null) return 'none'
    const value = timesPowerOfTwo(probe.jacdet, probe.exponent - report.exponent)
    return cssColour(rampColour(this.ramp, rampPosition(scale, value)))
  }

  dispose(): void {
    this.#listening.abort()
    this.#themes.dispose()
    this.#painter.dispose()
  }

  #paint({ state, report, zeroSurface }: Frame, layout: Layout, viewports: readonly Viewport[], isFine: boolean) {
    const { faceDisplay: display, section } = sliceOf(sceneSlice, state)
    const picture = {
      ...layout.whole,
      report,
      scale: scaleOf(state, report),
      ramp: this.ramp as Ramp,
      theme: this.#theme as Theme,
      display,
      faces: drawnFaces(display, sliceOf(scriptSlice, state).hiddenFaces),
      section,
      zeroSurface,
      viewports,
      pixelRatio: layout.unit * (isFine ? FINE : Math.min(devicePixelRatio, MOST_ON_SCREEN) * this.#stretch()),
    }
    this.isLoading = !isFine && !this.#painter.isReady(picture)
    if (this.isLoading) {
      this.#host.requestFrame()
      return true
    }
    const isOther = this.#painter.paint(picture)
    if (isOther) this.picturesDrawn++
    this.#scene.dataset.frames = String(this.picturesDrawn)
    return isOther
  }

  /**
   * At least as many pixels as the screen shows of an element that transforms or zoom make larger. No event tells of a transform,
   * so it is measured for each picture; pointing at the element draws one.
   */
  #stretch(): number {
    const steps = Math.ceil((stretchOf(this.#scene) - STRETCH_ERROR) / STRETCH_STEP)
    return Math.max(1, Math.min(MOST_STRETCH, steps * STRETCH_STEP))
  }

  #copy(): HTMLCanvasElement | null {
    const { root } = this.#painter
    if (!(root instanceof HTMLCanvasElement)) return null
    const copy = copyOf(root)
    copy.className = 'for-paper'
    root.before(copy)
    return copy
  }

  #onContext(isLost: boolean): void {
    this.#isLost = isLost
    this.#scene.classList.toggle('unpainted', isLost)
    if (isLost) this.#host.raise({ code: 'context-lost', message: say(CONTEXT_LOST) })
    else this.#host.clear('context-lost')
    this.#host.requestFrame()
  }
}

export function scaleOf(state: State, report: Report | null): ColourScale | null {
  if (report === null) return null
  return sliceOf(sceneSlice, state).faceDisplay === 'inside'
    ? colourScaleInside(report)
    : colourScaleOf(report.boundaryMinimum, report.boundaryMaximum)
}

/** Asks for the present ratio by a media query, since a change of it has no event. */
function watchPixelRatio(onChange: () => void, signal: AbortSignal): void {
  const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`)
  const changed = () => {
    watchPixelRatio(onChange, signal)
    onChange()
  }
  query.addEventListener('change', changed, { once: true, signal })
}
