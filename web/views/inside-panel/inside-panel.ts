/** What is inside: the least jacdet there against the boundary's, a section that slides, and the surface jacdet = 0. */
import { html, render, type TemplateResult } from 'lit-html'
import type { Report } from '../../core/report'
import { formatBound, formatJacdet, formatNumber, formatPoint } from '../../model/decimal'
import type { Axis, Vec3 } from '../../model/hexahedron'
import type { ReferenceCube, Section } from '../../model/state'
import { colourScaleOf } from '../colour-map'
import { approximation, lowerInside } from '../inside'
import { ThemeReader } from '../theme'
import type { CreateView, Frame, View, ViewHost } from '../view'
import css from './inside-panel.css?inline'
import { insideSentence } from './inside-words'
import { AXIS_NAMES, SectionMap } from './section-map'
import { SurfaceCanvas } from './surface-picture'

export const styles = css

const LARGEST_SIDE = 340
const MARGIN = 22
const STEP = 0.01
const KEYS = 'Arrow keys move the point looked at over the section, Escape takes it away.'

class InsidePanel implements View {
  readonly root = document.createElement('div')
  readonly #host: ViewHost
  readonly #minima = document.createElement('div')
  readonly #controls = document.createElement('div')
  readonly #map: SectionMap
  readonly #readout = document.createElement('p')
  readonly #surface = new SurfaceCanvas()
  readonly #figure = document.createElement('div')
  readonly #theme: ThemeReader
  readonly #resizes: ResizeObserver
  #side = 0
  #report: Report | null = null
  /** Of the last frame: in the next one with the same, both pictures are brought up to date. */
  #pictured: Report | null = null
  #nextPicture: 'section' | 'surface' = 'section'
  #isThere = false
  readonly #drawn = new Map<string, readonly unknown[]>()

  constructor(host: ViewHost) {
    this.#host = host
    this.#map = new SectionMap(point => host.dispatch({ type: 'probe', point }))
    this.#build()
    this.#theme = new ThemeReader(this.root, () => host.requestFrame())
    this.#resizes = new ResizeObserver(entries => {
      const width = Math.floor(entries.at(-1)?.contentRect.width ?? 0)
      this.#side = Math.max(0, Math.min(LARGEST_SIDE, width - MARGIN))
      host.requestFrame()
    })
    this.#resizes.observe(this.root)
  }

  update(frame: Frame): void {
    const { report, state } = frame
    this.root.hidden = report === null
    this.#report = report
    if (report === null || !state.openPanels.includes('inside')) return
    const theme = this.#theme.read()
    const { section, insideTurn: turn } = state
    const least = Math.min(report.boundaryMinimum, report.volumeMinimum.upper)
    const scale = colourScaleOf(least, report.boundaryMaximum)
    const isMoving = state.gestureStart !== null
    // While a gesture runs each of the two pictures is due every other frame, which keeps frames short.
    const due = isMoving && report !== this.#pictured ? this.#nextPicture : null
    if (this.#side > 0 && due !== 'surface')
      this.#map.update({ section, report, scale, theme, state, side: this.#side })
    if (due !== 'section') this.#isThere = this.#surface.update({ report, section, theme, isMoving, turn })
    this.#pictured = report
    if (due !== null) {
      this.#nextPicture = due === 'section' ? 'surface' : 'section'
      this.#host.requestFrame()
    }
    const isThere = this.#isThere
    this.#drawWords(frame, report, isThere)
  }

  dispose(): void {
    this.#theme.dispose()
    this.#resizes.disconnect()
  }

  #build(): void {
    this.root.className = 'inside'
    this.#readout.className = 'readout'
    this.#surface.canvas.setAttribute('role', 'img')
    this.#figure.className = 'surface'
    const words = document.createElement('div')
    this.#figure.append(this.#surface.canvas, words)
    this.#turnByPointer()
    const keys = document.createElement('span')
    keys.id = 'section-keys'
    keys.className = 'said'
    keys.textContent = KEYS
    this.#map.root.setAttribute('aria-describedby', keys.id)
    this.#map.root.addEventListener('focus', () => this.#readout.setAttribute('aria-live', 'polite'))
    this.#map.root.addEventListener('blur', () => this.#readout.setAttribute('aria-live', 'off'))
    this.root.append(this.#minima, this.#controls, this.#map.root, keys, this.#readout, this.#figure)
  }

  /** Whether any of it is new since the last time, and remembers it. */
  #isNew(part: string, ...shown: unknown[]): boolean {
    const drawn = this.#drawn.get(part)
    if (drawn && shown.every((value, i) => value === drawn[i])) return false
    this.#drawn.set(part, shown)
    return true
  }

  #drawWords({ state, probe }: Frame, report: Report, isThere: boolean): void {
    const { referenceCube: cube, section, insideTurn } = state
    if (this.#isNew('minima', report, cube)) render(minima(report, cube), this.#minima)
    const goal = minimizerOf(report)[section.axis]
    if (this.#isNew('controls', goal === section.value, lowerInside(report) !== null, section)) {
      render(this.#controlsOf(report, section), this.#controls)
      const value = `${AXIS_NAMES[section.axis]} = ${formatNumber(section.value)}`
      this.#map.root.setAttribute('aria-label', `Map of jacdet on the section ${value}`)
    }
    if (this.#isNew('readout', probe, report, section, cube)) {
      const isHere = probe !== null && probe.point[section.axis] === section.value
      render(
        isHere ? readout(probe.point, probe.jacdet, probe.exponent, cube) : offSection(report, section),
        this.#readout,
      )
    }
    if (this.#isNew('surface', isThere, insideTurn, lowerInside(report) !== null)) {
      const label = isThere
        ? 'Surface jacdet = 0 in the reference cube'
        : 'The reference cube; jacdet is zero nowhere inside'
      this.#surface.canvas.setAttribute('aria-label', label)
      render(
        this.#surfaceWords(isThere, lowerInside(report) !== null, insideTurn),
        this.#figure.lastElementChild as HTMLElement,
      )
    }
  }

  #controlsOf(report: Report, { axis, value }: Section): TemplateResult {
    const name = AXIS_NAMES[axis]
    const goal = minimizerOf(report)
    return html`<fieldset class="axes">
        <legend>Section at</legend>
        ${AXIS_NAMES.map(
          (other, i) => html`<label
            ><input
              type="radio"
              name="section-axis"
              .checked=${i === axis}
              @change=${() => this.#show({ axis: i as Axis, value })}
            /><span>${other}</span></label
          >`,
        )}
      </fieldset>
      <label class="slide">
        <span>${name} = <output>${formatNumber(value)}</output></span>
        <input
          type="range"
          min="0"
          max="1"
          step=${STEP}
          .value=${String(value)}
          aria-label=${`Section at ${name}`}
          aria-valuetext=${formatNumber(value)}
          @input=${(event: Event) => this.#show({ axis, value: (event.target as HTMLInputElement).valueAsNumber })}
        />
      </label>
      <button type="button" ?disabled=${goal[axis] === value} @click=${() => this.#goToMinimum()}>
        ${lowerInside(report) ? 'Go to the minimum inside' : 'Go to the minimum'}
      </button>`
  }

  #show(section: Section): void {
    this.#host.dispatch({ type: 'show-section', section })
    this.#host.dispatch({ type: 'probe', point: null })
  }

  #goToMinimum(): void {
    const { axis } = this.#host.state().section
    if (this.#report) this.#show({ axis, value: minimizerOf(this.#report)[axis] })
    // The button is now disabled, and keys should not be lost with it.
    this.#controls.querySelector<HTMLElement>('input[type=range]')?.focus({ preventScroll: true })
  }

  #surfaceWords(isThere: boolean, isLowerInside: boolean, turn: number): TemplateResult {
    return html`<label class="slide"
        ><span>Turn</span
        ><input
          type="range"
          min="-180"
          max="180"
          step="5"
          .value=${String(turn)}
          aria-label="Turn the cube"
          aria-valuetext=${`${Math.round(turn)}°`}
          @input=${(event: Event) => this.#turnTo((event.target as HTMLInputElement).valueAsNumber)}
      /></label>
      <p class="caption">
        ${isThere ? 'The surface J = 0, skin of the negative part.' : 'J is zero nowhere inside: there is no surface J = 0.'}
      </p>
      <p class="legend">
        <span><i class="ring"></i>minimum on the boundary</span>
        ${isLowerInside ? html`<span><i class="ring full"></i>minimum inside</span>` : ''}
        <span><i class="outline"></i>section</span>
      </p>`
  }

  #turnTo(degrees: number): void {
    this.#host.dispatch({ type: 'turn-inside', degrees })
  }

  #turnByPointer(): void {
    const { canvas } = this.#surface
    let from: { readonly id: number; readonly x: number; readonly turn: number } | null = null
    canvas.addEventListener('pointerdown', event => {
      if (event.button !== 0 || from) return
      from = { id: event.pointerId, x: event.clientX, turn: this.#host.state().insideTurn }
      canvas.setPointerCapture(event.pointerId)
    })
    canvas.addEventListener('pointermove', event => {
      if (event.pointerId !== from?.id) return
      const turn = from.turn - ((event.clientX - from.x) / canvas.clientWidth) * 180
      this.#turnTo(((((turn + 180) % 360) + 360) % 360) - 180)
    })
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
      canvas.addEventListener(end, event => {
        if (event.pointerId === from?.id) from = null
      })
    }
  }
}

function minimizerOf(report: Report): Vec3 {
  return lowerInside(report)?.point ?? report.minimizer.point
}

function minima(report: Report, cube: ReferenceCube): TemplateResult {
  const { exponent, boundaryMinimum, boundaryMinimumError, minimizer, volumeMinimum } = report
  const inside = lowerInside(report)
  const { lower, upper, point } = volumeMinimum
  const volume = approximation(volumeMinimum)
  const isExact = lower === upper
  return html`<p class="why">${insideSentence(report, cube)}</p>
    <table aria-label="Boundary minimum and volume minimum">
      <tbody>
        <tr>
          <th scope="row">On the boundary</th>
          <td>${jacdet(boundaryMinimum, exponent, cube)}</td>
          <td>${boundaryMinimumError === 0 ? 'exactly' : `± ${formatBound(boundaryMinimumError, exponent, cube)}`}<br />at ${formatPoint(minimizer.point)}</td>
        </tr>
        <tr>
          <th scope="row">In the whole element</th>
          <td>${inside ? jacdet(volume.value, exponent, cube) : 'the same'}</td>
          <td>
            ${isExact ? 'exactly' : html`between ${formatJacdet(lower, exponent, cube, 'down')} and ${formatJacdet(upper, exponent, cube, 'up')}`}
            ${inside ? html`<br />at ${formatPoint(point)}` : ''}
          </td>
        </tr>
      </tbody>
    </table>`
}

function jacdet(value: number, exponent: number, cube: ReferenceCube): TemplateResult {
  return html`<b class=${value < 0 ? 'negative' : ''}>${formatJacdet(value, exponent, cube)}</b>`
}

function readout(point: Vec3, value: number, exponent: number, cube: ReferenceCube): TemplateResult {
  return html`J = ${jacdet(value, exponent, cube)} at ${formatPoint(point)}`
}

/** The hint, or where the minimizer is that is marked although it does not lie on the section. */
function offSection(report: Report, { axis, value }: Section): string {
  const at = minimizerOf(report)[axis]
  if (at === value) return 'Point at the section to read jacdet there, or move over it with the arrow keys.'
  const off = formatNumber(Math.abs(at - value))
  return `The minimum is not on this section: it is ${off} ${at > value ? 'above' : 'below'} it in ${AXIS_NAMES[axis]}, marked where it projects.`
}

export const create: CreateView = host => new InsidePanel(host)
