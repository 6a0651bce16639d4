/**
 * The page Search: a form, a search in workers, its finds as small pictures, and elements that the
 * reader keeps. The form's state is in the address's query, the element in the lens in its
 * fragment.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import { quantitiesOf } from '../../core/quantities'
import '../element'
import { isMet } from '../../model/condition'
import { formatNumber } from '../../model/decimal'
import type { Vertices } from '../../model/hexahedron'
import { decodePermalink, encodePermalink } from '../../model/permalink'
import { saveFile } from '../../views/save-file'
import { Pictures } from '../pictures'
import { searchWorkers } from './engine'
import { startOf } from './engine/distribution'
import { measured } from './engine/measure'
import { type ParsedQuery, parseQuery } from './engine/query'
import type { Find, Order } from './engine/ranking'
import { polished, Search, type SearchWorkers } from './engine/search'
import { formTemplate } from './form'
import { decodeForm, encodeForm, type FormState, queryOf, withField } from './form-state'
import { exported, isSame, type KeptElement, KeptElements } from './kept'
import { LiveRegion } from './live-region'
import { type Choice, choicesTemplate } from './results'
import '../skip'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const root = document.querySelector('.searching') as HTMLElement

/** Milliseconds: more often nobody reads the numbers. */
const REDRAW = 500
const SOON = 20

/** Finds that are shown while they change from moment to moment. */
const MOST_WHILE_RUNNING = 12

const pictures = new Pictures(lens, root, () => schedule())
const kept = new KeptElements(() => localStorage)
const liveRegion = new LiveRegion(document.querySelector('.news') as HTMLElement)

let { form, problems } = decodeForm(new URLSearchParams(location.search))
let parsed = parseQuery(queryOf(form))
/** The last one that was begun, and what the form then asked to find. */
let search: Search | null = null
let searchedFor = form.find
let order: Order = 'simplicity'
/** Milliseconds that the search has run, and since when it runs again. */
let [ran, since] = [0, 0]
/** The last element that this page gave to the lens. */
let chosen: Choice | null = null
let polishing: { readonly controller: AbortController; steps: number } | null = null
let failure: string | null = null
let redrawAt: ReturnType<typeof setTimeout> | undefined

function schedule(delay = search?.isRunning ? REDRAW : SOON): void {
  redrawAt ??= setTimeout(draw, delay)
}

function draw(): void {
  clearTimeout(redrawAt)
  redrawAt = undefined
  const finds = search?.finds(order).slice(0, search.isRunning ? MOST_WHILE_RUNNING : undefined) ?? []
  pictures.begin([...finds, ...kept.elements].map(({ vertices }) => vertices))
  render(template(finds), root)
  if (pictures.isBehind) schedule(SOON)
}

function template(finds: readonly Find[]): TemplateResult {
  return html`${problems.map(problem => html`<p class="complaint" role="alert">${problem}</p>`)}
    ${formTemplate({ form, errors: parsed.ok ? [] : parsed.error, onChange: change, onSubmit: begin })} ${running()} ${inTheLens()}
    ${found(finds)} ${keptTemplate()}`
}

/** The form may have been changed since. */
function isOfTheForm({ query }: Search): boolean {
  return parsed.ok && JSON.stringify(query) === JSON.stringify(parsed.value.query)
}

function running(): TemplateResult {
  const isRunning = search?.isRunning ?? false
  const canGoOn = search !== null && !isRunning && search.elements > 0 && isOfTheForm(search)
  return html`<div class="run">
      ${
        isRunning
          ? html`<button type="button" @click=${stop}>Stop</button>`
          : html`<button type="submit" form="query" ?disabled=${!parsed.ok}>${canGoOn ? 'Start anew' : 'Start'}</button>
              ${canGoOn ? html`<button type="button" @click=${goOn}>Go on</button>` : nothing}`
      }
      <p class="counts">${counts()}</p>
    </div>
    ${failure === null ? nothing : html`<p class="complaint" role="alert">${failure}</p>`}`
}

function counts(): string {
  if (!search || search.elements === 0) return search?.isRunning ? 'Starting …' : ''
  const seconds = (ran + (search.isRunning ? performance.now() - since : 0)) / 1000
  const rate = `${thousands(Math.round(search.elements / seconds / 1000) * 1000)} a second`
  return `${thousands(search.elements)} elements, ${rate}; ${thousands(search.found)} found`
}

function thousands(count: number): string {
  return count.toLocaleString('en')
}

function inTheLens(): TemplateResult | typeof nothing {
  const { report } = lens
  if (!parsed.ok || !report) return nothing
  const has = isMet(parsed.value.property, quantitiesOf(report, parsed.value.start))
  return html`<section aria-labelledby="in-lens">
    <h2 id="in-lens">In the lens</h2>
    <p>${has ? extremeness(parsed.value, report) : 'The element in the lens does not have the property.'}</p>
    <div class="actions">
      <button type="button" ?disabled=${isKept(lens.vertices)} @click=${keep}>${isKept(lens.vertices) ? 'Kept' : 'Keep'}</button>
      ${
        polishing
          ? html`<button type="button" @click=${() => polishing?.controller.abort()}>Cancel</button>
              <span class="quiet">Polishing, ${polishing.steps} ${polishing.steps === 1 ? 'step' : 'steps'} so far</span>`
          : html`<button type="button" ?disabled=${!has} @click=${startPolishing}>Polish</button>`
      }
      <a class="button" href=${`./#${encodePermalink(lens.vertices)}`}>Open on the page Lens</a>
    </div>
  </section>`
}

function extremeness({ query, measure, start }: ParsedQuery, report: NonNullable<typeof lens.report>): TemplateResult {
  return html`It has the property; <code>${query.measure}</code> is ${formatNumber(measured(measure, report, start))}.`
}

function found(finds: readonly Find[]): TemplateResult | typeof nothing {
  if (!search) return nothing
  const sorted = (value: Order, label: string) =>
    html`<label><input type="radio" name="order" .checked=${order === value} @change=${() => sort(value)} /> ${label}</label>`
  return html`<section aria-labelledby="found">
    <div class="head">
      <h2 id="found">Found</h2>
      <div class="order" role="radiogroup" aria-label="Order">
        ${sorted('simplicity', 'simplest first')} ${sorted('extremeness', 'most extreme first')}
      </div>
    </div>
    ${
      finds.length === 0
        ? html`<p class="quiet">${search.isRunning ? 'Nothing yet.' : 'Nothing so far.'}</p>`
        : [
            choicesTemplate({ label: 'Found', choices: finds.map(choiceOf), pictures, isShown, onChoose: choose }),
            html`<button type="button" @click=${() => save('found', finds.map(choiceOf))}>Export what is found</button>`,
          ]
    }
  </section>`
}

function keptTemplate(): TemplateResult | typeof nothing {
  const { elements, persistence } = kept
  if (elements.length === 0 && persistence !== 'newer') return nothing
  const choices = elements.map(element => ({ ...element, caption: element.name }))
  return html`<section aria-labelledby="kept">
    <h2 id="kept">Kept</h2>
    ${STORAGE_NOTES[persistence] === '' ? nothing : html`<p class="quiet">${STORAGE_NOTES[persistence]}</p>`}
    ${choicesTemplate({ label: 'Kept', choices, pictures, isShown, onChoose: choose, onRemove: remove })}
    ${
      elements.length > 0
        ? html`<button type="button" @click=${() => save('kept', elements)}>Export what is kept</button>`
        : nothing
    }
  </section>`
}

const STORAGE_NOTES: Readonly<Record<KeptElements['persistence'], string>> = {
  stored: '',
  unavailable:
    'This browser stores nothing for this page. These elements are gone when the page is closed: export them to keep them.',
  newer:
    'A later version of this page has kept elements here. They stay as they are. What you keep now is gone when this page is closed.',
}

function choiceOf(find: Find): Choice {
  const value = order === 'simplicity' ? movedText(find) : formatNumber(find.extremeness)
  return { vertices: find.vertices, name: `${searchedFor}-${search?.query.seed}-${find.index}`, caption: value }
}

function movedText({ vertices }: Find): string {
  const start = search ? startOf(search.query.distribution) : vertices
  const moved = [0, 1, 2, 3, 4, 5, 6, 7].filter(v =>
    [0, 1, 2].some(r => vertices[3 * v + r] !== start[3 * v + r]),
  ).length
  return `${moved} moved`
}

function isShown(vertices: Vertices): boolean {
  return isSame(vertices, lens.vertices)
}

function isKept(vertices: Vertices): boolean {
  return kept.elements.some(element => isSame(element.vertices, vertices))
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
  if (!parsed.ok) return
  const { query } = parsed.value
  failure = null
  ran = 0
  search?.dispose()
  try {
    search = new Search(query, await workersOrReason(), news, fail)
    searchedFor = form.find
  } catch (reason) {
    return fail(reason as Error)
  }
  liveRegion.begin()
  goOn()
}

async function workersOrReason(): Promise<SearchWorkers> {
  try {
    return await searchWorkers()
  } catch (reason) {
    throw new Error(`searching and polishing need WebAssembly (${reason instanceof Error ? reason.message : reason}).`)
  }
}

function goOn(): void {
  since = performance.now()
  search?.start()
  draw()
}

function stop(): void {
  search?.stop()
}

/** Called when more elements were searched, and after `stop` for the last ones. */
function news(): void {
  if (!search) return
  liveRegion.report(search)
  if (!search.isRunning) ran += performance.now() - since
  schedule()
}

function fail(reason: Error): void {
  failure = `This did not work: ${reason.message}`
  draw()
}

function sort(value: Order): void {
  order = value
  draw()
}

function choose(choice: Choice): void {
  chosen = choice
  lens.vertices = choice.vertices
  address()
  draw()
}

/** The name of what was chosen; with a word more where the reader has moved a vertex since. */
function nameInLens(): string {
  if (chosen === null) return 'element'
  return isShown(chosen.vertices) ? chosen.name : `${chosen.name}-changed`
}

function keep(): void {
  keepAs(nameInLens(), lens.vertices)
}

function keepAs(name: string, vertices: Vertices): void {
  kept.add({ name, vertices, property: form.property })
  liveRegion.say(`Kept as ${name}.`)
  draw()
}

function remove({ name, vertices }: Choice): void {
  kept.remove({ name, vertices, property: '' })
  draw()
}

function save(what: string, elements: readonly (Choice | KeptElement)[]): void {
  const property = search?.query.property ?? ''
  saveFile(`hexlens-${what}.json`, exported(elements.map(element => ({ property, ...element }))), 'application/json')
}

async function startPolishing(): Promise<void> {
  if (!parsed.ok || polishing) return
  const { query } = parsed.value
  const name = `${nameInLens()}-polished`
  const job = { controller: new AbortController(), steps: 0 }
  polishing = job
  draw()
  try {
    const { vertices } = await polished(query, lens.vertices, await workersOrReason(), {
      signal: job.controller.signal,
      onStep: () => {
        job.steps += 1
        schedule()
      },
    })
    polishing = null
    kept.add({ name, vertices, property: query.property })
    choose({ name, vertices, caption: name })
    liveRegion.say(
      job.steps > 0 ? `Polished in ${job.steps} steps, and kept.` : 'It cannot be made simpler here. Kept.',
    )
  } catch (reason) {
    polishing = null
    if (!job.controller.signal.aborted) return fail(reason as Error)
    liveRegion.say('Polishing was cancelled.')
  }
  draw()
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

openLink()
addEventListener('hashchange', openLink)
for (const type of ['hex-change', 'hex-verdict'] as const) lens.addEventListener(type, () => schedule())
lens.addEventListener('hex-change', () => {
  lens.clear('link-broken')
  address()
})
addEventListener('storage', () => {
  kept.read()
  schedule()
})
draw()
