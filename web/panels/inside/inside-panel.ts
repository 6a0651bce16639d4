/** The inside: its least jacdet against the boundary's, and a section, flat and in the scene. */
import { html, render, type TemplateResult } from 'lit-html'
import { approximation, lowerInside } from '../../core/inside'
import type { Report } from '../../core/report'
import { formatBound, formatJacdet, formatNumber, formatPoint } from '../../model/decimal'
import type { Axis, Vec3 } from '../../model/hexahedron'
import { type ReferenceCube, type State, sliceChange, sliceOf } from '../../model/state'
import { ThemeReader } from '../../scene/paint/theme'
import { copyableJacdet, copyablePoint } from '../../views/copyable'
import { type SceneState, type Section, sceneSlice } from '../../views/scene-slices'
import type { CreateView, Frame, Update, View, ViewContext } from '../../views/view'
import { say, sayParts } from '../../words/say'
import css from './inside-panel.css?inline'
import { insideSentence } from './inside-words'
import { AXIS_NAMES, SectionMap } from './section-map'

export const styles = css

const LARGEST_SIDE = 340
const MARGIN = 22
const STEP = 0.01

class InsidePanel implements View {
  readonly root = document.createElement('div')
  readonly updates: readonly Update[] = [frame => this.#drawMap(frame)]
  readonly #context: ViewContext
  readonly #map: SectionMap
  readonly #theme: ThemeReader
  readonly #resizes: ResizeObserver
  #side = 0
  #report: Report | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.#map = new SectionMap(point => context.dispatch({ type: 'probe', point }))
    this.root.className = 'inside'
    const speak = (live: string) => () => this.root.querySelector('.readout')?.setAttribute('aria-live', live)
    this.#map.root.setAttribute('aria-describedby', 'section-keys')
    this.#map.root.addEventListener('focus', speak('polite'))
    this.#map.root.addEventListener('blur', speak('off'))
    this.#theme = new ThemeReader(this.root, () => context.requestFrame())
    this.#resizes = new ResizeObserver(entries => {
      const width = Math.floor(entries.at(-1)?.contentRect.width ?? 0)
      this.#side = Math.max(0, Math.min(LARGEST_SIDE, width - MARGIN))
      context.requestFrame()
    })
    this.#resizes.observe(this.root)
  }

  update(frame: Frame): void {
    const { report, state } = frame
    this.root.hidden = report === null
    this.#report = report
    if (report === null || !state.openPanels.includes('inside')) return
    this.#drawWords(frame, report)
  }

  dispose(): void {
    this.#theme.dispose()
    this.#resizes.disconnect()
  }

  #drawMap({ report, state }: Frame): void {
    if (report !== null && this.#side > 0)
      this.#map.update({ report, theme: this.#theme.read(), state, side: this.#side })
  }

  #drawWords({ state, probe, zeroSurface }: Frame, report: Report): void {
    const { referenceCube: cube } = state
    const { section } = sliceOf(sceneSlice, state)
    const isThere = zeroSurface && zeroSurface.triangles.length > 0
    const isHere = probe !== null && probe.point[section.axis] === section.value
    render(
      html`<div>${minima(report, cube)}</div>
        <div>${this.#placesOf(state, isThere)}</div>
        <div>${this.#controlsOf(report, section)}</div>
        ${this.#map.root}<span id="section-keys" class="said">${say('Arrow keys move the point over the section. Escape removes it.')}</span>
        <p class="readout">${isHere ? readout(probe.point, probe.jacdet, probe.exponent, cube) : offSection(report, section)}</p>`,
      this.root,
    )
  }

  /** Choices of where else the inside is shown. */
  #placesOf(state: State, isThere: boolean | null): TemplateResult {
    const { faceDisplay, referenceShown } = sliceOf(sceneSlice, state)
    const isInScene = faceDisplay === 'inside'
    const show = (event: Event) => (event.target as HTMLInputElement).checked
    return html`<fieldset class="places">
        <legend>${say('Shown in space')}</legend>
        <label
          ><input
            type="checkbox"
            .checked=${isInScene}
            @change=${(event: Event) => this.#change({ faceDisplay: show(event) ? 'inside' : 'opaque' })}
          />${say('in the element')}</label
        >
        <label
          ><input
            type="checkbox"
            .checked=${referenceShown}
            @change=${(event: Event) => this.#change({ referenceShown: show(event) })}
          />${say('and in the reference cube')}</label
        >
      </fieldset>
      <p class="caption">${surfaceWords(isThere)}</p>`
  }

  #controlsOf(report: Report, { axis, value }: Section): TemplateResult {
    const name = AXIS_NAMES[axis]
    const goal = minimizerOf(report)
    return html`<fieldset class="axes">
        <legend>${say('Section at')}</legend>
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
          aria-label=${say('Section at {axis}', { axis: name })}
          aria-valuetext=${formatNumber(value)}
          @input=${(event: Event) => this.#show({ axis, value: (event.target as HTMLInputElement).valueAsNumber })}
        />
      </label>
      <button type="button" ?disabled=${goal[axis] === value} @click=${() => this.#goToMinimum()}>
        ${lowerInside(report) ? say('Go to the minimum inside') : say('Go to the minimum')}
      </button>`
  }

  #change(change: Partial<SceneState>): void {
    this.#context.dispatch(sliceChange(sceneSlice, change))
  }

  #show(section: Section): void {
    this.#change({ section })
    this.#context.dispatch({ type: 'probe', point: null })
  }

  #goToMinimum(): void {
    const { axis } = sliceOf(sceneSlice, this.#context.state()).section
    if (this.#report) this.#show({ axis, value: minimizerOf(this.#report)[axis] })
    // The button is now disabled, and keys should not be lost with it.
    this.root.querySelector<HTMLElement>('input[type=range]')?.focus({ preventScroll: true })
  }
}

function surfaceWords(isThere: boolean | null): string {
  if (isThere === null) return say('The section and the surface J = 0 can be shown in space.')
  return isThere
    ? say('Red: the surface J = 0, around the negative part. The section cuts through both.')
    : say('J is zero nowhere inside, so there is no surface J = 0.')
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
    <table aria-label=${say('Boundary minimum and volume minimum')}>
      <tbody>
        <tr>
          <th scope="row">${say('On the boundary')}</th>
          <td><b>${copyableJacdet(boundaryMinimum, exponent, cube)}</b></td>
          <td>${boundaryMinimumError === 0 ? say('exactly') : `± ${formatBound(boundaryMinimumError, exponent, cube)}`}<br />${sayParts('at {point}', { point: copyablePoint(minimizer.point) })}</td>
        </tr>
        <tr>
          <th scope="row">${say('In the whole element')}</th>
          <td>${inside ? html`<b>${copyableJacdet(volume.value, exponent, cube)}</b>` : say('the same')}</td>
          <td>
            ${isExact ? say('exactly') : say('between {lower} and {upper}', { lower: formatJacdet(lower, exponent, cube, 'down'), upper: formatJacdet(upper, exponent, cube, 'up') })}
            ${inside ? html`<br />${sayParts('at {point}', { point: copyablePoint(point) })}` : ''}
          </td>
        </tr>
      </tbody>
    </table>`
}

function jacdet(value: number, exponent: number, cube: ReferenceCube): TemplateResult {
  return html`<b class=${value < 0 ? 'negative' : ''}>${formatJacdet(value, exponent, cube)}</b>`
}

function readout(point: Vec3, value: number, exponent: number, cube: ReferenceCube): TemplateResult {
  return html`${sayParts('J = {value} at {point}', {
    value: jacdet(value, exponent, cube),
    point: formatPoint(point) as TemplateResult | string,
  })}`
}

/** The hint, or the place of a minimizer that is marked although it is not on the section. */
function offSection(report: Report, { axis, value }: Section): string {
  const at = minimizerOf(report)[axis]
  if (at === value) return say('Point at the section to read jacdet there, or use the arrow keys.')
  const off = formatNumber(Math.abs(at - value))
  const place = { off, axis: AXIS_NAMES[axis] }
  return at > value
    ? say('The minimum is not on this section: it is {off} above it in {axis}, marked where it projects.', place)
    : say('The minimum is not on this section: it is {off} below it in {axis}, marked where it projects.', place)
}

export const create: CreateView = context => new InsidePanel(context)
