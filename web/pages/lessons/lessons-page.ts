/**
 * The page of the lessons: steps in the column beside the lens. The step that is read decides what the lens shows; the address names
 * it, so that a link, Back and a reload return to it, and to what the reader has done there.
 */
import { render } from 'lit-html'
import type { Report } from '../../core/report'
import type { Lesson } from './content/lessons'
import '../element'
import { entryAt, type HistoryEntry, keepEntry, presentKey } from '../history-entries'
import { scrollToTop } from '../scroll'
import { addressOf, complaintAbout, hashOf, neighbour, type StepAddress, stepAt } from './address'
import { type ColumnActions, column } from './column'
import { stateOf, verticesOf } from './step-state'
import '../skip'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const root = document.querySelector('.column') as HTMLElement

/** Milliseconds after the last scroll event: steps that are only passed by are not shown. */
const SETTLED = 120
/** The reader's line, as a fraction of the free height of the window. */
const READING = 0.42

const own = new Map<Lesson, readonly (Report | undefined)[]>()
let address = addressOf(location.hash)
let key = presentKey()
/** The scroll position that `show` has set, not the reader. */
let scrolledTo = -1
let settling = 0
let width = innerWidth

const actions: ColumnActions = {
  go: to => {
    keepEntry(key, present())
    history.pushState(null, '', hashOf(to))
    key = presentKey()
    show(to)
  },
  restore: () => apply(),
}

function draw(): void {
  const start = verticesOf(stepAt(address))
  const isChanged = lens.vertices.some((value, i) => value !== start[i])
  const complaint = complaintAbout(location.hash)
  render(
    column({ address, live: lens.report, own: own.get(address.lesson) ?? [], isChanged, complaint }, actions),
    root,
  )
}

/** The lens shows the step that is read. */
function apply(): void {
  const step = stepAt(address)
  if (lens.views !== step.views) lens.views = step.views
  lens.state = stateOf(step)
  scrollToTop(lens)
  draw()
}

function enter(to: StepAddress): void {
  const isNewLesson = to.lesson !== address.lesson
  address = to
  document.title = `${to.lesson.title}: Hexlens lessons`
  apply()
  if (isNewLesson || !own.has(to.lesson)) void analyze(to.lesson)
}

/** Keeps a step where it is on the screen while steps above it change: their drawings come late. */
function holding(step: number, change: () => void): void {
  const before = topOf(step)
  change()
  const by = topOf(step) - before
  if (by === 0) return
  scrollBy({ top: by, behavior: 'instant' })
  if (scrolledTo >= 0) scrolledTo = scrollY
}

/** Enters a step and has it in sight. */
function show(to: StepAddress): void {
  enter(to)
  reveal(to.step)
}

function reveal(step: number): void {
  if (step === 0) scrollTo(0, 0)
  else articleOf(step)?.scrollIntoView({ block: 'start', behavior: 'instant' })
  scrolledTo = scrollY
}

async function analyze(lesson: Lesson): Promise<void> {
  const reports = await Promise.all(lesson.steps.map(step => lens.analyze(verticesOf(step)).catch(() => undefined)))
  own.set(lesson, reports) // without a core there are none, and the lens says so
  holding(address.step, draw)
}

function articleOf(step: number): Element | undefined {
  return root.querySelectorAll('.step')[step]
}

function topOf(step: number): number {
  return articleOf(step)?.getBoundingClientRect().top ?? 0
}

/** The step's top in the window: on the page it depends on drawings before it, which come late. */
function present(): HistoryEntry {
  return { state: lens.state, scroll: [topOf(address.step)] }
}

/** Shows the step of the address, with what the reader had done when it was left. */
function open(): void {
  const kept = entryAt(key)
  show(addressOf(location.hash))
  if (!kept) return
  try {
    lens.state = kept.state
    scrollBy({ top: topOf(address.step) - (kept.scroll[0] ?? 0), behavior: 'instant' })
    scrolledTo = scrollY
    draw()
  } catch {
    apply() // what another version of the page kept
  }
}

/** The last step that begins above the line at which one reads. */
function stepInSight(): number {
  const { top, bottom } = lens.getBoundingClientRect()
  const free = Math.max(0, root.getBoundingClientRect().left > 0 ? top : bottom)
  const line = free + READING * (innerHeight - free)
  const isAtEnd = scrollY + innerHeight >= document.documentElement.scrollHeight - 2
  const tops = [...root.querySelectorAll('.step')].map(article => article.getBoundingClientRect().top)
  return isAtEnd
    ? tops.length - 1
    : Math.max(
        0,
        tops.findLastIndex(value => value <= line),
      )
}

function onSettled(): void {
  if (Math.abs(scrollY - scrolledTo) < 2) return
  scrolledTo = -1
  const step = stepInSight()
  if (step === address.step) return
  holding(step, () => enter({ ...address, step }))
  history.replaceState(history.state, '', hashOf(address))
}

function onKey(event: KeyboardEvent): void {
  const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : null
  const isOthers = event.altKey || event.ctrlKey || event.metaKey || event.shiftKey || event.target === lens
  const to = by && !isOthers ? neighbour(address, by) : null
  if (!to) return
  event.preventDefault()
  const isInSteps = document.activeElement?.closest('.step') != null
  actions.go(to)
  if (isInSteps) articleOf(to.step)?.querySelector<HTMLElement>('h2 a')?.focus({ preventScroll: true })
}

history.scrollRestoration = 'manual'
root.replaceChildren()
draw()
open()
for (const type of ['hex-input', 'hex-change', 'hex-verdict']) lens.addEventListener(type, draw)
addEventListener('keydown', onKey)
addEventListener(
  'scroll',
  () => {
    clearTimeout(settling)
    settling = window.setTimeout(onSettled, SETTLED)
  },
  { passive: true },
)
addEventListener('resize', () => {
  if (innerWidth === width) return // only a bar of the browser has come or gone
  width = innerWidth
  reveal(address.step)
})
root.addEventListener('click', event => {
  const link = (event.target as Element).closest<HTMLAnchorElement>('a[href^="#"]')
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return
  event.preventDefault()
  link.closest('details')?.removeAttribute('open')
  const { lesson } = address
  actions.go(addressOf(link.hash))
  if (address.lesson !== lesson) root.focus({ preventScroll: true })
})
addEventListener('popstate', () => {
  keepEntry(key, present())
  key = presentKey()
  open()
})
addEventListener('pagehide', () => keepEntry(key, present()))
