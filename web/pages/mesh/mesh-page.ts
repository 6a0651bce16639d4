/**
 * The page Mesh: a file becomes a sentence, a list, a picture, and any cell is in the lens. Views draw what the state has and tell what the
 * reader does; actions ask the mesh, which is in a worker, and change the state. Here they are put together.
 */
import { render } from 'lit-html'
import '../element'
import { CellTable } from '../../mesh-views/cell-table'
import type { ShownCells } from '../../survey/survey-jobs'
import { takeHanded } from '../handed-input'
import { Choosing } from './choosing'
import { ChosenView } from './chosen-view'
import { EXAMPLES } from './examples'
import { HistogramView } from './histogram-view'
import { InputDoor } from './input-door'
import { Listing } from './listing'
import { type ListingParts, listingTemplate } from './listing-view'
import { MeshMoves } from './mesh-moves'
import { MovingLens } from './moving-lens'
import { Opener } from './opener'
import { overviewTemplate } from './overview-view'
import { PageState, type Shown } from './page-state'
import { PictureControls } from './picture-controls'
import { PlaceFold } from './place-fold'
import { SettingsTravel } from './settings-travel'
import { Showing } from './showing'
import { StepsView } from './steps-view'
import { TakeAway } from './take-away'
import { isTyping } from './typing'
import { UntanglePanel } from './untangle-panel'

const part = (selector: string) => document.querySelector(selector) as HTMLElement
const overviewRoot = part('.overview')
const cellsRoot = part('.cells')
const lens = document.querySelector('hex-lens') as HTMLElementTagNameMap['hex-lens']
const BOUNDARY: ShownCells = { cells: { which: 'all' }, isWhole: false, most: Infinity }

const state = new PageState(draw)
const survey = () => state.survey
const chosenCell = () => state.chosen?.cell ?? null

const listRoot = document.createElement('div')
listRoot.className = 'list'
const table = new CellTable(listRoot, {
  rows: async (from, to) => (await state.asked(own => own.rows(from, to))) ?? [],
  arrange: order => void listing.arrange(order),
  choose: (cell, rank) => void choosing.chooseInList(cell, rank),
})
const histogram = new HistogramView(range => void listing.select(state.shown.condition, range))
const picture = new PictureControls(part('.picture'), {
  boundary: async () => state.opened.faces(BOUNDARY),
  cut: async cells => state.opened.cut(cells),
  choose: cell => void choosing.chooseAnywhere(cell),
  name: async cell => (await state.asked(own => own.detail(cell)))?.row ?? null,
  changed: () => travel.touch(),
  settingsText: () => travel.text,
  copySettings: () => void travel.copy(),
  takeSettings: text => travel.use(text),
})
const travel = new SettingsTravel({
  now: () => showing.travelling,
  overview: () => state.shown.overview,
  use: fitting => void showing.use(fitting),
  say: notice => picture.say(notice),
  written: () => picture.travelled(),
})
const takeAway = new TakeAway({ survey, picture: () => picture.toPNG(), saved: () => moves.saved() })
const chosenView = new ChosenView(part('.one'), step => void choosing.goToNext(step))
const moving = new MovingLens(lens, part('.one .moving'), {
  rows: rows => {
    table.patch(rows)
    const row = rows.find(({ cell }) => cell === chosenCell())
    if (row) chosenView.showAccepted(row)
  },
  move: made => void moves.take(own => own.move(made)),
  step: which => void moves.take(own => own[which]()),
  restore: points => void moves.take(own => own.restore(points)),
  freed: () => place.refresh(),
})
const place = new PlaceFold(part('.one .place'), {
  move: (point, to) => moves.take(own => own.move({ points: Uint32Array.of(point), to: Float64Array.from(to) })),
  whyFixed: vertex => moving.whyFixed(vertex),
  mark: marks => lens.markPlace(marks),
})
const untangling = new UntanglePanel({
  survey,
  chosen: chosenCell,
  ghost: lines => {
    picture.ghostLines = lines?.ends ?? null
  },
  take: found => void moves.take(own => own.move(found)),
  goTo: cell => void choosing.flyTo(cell),
})
const door = new InputDoor({
  open: input => void opener.open(input),
  use: settings => travel.use(settings),
  say: news => state.set({ news }),
})
const steps = new StepsView(part('.steps'), {
  chosen: chosenCell,
  show: (own, opening) => showing.showAnew(own, opening.opened, opening.chosen),
  take: opening => opener.takeTogether(opening),
  goTo: cell => choosing.flyTo(cell),
})

const views = { table, picture, chosen: chosenView, moving, place, steps, untangling }
const moves = new MeshMoves(state, views, (own, overview) => showing.showAnew(own, overview, chosenCell()))
const listing = new Listing(state, views)
const choosing = new Choosing(state, views, moves)
const showing = new Showing(state, views, { listing, choosing, travel })
const opener = new Opener(state, { showing, moves, travel }, selector =>
  overviewRoot.querySelector<HTMLElement>(selector)?.focus(),
)

function draw(shown: Shown): void {
  const { overview, movement, range } = shown
  const panels = [takeAway.show(overview, movement), untangling.root]
  const overviewParts = { door: door.buttons, buttons: [takeAway.button, untangling.button], panels }
  render(overviewTemplate(shown, opener, overviewParts), overviewRoot)
  const listingParts: ListingParts = { histogram: histogram.show(shown.histogram, range), table: listRoot }
  render(listingTemplate(shown, { listing, choosing }, listingParts), cellsRoot)
  chosenView.draw(overview)
  travel.touch()
}

document.addEventListener('keydown', event => {
  if (isTyping(event)) return
  // A browser would undo what was typed in a field that nobody is in.
  if ((event.ctrlKey || event.metaKey) && /^[yz]$/i.test(event.key)) event.preventDefault()
  if (event.altKey || event.ctrlKey || event.metaKey) return
  if (event.key === 'n') void choosing.goToNext(1)
  else if (event.key === 'p') void choosing.goToNext(-1)
  else return
  event.preventDefault()
})

addEventListener('beforeunload', event => {
  if (moves.areUnsaved || state.shown.aside) event.preventDefault()
})

void start()

/** What the page of the lens has handed over, or the example. */
async function start(): Promise<void> {
  const handed = await takeHanded()
  if (handed && 'input' in handed) return opener.open(handed.input)
  const [first] = EXAMPLES
  const opening = opener.open({ files: [first.file()] }, first)
  if (handed) state.set({ news: handed.lost })
  return opening
}
