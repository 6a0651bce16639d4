/**
 * `<hex-lens>`: one hexahedron and everything said about it. It owns the state, asks the core once
 * a frame and hands the same frame to every view. Nothing is scheduled while nothing changes,
 * nothing is drawn while nobody sees it. docs/element.md lists attributes, properties, methods,
 * events, slots, parts and custom properties.
 *
 * Beyond those, for the page around it: `permalink` is the address that opens this element again,
 * bit for bit; `raise` and `clear` are for what the page has to say about a problem.
 */

import { fetchCore } from '../core/fetch-core'
import type { Report } from '../core/report'
import { InputReader } from '../input/input-reader'
import { listenForInput } from '../input/pasted-input'
import type { Vertices } from '../model/hexahedron'
import { encodePermalink } from '../model/permalink'
import { type Preset, presetOf, presets, presetVertices } from '../model/presets'
import type { Action, Cameras } from '../model/state'
import { readState, type StateDocument, stateDocument } from '../model/state-document'
import { createStore } from '../model/store'
import { knownPanels, type Panel } from '../panels/panel'
import type { Figure, FigureName, Frame, Problem, ViewContext } from '../views/view'
import { Analyzer } from './analyzer'
import {
  type AttributeName,
  type Attributes,
  attributeNames,
  checkedVertices,
  FIRST_VIEWS,
  readAttribute,
  readVertices,
  verticesText,
  viewNames,
} from './attributes'
import { Changes } from './changes'
import type { Composition } from './composition'
import { Copying, pointInFull } from './copying'
import { type DueFrame, FrameLoop } from './frame-loop'
import { HexLensError } from './hex-lens-error'
import { ReflectingElement } from './reflecting-element'
import { shortcut } from './shortcuts'
import { ViewHost } from './view-host'

/** A reader hardly notices this wait; a page that stays empty for longer looks broken. */
const PATIENCE_MS = 150

/** Actions that a reader may not take on a read-only element. */
const CHANGES: ReadonlySet<Action['type']> = new Set([
  'move-vertex',
  'move-coordinate',
  'move-all',
  'set-vertices',
  'begin-gesture',
  'undo',
  'redo',
  'reset',
])

/** Properties that a page may have set on the element before its script came. */
const EARLY = ['vertices', 'state', 'preset', 'views', 'controls', 'camera', 'theme', 'poster', 'label', 'readOnly']

export class HexLens extends ReflectingElement {
  static readonly observedAttributes = attributeNames
  /** `define` sets it once, before an element is made. */
  static composition: Required<Composition>

  readonly #context: ViewContext = {
    state: () => this.#store.state,
    dispatch: action => this.#dispatchOfReader(action),
    raise: problem => this.raise(problem),
    clear: code => this.clear(code),
    requestFrame: () => this.#frames.schedule(),
    permalink: () => this.permalink,
    figure: name => this.#views.figure(name),
    input: {
      isWelcome: () => this.#input.isWelcome(),
      read: input => this.#input.read(input),
      close: () => this.#input.close(),
      show: (cell, order) => this.#input.show(cell, order),
    },
  }
  readonly #views: ViewHost
  readonly #analyzer = new Analyzer(
    HexLens.composition.panels,
    message => this.raise({ code: 'core-failed', message }),
    () => this.#frames.schedule(),
  )
  readonly #problems = new Map<Problem['code'], Problem>()
  readonly #store = createStore(presetVertices(presets[0]), presets[0].id)
  readonly #changes = new Changes(this.#store.state.vertices, {
    tell: (event: string, detail: unknown = null) => this.#tell(event, detail),
    reflect: () => this.#reflect(),
  })
  readonly #frames = new FrameLoop(this, frame => this.#onFrame(frame))
  /** Names of panels, as the attribute last said them. */
  #viewNames: readonly string[] = FIRST_VIEWS
  readonly #input = new InputReader(HexLens.composition.readingWorker, {
    isWelcome: () => this.#shownPanels.some(panel => panel.name === 'paste'),
    take: vertices => {
      this.#setVertices(vertices, null)
      return this.#store.state.vertices
    },
    refuse: message => (message === null ? this.clear('not-read') : this.raise({ code: 'not-read', message })),
    onNews: () => this.#frames.schedule(),
  })
  #cameras: Cameras | null = null
  #drawnCameras: Cameras | null = null
  #isReflecting = false

  constructor() {
    super()
    const shadow = this.attachShadow({ mode: 'open' })
    this.#views = new ViewHost(shadow, this.#context, HexLens.composition.panels)
    shadow.addEventListener('keydown', event => this.#onKeyDown(event as KeyboardEvent))
    new Copying(this.#views.lens, () => {
      const { state } = this.#store
      return pointInFull(this.#analyzer.probed(state), state.referenceCube)
    })
    listenForInput(shadow, this.#views.lens, {
      isWelcome: () => this.#input.isWelcome(),
      take: input => this.#input.read(input),
    })
  }

  connectedCallback(): void {
    for (const name of EARLY) this.#adopt(name)
    this.#views.begin(this.#shownPanels)
    this.#frames.start()
    if (this.#analyzer.core === null) void this.#start()
    else this.#frames.schedule()
  }

  disconnectedCallback(): void {
    this.#cameras = this.#camerasNow
    this.#frames.stop()
    this.#analyzer.stop()
    this.#views.end()
    this.#input.close()
  }

  attributeChangedCallback(name: AttributeName): void {
    if (this.#isReflecting) return
    try {
      this.#take(name)
      this.clear(`bad-${name}`)
    } catch (reason) {
      if (!(reason instanceof HexLensError)) throw reason
      this.raise({ code: `bad-${name}`, message: reason.message })
    }
  }

  get vertices(): number[] {
    return this.#store.state.vertices.slice()
  }

  /** Takes 24 finite numbers in an array-like or a text. Throws HexLensError for anything else. */
  set vertices(given: ArrayLike<number> | string) {
    const vertices = typeof given === 'string' ? readVertices(given) : checkedVertices(given)
    this.#setVertices(vertices, presetOf(vertices))
  }

  get state(): StateDocument {
    return stateDocument(this.#store.state, this.#camerasNow, knownPanels(HexLens.composition.panels))
  }

  /** Throws HexLensError outside the schema. Changes of the element are one step to undo. */
  set state(given: StateDocument) {
    const result = readState(given, knownPanels(HexLens.composition.panels))
    if (!result.ok) throw new HexLensError(result.error.code, result.error.message)
    const { state, cameras } = result.value
    if (!this.#changes.haveBegun) this.#begin(state.vertices, state.preset, state.start)
    this.#cameras = cameras
    this.#store.dispatch({ type: 'restore', state })
    this.#frames.schedule()
  }

  get preset(): string | null {
    return this.#store.state.preset
  }

  /** Throws HexLensError unless there is such a preset. */
  set preset(id: string | null) {
    const preset = readAttribute('preset', id, viewNames(HexLens.composition))
    if (preset) this.#setVertices(presetVertices(preset), preset.id)
  }

  get report(): Report | null {
    return this.#analyzer.report(this.#store.state.vertices)
  }

  get permalink(): string {
    const address = new URL(document.location.href)
    address.hash = encodePermalink(this.#store.state.vertices)
    return address.href
  }

  /** How far its scrolling boxes are scrolled, in CSS pixels, to set it so again; 0 where none is given. */
  get scrollPositions(): readonly number[] {
    return this.#views.scrollers.map(({ scrollTop }) => scrollTop)
  }

  set scrollPositions(positions: readonly number[]) {
    for (const [i, scroller] of this.#views.scrollers.entries()) scroller.scrollTop = positions[i] ?? 0
  }

  /** True if all that is to be seen is drawn: views come when they are seen or opened. */
  get complete(): boolean {
    return this.#frames.isSeen && this.#changes.haveBegun && this.#frames.isIdle && this.#views.isComplete
  }

  undo(): void {
    this.#dispatch({ type: 'undo' })
  }

  redo(): void {
    this.#dispatch({ type: 'redo' })
  }

  /** Reports on any 24 numbers, by default the element's own. Rejects with HexLensError. */
  async analyze(given: ArrayLike<number> = this.#store.state.vertices): Promise<Report> {
    const vertices = checkedVertices(given)
    const core = await fetchCore(HexLens.composition.core).catch(reason => {
      throw new HexLensError(
        'no-core',
        `The core did not start (${reason instanceof Error ? reason.message : reason}).`,
      )
    })
    const result = core.analyze(vertices)
    if (!result.ok) throw new HexLensError('no-core', result.error.message)
    return result.value
  }

  /** The scene as it is; dropped on an element it opens the vertices. Rejects with HexLensError. */
  async toPNG(): Promise<Blob> {
    const [{ figurePng }, figure] = await Promise.all([import('../views/figure-files'), this.#figure('scene')])
    return figurePng(figure, this.#store.state.vertices)
  }

  /** The scene, or the open face maps, as a document of its own. Rejects with HexLensError. */
  async toSVG(name: FigureName = 'scene'): Promise<string> {
    const [{ figureSvg }, figure] = await Promise.all([import('../views/figure-files'), this.#figure(name)])
    return figureSvg(figure, this.#store.state.vertices, this.label ?? this.preset ?? 'Hexahedron')
  }

  /**
   * Reads a text, a file, or files that belong together, as if it were dropped here. One element
   * becomes the element, as one step to undo; of several the reader chooses one if the view `paste`
   * is shown. `hex-error` tells what cannot be read.
   */
  offer(given: string | File | readonly File[]): void {
    if (typeof given === 'string') this.#input.read({ text: given })
    else this.#input.read({ files: given instanceof File ? [given] : given })
  }

  raise(problem: Problem): void {
    if (this.#problems.get(problem.code)?.message === problem.message) return
    this.#problems.set(problem.code, problem)
    this.#frames.schedule()
    this.#tell('hex-error', problem)
  }

  clear(code: Problem['code']): void {
    if (this.#problems.delete(code)) this.#frames.schedule()
  }

  /** A property set before the class was there hides the class's own. */
  #adopt(name: string): void {
    const early = Object.getOwnPropertyDescriptor(this, name)
    if (early === undefined) return
    Reflect.deleteProperty(this, name)
    Reflect.set(this, name, early.value)
  }

  /** Does what an attribute says. Throws HexLensError, with nothing changed. */
  #take(name: AttributeName): void {
    const takes: { readonly [Name in AttributeName]: (value: Attributes[Name]) => void } = {
      vertices: vertices => this.#takeElement(vertices, null),
      preset: preset => this.#takeElement(null, preset),
      views: names => this.#showPanels(names),
      controls: controls => this.#dispatch({ type: 'show-controls', controls }),
      camera: camera => {
        this.#cameras = { camera, referenceCamera: this.#camerasNow.referenceCamera }
        this.#frames.schedule()
      },
      theme: () => {}, // the style sheet does it
      readonly: isReadonly => {
        this.#dispatch({ type: 'set-readonly', isReadonly })
        this.#showPanels(this.#viewNames)
      },
      poster: poster => this.#views.setPoster(poster),
      label: label => this.#views.setLabel(label),
    }
    const take = takes[name] as (value: unknown) => void
    take(readAttribute(name, this.getAttribute(name), viewNames(HexLens.composition)))
  }

  /** The two attributes, in any order before the first frame, are where the element starts. */
  #takeElement(vertices: Vertices | null, preset: Preset | null): void {
    if (!this.#changes.haveBegun) {
      const own = vertices ?? this.#understood('vertices')
      const from = preset ?? this.#understood('preset')
      const start = from && from.valid !== null ? presetVertices(from) : own
      const first = own ?? (from && presetVertices(from))
      if (first) this.#begin(first, from?.id ?? presetOf(first), start ?? first)
    } else if (vertices) this.#setVertices(vertices, presetOf(vertices))
    else if (preset) this.#setVertices(presetVertices(preset), preset.id)
  }

  /** The value of an attribute; null if there is none, or its text is not understood. */
  #understood<Name extends AttributeName>(name: Name): Attributes[Name] | null {
    try {
      return readAttribute(name, this.getAttribute(name), viewNames(HexLens.composition))
    } catch {
      return null // its own call of #take refuses it
    }
  }

  get #shownPanels(): readonly Panel[] {
    const { isReadonly } = this.#store.state
    return HexLens.composition.panels.filter(
      panel => panel.always || (this.#viewNames.includes(panel.with ?? panel.name) && !(isReadonly && panel.changes)),
    )
  }

  #showPanels(names: readonly string[]): void {
    this.#viewNames = names
    if (!this.isConnected) return
    this.#cameras = this.#camerasNow
    this.#views.begin(this.#shownPanels)
    this.#frames.schedule()
  }

  #setVertices(vertices: Vertices, preset: string | null): void {
    if (this.#changes.haveBegun) this.#dispatch({ type: 'set-vertices', vertices, preset })
    else this.#begin(vertices, preset, vertices)
  }

  /** Vertices set before the first frame are where the element starts, not a step to undo. */
  #begin(vertices: Vertices, preset: string | null, start: Vertices): void {
    this.#store.dispatch({ type: 'initialize', vertices, preset, start })
    this.#changes.begin(this.#store.state.vertices)
  }

  /** The cameras as the reader has turned them, or as they were asked for. */
  get #camerasNow(): Cameras {
    const seen = this.#cameras === this.#drawnCameras ? this.#views.cameras() : null
    return seen ?? this.#cameras ?? { camera: null, referenceCamera: null }
  }

  #dispatch(action: Action): void {
    const before = this.#store.state
    this.#store.dispatch(action)
    if (this.#store.state !== before) this.#frames.schedule()
  }

  #dispatchOfReader(action: Action): void {
    if (!(this.#store.state.isReadonly && CHANGES.has(action.type))) this.#dispatch(action)
  }

  /** The core comes before the first frame, unless it is slow to come. */
  async #start(): Promise<void> {
    const slow = setTimeout(() => this.#frames.schedule(), PATIENCE_MS)
    try {
      this.#analyzer.core = await fetchCore(HexLens.composition.core)
      this.clear('core-failed')
      if (this.isConnected) this.#changes.tell(this.#store.state, this.report)
      this.#frames.schedule()
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

  #onFrame({ time, isNews, isSeen, isForPaper }: DueFrame) {
    const { state } = this.#store
    this.#changes.tell(state, this.#analyzer.report(state.vertices))
    if (!isSeen) return { isWaiting: false, isUnmade: false }
    const frame: Frame = {
      state,
      ...this.#analyzer.analyze(state),
      reading: this.#input.reading,
      cameras: this.#cameras,
      problems: [...this.#problems.values()],
      isForPaper,
    }
    this.#views.draw(frame, isNews, time)
    this.#drawnCameras = frame.cameras
    return this.#views
  }

  /** Writes the present vertices and preset to the attributes. */
  #reflect(): void {
    const { vertices, preset } = this.#store.state
    this.#isReflecting = true
    this.setAttribute('vertices', verticesText(vertices))
    if (preset === null) this.removeAttribute('preset')
    else this.setAttribute('preset', preset)
    this.#isReflecting = false
    for (const name of ['vertices', 'preset'] as const) this.clear(`bad-${name}`)
  }

  #figure(name: FigureName): Promise<Figure> {
    return this.#frames.whileDrawn(async () => {
      await fetchCore(HexLens.composition.core).catch(() => {}) // without it there are lines, and they are drawn
      while (this.isConnected && !this.complete) await new Promise(requestAnimationFrame)
      const figure = this.#views.figure(name)
      if (figure === null) throw new HexLensError('no-picture', `There is no picture of the ${name} on the page.`)
      return figure
    })
  }

  #onKeyDown(event: KeyboardEvent): void {
    const action = shortcut(event, this.#store.state)
    if (action === null) return
    event.preventDefault()
    this.#dispatchOfReader(action)
  }

  #tell(name: string, detail: unknown = null): void {
    this.dispatchEvent(new CustomEvent(name, { bubbles: true, composed: true, detail }))
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'hex-lens': HexLens
  }
}
