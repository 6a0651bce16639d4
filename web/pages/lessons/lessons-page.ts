/**
 * The page of the lessons: an overview, or steps in the column beside the lens. The step that is read decides what the lens shows; the
 * address names it, so that a link, Back and a reload return to it, and to what the reader has done there.
 */
import { render } from 'lit-html'
import type { Report } from '../../core/report'
import type { Lesson } from './content/lessons'
import '../element'
import { entryAt, keepEntry, presentKey, type ScrollEntry } from '../history-entries'
import { LensWork } from '../lens-work'
import { addressOf, complaintAbout, hashOf, neighbour, type StepAddress, stepAt } from './address'
import { type ColumnActions, column } from './column'
import { showMeanings } from './meaning'
import { overview } from './overview'
import { Progress } from './progress'
import { type Given, isSolvedBy, type QuestionActions } from './question'
import { Stage } from './stage'
import { shownStep, verticesOf } from './step-state'
import '../skip'

const main = document.querySelector('main') as HTMLElement
const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const root = document.querySelector('.column') as HTMLElement

/** Milliseconds after the last scroll event: steps that are only passed by are not shown. */
const SETTLED = 120
/** The reader's line, as a fraction of the free height of the window. */
const READING = 0.42
const OVERVIEW_TITLE = document.title

const own = new Map<Lesson, readonly (Report | undefined)[]>()
const progress = new Progress()
/** Null is the overview. */
let address: StepAddress | null = null
let key = presentKey()
/** The scroll position that `show` has set, not the reader; and there the step's top in the window. */
let scrolledTo = -1
let heldAt = 0
let settling = 0
let width = innerWidth
const stage = new Stage(main, lens, draw, onPress)
const work = new LensWork(stage, main.querySelectorAll('hex-lens, .plane'), open)

const actions: ColumnActions = {
  go,
  restore: () => apply(),
  question: step => questionActions(step),
}

/** Null is the overview. */
function go(to: StepAddress | null): void {
  keepEntry(key, present())
  history.pushState(null, '', to ? hashOf(to) : `${location.pathname}${location.search}`)
  key = presentKey()
  show(to)
}

function questionActions(step: number): QuestionActions {
  return {
    choose: choice => answer(step, choice),
    handIn: () => answer(step, solved(step)),
    show: () => answer(step, null),
    askAgain: () => answer(step, undefined),
  }
}

/** What the core says of the element that is handed in; undefined, no answer, while it says nothing. */
function solved(step: number): boolean | undefined {
  const asked = address?.lesson.steps[step]
  if (!asked?.question || !stage.report) return undefined
  return isSolvedBy(asked.question, stage.report, verticesOf(asked)) ?? undefined
}

function onPress(corner: number): void {
  const answers = address && stepAt(address).question?.answer
  const choice = answers?.kind === 'vertex' ? answers.vertices.indexOf(corner) : -1
  if (address && choice >= 0) answer(address.step, choice)
}

/** Undefined asks again. */
function answer(step: number, given: Given | undefined): void {
  if (!address) return
  const to = { ...address, step }
  if (given === undefined) progress.forgetAnswer(to)
  else progress.answer(to, given)
  if (step === address.step) stage.ask(stepAt(to), isAsked(to))
  holding(step, draw)
  // The step is shorter again: what is in sight would be the next one.
  if (given === undefined && step === address.step) reveal(step)
  const place = given === undefined ? '.choices button' : '.judged'
  articleOf(step)?.querySelector<HTMLElement>(place)?.focus({ preventScroll: true })
}

function isAsked(to: StepAddress): boolean {
  return stepAt(to).question !== undefined && progress.answerTo(to) === undefined
}

function draw(): void {
  const complaint = complaintAbout(location.hash)
  if (!address) {
    render(overview({ progress, complaint }, forget), root)
    return
  }
  const { lesson } = address
  const { vertices } = stage
  const start = verticesOf(shownStep(stepAt(address), isAsked(address)))
  render(
    column(
      {
        address,
        live: stage.report,
        vertices,
        own: own.get(lesson) ?? [],
        isChanged: vertices.some((value, i) => value !== start[i]),
        complaint,
        answers: lesson.steps.map((_, step) => progress.answerTo({ lesson, step })),
      },
      actions,
    ),
    root,
  )
}

function forget(): void {
  progress.forget()
  draw()
  root.focus({ preventScroll: true })
}

/** The step as it begins. */
function apply(): void {
  stage.show(address && stepAt(address), address !== null && isAsked(address))
  draw()
}

function enter(to: StepAddress | null): void {
  const isNewLesson = to?.lesson !== address?.lesson
  address = to
  document.title = to ? `${to.lesson.title}: Hexlens lessons` : OVERVIEW_TITLE
  if (to) progress.see(to)
  work.close()
  stage.show(to && stepAt(to), to !== null && isAsked(to))
  if (to) work.open(`lesson-${to.lesson.id}-${stepAt(to).title}`, stage.state)
  draw()
  if (to && (isNewLesson || !own.has(to.lesson))) void analyze(to.lesson)
}

/** Keeps a step where it is on the screen while steps above it change: their drawings come late. */
function holding(step: number, change: () => void): void {
  // The font may have moved it before anybody was told.
  const before = step === address?.step && Math.abs(scrollY - scrolledTo) < 2 ? heldAt : topOf(step)
  change()
  const by = topOf(step) - before
  if (by === 0) return
  scrollBy({ top: by, behavior: 'instant' })
  if (scrolledTo >= 0) hold(step)
}

/** Enters a step and has it in sight. */
function show(to: StepAddress | null): void {
  enter(to)
  reveal(to?.step ?? 0)
}

function reveal(step: number): void {
  if (step === 0) scrollTo(0, 0)
  else articleOf(step)?.scrollIntoView({ block: 'start', behavior: 'instant' })
  hold(step)
}

function hold(step: number): void {
  scrolledTo = scrollY
  heldAt = topOf(step)
}

async function analyze(lesson: Lesson): Promise<void> {
  const reports = await Promise.all(lesson.steps.map(step => lens.analyze(verticesOf(step)).catch(() => undefined)))
  own.set(lesson, reports) // without a core there are none, and the lens says so
  holding(address?.step ?? 0, draw)
}

function articleOf(step: number): Element | undefined {
  return root.querySelectorAll('.step')[step]
}

function topOf(step: number): number {
  return articleOf(step)?.getBoundingClientRect().top ?? 0
}

/** The step's top in the window: on the page it depends on drawings before it, which come late. */
function present(): ScrollEntry {
  return { scroll: address ? [topOf(address.step)] : [-scrollY] }
}

/** Shows the step of the address where it was in the window. */
function open(): void {
  const kept = entryAt<ScrollEntry>(key)
  show(addressOf(location.hash))
  if (!kept) return
  scrollBy({ top: (address ? topOf(address.step) : 0) - (kept.scroll[0] ?? 0), behavior: 'instant' })
  hold(address?.step ?? 0)
}

/** The last step that begins above the line at which one reads. */
function stepInSight(): number {
  const { top, bottom } = stage.element.getBoundingClientRect()
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
  if (!address) return
  const to = { ...address, step: stepInSight() }
  if (to.step === address.step) return
  holding(to.step, () => enter(to))
  history.replaceState(history.state, '', hashOf(to))
}

function onKey(event: KeyboardEvent): void {
  const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : null
  const isOthers = event.altKey || event.ctrlKey || event.metaKey || event.shiftKey
  if (!address || !by || isOthers || stage.element.contains(event.target as Node)) return
  const to = neighbour(address, by)
  if (!to) return
  event.preventDefault()
  const isInSteps = document.activeElement?.closest('.step') != null
  go(to)
  if (isInSteps) articleOf(to.step)?.querySelector<HTMLElement>('h2 a')?.focus({ preventScroll: true })
}

history.scrollRestoration = 'manual'
root.replaceChildren()
open()
showMeanings(root, main)
addEventListener('keydown', onKey)
// The font of the formulas comes late, and lines change.
document.fonts.addEventListener('loadingdone', () => {
  if (!address || Math.abs(scrollY - scrolledTo) >= 2) return
  scrollBy({ top: topOf(address.step) - heldAt, behavior: 'instant' })
  hold(address.step)
})
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
  if (address) reveal(address.step)
})
root.addEventListener('click', event => {
  const link = (event.target as Element).closest<HTMLAnchorElement>('a[href^="#"]')
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return
  event.preventDefault()
  link.closest('details')?.removeAttribute('open')
  const lesson = address?.lesson
  go(addressOf(link.hash))
  if (address?.lesson !== lesson) root.focus({ preventScroll: true })
})
addEventListener('popstate', () => {
  keepEntry(key, present())
  key = presentKey()
  open()
})
addEventListener('pagehide', () => keepEntry(key, present()))
