/**
 * The page Mesh: a file becomes a sentence, a list, a picture, and any cell is in the lens. The mesh is in a worker, which is ended
 * when another one is opened; here is what has been asked of it.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import '../element'
import '../skip'
import { unfolded } from '../../input/dropped-folders'
import { droppedIn, type PastedInput, pastedIn, takesDrop } from '../../input/pasted-input'
import type { ReadingProgress } from '../../input/reading'
import { LOADING } from '../../mesh/hdf5-reader'
import { CellTable } from '../../mesh-views/cell-table'
import { parseCondition } from '../../model/condition'
import { encodePermalink } from '../../model/permalink'
import { OpenSurvey } from '../../survey/open-survey'
import type { Arrangement, Fix, Histogram, Opening, Overview, Selected, StepOpening } from '../../survey/survey-jobs'
import { startSurveyWorker } from '../../survey/survey-worker'
import { histogramTemplate, type Range } from './histogram-view'
import { partFile } from './part'
import { PictureControls } from './picture-controls'
import { StepsView } from './steps-view'
import { TakeAway } from './take-away'

const part = (selector: string) => document.querySelector(selector) as HTMLElement
const overviewRoot = part('.overview')
const cellsRoot = part('.cells')
const oneRoot = part('.one')
const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']

/** Conditions that are asked for most. */
const CONDITIONS: readonly { readonly name: string; readonly condition: string }[] = [
  { name: 'All cells', condition: '' },
  { name: 'Invalid', condition: 'not valid' },
  { name: 'Invalid, yet the corners accept', condition: 'not valid and corner_min > 0' },
  { name: 'Invalid, yet VTK’s scaled Jacobian accepts', condition: 'not valid and scaled_jacobian > 0' },
  { name: 'Invalid, yet 2×2×2 Gauss points accept', condition: 'not valid and gauss2_min > 0' },
  { name: 'Relative minimum below 0.2', condition: 'boundary_min / volume < 0.2' },
]

/** Everything that the page shows; replaced, never changed. */
interface Shown {
  readonly name: string
  /** Of the input that is being read; what is open stays until it has been. */
  readonly reading: { readonly name: string; readonly progress: ReadingProgress } | null
  readonly refused: string | null
  readonly overview: Overview | null
  readonly isExample: boolean
  readonly histogram: Histogram | null
  readonly order: Arrangement
  readonly condition: string
  readonly complaint: string | null
  readonly range: Range
  readonly selected: Selected | null
  readonly message: string
}

const FIRST_ORDER: Arrangement = { column: 'worst', isDescending: false }
const NOTHING: Shown = {
  name: '',
  reading: null,
  refused: null,
  overview: null,
  isExample: false,
  histogram: null,
  order: FIRST_ORDER,
  condition: '',
  complaint: null,
  range: null,
  selected: null,
  message: '',
}

let shown: Shown = NOTHING
let survey: OpenSurvey | null = null
/** Reads the input that will take its place. */
let reader: OpenSurvey | null = null
let chosen: { readonly cell: number; readonly rank: number | null } | null = null

const listRoot = document.createElement('div')
listRoot.className = 'list'
const table = new CellTable(listRoot, {
  rows: (from, to) => survey?.rows(from, to) ?? Promise.resolve([]),
  arrange: order => void arrange(order),
  choose: (cell, rank) => void choose(cell, rank),
})
const picture = new PictureControls(part('.picture'), {
  faces: cells => survey?.faces(cells) ?? Promise.reject(new Error('No mesh is open.')),
  choose: cell => void chooseInPicture(cell),
  name: async cell => (await survey?.detail(cell))?.row ?? null,
})
const takeAway = new TakeAway({ survey: () => survey, picture: () => picture.toPNG() })

const steps = new StepsView(part('.steps'), {
  chosen: () => chosen?.cell ?? null,
  show: showStep,
  take: takeOrRefuse,
  goTo: flyTo,
})

async function open(input: PastedInput, isExample = false): Promise<void> {
  const name = nameOf(input)
  const own = new OpenSurvey(startSurveyWorker)
  reader?.close()
  reader = own
  const onProgress = (progress: ReadingProgress) => {
    if (own === reader) set({ ...shown, reading: { name, progress } })
  }
  set({ ...shown, refused: null, message: '' })
  onProgress({ step: 'reading', fraction: 0 })
  const opening = await own.open(input, onProgress)
  if (own !== reader) return own.close()
  reader = null
  set({ ...shown, reading: null })
  if ('refused' in opening) {
    own.close()
    set({ ...shown, refused: opening.refused })
    return
  }
  survey?.close()
  survey = own
  await take(opening.opened, isExample)
}

/** What comes first is said first: the sentence and the list, then the picture. */
async function take(overview: Overview, isExample: boolean): Promise<void> {
  const own = survey as OpenSurvey
  set({ ...NOTHING, name: overview.name, overview, isExample, selected: allOf(overview) })
  table.show(overview.hexahedra, { hasBlocks: overview.blocks.length > 0, order: FIRST_ORDER })
  picture.open(overview)
  void steps.open(own)
  const [worst] = overview.worst
  if (worst) await choose(worst.cell, 0)
  const histogram = await own.histogram()
  if (own !== survey) return
  set({ ...shown, histogram })
  await own.join(() => {})
  if (own !== survey) return
  await picture.show()
  if (chosen && own === survey) await showNeighbours(chosen.cell)
  if (own === survey) await steps.readAll()
}

/** Order, selection and view stay; the chosen cell is the one of the same id. */
async function showStep(
  own: OpenSurvey,
  { opened: overview, chosen: cell }: Extract<StepOpening, { opened: unknown }>,
): Promise<void> {
  if (own !== survey) return
  const { order, condition, range } = shown
  await own.arrange(order)
  if (own !== survey) return
  set({ ...shown, name: overview.name, overview, selected: allOf(overview) })
  picture.step(overview)
  if (cell === null) chooseNone()
  else await choose(cell, null)
  await select(condition, range)
  const [histogram] = await Promise.all([own.histogram(), own.join(() => {})])
  if (own !== survey) return
  set({ ...shown, histogram })
  await picture.show()
  if (cell === null || own !== survey) return
  const { rank } = await own.placeOf(cell)
  if (own === survey && chosen?.cell === cell) await choose(cell, rank)
}

function chooseNone(): void {
  chosen = null
  table.choose(null, null)
  render(html`The chosen cell is not in this step.`, oneRoot.querySelector('.which') as HTMLElement)
  lens.hidden = true
  picture.choose(null, [])
}

function allOf({ hexahedra }: Overview): Selected {
  return { listed: hexahedra, done: hexahedra }
}

function cancel(): void {
  reader?.close()
  reader = null
  const left = shown.overview ? `${shown.name} is still open.` : 'Nothing is open.'
  set({ ...shown, reading: null, message: `Cancelled. ${left}` })
}

async function arrange(order: Arrangement): Promise<void> {
  await survey?.arrange(order)
  set({ ...shown, order })
  showTable()
}

function showTable(): void {
  const { overview, selected, order } = shown
  table.show(selected?.listed ?? 0, { hasBlocks: (overview?.blocks.length ?? 0) > 0, order })
}

async function select(condition: string, range: Range): Promise<void> {
  const { overview } = shown
  if (!survey || !overview) return
  const complaint = complaintAbout(condition)
  set({ ...shown, condition, range, complaint })
  if (complaint !== null) return
  const selection = { condition: condition.trim() === '' ? null : condition, range }
  await survey.select(selection, overview.hexahedra, selected => {
    set({ ...shown, selected })
    showTable()
  })
  await picture.refresh()
}

function complaintAbout(condition: string): string | null {
  if (condition.trim() === '') return null
  const parsed = parseCondition(condition)
  if (!parsed.ok) return parsed.error.message
  return parsed.value.names.includes('moved') ? 'Nothing has been moved here: “moved” is for challenges.' : null
}

async function choose(cell: number, rank: number | null): Promise<void> {
  chosen = { cell, rank }
  table.choose(cell, rank)
  const own = survey
  const detail = await own?.detail(cell)
  if (!detail || own !== survey || chosen?.cell !== cell) return
  const { row, vertices } = detail
  render(
    html`Cell ${row.id}${row.block === null ? '' : `, block ${row.block}`}${
      vertices === null ? html`: ${row.why}` : html`. <a href=${`./#${encodePermalink(vertices)}`}>Open in the lens</a>`
    }`,
    oneRoot.querySelector('.which') as HTMLElement,
  )
  lens.hidden = vertices === null
  if (vertices) lens.vertices = [...vertices]
  picture.choose(vertices, detail.neighbours)
}

async function showNeighbours(cell: number): Promise<void> {
  const detail = await survey?.detail(cell)
  if (detail && chosen?.cell === cell) picture.choose(detail.vertices, detail.neighbours)
}

async function chooseInPicture(cell: number): Promise<void> {
  const place = await survey?.placeOf(cell)
  if (place) await choose(cell, place.rank)
}

async function flyTo(cell: number): Promise<void> {
  await chooseInPicture(cell)
  picture.flyToChosen()
}

async function goToNext(step: 1 | -1): Promise<void> {
  const place = await survey?.nextInvalid(chosen?.rank ?? (step > 0 ? -1 : 0), step)
  if (!place) return
  await choose(place.cell, place.rank)
  picture.flyToChosen()
}

async function goTo(id: string): Promise<void> {
  const place = await survey?.find(id, chosen?.rank ?? -1)
  set({ ...shown, message: place ? '' : `There is no cell ${id} in the list.` })
  if (!place) return
  await choose(place.cell, place.rank)
  picture.flyToChosen()
}

async function mend(fix: Fix): Promise<void> {
  const own = survey
  const opening: Opening | undefined = await own?.mend(fix.id)
  if (opening && own === survey) await takeOrRefuse(opening)
}

async function takeOrRefuse(opening: Opening): Promise<void> {
  if ('opened' in opening) await take(opening.opened, shown.isExample)
  else set({ ...shown, refused: opening.refused })
}

function set(next: Shown): void {
  shown = next
  render(overviewTemplate(next), overviewRoot)
  render(cellsTemplate(next), cellsRoot)
}

function overviewTemplate({ overview, reading, refused, isExample, name, message }: Shown): TemplateResult {
  return html`<div class="said" role="status">${refused ?? (reading ? `Reading ${reading.name}.` : (overview?.headline ?? message))}</div>
    ${reading ? progressTemplate(reading.progress, reading.name) : nothing}
    ${refused === null ? nothing : html`<p class="refused">${refused}</p>`}
    ${overview ? html`<p class="headline">${headlineTemplate(overview.headline)}</p>` : html`<p>${message}</p>`}
    <div class="below">
      <p class="notes">
        ${isExample ? 'An elbow of a pipe in which some points are misplaced. Drop your own mesh here: it stays in this browser.' : html`<b>${name}</b>${overview ? `, ${overview.format}. It stays in this browser.` : ''}`}
        ${overview?.sentences.map(sentence => html` ${sentence}`)}
      </p>
      <p class="buttons">
        ${overview?.fixes.map(fix => html`<button type="button" @click=${() => mend(fix)}>${fix.words}</button>`)}
        <button type="button" @click=${() => part('input[type=file]').click()}>Open a file</button>
        <button type="button" @click=${paste}>Paste</button>
        ${takeAway.button}
        <input type="file" multiple hidden @change=${onFiles} />
      </p>
    </div>
    ${takeAway.show(overview)}`
}

/** INVALID counts stand out. */
function headlineTemplate(headline: string): TemplateResult {
  const [first, ...others] = headline.split(/(?<=\.) /)
  return html`<strong>${first}</strong> ${others.join(' ')}`
}

const doing: Readonly<Record<ReadingProgress['step'], (name: string) => string>> = {
  loading: () => LOADING,
  reading: name => `Reading ${name}`,
  deciding: () => 'Deciding its cells',
}

function progressTemplate({ step, fraction }: ReadingProgress, name: string): TemplateResult {
  return html`<p class="progress">
    <label>${doing[step](name)} <progress max="1" .value=${fraction}></progress></label>
    <button type="button" @click=${cancel}>Cancel</button>
  </p>`
}

function cellsTemplate({ overview, histogram, condition, complaint, range, selected, message }: Shown): TemplateResult {
  if (!overview) return html`${nothing}`
  const isDone = selected?.done === overview.hexahedra
  return html`<form class="filter" @submit=${(event: Event) => event.preventDefault()}>
      <label class="said" for="condition">Cells that are listed meet this condition</label>
      <select aria-label="Usual conditions" @change=${(event: Event) => select((event.target as HTMLSelectElement).value, range)}>
        ${CONDITIONS.map(
          given =>
            html`<option value=${given.condition} ?selected=${given.condition === condition}>${given.name}</option>`,
        )}
        <option hidden ?selected=${!CONDITIONS.some(given => given.condition === condition)}>Own condition</option>
      </select>
      <input
        id="condition"
        .value=${condition}
        placeholder="not valid and corner_min > 0"
        spellcheck="false"
        autocomplete="off"
        aria-invalid=${complaint === null ? nothing : 'true'}
        aria-describedby="condition-complaint"
        @change=${(event: Event) => select((event.target as HTMLInputElement).value, range)}
      />
      <p id="condition-complaint" class="complaint" role="status">${complaint}</p>
    </form>
    ${histogram ? histogramTemplate(histogram, range, chosenRange => select(condition, chosenRange)) : nothing}
    <form class="go" @submit=${onGo}>
      <p class="count" role="status">
        ${selected ? `${selected.listed.toLocaleString('en')} of ${overview.hexahedra.toLocaleString('en')} cells` : ''}${isDone ? '' : `, ${Math.floor((100 * (selected?.done ?? 0)) / overview.hexahedra)} % looked at`}
        ${range === null ? nothing : html`<button type="button" @click=${() => select(condition, null)}>Whole range</button>`}
      </p>
      <label>Go to ${overview.hasIds ? 'id' : 'index'} <input name="id" autocomplete="off" spellcheck="false" /></label>
      <button type="submit">Go</button>
      <button type="button" title="Previous invalid cell (P)" @click=${() => goToNext(-1)}>Previous</button>
      <button type="button" title="Next invalid cell (N)" @click=${() => goToNext(1)}>Next</button>
    </form>
    <p class="message" role="status">${message}</p>
    ${listRoot}`
}

function onGo(event: SubmitEvent): void {
  event.preventDefault()
  const id = new FormData(event.target as HTMLFormElement).get('id')
  if (typeof id === 'string' && id.trim() !== '') void goTo(id.trim())
}

function onFiles(event: Event): void {
  const input = event.target as HTMLInputElement
  const files = [...(input.files ?? [])]
  input.value = ''
  if (files.length > 0) void open({ files })
}

async function paste(): Promise<void> {
  try {
    const text = await navigator.clipboard.readText()
    if (text.trim() === '') set({ ...shown, refused: 'The clipboard has no text.' })
    else void open({ text })
  } catch {
    set({ ...shown, refused: 'This browser does not let the page read the clipboard: press Ctrl+V instead.' })
  }
}

function nameOf(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}

document.addEventListener('paste', event => {
  const input = pastedIn(event)
  if (input) void open(input)
})
document.addEventListener('dragover', event => {
  if (!takesDrop(event) || !event.dataTransfer) return
  event.preventDefault()
  event.dataTransfer.dropEffect = 'copy'
  document.body.classList.add('is-drop-target')
})
for (const type of ['dragleave', 'drop', 'dragend'])
  document.addEventListener(type, () => document.body.classList.remove('is-drop-target'))
document.addEventListener('drop', async event => {
  const input = droppedIn(event)
  if (!input) return
  const whole = await Promise.resolve(unfolded(event, input)).catch(() => null)
  if (whole) void open(whole)
  else set({ ...shown, refused: 'The folder could not be read.' })
})
document.addEventListener('keydown', event => {
  const isTyping = event.target instanceof HTMLElement && event.target.matches('input, textarea, select, hex-lens')
  if (isTyping || event.altKey || event.ctrlKey || event.metaKey) return
  if (event.key === 'n') void goToNext(1)
  else if (event.key === 'p') void goToNext(-1)
  else return
  event.preventDefault()
})

void open({ files: [partFile()] }, true)
