/**
 * `<hex-lens>`: one hexahedron and everything said about it. It owns the state, asks the core once a frame and hands
 * one frame's truth to every view. Nothing is scheduled while nothing changes.
 *
 * `vertices`  24 finite numbers, VTK_HEXAHEDRON order, get (a copy) and set (any array-like; else HexLensError, state kept)
 * `state`     everything that a reader would expect to come back, as plain data for JSON: see docs/state.schema.json
 * `preset`    the id of the preset that the element started from, or null
 * `report`    what the core knows about exactly these vertices; null while there is no core
 * `permalink` the address that opens this element again, bit for bit
 * methods     undo, redo; offer, for a text or a file with eight points in it;
 *             raise and clear for what the page around it has to say about a problem
 * events      hex-input (live), hex-change (committed), hex-verdict (valid changed), hex-error (a problem was raised)
 */
import { presets, presetVertices } from '../content/presets'
import { type Morph, morphOf } from '../core/morph'
import type { Core, JacobianReport, Report } from '../core/report'
import { type Surface, zeroSurface } from '../core/zero-surface'
import { jacdetInFull } from '../model/decimal'
import { COORDINATE_COUNT, type Vertices } from '../model/hexahedron'
import { encodePermalink } from '../model/permalink'
import type { Action, Cameras } from '../model/state'
import { readState, type StateDocument, stateDocument } from '../model/state-document'
import { createStore, type Store } from '../model/store'
import marks from '../views/marks.css?inline'
import said from '../views/said.css?inline'
import type { Figure, Offer, Problem, Proof, TriedOrders, View, ViewHost } from '../views/view'
import { Copying } from './copying'
import { fetchCore } from './fetch-core'
import css from './hex-lens.css?inline'
import { HexLensError } from './hex-lens-error'
import { listenForOffers } from './offers'
import { type Part, parts } from './parts'
import { historyStep } from './shortcuts'
import { triedOrders } from './tried-orders'
import { Turns } from './turns'

const styleSheets = [css, said, marks, ...parts.map(part => part.styles)].map(styles => {
  const sheet = new CSSStyleSheet()
  sheet.replaceSync(styles)
  return sheet
})

/** Cells of the grid along each axis from which the surface jacdet = 0 is made, between gestures and in one. */
const SURFACE_CELLS = 24
const GESTURE_SURFACE_CELLS = 8

/** What a reader hardly notices; a page that stays empty for longer looks broken. */
const PATIENCE_MS = 150

export class HexLens extends HTMLElement {
  readonly #places: Readonly<Record<'head' | 'stage' | 'panel', HTMLElement>>
  readonly #problems = new Map<Problem['code'], Problem>()
  #store: Store = createStore(presetVertices(presets[0]), presets[0].id)
  #committed: Vertices = this.#store.state.vertices
  #drawn: Vertices | null = null
  #core: Core | null = null
  #analyzed: { readonly vertices: Vertices; readonly report: Report } | null = null
  #proof: Proof | null = null
  #triedOrders: TriedOrders | null = null
  #zeroSurface: { readonly report: Report; readonly cells: number; readonly surface: Surface } | null = null
  #offer: Offer | null = null
  #cameras: Cameras | null = null
  #drawnCameras: Cameras | null = null
  #morph: Morph | null = null
  #toldValid: boolean | null = null
  #views: readonly View[] = []
  /** Parts to be made in the next frame, in the one after it, … */
  #unmade: readonly (readonly Part[])[] = []
  #frameRequest = 0
  /** Whether there is more to draw than what waits for its turn. */
  #isNews = false
  #turns = new Turns()

  constructor() {
    super()
    const shadow = this.attachShadow({ mode: 'open' })
    shadow.adoptedStyleSheets = styleSheets
    this.#places = { head: place('head'), stage: place('stage'), panel: place('panel') }
    const lens = place('lens')
    lens.append(this.#places.head, this.#places.stage, this.#places.panel)
    shadow.append(lens)
    shadow.addEventListener('keydown', event => this.#onKeyDown(event as KeyboardEvent))
    new Copying(lens, () => this.#pointInFull())
    listenForOffers(shadow, lens, offer => this.offer(offer))
  }

  connectedCallback(): void {
    this.#unmade = [parts.filter(part => !part.slow), parts.filter(part => part.slow)]
    if (this.#core === null) void this.#start()
    else this.#schedule()
  }

  disconnectedCallback(): void {
    this.#cameras = this.#camerasNow
    cancelAnimationFrame(this.#frameRequest)
    this.#frameRequest = 0
    for (const view of this.#views) {
      view.dispose()
      view.root.remove()
    }
    this.#views = []
    this.#turns = new Turns()
    this.#unmade = []
    this.#offer = null
  }

  get vertices(): number[] {
    return this.#store.state.vertices.slice()
  }

  set vertices(given: ArrayLike<number>) {
    const vertices = checked(given)
    const preset = presetOf(vertices)
    if (this.#drawn === null) this.#begin(vertices, preset)
    else this.#dispatch({ type: 'set-vertices', vertices, preset })
  }

  get state(): StateDocument {
    return stateDocument(this.#store.state, this.#camerasNow)
  }

  /** Throws HexLensError for what the schema does not let through. What it changes of the element is one step to undo. */
  set state(given: StateDocument) {
    const result = readState(given)
    if (!result.ok) throw new HexLensError(result.error.code, result.error.message)
    const { state, cameras } = result.value
    if (this.#drawn === null) this.#begin(state.vertices, state.preset, state.start)
    this.#cameras = cameras
    this.#store.dispatch({ type: 'restore', state })
    this.#schedule()
  }

  get preset(): string | null {
    return this.#store.state.preset
  }

  get report(): Report | null {
    const { vertices } = this.#store.state
    if (this.#core === null) return null
    if (this.#analyzed?.vertices !== vertices) {
      const result = this.#core.analyze(vertices)
      this.#analyzed = result.ok ? { vertices, report: result.value } : null
      if (!result.ok) this.raise({ code: 'core-failed', message: result.error.message })
    }
    return this.#analyzed?.report ?? null
  }

  get permalink(): string {
    const address = new URL(document.location.href)
    address.hash = encodePermalink(this.#store.state.vertices)
    return address.href
  }

  undo(): void {
    this.#dispatch({ type: 'undo' })
  }

  redo(): void {
    this.#dispatch({ type: 'redo' })
  }

  /** The panel that reads it opens; what it finds becomes the element, as one step to undo. */
  offer(offer: Offer): void {
    this.#offer = offer
    this.#dispatch({ type: 'open-panel', panel: 'paste', isOpen: true })
    this.#schedule()
  }

  raise(problem: Problem): void {
    if (this.#problems.get(problem.code)?.message === problem.message) return
    this.#problems.set(problem.code, problem)
    this.#schedule()
    this.#tell('hex-error', problem)
  }

  clear(code: Problem['code']): void {
    if (this.#problems.delete(code)) this.#schedule()
  }

  readonly #host: ViewHost = {
    state: () => this.#store.state,
    dispatch: action => this.#dispatch(action),
    raise: problem => this.raise(problem),
    clear: code => this.clear(code),
    requestFrame: () => this.#schedule(),
    permalink: () => this.permalink,
    figure: name => this.#views.reduce<Figure | null>((found, view) => found ?? view.figure?.(name) ?? null, null),
  }

  /** What is set before the first frame is what the element starts from, not a step to undo. */
  #begin(vertices: Vertices, preset: string | null, start = vertices): void {
    this.#store = createStore(vertices, preset, start)
    this.#committed = this.#store.state.vertices
  }

  /** As the reader has turned them, or as they were asked for. */
  get #camerasNow(): Cameras {
    const isDrawn = this.#cameras === this.#drawnCameras
    const views = isDrawn ? this.#views : []
    const seen = views.reduce<Cameras | null>((found, view) => found ?? view.cameras?.() ?? null, null)
    return seen ?? this.#cameras ?? { camera: null, referenceCamera: null }
  }

  #dispatch(action: Action): void {
    const before = this.#store.state
    this.#store.dispatch(action)
    if (this.#store.state !== before) this.#schedule()
  }

  /** The core comes before the first frame, unless it is slow to come. */
  async #start(): Promise<void> {
    const slow = setTimeout(() => this.#schedule(), PATIENCE_MS)
    try {
      this.#core = await fetchCore()
      this.clear('core-failed')
      this.#schedule()
    } catch (reason) {
      const why = reason instanceof Error ? reason.message : String(reason)
      this.raise({
        code: 'core-failed',
        message: `The WebAssembly core did not start, so there is no verdict (${why}). The vertices and the link still work; reload the page to try again.`,
      })
    } finally {
      clearTimeout(slow)
    }
  }

  #schedule(): void {
    this.#isNews = true
    this.#request()
  }

  #request(): void {
    if (this.isConnected && this.#frameRequest === 0) this.#frameRequest = requestAnimationFrame(this.#draw)
  }

  /** Makes what is due in this frame. */
  #make(): void {
    const [due = [], ...later] = this.#unmade
    const made = due.map(part => {
      const view = part.create(this.#host)
      this.#places[part.place].append(view.root)
      return view
    })
    this.#views = [...this.#views, ...made]
    this.#unmade = later
  }

  /** The proof follows the vertices between gestures; nothing is computed while it is closed. */
  #prove(): void {
    const { vertices, gestureStart, proofShown } = this.#store.state
    if (!proofShown || this.#analyzed === null) this.#proof = null
    else if (this.#core && this.#proof?.vertices !== vertices && (this.#proof === null || gestureStart === null)) {
      const result = this.#core.certificate(vertices)
      this.#proof = result.ok ? { vertices, certificate: result.value } : null
    }
  }

  /** Between gestures, like the proof; of invalid elements only. */
  #tryOrders(): void {
    const { vertices, gestureStart, openPanels } = this.#store.state
    if (!openPanels.includes('node-order') || this.#analyzed === null) this.#triedOrders = null
    else if (this.#core && gestureStart === null && this.#triedOrders?.vertices !== vertices)
      this.#triedOrders = this.#analyzed.report.valid ? null : triedOrders(this.#core, vertices)
  }

  /** Coarser while a gesture runs; what is already finer stays. */
  #surfaced(report: Report | null): Surface | null {
    const { faceDisplay, gestureStart } = this.#store.state
    if (faceDisplay !== 'inside' || report === null) return null
    const cells = gestureStart === null ? SURFACE_CELLS : GESTURE_SURFACE_CELLS
    if (this.#zeroSurface?.report !== report || this.#zeroSurface.cells < cells)
      this.#zeroSurface = { report, cells, surface: zeroSurface(report.bernstein, cells) }
    return this.#zeroSurface.surface
  }

  #morphed(): Morph | null {
    const { vertices, start, morphA, morphB, gestureStart, openPanels } = this.#store.state
    const [a, b] = [morphA ?? start, morphB ?? vertices]
    if (!openPanels.includes('morph') || this.#core === null || this.#analyzed === null) this.#morph = null
    else if (gestureStart === null && (this.#morph?.a !== a || this.#morph.b !== b))
      this.#morph = morphOf(this.#core, a, b)
    return this.#morph
  }

  #probed(): JacobianReport | null {
    const { vertices, probe } = this.#store.state
    const result = probe && this.#core?.jacobian(vertices, probe)
    return result?.ok ? result.value : null
  }

  /** Of what is pointed at: every number with all its digits. */
  #pointInFull(): string | null {
    const probe = this.#probed()
    if (probe === null) return null
    const jacdet = jacdetInFull(probe.jacdet, probe.exponent, this.#store.state.referenceCube)
    return `jacdet = ${jacdet}, (xi, eta, zeta) = (${probe.point.join(', ')}), (x, y, z) = (${probe.position.join(', ')})`
  }

  readonly #draw = (): void => {
    this.#frameRequest = 0
    const isNews = this.#isNews
    this.#isNews = false
    this.#make()
    const report = this.report
    this.#prove()
    this.#tryOrders()
    const frame = {
      state: this.#store.state,
      report,
      proof: this.#proof,
      triedOrders: this.#triedOrders,
      probe: report && this.#probed(),
      offer: this.#offer,
      cameras: this.#cameras,
      morph: this.#morphed(),
      zeroSurface: this.#surfaced(report),
      problems: [...this.#problems.values()],
    }
    for (const view of this.#turns.due(this.#views, isNews, frame.state.gestureStart !== null)) {
      try {
        view.update(frame)
      } catch (bug) {
        reportError(bug) // one view's bug must not take the others' numbers away
      }
    }
    if (this.#unmade.length > 0) this.#schedule()
    else if (this.#turns.isWaiting) this.#request()
    const { vertices, gestureStart } = frame.state
    const moved = this.#drawn !== null && this.#drawn !== vertices
    this.#drawn = vertices
    this.#drawnCameras = frame.cameras
    if (moved) this.#tell('hex-input')
    if (report && report.valid !== this.#toldValid) {
      this.#toldValid = report.valid
      this.#tell('hex-verdict', { valid: report.valid })
    }
    if (gestureStart === null && this.#committed !== vertices) {
      this.#committed = vertices
      this.#tell('hex-change')
    }
  }

  #onKeyDown(event: KeyboardEvent): void {
    const step = historyStep(event)
    const midEdit = this.#store.state.gestureStart !== null || (event.target as Element).matches('[aria-invalid]')
    if (step === null || midEdit || event.defaultPrevented) return
    event.preventDefault()
    this.#dispatch({ type: step })
  }

  #tell(name: string, detail: unknown = null): void {
    this.dispatchEvent(new CustomEvent(name, { bubbles: true, composed: true, detail }))
  }
}

function place(name: string): HTMLElement {
  const element = document.createElement('div')
  element.className = name
  return element
}

/** The id of the preset that is these very numbers. */
function presetOf(vertices: Vertices): string | null {
  const isThis = (known: Vertices) => known.every((value, i) => Object.is(value, vertices[i]))
  return presets.find(preset => preset.valid !== null && isThis(presetVertices(preset)))?.id ?? null
}

function checked(given: ArrayLike<number>): Vertices {
  if (given?.length !== COORDINATE_COUNT) {
    throw new HexLensError('wrong-count', `A hexahedron has 24 coordinates; ${given?.length ?? 'none'} were given.`)
  }
  const vertices = Array.from(given)
  const bad = vertices.findIndex(value => !Number.isFinite(value))
  if (bad >= 0) throw new HexLensError('not-finite', `Coordinate ${bad} is ${vertices[bad]}, not a finite number.`)
  return vertices
}

if (!customElements.get('hex-lens')) customElements.define('hex-lens', HexLens)

declare global {
  interface HTMLElementTagNameMap {
    'hex-lens': HexLens
  }
}
