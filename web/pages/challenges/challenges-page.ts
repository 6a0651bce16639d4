/**
 * The page Challenges: what the address is about stands beside the lens and is judged with every report. The element as it is goes into
 * the address, so that reload, bookmark and link return to it.
 */
import { html, render } from 'lit-html'
import { quantitiesOf, shownNumber } from '../../core/quantities'
import { challenges } from './challenges'
import '../element'
import { historyStep } from '../../element/shortcuts'
import { written } from '../../model/document-readers'
import { sameBits, type Vertices } from '../../model/hexahedron'
import { copyText } from '../../views/copy-text'
import { Forget } from '../forget'
import { LensWork } from '../lens-work'
import { type Challenge, judged, readChallenge, readChallengeText } from './challenge'
import { type ChallengeAddress, challengeFragment, readChallengeAddress } from './challenge-link'
import { type Actions, challengeColumn, listColumn, type Opened } from './column'
import { Progress } from './progress'
import { WriteForm } from './write-form'
import '../skip'

const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const column = document.createElement('div')
document.querySelector('#column')?.append(column)

const progress = new Progress()
const work = new LensWork(lens, [lens], () => {
  writeForm = newForm()
  open()
})
const forgetting = new Forget(draw, () => {
  progress.forget()
  work.forget()
  writeForm = newForm()
  work.open('challenges')
})
let writeForm = newForm()
let form: WriteForm | null = null
let complaint: string | null = null
let address: ChallengeAddress = { kind: 'list' }
let opened: Opened | null = null
/** The last vertices that the page set, not the reader. */
let given: Vertices = []

function open(): void {
  const result = readChallengeAddress(location.hash)
  address = result.ok ? result.value : { kind: 'list' }
  complaint = result.ok ? null : result.error
  opened = null
  form = address.kind === 'write' ? writeForm : null
  if (address.kind === 'challenge') openNamed(address.id, address.vertices)
  if (address.kind === 'own') openOwn(address.json, address.vertices)
  if (opened === null) work.open('challenges')
  judge()
}

function newForm(): WriteForm {
  return new WriteForm(() => lens.vertices, draw)
}

function openNamed(id: string, vertices: Vertices | null): void {
  const named = challenges.find(challenge => challenge.id === id)
  const result = named && readChallenge(named)
  if (result?.ok) begin(id, `challenge-${id}`, result.value, vertices)
  else refuse(`There is no challenge “${id.slice(0, 40)}”.`)
}

function openOwn(json: string, vertices: Vertices | null): void {
  const result = readChallengeText(json)
  if (result.ok) begin(null, `challenge-${json}`, result.value, vertices)
  else refuse(result.error.message)
}

function refuse(message: string): void {
  complaint = message
  address = { kind: 'list' }
}

/** The reader's work on it is kept under the name. What a link adds to that is a step. */
function begin(id: string | null, name: string, challenge: Challenge, vertices: Vertices | null): void {
  opened = {
    id,
    challenge,
    report: null,
    judgement: null,
    outcome: 'open',
    isHintShown: false,
    copying: null,
    toBeat: null,
  }
  const start = written(challenge.start)
  const isFound = work.open(name, { ...lens.state, preset: null, start, vertices: start })
  given = lens.vertices
  if (vertices) put(vertices, challenge.start)
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

/** One step to undo. */
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
  opened = { ...opened, copying: null }
  judge()
  conclude(opened)
  if (opened.outcome === 'solved' && opened.id !== null && !sameBits(vertices, given)) keep(opened.id, opened)
  nameInAddress(vertices)
  draw()
}

function nameInAddress(vertices: Vertices): void {
  if (address.kind !== 'challenge' && address.kind !== 'own') return
  address = { ...address, vertices }
  history.replaceState(history.state, '', `#${challengeFragment(address)}`)
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
    const url = new URL(location.href)
    url.hash = challengeFragment({ ...address, vertices: lens.vertices } as ChallengeAddress)
    const isCopied = await copyText(url.href)
    change({
      copying: isCopied
        ? { text: 'The link is copied: it opens this challenge with the element as it is.', link: null }
        : { text: 'Copying is not allowed here. This is the link:', link: url.href },
    })
  },
  forget: () => {
    progress.forget()
    draw()
    document.querySelector<HTMLElement>('#column')?.focus({ preventScroll: true })
  },
}

function change(some: Partial<Opened>): void {
  if (opened) opened = { ...opened, ...some }
  draw()
}

const title = document.title

function draw(): void {
  document.title = opened ? `Hexlens: ${opened.challenge.title}` : title
  const content =
    form?.column() ??
    (opened ? challengeColumn(opened, progress, actions) : listColumn(progress, complaint, actions, forgetting))
  render(html`${content}`, column)
}

/** The numbers stand beside the scene where there is room: on smaller screens it would be crowded out. */
const isRoomy = matchMedia('(min-width: 84rem)')
function chooseViews(): void {
  lens.setAttribute('views', isRoomy.matches ? 'scene verdict vertices' : 'scene verdict')
}

chooseViews()
isRoomy.addEventListener('change', chooseViews)
open()
addEventListener('hashchange', () => {
  open()
  column.querySelector<HTMLElement>('.title')?.focus({ preventScroll: true })
  document.querySelector('#column')?.scrollIntoView({ block: 'nearest' })
})
lens.addEventListener('hex-input', judge)
lens.addEventListener('hex-verdict', judge)
lens.addEventListener('hex-change', settle)
// While nothing has the focus, undo and redo can only mean the element.
addEventListener('keydown', event => {
  const step = event.target === document.body ? historyStep(event) : null
  if (step === null) return
  event.preventDefault()
  lens[step]()
})
