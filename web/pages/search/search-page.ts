/**
 * The page Search: a form, a search in workers, its finds as small pictures, and elements that the
 * reader keeps. The form's state is in the address's query, the element in the lens in its
 * fragment; searches are kept with their finds, so that leaving the page loses none.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import '../element'
import type { Vertices } from '../../model/hexahedron'
import { decodePermalink, encodePermalink } from '../../model/permalink'
import { saveFile } from '../../views/save-file'
import { entryAt, keepEntry, presentKey } from '../history-entries'
import { onSettled } from '../on-settled'
import { Pictures } from '../pictures'
import { put } from '../put'
import { scrollOf, scrollTo } from '../scroll'
import { searchWorkers } from './engine'
import { parseQuery } from './engine/query'
import type { Order } from './engine/ranking'
import { Search, type SearchWorkers } from './engine/search'
import { Tally } from './engine/tally'
import { formTemplate, kindTemplate } from './form'
import { decodeForm, encodeForm, type FormState, queryOf, withField } from './form-state'
import { choiceOf, countsText, foundTemplate, shownFinds } from './found'
import { Improvement, type ImprovementRequest, improvedName, improvementButton, outcomeText } from './improvement'
import { inTheLensTemplate } from './in-the-lens'
import { exported, isSame, type KeptElement, KeptElements } from './kept'
import { SearchKeeper, type SearchRecord, searchOf, withSearch } from './kept-searches'
import { LiveRegion } from './live-region'
import { Redraw } from './redraw'
import { type Choice, choicesTemplate, keptTemplate } from './results'
import '../skip'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const root = document.querySelector('.searching') as HTMLElement

/** Milliseconds: more often nobody reads the numbers. */
const REDRAW = 500
const SOON = 20

const pictures = new Pictures(lens, root, () => schedule(hasFirstPicture && isRunning() ? REDRAW : SOON))
const kept = new KeptElements(() => localStorage)
const keeper = new SearchKeeper()
const liveRegion = new LiveRegion(document.querySelector('.news') as HTMLElement)

const work = keeper.found()
let { form, problems } = decodeForm(new URLSearchParams(location.search || (work?.form ?? '')))
let parsed = parseQuery(queryOf(form))
let searches: readonly SearchRecord[] = work?.searches ?? []
let order: Order = work?.order ?? 'simplicity'
/** The search under way, or that can go on at once, and since when it runs. */
let search: Search | null = null
let since = 0
let showsAll = false
/** False while the first find is not seen yet. */
let hasFirstPicture = false
/** The last element that this page gave to the lens. */
let chosen: Choice | null = null
let improvement: Improvement | null = null
let ended: Improvement | null = null
let failure: string | null = null
const redraw = new Redraw(draw)

function schedule(delay = isRunning() ? REDRAW : SOON): void {
  redraw.within(delay)
}

function draw(): void {
  redraw.cancel()
  const record = shownRecord()
  const finds = record ? shownFinds({ record, order, showsAll, isRunning: isRunning() }) : []
  pictures.begin([...finds, ...kept.elements].map(({ vertices }) => vertices))
  render(template(record), root)
  hasFirstPicture = finds[0] !== undefined && pictures.of(finds[0].vertices) !== null
  if (pictures.isBehind) schedule(SOON)
}

function template(record: SearchRecord | undefined): TemplateResult {
  const props = { form, errors: parsed.ok ? [] : parsed.error, onChange: change, onSubmit: begin }
  return html`${problems.map(problem => html`<p class="complaint" role="alert">${problem}</p>`)}
    ${kindTemplate(props)} ${running(record)}
    ${record ? [found(record), inTheLens()] : nothing}
    ${formTemplate(props)}
    ${record ? nothing : inTheLens()} ${keptElements()}`
}

/** The search of the form, or the latest. */
function shownRecord(): SearchRecord | undefined {
  return recordOfForm() ?? searches[0]
}

function recordOfForm(): SearchRecord | undefined {
  return parsed.ok ? searchOf(searches, parsed.value.query) : undefined
}

function isRunning(): boolean {
  return search?.isRunning ?? false
}

function running(record: SearchRecord | undefined): TemplateResult {
  const own = recordOfForm()
  const canGoOn = !isRunning() && own !== undefined && own.tally.elements > 0
  const label = isRunning() ? 'Stop' : canGoOn ? 'Start over' : 'Start'
  // One button, which keeps the focus.
  return html`<div class="run">
      <button
        type=${isRunning() ? 'button' : 'submit'}
        form="query"
        ?disabled=${!isRunning() && !parsed.ok}
        @click=${isRunning() ? stop : null}
      >${label}</button>
      ${canGoOn ? html`<button type="button" @click=${() => run(own)}>Continue</button>` : nothing}
      <p class="counts">${record && counts(record)}</p>
    </div>
    ${failure === null ? nothing : html`<p class="complaint" role="alert">${failure}</p>`}`
}

function counts({ tally, ran }: SearchRecord): string {
  if (tally.elements === 0) return isRunning() ? 'Starting …' : ''
  return countsText(tally, ran + (isRunning() ? performance.now() - since : 0))
}

function inTheLens(): TemplateResult | typeof nothing {
  const { report } = lens
  if (!parsed.ok || !report) return nothing
  return inTheLensTemplate({
    parsed: parsed.value,
    report,
    name: nameInLens(),
    isKept: kept.elements.some(element => isShown(element.vertices)),
    improvement,
    ended,
    onStart: improve,
    onKeep: keep,
  })
}

function found(record: SearchRecord): TemplateResult {
  const { query } = record.tally
  return foundTemplate({
    record,
    isOfForm: record === recordOfForm(),
    isRunning: isRunning(),
    order,
    showsAll,
    keeping: keeper.keeping,
    choicesTemplate: choices =>
      choicesTemplate({
        label: 'Found',
        choices,
        pictures,
        isShown,
        onChoose: choose,
        actionsOf: ({ vertices, name }) =>
          improvementButton({
            request: { kind: 'climb', query, vertices, name },
            label: 'More extreme',
            name: `More extreme from here: ${name}`,
            isPossible: true,
            improvement,
            ended,
            onStart: improve,
          }),
      }),
    onSort: value => {
      order = value
      draw()
    },
    onShowAll: () => {
      showsAll = !showsAll
      draw()
    },
    onExport: () =>
      saveElements(
        'found',
        record.tally.finds(order).map(find => ({ ...choiceOf(record, find, order), property: query.property })),
      ),
  })
}

function keptElements(): TemplateResult | typeof nothing {
  return keptTemplate({
    kept,
    choicesTemplate: choices =>
      choicesTemplate({
        label: 'Kept',
        choices,
        pictures,
        isShown,
        onChoose: choose,
        onRemove: element => {
          kept.remove({ ...element, property: '' })
          draw()
        },
      }),
    onExport: () => saveElements('kept', kept.elements),
  })
}

function isShown(vertices: Vertices): boolean {
  return isSame(vertices, lens.vertices)
}

function change(name: keyof FormState, value: string): void {
  form = withField(form, name, value)
  problems = []
  parsed = parseQuery(queryOf(form))
  search?.stop()
  failure = null
  address()
  draw()
}

/** The form and the element, as the address has them. */
function address(): void {
  history.replaceState(history.state, '', `?${encodeForm(form)}#${encodePermalink(lens.vertices)}`)
}

async function begin(): Promise<void> {
  if (parsed.ok) await run({ find: form.find, tally: new Tally(parsed.value.query), ran: 0 })
}

async function run(record: SearchRecord): Promise<void> {
  try {
    const workers = await workersOrReason()
    // Enter in the form submits it again.
    if (search?.isRunning && recordOfForm()?.tally === search.tally) return
    halt()
    if (search?.tally !== record.tally) search = new Search(record.tally.query, workers, news, fail, record.tally)
  } catch (reason) {
    return fail(reason as Error)
  }
  failure = null
  searches = withSearch(searches, record)
  hasFirstPicture = false
  since = performance.now()
  liveRegion.begin()
  search.start()
  draw()
  document.querySelector('.run')?.scrollIntoView({ block: narrow.matches ? 'start' : 'nearest' })
}

/** Ends the workers at once; what they have handed in stays. */
function halt(): void {
  if (!search) return
  const wasRunning = search.isRunning
  search.dispose()
  if (wasRunning) rest(search)
}

async function workersOrReason(): Promise<SearchWorkers> {
  try {
    return await searchWorkers()
  } catch (reason) {
    throw new Error(`a search needs WebAssembly (${reason instanceof Error ? reason.message : reason}).`)
  }
}

function stop(event: Event): void {
  event.preventDefault() // the button is one that submits again
  search?.stop()
}

/** Called when more elements were searched, and after `stop` for the last ones. */
function news(): void {
  if (!search) return
  liveRegion.report(search)
  if (!search.isRunning) rest(search)
  schedule(search.found > 0 && !hasFirstPicture ? 0 : undefined)
}

/** Keeps a search that has stopped. */
function rest({ tally }: Search): void {
  const record = searches.find(record => record.tally === tally)
  if (!record) return
  searches = withSearch(searches, { ...record, ran: record.ran + performance.now() - since })
  keepWork()
}

function keepWork(): void {
  keeper.keep({ form: String(encodeForm(form)), vertices: lens.vertices, order, searches })
}

function fail(reason: Error): void {
  failure = `This did not work: ${reason.message}`
  draw()
}

function choose(choice: Choice): void {
  chosen = choice
  lens.vertices = choice.vertices
  address()
  draw()
}

/** The name that the element was found or kept by; with a word more if a vertex was moved since. */
function nameInLens(): string {
  const record = shownRecord()
  const finds = (['simplicity', 'extremeness'] as const).flatMap(order => record?.tally.finds(order) ?? [])
  const known = [chosen, ...kept.elements, ...finds].find(element => element && isShown(element.vertices))
  if (known && 'name' in known) return known.name
  if (record && known) return choiceOf(record, known, order).name
  return chosen === null ? 'element' : `${chosen.name}-changed`
}

function keep(): void {
  const name = nameInLens()
  kept.add({ name, vertices: lens.vertices, property: form.property })
  liveRegion.say(`Kept as ${name}.`)
  draw()
}

function saveElements(what: string, elements: readonly KeptElement[]): void {
  saveFile(`hexlens-${what}.json`, exported(elements), 'application/json')
}

async function improve(request: ImprovementRequest): Promise<void> {
  if (improvement) return
  const { name, vertices } = request
  const job = new Improvement(request)
  improvement = job
  if (isShown(vertices)) draw()
  else choose({ name, vertices, caption: name })
  try {
    await job.run(await workersOrReason(), schedule)
  } catch (reason) {
    improvement = null
    return fail(reason as Error)
  }
  if (improvement === job) settle(job)
  draw()
}

/** Keeps what an improvement has come to, and shows it. */
function settle(job: Improvement): void {
  improvement = null
  ended = job
  const name = improvedName(job)
  if (job.steps > 0) {
    kept.add({ name, vertices: job.best, property: job.request.query.property })
    choose({ name, vertices: job.best, caption: name })
  }
  liveRegion.say(outcomeText(job))
}

/** The width of beside.css at which the lens is above the column, with little room for panels. */
const narrow = matchMedia('(max-width: 55.99rem)')
const chooseViews = () => {
  lens.views = narrow.matches ? 'scene verdict' : 'scene verdict checks'
}

chooseViews()
narrow.addEventListener('change', chooseViews)

function openLink(): void {
  const link = decodePermalink(location.hash)
  if (link.ok) lens.vertices = link.value
  else if (link.error.code !== 'absent') lens.raise({ code: 'link-broken', message: link.error.message })
}

/** The element and the scroll of this entry of the history. The address has the last word on the element. */
function openEntry(): void {
  const entry = entryAt(key)
  const link = decodePermalink(location.hash)
  if (!link.ok && link.error.code === 'absent' && work) lens.vertices = work.vertices
  if (!entry) return
  try {
    put(() => {
      lens.state = { ...entry.state, vertices: lens.vertices }
    })
  } catch {
    return // what another version of the page kept
  }
  scrollTo(lens, entry.scroll)
}

function leave(): void {
  halt()
  if (improvement) {
    improvement.stop()
    settle(improvement)
  }
  keepWork()
  keepEntry(key, { state: lens.state, scroll: scrollOf(lens) })
}

history.scrollRestoration = 'manual'
const key = presentKey()
addEventListener('hashchange', openLink)
addEventListener('pagehide', leave)
// A phone may end a page that is not seen without a word.
document.addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && keepWork())
lens.addEventListener('hex-verdict', () => schedule())
onSettled(lens, () => {
  schedule()
  lens.clear('link-broken')
  address()
})
addEventListener('storage', () => {
  kept.read()
  schedule()
})
// Restored as it was, but for what ran.
addEventListener('pageshow', () => schedule())
openLink()
draw()
openEntry()
