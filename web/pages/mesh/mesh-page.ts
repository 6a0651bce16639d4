/**
 * The page Mesh: a file becomes a sentence, a list, a picture, and any cell is in the lens. The mesh is in a worker, which is ended
 * when another one is opened; here is what has been asked of it.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import '../element'
import { wordsOf } from '../../core/workers'
import { ofFolder, unfolded } from '../../input/dropped-folders'
import { droppedIn, type PastedInput, pastedIn, takesDrop } from '../../input/pasted-input'
import type { ReadingProgress } from '../../input/reading'
import { WaitingFiles } from '../../input/waiting-files'
import { LOADING } from '../../mesh/hdf5-reader'
import { CellTable } from '../../mesh-views/cell-table'
import { parseCondition } from '../../model/condition'
import { encodePermalink } from '../../model/permalink'
import { OpenSurvey } from '../../survey/open-survey'
import type { Arrangement, Column, Fix, Histogram, Overview, Selected, StepOpening } from '../../survey/survey-jobs'
import { startSurveyWorker } from '../../survey/survey-worker'
import { takeHanded } from '../handed-input'
import { histogramTemplate, type Range } from './histogram-view'
import {
  ALL_FORMATS,
  cancelledWords,
  EXAMPLE,
  FORMATS,
  NOTHING_OPEN,
  namesakeSentence,
  nextSentence,
  refusalWords,
  STAYS,
} from './page-words'
import { partFile } from './part'
import { PictureControls } from './picture-controls'
import { isSettingsText, type Travelling } from './settings-text'
import { SettingsTravel } from './settings-travel'
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

/** Also by columns for which the list has no room. */
const ORDERS: readonly { readonly column: Column; readonly name: string }[] = [
  { column: 'worst', name: 'Worst first' },
  { column: 'id', name: 'By cell' },
  { column: 'minimum', name: 'By minimum' },
  { column: 'volume', name: 'By volume' },
  { column: 'class', name: 'By class' },
  { column: 'accepted-by', name: 'By who accepts' },
  { column: 'block', name: 'By block' },
]

/** What is being read, while the mesh before stays. */
interface UnderWay extends ReadingProgress {
  readonly name: string
}

/** Everything that the page shows; replaced, never changed. */
interface Shown {
  readonly progress: UnderWay | null
  /** What became of the last input, if it is not what is shown. */
  readonly news: string
  readonly overview: Overview | null
  readonly isExample: boolean
  /** About the files that were given. */
  readonly beside: string
  readonly histogram: Histogram | null
  readonly order: Arrangement
  readonly condition: string
  readonly complaint: string | null
  readonly range: Range
  readonly selected: Selected | null
  /** About the list. */
  readonly message: string
}

const FIRST_ORDER: Arrangement = { column: 'worst', isDescending: false }
const NOTHING: Shown = {
  progress: null,
  news: '',
  overview: null,
  isExample: false,
  beside: '',
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
/** Another mesh, which is being read. */
let opening: OpenSurvey | null = null
/** A started worker for the mesh that is opened next. */
let spare: OpenSurvey | null = null
let chosen: { readonly cell: number; readonly rank: number | null } | null = null
const waiting = new WaitingFiles()

const listRoot = document.createElement('div')
listRoot.className = 'list'
const table = new CellTable(listRoot, {
  rows: async (from, to) => (await asked(own => own.rows(from, to))) ?? [],
  arrange: order => void arrange(order),
  choose: (cell, rank) => void choose(cell, rank),
})
const picture = new PictureControls(part('.picture'), {
  cut: cells => survey?.cut(cells) ?? Promise.reject(new Error('No mesh is open.')),
  choose: cell => void chooseInPicture(cell),
  name: async cell => (await asked(own => own.detail(cell)))?.row ?? null,
  changed: () => travel.touch(),
  settingsText: () => travel.text,
  copySettings: () => void travel.copy(),
  takeSettings: text => travel.use(text),
})
const travel = new SettingsTravel({
  now: travelling,
  overview: () => shown.overview,
  use: fitting => {
    picture.use(fitting.picture, fitting.camera)
    void list(fitting)
  },
  say: notice => picture.say(notice),
  written: () => picture.travelled(),
})
const takeAway = new TakeAway({ survey: () => survey, picture: () => picture.toPNG() })

const steps = new StepsView(part('.steps'), {
  chosen: () => chosen?.cell ?? null,
  show: showStep,
  take: async given => {
    set({ ...shown, news: 'refused' in given ? given.refused : '' })
    if ('opened' in given) await take(given.opened, { isExample: false, beside: '' })
  },
  goTo: flyTo,
})

/** The answer of the open mesh; null if another one is open by then, or if its worker has ended, which is said. */
async function asked<T>(ask: (own: OpenSurvey) => Promise<T>): Promise<T | null> {
  const own = survey
  if (!own) return null
  try {
    const answer = await ask(own)
    return own === survey ? answer : null
  } catch (reason) {
    if (own === survey) set({ ...shown, news: wordsOf(reason) })
    return null
  }
}

/** The mesh that was open stays until the other one is decided. */
async function open(given: PastedInput, isExample = false): Promise<void> {
  const input = waiting.completed(given)
  const name = nameOf(input)
  opening?.close()
  const own = spare ?? new OpenSurvey(startSurveyWorker)
  spare = null
  opening = own
  set({ ...shown, progress: { name, step: 'reading', fraction: 0 }, news: '' })
  const result = await own.open(input, progress => {
    if (own === opening) set({ ...shown, progress: { name, ...progress } })
  })
  if (own !== opening) return own.close()
  opening = null
  waiting.refused(input, 'refused' in result ? result.missing : [])
  if ('refused' in result) {
    own.close()
    set({ ...shown, progress: null, news: refusalWords(name, result.refused, openName()) })
    return
  }
  survey?.close()
  survey = own
  const hasSteps = (await asked(open => open.steps())) !== null
  const beside = 'files' in input && !hasSteps ? namesakeSentence(input.paths) : ''
  if (own === survey) await take(result.opened, { isExample, beside })
}

function openName(): string | null {
  if (!survey) return null
  return shown.isExample ? 'the example' : (shown.overview?.name ?? null)
}

/** What comes first is said first: the sentence and the list, then the picture. */
async function take(overview: Overview, about: Pick<Shown, 'isExample' | 'beside'>): Promise<void> {
  const own = survey as OpenSurvey
  // Another mesh may be on its way by now.
  const { news } = shown
  set({ ...NOTHING, ...about, news, progress: opening ? shown.progress : null, overview, selected: allOf(overview) })
  table.show(overview.hexahedra, { hasBlocks: overview.blocks.length > 0, order: FIRST_ORDER }, overview.worst)
  const arriving = travel.arrivingIn(overview, about.isExample)
  picture.open(overview, arriving?.picture, arriving?.camera)
  picture.say(travel.takeNotice())
  void steps.open(own)
  const [worst] = overview.worst
  if (worst) await choose(worst.cell, 0)
  if (arriving && own === survey) await list(arriving)
  const histogram = await asked(open => open.histogram())
  if (histogram === null) return
  set({ ...shown, histogram })
  if ((await asked(open => open.join(part => own === survey && picture.joining(part)))) === null) return
  await picture.show()
  if (chosen && own === survey) await showNeighbours(chosen.cell)
  if (own === survey) await steps.readAll()
  if (own === survey) spare ??= startedSpare()
}

function startedSpare(): OpenSurvey {
  const next = new OpenSurvey(startSurveyWorker)
  next.prepare()
  return next
}

/** All that travels; null while no mesh is open. */
function travelling(): Travelling | null {
  const { overview, condition, complaint, range, order } = shown
  if (!overview || !survey) return null
  const block = overview.blocks[Number(picture.settings.set.slice('block-'.length))]?.name ?? null
  return {
    of: overview.hexahedra,
    picture: picture.settings,
    block,
    camera: picture.camera,
    chosen: chosen?.cell === overview.worst[0]?.cell ? null : (chosen?.cell ?? null),
    listing: { condition: complaint === null ? condition : '', range, order },
  }
}

/** The list and the chosen cell of settings that have come. */
async function list({ listing: { condition, range, order }, chosen: cell }: Travelling): Promise<void> {
  const own = survey
  await arrange(order)
  if (own === survey) await select(condition, range)
  const worst = shown.overview?.worst[0]?.cell
  if (own === survey && (cell ?? worst) !== undefined) await chooseInPicture((cell ?? worst) as number)
}

/** Order, selection and view stay; the chosen cell is the one of the same id. */
async function showStep(
  own: OpenSurvey,
  { opened: overview, chosen: cell }: Extract<StepOpening, { opened: unknown }>,
): Promise<void> {
  if (own !== survey) return
  const { order, condition, range } = shown
  await asked(open => open.arrange(order))
  if (own !== survey) return
  set({ ...shown, overview, selected: allOf(overview) })
  picture.step(overview)
  if (cell === null) chooseNone()
  else await choose(cell, null)
  await select(condition, range)
  const both = await asked(open => Promise.all([open.histogram(), open.join(() => {})]))
  if (both === null) return
  set({ ...shown, histogram: both[0] })
  await picture.show()
  if (cell === null) return
  const place = await asked(open => open.placeOf(cell))
  if (place && chosen?.cell === cell) await choose(cell, place.rank)
}

function chooseNone(): void {
  chosen = null
  table.choose(null, null)
  render(html`The chosen cell is not in this step.`, oneRoot.querySelector('.which') as HTMLElement)
  lens.hidden = true
  picture.choose(null, null, [])
}

function allOf({ hexahedra }: Overview): Selected {
  return { listed: hexahedra, done: hexahedra }
}

function cancel(): void {
  opening?.close()
  opening = null
  set({ ...shown, progress: null, news: cancelledWords(openName()) })
  part('.overview .open').focus()
}

async function arrange(order: Arrangement): Promise<void> {
  if ((await asked(open => open.arrange(order).then(() => true))) === null) return
  set({ ...shown, order })
  showTable()
}

function showTable(): void {
  const { overview, selected, order } = shown
  table.show(selected?.listed ?? 0, { hasBlocks: (overview?.blocks.length ?? 0) > 0, order })
}

async function select(condition: string, range: Range): Promise<void> {
  const { overview } = shown
  if (!overview) return
  const complaint = complaintAbout(condition)
  set({ ...shown, condition, range, complaint })
  if (complaint !== null) return
  const selection = { condition: condition.trim() === '' ? null : condition, range }
  const selected = await asked(own =>
    own.select(selection, overview.hexahedra, found => {
      if (own !== survey) return
      set({ ...shown, selected: found })
      showTable()
    }),
  )
  if (selected) await picture.refresh()
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
  const detail = await asked(open => open.detail(cell))
  if (!detail || chosen?.cell !== cell) return
  const { row, vertices } = detail
  render(
    html`Cell ${row.id}${row.block === null ? '' : `, block ${row.block}`}${
      vertices === null
        ? html`: ${row.why}`
        : html`. <a href=${`./#${encodePermalink(vertices)}`} title="To move its vertices, and for the proof">Open in the lens</a>`
    }`,
    oneRoot.querySelector('.which') as HTMLElement,
  )
  lens.hidden = vertices === null
  if (vertices) lens.vertices = [...vertices]
  picture.choose(cell, vertices, detail.neighbours)
}

async function showNeighbours(cell: number): Promise<void> {
  const detail = await asked(open => open.detail(cell))
  if (detail && chosen?.cell === cell) picture.choose(cell, detail.vertices, detail.neighbours)
}

async function chooseInPicture(cell: number): Promise<void> {
  const place = await asked(open => open.placeOf(cell))
  if (place) await choose(cell, place.rank)
}

async function flyTo(cell: number): Promise<void> {
  await chooseInPicture(cell)
  picture.flyToChosen()
}

async function goToNext(step: 1 | -1): Promise<void> {
  const place = await asked(open => open.nextInvalid(chosen?.rank ?? (step > 0 ? -1 : 0), step))
  if (!place) return
  await choose(place.cell, place.rank)
  picture.flyToChosen()
}

async function goTo(id: string): Promise<void> {
  const own = survey
  const place = await asked(open => open.find(id, chosen?.rank ?? -1))
  if (own !== survey) return
  set({ ...shown, message: place ? '' : `There is no cell ${id} in the list.` })
  if (!place) return
  await choose(place.cell, place.rank)
  picture.flyToChosen()
}

/** The button goes with what it corrects. */
async function mend(fix: Fix): Promise<void> {
  const result = await asked(open => open.mend(fix.id))
  if (!result) return
  set({ ...shown, news: 'refused' in result ? result.refused : '' })
  if ('opened' in result) {
    travel.keep()
    const { isExample, beside } = shown
    const taking = take(result.opened, { isExample, beside })
    part('.overview .headline').focus()
    await taking
  }
}

function set(next: Shown): void {
  shown = next
  render(overviewTemplate(next), overviewRoot)
  render(cellsTemplate(next), cellsRoot)
  render(throughTemplate(next), oneRoot.querySelector('.through') as HTMLElement)
  oneRoot.hidden = next.overview === null
  travel.touch()
}

function overviewTemplate(now: Shown): TemplateResult {
  const { overview, progress, news } = now
  return html`${progress ? progressTemplate(progress) : nothing}
    <div role="status" aria-atomic="false">
      <p class="said">${progress && !news ? `Reading ${progress.name}.` : ''}</p>
      ${news === '' ? nothing : html`<p class="news">${news}</p>`}
      ${overview ? html`<p class="headline" tabindex="-1">${headlineTemplate(overview.headline)}</p>` : nothing}
      ${!overview && !progress ? html`<p class="headline">${NOTHING_OPEN}</p>` : nothing}
    </div>
    <div class=${overview ? 'below has-mesh' : 'below'}>
      <p class="notes">${notesTemplate(now)}</p>
      <p class="buttons">
        ${overview?.fixes.map(fix => html`<button type="button" class="fix" @click=${() => mend(fix)}>${fix.words}</button>`)}
        <button type="button" class="open" title=${ALL_FORMATS} @click=${() => part('input[type=file]').click()}>Open files</button>
        ${FOLDERS === null ? nothing : html`<button type="button" class="folder" title="For example one of time steps" @click=${() => FOLDERS.click()}>Open a folder</button>`}
        <button type="button" @click=${paste}>Paste</button>
        ${takeAway.button}
        <input type="file" multiple hidden @change=${onFiles} />
      </p>
    </div>
    ${takeAway.show(overview)}`
}

function notesTemplate({ overview, isExample, beside }: Shown): TemplateResult {
  const formats = html`<span class="formats" title=${ALL_FORMATS}>${FORMATS}</span>`
  if (!overview) return html`${STAYS} ${formats}`
  const sentences = [...overview.sentences, beside].filter(sentence => sentence !== '')
  const own = sentences.map(sentence => html` ${sentence}`)
  if (isExample) return html`${EXAMPLE} ${STAYS}${own} ${formats}`
  return html`<b>${overview.name}</b>, ${overview.format}. ${STAYS}${own} ${nextSentence(overview)}`
}

/** INVALID counts stand out. */
function headlineTemplate(headline: string): TemplateResult {
  const [first, ...others] = headline.split(/(?<=\.) /)
  return html`<strong>${first}</strong> ${others.join(' ')}`
}

const doing: Readonly<Record<ReadingProgress['step'], (name: string) => string>> = {
  loading: () => LOADING,
  reading: name => `Reading ${name}`,
  deciding: name => `Deciding the cells of ${name}`,
}

function progressTemplate({ name, step, fraction }: UnderWay): TemplateResult {
  return html`<p class="progress">
    <label>${doing[step](name)} <progress max="1" .value=${fraction}></progress></label>
    <button type="button" @click=${cancel}>Cancel</button>
  </p>`
}

function throughTemplate({ overview }: Shown): TemplateResult | typeof nothing {
  if (!overview || overview.counts.invalid === 0) return nothing
  return html`<button type="button" title="Previous invalid cell (P)" aria-label="Previous invalid cell" @click=${() => goToNext(-1)}>Previous</button>
    <button type="button" title="Next invalid cell (N)" aria-label="Next invalid cell" @click=${() => goToNext(1)}>Next</button>`
}

function cellsTemplate({
  overview,
  histogram,
  order,
  condition,
  complaint,
  range,
  selected,
  message,
}: Shown): TemplateResult {
  if (!overview) return html`${nothing}`
  const all = overview.hexahedra.toLocaleString('en')
  const isDone = selected?.done === overview.hexahedra
  const isWhole = isDone && selected.listed === overview.hexahedra
  const count = isWhole
    ? all === '1'
      ? 'One cell'
      : `All ${all} cells`
    : `${(selected?.listed ?? 0).toLocaleString('en')} of ${all} cells`
  return html`<form class="filter" @submit=${(event: Event) => event.preventDefault()}>
      <select aria-label="Usual conditions" @change=${(event: Event) => select((event.target as HTMLSelectElement).value, range)}>
        ${CONDITIONS.map(
          given =>
            html`<option value=${given.condition} .selected=${given.condition === condition}>${given.name}</option>`,
        )}
        <option hidden .selected=${!CONDITIONS.some(given => given.condition === condition)}>Own condition</option>
      </select>
      <select aria-label="Sorted by" @change=${(event: Event) => arrange({ column: (event.target as HTMLSelectElement).value as Column, isDescending: false })}>
        ${ORDERS.filter(({ column }) => column !== 'block' || overview.blocks.length > 0).map(
          given =>
            html`<option value=${given.column} .selected=${given.column === order.column}>${given.name}</option>`,
        )}
      </select>
      <label class="said" for="condition">Cells that are listed meet this condition</label>
      <input
        id="condition"
        .value=${condition}
        placeholder="not valid and corner_min > 0"
        spellcheck="false"
        autocomplete="off"
        autocapitalize="off"
        aria-invalid=${complaint === null ? nothing : 'true'}
        aria-describedby="condition-complaint"
        @change=${(event: Event) => select((event.target as HTMLInputElement).value, range)}
      />
      <p id="condition-complaint" class="complaint" role="status">${complaint}</p>
    </form>
    ${histogram ? histogramTemplate(histogram, range, chosenRange => select(condition, chosenRange)) : nothing}
    <form class="go" @submit=${onGo}>
      <p class="count">
        ${count}${isDone ? '' : `, ${Math.floor((100 * (selected?.done ?? 0)) / overview.hexahedra)} % looked at`}
        ${range === null ? nothing : html`<button type="button" @click=${wholeRange}>Whole range</button>`}
      </p>
      <label>Go to ${overview.hasIds ? 'id' : 'index'} <input name="id" autocomplete="off" spellcheck="false" /></label>
      <button type="submit">Go</button>
    </form>
    <p class="said" role="status">${isDone && !isWhole ? `${count} are listed.` : ''}</p>
    <p class="message" role="status">${message}</p>
    ${listRoot}`
}

function wholeRange(): void {
  void select(shown.condition, null)
  table.focus()
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

/** Null where the browser opens no folders. */
const FOLDERS = folderInput()

function folderInput(): HTMLInputElement | null {
  const input = document.createElement('input')
  if (!('webkitdirectory' in input)) return null
  Object.assign(input, { type: 'file', webkitdirectory: true })
  input.addEventListener('change', () => {
    const given = ofFolder([...(input.files ?? [])])
    input.value = ''
    if ('files' in given && given.files.length > 0) void open(given)
    else set({ ...shown, news: 'There are no files in this folder.' })
  })
  return input
}

async function paste(): Promise<void> {
  try {
    const text = await navigator.clipboard.readText()
    if (text.trim() === '') set({ ...shown, news: 'The clipboard has no text.' })
    else if (isSettingsText(text)) travel.use(text)
    else void open({ text })
  } catch {
    set({ ...shown, news: 'This browser does not let the page read the clipboard: press Ctrl+V instead.' })
  }
}

function nameOf(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}

document.addEventListener('paste', event => {
  const input = pastedIn(event)
  if (input && 'text' in input && isSettingsText(input.text)) travel.use(input.text)
  else if (input) void open(input)
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
  else set({ ...shown, news: 'The folder could not be read.' })
})
document.addEventListener('keydown', event => {
  const isTyping = event.target instanceof HTMLElement && event.target.matches('input, textarea, select, hex-lens')
  if (isTyping || event.altKey || event.ctrlKey || event.metaKey) return
  if (event.key === 'n') void goToNext(1)
  else if (event.key === 'p') void goToNext(-1)
  else return
  event.preventDefault()
})

void start()

/** What the page of the lens has handed over, or the example. */
async function start(): Promise<void> {
  const handed = await takeHanded()
  if (handed && 'input' in handed) return open(handed.input)
  const opening = open({ files: [partFile()] }, true)
  if (handed) set({ ...shown, news: handed.lost })
  return opening
}
