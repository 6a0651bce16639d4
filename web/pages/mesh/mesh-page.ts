/**
 * The page Mesh: a file becomes a sentence, a list, a picture, and any cell is in the lens. The mesh is in a worker, which is ended
 * when another one is opened; here is what has been asked of it.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import '../element'
import { wordsOf } from '../../core/workers'
import type { PastedInput } from '../../input/pasted-input'
import type { ReadingProgress } from '../../input/reading'
import { WaitingFiles } from '../../input/waiting-files'
import { LOADING } from '../../mesh/hdf5-reader'
import { CellTable } from '../../mesh-views/cell-table'
import { parseCondition } from '../../model/condition'
import { encodePermalink } from '../../model/permalink'
import { OpenSurvey } from '../../survey/open-survey'
import type {
  Arrangement,
  Column,
  Fix,
  Histogram,
  MovedMesh,
  MovementCounts,
  Overview,
  Selected,
  ShownCells,
  StepOpening,
} from '../../survey/survey-jobs'
import { startSurveyWorker } from '../../survey/survey-worker'
import { takeHanded } from '../handed-input'
import { type Arranging, arrangingTemplate } from './arranging'
import { EXAMPLES, type Example } from './examples'
import type { Range } from './histogram-range'
import { HistogramView } from './histogram-view'
import { InputDoor } from './input-door'
import { MovingLens, NOTHING_MOVED } from './moving-lens'
import { notesTemplate } from './notes'
import {
  acceptedSentence,
  cancelledWords,
  NOT_IN_STEPS,
  NOTHING_OPEN,
  namesakeSentence,
  refusalWords,
  unsavedSentence,
} from './page-words'
import { PictureControls } from './picture-controls'
import { PlaceFold } from './place-fold'
import type { Travelling } from './settings-text'
import { SettingsTravel } from './settings-travel'
import { StepsView } from './steps-view'
import { TakeAway } from './take-away'
import { UntanglePanel } from './untangle-panel'

const part = (selector: string) => document.querySelector(selector) as HTMLElement
const overviewRoot = part('.overview')
const cellsRoot = part('.cells')
const oneRoot = part('.one')
const acceptedRoot = part('.one .accepted')
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

/** A mesh whose moved vertices are in no file, while another one is shown. */
interface PutAside extends Pick<Shown, 'example' | 'beside' | 'movement'> {
  readonly survey: OpenSurvey
  readonly overview: Overview
}

/** Everything that the page shows; replaced, never changed. */
interface Shown {
  readonly progress: UnderWay | null
  /** What became of the last input, if it is not what is shown. */
  readonly news: string
  readonly aside: PutAside | null
  readonly overview: Overview | null
  readonly example: Example | null
  readonly movement: MovementCounts
  /** About the files that were given. */
  readonly beside: string
  readonly histogram: Histogram | null
  readonly order: Arrangement
  /** An order that takes longer, and which part is done. */
  readonly arranging: Arranging | null
  readonly condition: string
  readonly complaint: string | null
  readonly range: Range
  readonly selected: Selected | null
  /** About the list. */
  readonly message: string
}

const BOUNDARY: ShownCells = { cells: { which: 'all' }, isWhole: false, most: Infinity }
/** As in mesh.css. */
const PHONE = '(max-width: 43.99rem)'
const FIRST_ORDER: Arrangement = { column: 'worst', isDescending: false }
const NOTHING: Shown = {
  progress: null,
  news: '',
  aside: null,
  overview: null,
  example: null,
  movement: NOTHING_MOVED,
  beside: '',
  histogram: null,
  order: FIRST_ORDER,
  arranging: null,
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
  choose: (cell, rank) => void chooseInList(cell, rank),
})
const histogramView = new HistogramView(range => void select(shown.condition, range))
const picture = new PictureControls(part('.picture'), {
  boundary: () => survey?.faces(BOUNDARY) ?? Promise.reject(new Error('No mesh is open.')),
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
const takeAway = new TakeAway({
  survey: () => survey,
  picture: () => picture.toPNG(),
  saved: () => {
    isSaved = true
  },
})
const moving = new MovingLens(lens, oneRoot.querySelector('.moving') as HTMLElement, {
  rows: rows => {
    table.patch(rows)
    const row = rows.find(({ cell }) => cell === chosen?.cell)
    if (row) acceptedRoot.textContent = acceptedSentence(row)
  },
  move: moves => void takeMoved(own => own.move(moves)),
  step: which => void takeMoved(own => own[which]()),
  restore: points => void takeMoved(own => own.restore(points)),
  freed: () => place.refresh(),
})
const place = new PlaceFold(oneRoot.querySelector('.place') as HTMLElement, {
  move: (point, to) => takeMoved(own => own.move({ points: Uint32Array.of(point), to: Float64Array.from(to) })),
  whyFixed: vertex => moving.whyFixed(vertex),
  mark: marks => lens.markPlace(marks),
})
const untangling = new UntanglePanel({
  survey: () => survey,
  chosen: () => chosen?.cell ?? null,
  ghost: lines => {
    picture.ghostLines = lines?.ends ?? null
  },
  take: moves => void takeMoved(own => own.move(moves)),
  goTo: cell => void flyTo(cell),
})

const door = new InputDoor({
  open: input => void open(input),
  use: settings => travel.use(settings),
  say: news => set({ ...shown, news }),
})

const steps = new StepsView(part('.steps'), {
  chosen: () => chosen?.cell ?? null,
  show: showStep,
  take: async given => {
    set({ ...shown, news: 'refused' in given ? given.refused : '' })
    if ('opened' in given) await take(given.opened, { example: null, beside: '' })
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
async function open(given: PastedInput, example: Example | null = null): Promise<void> {
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
  waiting.refused(input, 'refused' in result ? result.missing : [])
  if ('refused' in result) {
    opening = null
    own.close()
    set({ ...shown, progress: null, news: refusalWords(name, result.refused, openName()) })
    return
  }
  await lastMove
  if (own !== opening) return own.close()
  opening = null
  putAside()
  survey = own
  const hasSteps = (await asked(open => open.steps())) !== null
  const beside = 'files' in input && !hasSteps ? namesakeSentence(input.paths) : ''
  if (own === survey) await take(result.opened, { example, beside })
}

function hasUnsavedMoves(): boolean {
  return shown.movement.movedCount > 0 && !isSaved
}

/** Makes room for another mesh. */
function putAside(): void {
  const { overview, example, beside, movement } = shown
  if (!survey) return
  if (!overview || !hasUnsavedMoves()) {
    survey.close()
    return
  }
  shown.aside?.survey.close()
  shown = { ...shown, aside: { survey, overview, example, beside, movement } }
}

async function bringBack({ survey: own, overview, ...about }: PutAside): Promise<void> {
  opening?.close()
  opening = null
  await lastMove
  shown = { ...shown, aside: null, news: '' }
  putAside()
  survey = own
  isSaved = false
  await asked(open => open.arrange(FIRST_ORDER))
  await asked(open => open.select({ condition: null, range: null }, overview.hexahedra, () => {}))
  if (own !== survey) return
  const taking = take(overview, about)
  part('.overview .headline').focus()
  await taking
}

function openName(): string | null {
  if (!survey) return null
  return shown.example ? 'the example' : (shown.overview?.name ?? null)
}

/** What comes first is said first: the sentence and the list, then the picture. */
async function take(
  overview: Overview,
  about: Pick<Shown, 'example' | 'beside'> & Partial<Pick<Shown, 'movement'>>,
): Promise<void> {
  const own = survey as OpenSurvey
  // Another mesh may be on its way by now.
  const { news, aside } = shown
  set({
    ...NOTHING,
    ...about,
    news,
    aside,
    progress: opening ? shown.progress : null,
    overview,
    selected: allOf(overview),
  })
  table.show(overview.hexahedra, { hasBlocks: overview.blocks.length > 0, order: FIRST_ORDER }, overview.worst)
  const arriving = travel.arrivingIn(overview, about.example !== null)
  picture.open(overview, arriving?.picture, arriving?.camera)
  picture.say(travel.takeNotice())
  moving.movement = shown.movement
  await steps.open(own)
  if (own !== survey) return
  untangling.open(overview, steps.hasSteps ? NOT_IN_STEPS : '')
  const [worst] = overview.worst
  if (worst) await choose(worst.cell, 0)
  if (arriving && own === survey) await list(arriving)
  const histogram = await asked(open => open.histogram())
  if (histogram === null) return
  set({ ...shown, histogram })
  if ((await asked(open => open.join(part => own === survey && picture.joining(part)))) === null) return
  await picture.show()
  if (chosen && own === survey) await choose(chosen.cell, null)
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
  await showAnew(own, overview, cell)
}

/** The same cells with other points. */
async function showAnew(own: OpenSurvey, overview: Overview, cell: number | null): Promise<void> {
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

/** Moves that are on their way to the mesh; what comes of the last is shown. */
let movesUnderWay = 0
let lastMove: Promise<unknown> = Promise.resolve()
/** True if the mesh as it is is in a file. */
let isSaved = false

async function takeMoved(step: (own: OpenSurvey) => Promise<MovedMesh>): Promise<void> {
  const own = survey
  movesUnderWay++
  const answer = asked(step)
  lastMove = answer
  const moved = await answer
  movesUnderWay--
  if (!own || own !== survey || moved === null) return
  isSaved = false
  set({ ...shown, movement: moved.movement })
  moving.movement = moved.movement
  untangling.moved(moved.opened)
  if (movesUnderWay === 0) await showAnew(own, moved.opened, chosen?.cell ?? null)
}

function chooseNone(): void {
  chosen = null
  moving.showNone()
  place.show(null)
  table.choose(null, null)
  acceptedRoot.textContent = ''
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
  const own = survey
  const onStep = (fraction: number) => own === survey && set({ ...shown, arranging: { order, fraction } })
  const isArranged = await asked(open => open.arrange(order, onStep))
  if (!isArranged) return
  const isOther = order.column !== shown.order.column || order.isDescending !== shown.order.isDescending
  set({ ...shown, order, arranging: null })
  showTable()
  if (isOther) table.toStart()
}

function cancelArranging(): void {
  survey?.cancelArranging()
  set({ ...shown, arranging: null })
  table.focus()
}

function showTable(): void {
  const { overview, selected, order } = shown
  table.show(selected?.listed ?? 0, { hasBlocks: (overview?.blocks.length ?? 0) > 0, order })
}

async function select(condition: string, range: Range): Promise<void> {
  const { overview } = shown
  if (!overview) return
  const complaint = complaintAbout(condition)
  const isOther = condition !== shown.condition || range !== shown.range
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
  if (!selected) return
  if (isOther) table.toStart()
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
  const answers = await asked(open => Promise.all([open.detail(cell), open.around(cell)]))
  if (!answers || chosen?.cell !== cell || movesUnderWay > 0) return
  const [{ row, vertices, neighbours }, around] = answers
  render(
    html`Cell ${row.id}${row.block === null ? '' : `, block ${row.block}`}${
      vertices === null
        ? html`: ${row.why}`
        : html`. <a href=${`./#${encodePermalink(vertices)}`} title="To move its vertices, and for the proof">Open in the lens</a>`
    }`,
    oneRoot.querySelector('.which') as HTMLElement,
  )
  acceptedRoot.textContent = acceptedSentence(row)
  lens.hidden = vertices === null
  if (vertices) moving.show(cell, vertices, around, { hasSteps: steps.hasSteps })
  else moving.showNone()
  place.show(vertices && { id: row.id, cell, around })
  picture.choose(cell, vertices, neighbours)
}

/** On a phone the lens lies below the list. */
async function chooseInList(cell: number, rank: number): Promise<void> {
  await choose(cell, rank)
  if (matchMedia(PHONE).matches) oneRoot.scrollIntoView({ block: 'nearest' })
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
    const { example, beside, movement } = shown
    const taking = take(result.opened, { example, beside, movement })
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
  const { overview, progress, news, aside } = now
  return html`${progress ? progressTemplate(progress) : nothing}
    <div role="status" aria-atomic="false">
      <p class="said">${progress && !news ? `Reading ${progress.name}.` : ''}</p>
      ${news === '' ? nothing : html`<p class="news">${news}</p>`}
      ${aside ? asideTemplate(aside) : nothing}
      ${overview ? html`<p class="headline" tabindex="-1">${headlineTemplate(overview.headline)}</p>` : nothing}
      ${!overview && !progress ? html`<p class="headline">${NOTHING_OPEN}</p>` : nothing}
    </div>
    <div class=${overview ? 'below has-mesh' : 'below'}>
      <div class="notes">${notesTemplate(now)}</div>
      <p class="buttons">
        ${overview?.fixes.map(fix => html`<button type="button" class="fix" @click=${() => mend(fix)}>${fix.words}</button>`)}
        ${door.buttons}
        ${takeAway.button} ${untangling.button}
        ${examplesTemplate(now)}
      </p>
    </div>
    ${takeAway.show(overview, now.movement)} ${untangling.root}`
}

function asideTemplate(aside: PutAside): TemplateResult {
  const name = aside.example ? 'the example before' : aside.overview.name
  return html`<p class="news">
    ${unsavedSentence(name, aside.movement.movedCount)}
    <button type="button" @click=${() => bringBack(aside)}>Back to ${name}</button>
  </p>`
}

function examplesTemplate({ example }: Shown): TemplateResult {
  return html`<select class="examples" aria-label="Examples" @change=${onExample}>
    <option value="" .selected=${example === null}>Examples</option>
    ${EXAMPLES.map((each, i) => html`<option value=${i} .selected=${each === example}>${each.name}</option>`)}
  </select>`
}

function onExample({ target }: Event): void {
  const example = EXAMPLES[Number((target as HTMLSelectElement).value || -1)]
  if (example) void open({ files: [example.file()] }, example)
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
    <label>${doing[step](name)} <progress max="1" value=${step === 'loading' ? nothing : fraction}></progress></label>
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
  arranging,
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
            html`<option value=${given.column} .selected=${given.column === (arranging?.order ?? order).column}>${given.name}</option>`,
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
    ${histogramView.show(histogram, range)}
    <form class="go" @submit=${onGo}>
      <p class="count" title=${isDone ? nothing : 'So many per cent of the cells have been looked at'}>
        ${count}${isDone ? '' : `, ${Math.floor((100 * (selected?.done ?? 0)) / overview.hexahedra)} %`}
        ${range === null ? nothing : html`<button type="button" title="Whole range" aria-label="Whole range" @click=${wholeRange}>✕</button>`}
      </p>
      <label>Go to ${overview.hasIds ? 'id' : 'index'} <input name="id" autocomplete="off" spellcheck="false" /></label>
      <button type="submit">Go</button>
    </form>
    <p class="said" role="status">${isDone && !isWhole ? `${count} are listed.` : ''}</p>
    <p class="message" role="status">${message}</p>
    ${arranging ? arrangingTemplate(arranging, cancelArranging) : nothing}
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

function nameOf(input: PastedInput): string {
  if ('text' in input) return 'the text'
  const [first] = input.files
  return input.files.length === 1 && first ? first.name : `${input.files.length} files`
}

document.addEventListener('keydown', event => {
  const isTyping = event.target instanceof HTMLElement && event.target.matches('input, textarea, select, hex-lens')
  if (isTyping || event.altKey || event.ctrlKey || event.metaKey) return
  if (event.key === 'n') void goToNext(1)
  else if (event.key === 'p') void goToNext(-1)
  else return
  event.preventDefault()
})

addEventListener('beforeunload', event => {
  if (hasUnsavedMoves() || shown.aside) event.preventDefault()
})

void start()

/** What the page of the lens has handed over, or the example. */
async function start(): Promise<void> {
  const handed = await takeHanded()
  if (handed && 'input' in handed) return open(handed.input)
  const [first] = EXAMPLES
  const opening = open({ files: [first.file()] }, first)
  if (handed) set({ ...shown, news: handed.lost })
  return opening
}
