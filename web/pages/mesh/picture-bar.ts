/** The controls below the picture: a line of them, and one more for each that is on. */
import { html, nothing, type TemplateResult } from 'lit-html'
import type { Vec3 } from '../../model/hexahedron'
import { readNumber } from '../../model/number-text'
import { azimuthOf, directionAt, elevationOf } from '../../scene/space/camera'
import type { CutFaces, Overview } from '../../survey/survey-jobs'
import {
  type CellSet,
  flipped,
  MOST_RINGS,
  type PictureSettings,
  roundedNormal,
  type Slice,
  unitOf,
} from './picture-settings'

/** What the bar has beside the settings. */
export interface BarState {
  readonly overview: Overview
  readonly settings: PictureSettings
  readonly isDigging: boolean
  readonly isTravelOpen: boolean
  /** The settings as a text. */
  readonly travelText: string
  /** The slice and the threshold that come back. */
  readonly before: { readonly slice: Slice; readonly relative: readonly [number, number] }
  readonly faces: CutFaces | null
  readonly invalidLeftOut: string
  readonly hasChosen: boolean
  /** Why a number that was typed is refused, and in which field. */
  readonly complaint: { readonly field: string; readonly sentence: string } | null
  readonly notice: string
}

export interface BarHost {
  set(settings: Partial<PictureSettings>): void
  digging(isDigging: boolean): void
  digChosen(): void
  undoDig(): void
  travelling(isOpen: boolean): void
  copySettings(): void
  takeSettings(text: string): void
  complain(complaint: BarState['complaint']): void
  /** From the mesh to the eye. */
  direction(): Vec3
  flyToChosen(): void
  fit(): void
}

export function barTemplate(state: BarState, host: BarHost): TemplateResult {
  const { overview, settings, before, isDigging, isTravelOpen } = state
  const { slice, relative, layers, away, isApart } = settings
  return html`<div class="row" role="group" aria-label="The picture">
      ${setTemplate(overview, settings, host)}
      <span class="toggles">
        ${toggle('Slice', slice !== null, 'Cut the mesh by a plane', on => host.set({ slice: on ? before.slice : null }))}
        ${toggle('Threshold', relative !== null, 'Only cells of some relative minima', on => host.set({ relative: on ? before.relative : null }))}
        ${toggle('Peel', layers > 0, 'Take layers of cells off the boundary', on => host.set({ layers: on ? 1 : 0 }))}
        ${toggle('Dig', isDigging, 'Take away the cell that is clicked', host.digging)}
        ${toggle('Apart', isApart, 'Draw the cells smaller, with gaps', on => host.set({ isApart: on }))}
      </span>
      <span class="toggles">
        <button type="button" title="Bring the chosen cell near" ?disabled=${!state.hasChosen} @click=${host.flyToChosen}>Fly to cell</button>
        <button type="button" title="The whole mesh (F)" @click=${host.fit}>Fit</button>
        ${toggle('Settings', isTravelOpen, 'Colours, and all settings as a text to copy', host.travelling)}
      </span>
    </div>
    ${slice ? sliceTemplate(slice, state, host) : nothing}
    ${relative ? thresholdTemplate(relative, state, host) : nothing}
    ${layers > 0 ? peelTemplate(state, host) : nothing}
    ${isDigging || away.length > 0 ? digTemplate(state, host) : nothing}
    ${isTravelOpen ? travelTemplate(state, host) : nothing}
    <div class="said-of-it">
      <p class="count" role="status">${countOf(state)}</p>
      <p class="notice" role="status">${state.notice}</p>
    </div>`
}

function toggle(name: string, isOn: boolean, title: string, onChange: (isOn: boolean) => void): TemplateResult {
  return html`<button type="button" class="toggle" aria-pressed=${isOn} title=${title} @click=${() => onChange(!isOn)}>${name}</button>`
}

function setTemplate({ blocks, counts }: Overview, { set, rings }: PictureSettings, host: BarHost): TemplateResult {
  const option = (value: CellSet, name: string) =>
    html`<option value=${value} ?selected=${value === set}>${name}</option>`
  return html`<label
      ><span class="said">Cells in the picture</span
      ><select .value=${set} @change=${(event: Event) => takeSet((event.target as HTMLSelectElement).value as CellSet, rings, host)}>
        ${option('all', 'All cells')}
        ${counts.invalid > 0 || set === 'invalid' ? option('invalid', 'Invalid cells') : nothing}
        ${option('around', 'Around the chosen cell')} ${option('listed', 'Listed cells')}
        ${blocks.map((block, i) => option(`block-${i}`, `Block ${block.name}`))}
      </select></label
    >${
      set === 'invalid' || set === 'around'
        ? html`<label
          >Rings around
          <select @change=${(event: Event) => host.set({ rings: Number((event.target as HTMLSelectElement).value) })}>
            ${Array.from({ length: MOST_RINGS + 1 }, (_, count) => html`<option ?selected=${count === rings}>${count}</option>`)}
          </select></label
        >`
        : nothing
    }`
}

/** One cell alone, of thousands and from afar, is a dot. */
function takeSet(set: CellSet, rings: number, host: BarHost): void {
  host.set(set === 'around' && rings === 0 ? { set, rings: 1 } : { set })
  if (set === 'around') host.flyToChosen()
}

const AXES = [
  ['x', [1, 0, 0]],
  ['y', [0, 1, 0]],
  ['z', [0, 0, 1]],
] as const

function sliceTemplate(slice: Slice, state: BarState, host: BarHost): TemplateResult {
  const unit = unitOf(slice.normal)
  const turned = (normal: Vec3) => host.set({ slice: { ...slice, normal: roundedNormal(normal) } })
  const [azimuth, elevation] = [Math.hypot(unit[0], unit[1]) > 0 ? azimuthOf(unit) : 0, elevationOf(unit)]
  const angle = (name: string, value: number, limit: number, take: (radians: number) => void) =>
    numberField(
      { name, value: Number(degrees(value).toFixed(1)), least: -limit, most: limit, unit: '°' },
      state,
      host,
      given => take((given * Math.PI) / 180),
    )
  return html`<div class="row" role="group" aria-label="Slice">
    <span class="toggles"
      ><span>Across</span>
      ${AXES.map(([name, axis]) =>
        toggle(
          name,
          axis.every((value, i) => Math.abs(unit[i as 0]) === value),
          `Across the ${name} axis`,
          () => turned(axis),
        ),
      )}
      <button type="button" title="Across the line of sight" @click=${() => turned(host.direction())}>As I look</button>
    </span>
    ${range({ name: 'Place of the slice', value: slice.place, least: 0, most: 1, step: 0.005 }, place => host.set({ slice: { ...slice, place } }))}
    <button type="button" title="Show the other side" @click=${() => host.set({ slice: flipped(slice) })}>Flip</button>
    ${angle('Azimuth', azimuth, 360, given => turned(directionAt(given, elevation)))}
    ${angle('Elevation', elevation, 90, given => turned(directionAt(azimuth, given)))}
  </div>`
}

const KINDS = [
  ['most', 'at most'],
  ['least', 'at least'],
  ['between', 'between'],
] as const

function thresholdTemplate(relative: readonly [number, number], state: BarState, host: BarHost): TemplateResult {
  const [lower, upper] = relative
  const kind = lower === -Infinity ? 'most' : upper === Infinity ? 'least' : 'between'
  const least = state.overview.counts.invalid > 0 ? -1 : 0
  const onKind = (event: Event) => {
    const wanted = (event.target as HTMLSelectElement).value as 'most' | 'least' | 'between'
    const one = kind === 'least' ? lower : upper
    const between: readonly [number, number] = kind === 'least' ? [one, Math.max(one, 1)] : [Math.min(one, least), one]
    host.set({ relative: wanted === 'between' ? between : wanted === 'most' ? [-Infinity, one] : [one, Infinity] })
  }
  const end = (name: string, value: number, take: (value: number) => void) =>
    html`${range({ name: `${name}, slider`, value, least, most: 1, step: 0.01 }, take)}
    ${numberField({ name, value, least: -Infinity, most: Infinity, isNameHidden: true }, state, host, take)}`
  return html`<div class="row" role="group" aria-label="Threshold">
    <label
      >Relative minimum
      <select @change=${onKind}>
        ${KINDS.map(([value, name]) => html`<option value=${value} ?selected=${value === kind}>${name}</option>`)}
      </select></label
    >
    ${
      kind === 'least' || kind === 'between'
        ? end('Least relative minimum', lower, value => host.set({ relative: [value, Math.max(value, upper)] }))
        : nothing
    }
    ${
      kind === 'most' || kind === 'between'
        ? end('Greatest relative minimum', upper, value => host.set({ relative: [Math.min(value, lower), value] }))
        : nothing
    }
  </div>`
}

function peelTemplate({ settings: { layers }, faces }: BarState, host: BarHost): TemplateResult {
  const most = Math.max(faces?.layers ?? 1, layers)
  return html`<div class="row" role="group" aria-label="Peel">
    ${range({ name: 'Layers that are peeled off', value: layers, least: 1, most, step: 1 }, count => host.set({ layers: count }))}
    <span>${layers} of ${counted(faces?.layers ?? most, 'layer')} peeled off the boundary</span>
  </div>`
}

function digTemplate({ settings: { away }, isDigging, hasChosen }: BarState, host: BarHost): TemplateResult {
  return html`<div class="row" role="group" aria-label="Dig">
    <span>${isDigging ? 'A click takes a cell away. ' : ''}${counted(away.length, 'cell')} dug away.</span>
    ${isDigging ? html`<button type="button" ?disabled=${!hasChosen} @click=${host.digChosen}>Dig the chosen cell</button>` : nothing}
    <button type="button" ?disabled=${away.length === 0} title="Put the last one back (Ctrl+Z)" @click=${host.undoDig}>Undo</button>
    <button type="button" ?disabled=${away.length === 0} @click=${() => host.set({ away: [] })}>Put all back</button>
  </div>`
}

function travelTemplate({ settings: { colours }, travelText }: BarState, host: BarHost): TemplateResult {
  const onSubmit = (event: SubmitEvent) => {
    event.preventDefault()
    const text = new FormData(event.target as HTMLFormElement).get('settings')
    if (typeof text === 'string') host.takeSettings(text)
  }
  return html`<form class="row" aria-label="Settings" @submit=${onSubmit}>
    <label
      >Colours
      <select @change=${(event: Event) => host.set({ colours: (event.target as HTMLSelectElement).value as 'all' | 'invalid' })}>
        <option value="all" ?selected=${colours === 'all'}>of all cells</option>
        <option value="invalid" ?selected=${colours === 'invalid'}>of invalid cells</option>
      </select></label
    >
    <label class="travel"
      ><span>All settings</span>
      <input name="settings" .value=${travelText} spellcheck="false" autocomplete="off" title="They are in the address, too. The mesh is not." /></label
    >
    <button type="button" @click=${host.copySettings}>Copy</button>
    <button type="submit" title="Take the settings in the field for this mesh">Use</button>
  </form>`
}

interface RangeWords {
  readonly name: string
  readonly value: number
  readonly least: number
  readonly most: number
  readonly step: number
}

function range({ name, value, least, most, step }: RangeWords, take: (value: number) => void): TemplateResult {
  return html`<label
    ><span class="said">${name}</span
    ><input
      type="range"
      min=${least}
      max=${most}
      step=${step}
      .value=${String(value)}
      @input=${(event: Event) => take(Number((event.target as HTMLInputElement).value))}
  /></label>`
}

interface FieldWords {
  readonly name: string
  readonly value: number
  readonly least: number
  readonly most: number
  readonly unit?: string
  readonly isNameHidden?: true
}

/** What is no number stays as it was typed. */
function numberField(
  { name, value, least, most, unit, isNameHidden }: FieldWords,
  { complaint }: BarState,
  host: BarHost,
  take: (value: number) => void,
): TemplateResult {
  const isRefused = complaint?.field === name
  const onChange = (event: Event) => {
    const read = readNumber((event.target as HTMLInputElement).value, { least, most })
    if (!read.ok) return host.complain({ field: name, sentence: read.error.message })
    host.complain(null)
    take(read.value)
  }
  return html`<label
    ><span class=${isNameHidden ? 'said' : ''}>${name}</span>
    <input
      class="number"
      autocomplete="off"
      aria-invalid=${isRefused ? 'true' : nothing}
      .value=${String(value).replace('-', '−')}
      @change=${onChange}
    />${unit ?? nothing}</label
    >${isRefused ? html`<span class="complaint" role="status">${complaint.sentence}</span>` : nothing}`
}

function countOf({ overview, faces, invalidLeftOut }: BarState): string {
  if (!faces) return ''
  const { shown, wanted } = faces
  const of = `${wanted.toLocaleString('en')} of ${counted(overview.hexahedra, 'cell')}`
  const worst = shown === wanted ? '' : ` The worst ${shown.toLocaleString('en')} of them are drawn.`
  return `${of}.${worst}${worst === '' && invalidLeftOut !== '' ? ` ${invalidLeftOut}` : ''}`
}

function counted(count: number, word: string): string {
  return `${count.toLocaleString('en')} ${word}${count === 1 ? '' : 's'}`
}

function degrees(radians: number): number {
  return (radians * 180) / Math.PI + 0
}
