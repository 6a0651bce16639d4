/**
 * The page Challenges: what the address is about stands beside the lens and is judged with every report. The element as it is goes into
 * the address, so that reload, bookmark and link return to it.
 */
import { html, render, type TemplateResult } from 'lit-html'
import { quantitiesOf, shownNumber } from '../../core/quantities'
import { challenges } from './challenges'
import '../element'
import { historyStep } from '../../element/shortcuts'
import { written } from '../../model/document-readers'
import { sameBits, type Vertices } from '../../model/hexahedron'
import { Refusal } from '../../model/result'
import { copyText } from '../../views/copy-text'
import { Forget } from '../forget'
import { LensWork } from '../lens-work'
import { onSettled } from '../on-settled'
import { type Challenge, type ChallengeDocument, judged, readChallenge, readChallengeText } from './challenge'
import { type ChallengeAddress, challengeFragment, lengthWarning, linkTo, readChallengeAddress } from './challenge-link'
import { type Actions, type Copying, challengeColumn, listColumn, type Opened, type Place } from './column'
import { handInLink } from './hand-in'
import { type HandedInView, handedInColumn, handedInView, judgedAnew } from './handed-in'
import { MadeInSeries } from './made'
import { Progress } from './progress'
import type { Member, Series } from './series'
import { decodeSeries } from './series-code'
import { Sheet } from './sheet'
import { printedLink, WriteForm } from './write-form'
import '../skip'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const column = document.createElement('div')
document.querySelector('#column')?.append(column)

const progress = new Progress()
const made = new MadeInSeries()
const sheet = new Sheet()
const work = new LensWork(lens, [lens], () => {
  writeForm = newForm()
  void open()
})
const forgetting = new Forget(draw, () => {
  progress.forget()
  made.forget()
  work.forget()
  writeForm = newForm()
  work.open('challenges')
})
let writeForm = newForm()
let studentName = ''
let form: WriteForm | null = null
let handedIn: HandedInView | null = null
let complaint: string | null = null
let address: ChallengeAddress = { kind: 'list' }
let opened: Opened | null = null
/** The series that is open, and its code. */
let series: { readonly code: string; readonly value: Series } | null = null
/** The last vertices that the page set, not the reader. */
let given: Vertices = []

/** Resolves when what the address is about is there. */
async function open(): Promise<void> {
  const result = readChallengeAddress(location.hash)
  const asked = result.ok ? result.value : ({ kind: 'list' } as const)
  if (asked.kind === 'series' && series?.code !== asked.code) {
    const decoded = await decodeSeries(asked.code)
    const now = readChallengeAddress(location.hash)
    if (!now.ok || now.value.kind !== 'series' || now.value.code !== asked.code) return // the reader is elsewhere
    series = decoded.ok ? { code: asked.code, value: decoded.value } : null
    if (!decoded.ok) return openAddress({ kind: 'list' }, decoded.error)
  }
  openAddress(asked, result.ok ? null : result.error)
}

function openAddress(asked: ChallengeAddress, problem: string | null): void {
  address = asked
  complaint = problem
  opened = null
  handedIn = null
  form = address.kind === 'write' ? writeForm : null
  sheet.clear()
  if (address.kind === 'challenge') openNamed(address.id, address.vertices)
  if (address.kind === 'own') openOwn(address.json, address.vertices)
  if (address.kind === 'series' && series) openSeries(series.value, address)
  if (opened === null && handedIn === null) work.open('challenges')
  judge()
}

function newForm(): WriteForm {
  return new WriteForm({
    vertices: () => lens.vertices,
    report: () => lens.report,
    analyze: vertices => lens.analyze(vertices),
    show: vertices => put(vertices, vertices),
    print: (members, link) => sheet.print(members, link),
    discardPrint: () => sheet.clear(),
    onChange: draw,
  })
}

function openNamed(id: string, vertices: Vertices | null): void {
  const named = challenges.find(challenge => challenge.id === id)
  const result = named && readChallenge(named)
  if (result?.ok) begin({ id, name: `challenge-${id}`, challenge: result.value, vertices, place: null })
  else refuse(`There is no challenge “${id.slice(0, 40)}”.`)
}

function openOwn(json: string, vertices: Vertices | null): void {
  const result = readChallengeText(json)
  if (result.ok) begin({ id: null, name: `challenge-${json}`, challenge: result.value, vertices, place: null })
  else refuse(result.error.message)
}

function openSeries(value: Series, { code, at, vertices }: ChallengeAddress & { kind: 'series' }): void {
  const { members, handedIn: elements } = value
  const member = members[at]
  if (elements) openHandedIn(handedInView(members, elements))
  else if (member === undefined) refuse(`The series has ${members.length} challenges, and none is number ${at + 1}.`)
  else {
    const { id, challenge } = member
    const name = `challenge-series-${code}-${at + 1}`
    begin({ id, name, challenge, vertices, place: placeIn(code, at, members) })
  }
}

function placeIn(code: string, at: number, members: readonly Member[]): Place {
  const all = made.of(code)
  return { code, at, members, solved: members.map((_, i) => all[i]?.isSolved ?? false) }
}

function openHandedIn(view: HandedInView): void {
  handedIn = view
  work.close() // a student's elements are not the reader's work
  showHandedIn(view.shown)
  void judgedAnew(view, vertices => lens.analyze(vertices)).then(
    judgedView => {
      if (handedIn?.members !== view.members) return
      handedIn = { ...judgedView, shown: handedIn.shown }
      draw()
    },
    () => {}, // the element says that there is no core
  )
}

function showHandedIn(at: number): void {
  if (handedIn === null) return
  handedIn = { ...handedIn, shown: at }
  const shown = handedIn.members[at]
  if (shown?.vertices) put(shown.vertices, shown.member.challenge.start)
  draw()
}

function refuse(message: string): void {
  complaint = message
  address = { kind: 'list' }
}

interface Beginning {
  readonly id: string | null
  /** The reader's work on it is kept under this. What a link adds to that is a step. */
  readonly name: string
  readonly challenge: Challenge
  readonly vertices: Vertices | null
  readonly place: Place | null
}

function begin({ id, name, challenge, vertices, place }: Beginning): void {
  opened = {
    id,
    challenge,
    report: null,
    judgement: null,
    outcome: 'open',
    isHintShown: false,
    copying: null,
    handingIn: null,
    printing: '',
    toBeat: null,
    place,
  }
  const start = written(challenge.start)
  const isFound = work.open(name, { ...lens.state, preset: null, start, vertices: start })
  const known = isFound || place === null ? null : (made.of(place.code)[place.at]?.vertices ?? null)
  given = lens.vertices
  if (vertices ?? known) put((vertices ?? known) as Vertices, challenge.start)
  else if (isFound) nameInAddress(given)
  void measureSolution(challenge)
}

/** The stored solution's number is the one to beat. */
async function measureSolution(challenge: Challenge): Promise<void> {
  const { record, solution, start } = challenge
  if (record === null || solution === null) return
  const report = await lens.analyze(solution).catch(() => null) // without a core there is no number
  if (report && opened?.challenge === challenge) change({ toBeat: shownNumber(record.quantity, report, start).value })
}

/** One step to undo, unless it is the first thing there. */
function put(vertices: Vertices, start: Vertices): void {
  given = vertices
  lens.state = { ...lens.state, preset: null, start: written(start), vertices: written(vertices) }
}

/** Marks the conditions with every report. A solution is announced when the move is done. */
function judge(): void {
  if (opened) {
    const { report } = lens
    const isOpening = opened.judgement === null
    const judgement = report && judged(opened.challenge, quantitiesOf(report, opened.challenge.start))
    opened = { ...opened, report, judgement, outcome: judgement?.isSolved ? opened.outcome : 'open' }
    if (isOpening) conclude(opened)
  }
  draw()
}

function conclude(concluded: Opened): void {
  if (!concluded.judgement?.isSolved) return
  const { solution } = concluded.challenge
  const isStored = solution !== null && sameBits(lens.vertices, solution)
  opened = { ...concluded, outcome: isStored ? 'shown' : 'solved' }
}

/** Decides with every change that is done if the reader has solved it. */
function settle(): void {
  if (opened === null) return
  const { vertices } = lens
  opened = { ...opened, copying: null, handingIn: null }
  judge()
  conclude(opened)
  const isReaders = !sameBits(vertices, given)
  if (opened.outcome === 'solved' && opened.id !== null && isReaders) keep(opened.id, opened)
  if (opened.place && isReaders && opened.outcome !== 'shown') keepInSeries(opened.place, vertices, opened.outcome)
  nameInAddress(vertices)
  draw()
}

function nameInAddress(vertices: Vertices): void {
  if (address.kind !== 'challenge' && address.kind !== 'own' && address.kind !== 'series') return
  address = { ...address, vertices }
  history.replaceState(history.state, '', `#${challengeFragment(address)}`)
}

function keepInSeries({ code, at, members }: Place, vertices: Vertices, outcome: Opened['outcome']): void {
  made.add(code, at, { vertices, isSolved: outcome === 'solved' })
  change({ place: placeIn(code, at, members) })
}

function keep(id: string, { challenge: { record, start }, report }: Opened): void {
  const before = progress.of(id)
  const value = record && report && shownNumber(record.quantity, report, start).value
  const isBetter = (now: number, best: number) => (record?.best === 'greatest' ? now > best : now < best)
  const best = before?.best ?? null
  if (value === null) {
    if (before === null) progress.add(id, { best: null })
  } else if (best === null || isBetter(value, best)) progress.add(id, { best: value })
}

const actions: Actions = {
  undo: () => lens.undo(),
  restart: () => opened && put(opened.challenge.start, opened.challenge.start),
  showSolution: () => opened?.challenge.solution && put(opened.challenge.solution, opened.challenge.start),
  toggleHint: () => change({ isHintShown: !opened?.isHintShown }),
  copyLink: async () => {
    const link = linkTo({ ...address, vertices: lens.vertices } as ChallengeAddress)
    change({
      copying: await copied(link, 'The link is copied: it opens this challenge with the element as it is.'),
    })
  },
  setName: name => {
    studentName = name
    draw()
  },
  handIn: async () => {
    if (opened === null) return
    const members = openedMembers(opened)
    try {
      const link = await handInLink(members, elementsToHandIn(opened), studentName)
      change({ handingIn: await copied(link, `The link to hand in is copied. ${lengthWarning(link)}`) })
    } catch (reason) {
      if (!(reason instanceof Refusal)) throw reason
      change({ handingIn: { text: reason.message, link: null } })
    }
  },
  print: async () => {
    if (opened === null) return
    const members = openedMembers(opened)
    const printing = await sheet.print(members, await printedLink(members))
    change({ printing })
  },
  forget: () => {
    progress.forget()
    made.forget()
    draw()
    document.querySelector<HTMLElement>('#column')?.focus({ preventScroll: true })
  },
}

async function copied(link: string, text: string): Promise<Copying> {
  return (await copyText(link))
    ? { text, link: null }
    : { text: 'Copying is not allowed here. This is the link:', link }
}

/** The challenges of the series, or the one that stands alone. */
function openedMembers({ id, challenge, place }: Opened): readonly Member[] {
  if (place) return place.members
  const document = address.kind === 'own' ? (JSON.parse(address.json) as ChallengeDocument) : (id as string)
  return [{ id, challenge, document }]
}

/** What solves each challenge, or else the latest; of this one the element as it is, unless another has solved it. */
function elementsToHandIn({ place, outcome }: Opened): readonly (Vertices | null)[] {
  const { vertices } = lens
  if (place === null) return [vertices]
  const all = made.of(place.code)
  return place.members.map((_, i) => {
    const known = all[i] ?? null
    return i === place.at && (outcome === 'solved' || !known?.isSolved) ? vertices : (known?.vertices ?? null)
  })
}

function change(some: Partial<Opened>): void {
  if (opened) opened = { ...opened, ...some }
  draw()
}

const title = document.title

function draw(): void {
  document.title = opened ? `Hexlens: ${opened.challenge.title}` : title
  render(html`${content()}`, column)
}

function content(): TemplateResult {
  if (form) return form.column()
  if (handedIn) return handedInColumn(handedIn, showHandedIn)
  return opened
    ? challengeColumn(opened, progress, studentName, actions)
    : listColumn({ progress, hasMade: !made.isEmpty, complaint, actions, forgetting })
}

/** The numbers stand beside the scene where there is room: on smaller screens it would be crowded out. */
const isRoomy = matchMedia('(min-width: 84rem)')
function chooseViews(): void {
  lens.setAttribute('views', isRoomy.matches ? 'scene verdict vertices' : 'scene verdict')
}

chooseViews()
isRoomy.addEventListener('change', chooseViews)
void open()
addEventListener('hashchange', async () => {
  await open()
  column.querySelector<HTMLElement>('.title')?.focus({ preventScroll: true })
  document.querySelector('#column')?.scrollIntoView({ block: 'nearest' })
})
lens.addEventListener('hex-input', judge)
lens.addEventListener('hex-verdict', judge)
onSettled(lens, settle)
// While nothing has the focus, undo and redo can only mean the element.
addEventListener('keydown', event => {
  const step = event.target === document.body ? historyStep(event) : null
  if (step === null) return
  event.preventDefault()
  lens[step]()
})
