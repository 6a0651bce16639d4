/**
 * A quadrilateral to drag, beside it the square that is mapped to it, and the verdict: what stands in the lens's place in a step in the
 * plane. State and history are those of the quadrilateral drawn out to a hexahedron; the core's report on that is the one source of
 * every number about the whole.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import type { Report } from '../../../core/report'
import { formatJacdet, formatNumber, speakJacdet, speakNumber } from '../../../model/decimal'
import { type Vertices, vertexOf } from '../../../model/hexahedron'
import { type HistoryDocument, historyDocument, readHistory } from '../../../model/history-document'
import { Refusal } from '../../../model/result'
import type { Action } from '../../../model/state'
import { createStore, type Store } from '../../../model/store'
import { colourScaleOf, type Ramp, rampOf, type Theme } from '../../../scene/paint/colour-map'
import { ThemeReader } from '../../../scene/paint/theme'
import { LITTLE, type PanePicture, panePicture } from './picture'
import { listen } from './plane-input'
import {
  baseOf,
  CORNER_COUNT,
  cornerJacdets,
  cornerReference,
  jacdetAt,
  type Quadrilateral,
  type Vec2,
} from './quadrilateral'
import { type Frame, frameOf, type PlaneView, shows, viewOf } from './view'

export interface PlaneHost {
  readonly analyze: (vertices: Vertices) => Promise<Report>
  /** The quadrilateral has changed, and there is a report on it, or there is no core. */
  readonly onChange: () => void
  /** A corner was pressed while the answer is hidden. */
  readonly onPress: (corner: number) => void
}

export interface PlaneStart {
  readonly quadrilateral: Quadrilateral
  readonly probe: Vec2 | null
}

const squareFrame = frameOf(cornerReference, 0.02)

export class Plane {
  readonly root: HTMLElement
  readonly #host: PlaneHost
  readonly #theme: ThemeReader
  #store: Store = createStore([...Array(24).fill(0)], null)
  #report: Report | null = null
  /** False if the core could not start. */
  #hasCore = true
  #frame: Frame = squareFrame
  #probe: Vec2 | null = null
  #selected = 0
  #asks: 'nothing' | 'choice' | 'drag' = 'nothing'
  #ramp: { readonly theme: Theme; readonly ramp: Ramp } | null = null
  #announced = ''
  #drawing = 0

  constructor(root: HTMLElement, host: PlaneHost) {
    this.root = root
    this.#host = host
    this.#theme = new ThemeReader(root, () => this.#ask())
    this.#draw()
    const [element, square] = ['element', 'square'].map(name => this.#pane(name)) as [SVGElement, SVGElement]
    listen({
      element,
      square,
      view: name => this.#view(name),
      state: () => this.#store.state,
      dispatch: action => this.#dispatch(action),
      probe: () => this.#probe,
      setProbe: point => {
        this.#probe = point
        this.#ask()
      },
      canMove: () => this.#asks !== 'choice',
      press: corner => {
        if (this.#asks === 'choice') this.#host.onPress(corner)
      },
      select: corner => {
        this.#selected = corner
        this.#ask()
      },
      selected: () => this.#selected,
      moved: () => this.#settle(),
    })
    new ResizeObserver(() => this.#ask()).observe(root)
    root.addEventListener('keydown', event => this.#onKey(event))
  }

  /** Begins anew with a step's quadrilateral. */
  show({ quadrilateral, probe }: PlaneStart, start: Vertices): void {
    this.#store = createStore(start, null)
    this.#frame = frameOf(quadrilateral)
    this.#probe = probe
    this.#selected = 0
    this.#announced = ''
    this.#changed()
  }

  /** What the reader is asked: `choice` and `drag` hide colours and verdict, and with `choice` nothing moves. */
  set asks(what: 'nothing' | 'choice' | 'drag') {
    this.#asks = what
    this.#ask()
  }

  get vertices(): Vertices {
    return this.#store.state.vertices
  }

  get history(): HistoryDocument {
    return historyDocument(this.#store.history)
  }

  /** Throws Refusal if it is none. */
  set history(given: HistoryDocument) {
    const result = readHistory(given)
    if (!result.ok) throw new Refusal(result.error.message)
    this.#dispatch({ type: 'take-history', history: result.value })
    this.#settle()
  }

  /** On these vertices; null while it is on its way, or if the core could not start. */
  get report(): Report | null {
    return this.#report
  }

  #pane(name: string): SVGElement {
    return this.root.querySelector(`svg.${name}`) as SVGElement
  }

  #view(name: 'element' | 'square'): PlaneView {
    const { clientWidth: width, clientHeight: height } = this.#pane(name)
    return viewOf(name === 'element' ? this.#frame : squareFrame, { width, height })
  }

  #dispatch(action: Action): void {
    const before = this.vertices
    this.#store.dispatch(action)
    if (this.vertices !== before) this.#changed()
    else this.#ask()
  }

  #changed(): void {
    this.#report = null
    this.#ask()
    const { vertices } = this
    this.#host.analyze(vertices).then(
      report => {
        if (vertices !== this.vertices) return
        this.#report = report
        this.#hasCore = true
        this.#ask()
        this.#host.onChange()
      },
      () => {
        this.#hasCore = false
        this.#ask()
        this.#host.onChange()
      },
    )
  }

  /** After a gesture: all corners are brought into sight, and screen readers hear where things are. */
  #settle(): void {
    const quadrilateral = baseOf(this.vertices)
    const { clientWidth: width, clientHeight: height } = this.#pane('element')
    if (!shows(this.#view('element'), { width, height }, quadrilateral)) this.#frame = frameOf(quadrilateral)
    const [x, y] = vertexOf(this.vertices, this.#selected)
    const where = `Corner ${this.#selected}: ${speakNumber(x)}, ${speakNumber(y)}.`
    this.#announced = where
    this.#ask()
    if (this.#asks !== 'nothing') return
    const { vertices } = this
    void this.#host.analyze(vertices).then(
      report => {
        if (vertices !== this.vertices) return
        const least = speakJacdet(report.boundaryMinimum, report.exponent, 'unit')
        const verdict = report.valid ? 'Valid' : 'Invalid'
        this.#announced = `${where} Least jacdet ${least} at corner ${leastCorner(this.vertices)}. ${verdict}.`
        this.#ask()
      },
      () => undefined, // the verdict's place says so
    )
  }

  #onKey(event: KeyboardEvent): void {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.key.toLowerCase() !== 'z') return
    event.preventDefault()
    this.#dispatch({ type: event.shiftKey ? 'redo' : 'undo' })
    this.#settle()
  }

  #ask(): void {
    this.#drawing ||= requestAnimationFrame(() => {
      this.#drawing = 0
      this.#draw()
    })
  }

  #draw(): void {
    render(this.#template(), this.root)
  }

  #template(): TemplateResult {
    const quadrilateral = baseOf(this.vertices)
    const [element, square] = this.root.hasChildNodes() ? [this.#picture('element'), this.#picture('square')] : []
    const chosen = quadrilateral[this.#selected] as Vec2
    const label = `The quadrilateral. Corner ${this.#selected} is chosen, at ${formatNumber(chosen[0])}, ${formatNumber(chosen[1])}. Keys 0 to 3 choose a corner, arrows move it.`
    return html`
      <div class="panes">
        <svg class="element" viewBox=${this.#box('element')} tabindex="0" role="application" aria-label=${label}>${element ?? nothing}</svg>
        <svg class="square" viewBox=${this.#box('square')} tabindex="0" role="application" aria-label="The reference square. Arrows move the point that is marked.">
          ${square ?? nothing}
        </svg>
        <p class="name" aria-hidden="true">(x, y)</p>
        <p class="name" aria-hidden="true">(ξ, η)</p>
      </div>
      <div class="foot">
        <div class="words">
          ${this.#asks === 'nothing' ? this.#verdict() : html`<p class="quiet">Colours and verdict come with the answer.</p>`}
          <p class="readout">${this.#readout(quadrilateral)}</p>
        </div>
        <p class="buttons">
          <button type="button" ?disabled=${!this.#store.state.canUndo} @click=${() => this.#step('undo')}>Undo</button>
          <button type="button" ?disabled=${!this.#store.state.canRedo} @click=${() => this.#step('redo')}>Redo</button>
        </p>
      </div>
      <p class="said" role="status">${this.#announced}</p>`
  }

  /** A unit is a pixel of the screen; on paper the picture is as large as there is room. */
  #box(name: string): string {
    const { clientWidth = 0, clientHeight = 0 } = this.root.hasChildNodes() ? this.#pane(name) : {}
    return `0 0 ${clientWidth} ${clientHeight}`
  }

  #step(type: 'undo' | 'redo'): void {
    this.#dispatch({ type })
    this.#settle()
  }

  #picture(name: 'element' | 'square'): TemplateResult {
    const { vertices, gestureStart } = this.#store.state
    const quadrilateral = baseOf(vertices)
    const jacdets = cornerJacdets(quadrilateral)
    const corner = leastCorner(vertices)
    const isHidden = this.#asks !== 'nothing'
    const theme = this.#theme.read()
    if (this.#ramp?.theme !== theme) this.#ramp = { theme, ramp: rampOf(theme) }
    const picture: PanePicture = {
      name,
      map: name === 'element' ? quadrilateral : cornerReference,
      view: this.#view(name),
      quadrilateral,
      colouring: isHidden
        ? null
        : { scale: colourScaleOf(Math.min(...jacdets), Math.max(...jacdets)), ramp: this.#ramp.ramp },
      probe: this.#probe,
      least:
        isHidden || !this.#report
          ? null
          : {
              corner,
              text: formatJacdet(this.#report.boundaryMinimum, this.#report.exponent, 'unit'),
              isNegative: !this.#report.valid,
            },
      selected: name === 'element' ? this.#selected : null,
      ghost: name === 'element' && gestureStart ? baseOf(gestureStart) : null,
    }
    return panePicture(picture)
  }

  #verdict(): TemplateResult {
    const report = this.#report
    if (!report)
      return html`<p class="verdict"><strong>${this.#hasCore ? '…' : 'NO VERDICT'}</strong>${this.#hasCore ? nothing : ' The core could not start.'}</p>`
    const least = formatJacdet(report.boundaryMinimum, report.exponent, 'unit')
    return html`<p class="verdict">
      <strong class=${report.valid ? 'valid' : 'invalid'}>${report.valid ? 'VALID' : 'INVALID'}</strong>
      <span>Least J: ${least}, at corner ${leastCorner(this.vertices)}</span>
    </p>`
  }

  #readout(quadrilateral: Quadrilateral): string {
    if (this.#store.state.gestureStart) {
      const [x, y] = quadrilateral[this.#selected] as Vec2
      return `Corner ${this.#selected}: (${formatNumber(x)}, ${formatNumber(y)})`
    }
    if (!this.#probe) return 'Point at a picture, or tap it, for the little square.'
    const [xi, eta] = this.#probe
    const at = `At (ξ, η) = (${rounded(xi)}, ${rounded(eta)})`
    if (this.#asks !== 'nothing') return `${at}.`
    const jacdet = jacdetAt(quadrilateral, this.#probe)
    const area = `Areas: ${rounded(LITTLE * LITTLE)} and ${rounded(LITTLE * LITTLE * jacdet)}`
    return `${at}: J = ${rounded(jacdet)}. ${area}${jacdet < 0 ? ', inside out' : ''}.`
  }
}

/** The first of the corners with the least jacdet. */
function leastCorner(vertices: Vertices): number {
  const jacdets = cornerJacdets(baseOf(vertices))
  return jacdets.indexOf(Math.min(...jacdets)) % CORNER_COUNT
}

/** What pointing can tell. */
function rounded(value: number): string {
  return formatNumber(Number(value.toPrecision(3)))
}
