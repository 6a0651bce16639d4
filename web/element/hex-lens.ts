/**
 * `<hex-lens>`: one hexahedron and everything said about it. It owns the state, asks the core once
 * a frame and hands the same frame to every view. Nothing is scheduled while nothing changes,
 * nothing is drawn while nobody sees it. `npm run reference` writes custom-elements.json and
 * docs/element.md from the comments of the class and of its public members.
 */

import { fetchCore } from '../core/fetch-core'
import type { Report } from '../core/report'
import { InputReader } from '../input/input-reader'
import { sameBits, type Vertices } from '../model/hexahedron'
import { type HistoryDocument, historyDocument, readHistory } from '../model/history-document'
import { encodePermalink } from '../model/permalink'
import { presetOf, presets, presetVertices } from '../model/presets'
import { type Action, type Cameras, type CameraView, type ChangeSource, sliceChange, sliceOf } from '../model/state'
import { readState, type StateDocument, stateDocument } from '../model/state-document'
import { createStore } from '../model/store'
import { elementAt } from '../model/way'
import { knownPanels, type Panel } from '../panels/panel'
import { DEFAULT_VIEW } from '../scene/space/orbit-camera'
import { placeSlice } from '../views/place-marks'
import { type SceneState, scriptSlice, surroundingsSlice } from '../views/scene-slices'
import type { Figure, FigureName, Frame, Problem, ViewContext } from '../views/view'
import { say } from '../words/say'
import { Analyzer } from './analyzer'
import {
  AttributeInput,
  type AttributeName,
  attributeNames,
  checkedVertices,
  FIRST_VIEWS,
  type GivenVertices,
  listOf,
  readAttribute,
  taking,
  viewNames,
} from './attributes'
import { Changes } from './changes'
import type { Composition } from './composition'
import { Copying, pointInFull } from './copying'
import { type DueFrame, FrameLoop } from './frame-loop'
import { HexLensError } from './hex-lens-error'
import { Keys } from './keys'
import { Looking } from './looking'
import { cameraBetween, Motion, type MotionOptions } from './motion'
import { OwnLanguage } from './own-language'
import { Readiness } from './readiness'
import { ReflectingElement, textOf } from './reflecting-element'
import {
  type CameraGoal,
  type HighlightedParts,
  type PlaceParts,
  readCameraView,
  readHighlights,
  readPlace,
  readSeconds,
  readSurroundings,
  type SurroundingParts,
} from './script-arguments'
import { Sharing } from './sharing'
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
const EARLY = [
  'history',
  'vertices',
  'state',
  'preset',
  'views',
  'controls',
  'camera',
  'theme',
  'poster',
  'label',
  'app',
  'readOnly',
  'group',
  'share',
  'hiddenFaces',
]

/**
 * @summary One trilinear hexahedron to drag, coloured by its Jacobian determinant, with a certain
 *   verdict.
 * @tag hex-lens
 *
 * @attr {24 numbers} [vertices=the preset’s] - Eight vertices x, y, z in VTK_HEXAHEDRON order.
 *   Commas, brackets and white space may stand between the numbers. Every committed change is
 *   written back, bit for bit.
 * @attr {a preset’s id} [preset=looks-fine] - The element to start from. If `vertices` is there
 *   too, Reset goes back to the preset.
 * @attr {a list of words, or `all`} [views=scene verdict] - What is shown: `scene`, `verdict`,
 *   `toolbar`, `checks`, `proof`, `vertices`, and the panels that open on request: `face-maps`,
 *   `algorithm`, `inside`, `morph`, `node-order`, `paste`, `take-away`, `embed`. The pages of
 *   Hexlens add `nearest`; elsewhere the word is ignored. With the scene and the verdict alone, the
 *   verdict is a line or two below the scene.
 * @attr {a list of words, `all` or `none`} [controls=all] - Buttons of the scene: `minimum`, `faces`,
 *   `reference`, `turn`, `fit`, `help`. The keys work without their buttons.
 * @attr {azimuth, elevation, zoom} [camera=-58 24 1] - The first view: two angles in degrees, and
 *   how many times nearer than the view in which the element just fits. Without it, a preset whose
 *   minimum is negative and hidden, or hardly seen from there, is first seen from another direction. Turning by the reader
 *   changes the property and `state`, not this.
 * @attr {`auto`, `light` or `dark`} [theme=auto] - `auto` is the `color-scheme` of the page where the
 *   element stands.
 * @attr {there or not} [readonly=not] - The reader may look and turn, but not change the element.
 *   Programs may change it.
 * @attr {an address} [poster=none] - A picture in the element’s place until it is drawn.
 * @attr {a text} [label=none] - The name of the whole for screen readers.
 * @attr {a name} [group=none] - Elements of one group have one element with one history, one camera
 *   and one point that is pointed at. One that joins takes what the group has.
 * @attr {a list of words, `all` or `none`} [share=all] - What it shares with its group: `vertices`,
 *   `camera`, `probe`. Two elements share what both say.
 * @attr {a list of numbers, `all` or `none`} [hidden-faces=none] - Faces that are not drawn: 0 to 5
 *   are -xi, +xi, -eta, +eta, -zeta, +zeta. One that the reader asks for alone is drawn.
 * @attr {an address} [app=none] - The Hexlens page that links to the element lead to; empty for the
 *   page itself. Without it there are neither links nor “Copy embed”.
 *
 * @slot - Shown until the element is drawn, and where it never is: without JavaScript, for one.
 * @slot hint - Words of the page’s own in the scene, where it has room for its legend. They stand in
 *   the legend’s place, and arrows around a handle show that it can be dragged, until the reader
 *   first moves a vertex.
 * @slot list - Words of the page’s own above the cells of a list that was read.
 * @slot caption - Below the element, in the page’s own style.
 *
 * @cssState ready - Everything in sight has been drawn.
 * @cssState valid - The verdict; neither this nor the next while there is none.
 * @cssState invalid
 *
 * @csspart lens - The whole element.
 * @csspart head - The part above the picture: toolbar and problems.
 * @csspart stage - The place of the scene.
 * @csspart panels - The part beside or below the scene.
 * @csspart caption - The box of the slot of that name.
 * @csspart fallback - The box of the poster and of the content between the tags.
 * @csspart poster - The picture in the fallback.
 * @csspart scene - A view, as are all parts that follow.
 * @csspart verdict
 * @csspart toolbar
 * @csspart problems
 * @csspart announcer
 * @csspart checks
 * @csspart minimum - Shown with the verdict: the numbers behind it.
 * @csspart proof
 * @csspart vertices
 * @csspart face-maps
 * @csspart algorithm
 * @csspart inside
 * @csspart nearest - On the pages of Hexlens only.
 * @csspart morph
 * @csspart node-order
 * @csspart paste
 * @csspart reading - Beside the verdict where `paste` is among the views: what was read, and the
 *   cells to choose from.
 * @csspart take-away
 * @csspart embed
 *
 * @cssprop [--hl-aspect-ratio=4 / 3] - Aspect ratio of the element’s box, if its height is not
 *   given; `auto` leaves it to the content and to `min-height`.
 * @cssprop [--hl-stage-height=minmax(11rem, 1fr)] - Height of the picture’s row if panels are below
 *   it: any value of grid-template-rows. With it, all panels below are open.
 * @cssprop [--hl-split-stage-height=minmax(22rem, 1fr)] - The same while the reference cube is
 *   below the element.
 * @cssprop [--hl-rem=16px] - The unit for the sizes of text and marks, whatever the page’s own text
 *   size is.
 * @cssprop [--hl-paper=#fcfcfb, dark #17181a] - The background.
 * @cssprop [--hl-ink=#1c1e21, dark #e9e9e6] - Text and lines.
 * @cssprop [--hl-muted=#6a6f76, dark #9a9fa6] - Text of less weight.
 * @cssprop [--hl-line=#e4e5e3, dark #303336] - Hairlines.
 * @cssprop [--hl-negative=#b2182b, dark #f4787a] - The hue of negative jacdet.
 * @cssprop [--hl-positive=#2166ac, dark #74b3f0] - The hue of positive jacdet.
 * @cssprop [--hl-neutral=#eeeeeb, dark #373a3f] - The colour of zero.
 */
export class HexLens extends ReflectingElement {
  static readonly observedAttributes: readonly AttributeName[] = attributeNames
  /** `define` sets it once, before an element is made. */
  static composition: Required<Composition>

  readonly #context: ViewContext = {
    state: () => this.#store.state,
    dispatch: action => this.#dispatchOfReader(action),
    raise: problem => this.raise(problem),
    clear: code => this.clear(code),
    requestFrame: () => this.#frames.schedule(),
    turned: () => {
      this.#looking.hasTurned = true
      this.#frames.schedule()
    },
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
  readonly #language: OwnLanguage
  readonly #analyzer = new Analyzer(
    HexLens.composition.panels,
    message => this.raise({ code: 'core-failed', message }),
    () => this.#frames.schedule(),
  )
  readonly #problems = new Map<Problem['code'], Problem>()
  readonly #store = createStore(presetVertices(presets[0]), presets[0].id, 'starting')
  readonly #changes = new Changes({
    tell: (event, detail) => this.#tell(event, detail),
    reflect: () => this.#attributes.reflect(this.#store.state),
  })
  readonly #looking = new Looking({
    tell: (event: string, detail: unknown) => this.#tell(event, detail),
  })
  readonly #sharing = new Sharing({
    state: () => this.#store.state,
    history: () => this.#store.history,
    camera: () => this.#looking.camera,
    source: () => this.#changes.source,
    dispatch: (action, source) => this.#dispatch(action, source),
    lookFrom: camera => this.#lookFrom(camera),
    draw: time => this.#frames.drawIn(time),
  })
  readonly #turning = new Motion(this)
  readonly #morphing = new Motion(this)
  readonly #frames = new FrameLoop(this, frame => this.#onFrame(frame))
  readonly #readiness = new Readiness(this, () => this.#tell('hex-ready'))
  readonly #keys: Keys
  #app: URL | null = null
  /** Names of panels, as the attribute last said them. */
  #viewNames: readonly string[] = FIRST_VIEWS
  readonly #input = new InputReader(HexLens.composition.readingWorker, {
    isWelcome: () => this.#shownPanels.some(panel => panel.name === 'paste'),
    take: vertices => {
      this.#dispatch({ type: 'set-vertices', vertices, preset: null }, 'paste')
      return this.#store.state.vertices
    },
    refuse: message => (message === null ? this.clear('not-read') : this.raise({ code: 'not-read', message })),
    onNews: () => this.#frames.schedule(),
    onList: list => this.#tell('hex-list', list),
  })
  readonly #attributes = new AttributeInput(this, viewNames(HexLens.composition), {
    state: () => this.#store.state,
    dispatch: action => this.#dispatch(action),
    setVertices: vertices => this.#setVertices(vertices),
    setApp: address => {
      this.#app = address
      this.#showPanels(this.#viewNames)
    },
    showViews: names => this.#showPanels(names),
    setReadonly: isReadonly => {
      this.#dispatch({ type: 'set-readonly', isReadonly })
      this.#showPanels(this.#viewNames)
    },
    lookFrom: camera => this.#lookFrom(camera),
    setPoster: address => this.#views.setPoster(address),
    setLabel: label => this.#views.setLabel(label),
    share: change => {
      Object.assign(this.#sharing, change)
      if (this.isConnected) this.#sharing.join()
    },
  })

  constructor() {
    super()
    const shadow = this.attachShadow({ mode: 'open' })
    this.#views = new ViewHost(shadow, this.#context, HexLens.composition.panels)
    this.#language = new OwnLanguage(this, this.#views.lens, () => this.#sayAnew())
    shadow.addEventListener('keydown', event => this.#onKeyDown(event as KeyboardEvent))
    new Copying(this.#views.lens, () => {
      const { state } = this.#store
      return pointInFull(this.#analyzer.probed(state), state.referenceCube)
    })
    this.#input.listen(shadow, this.#views.lens)
    this.#keys = new Keys(this, shadow)
  }

  connectedCallback(): void {
    this.#language.start()
    for (const name of EARLY) this.#adopt(name)
    this.#sharing.join()
    this.#views.begin(this.#shownPanels)
    this.#frames.start()
    if (this.#analyzer.core === null) void this.#start()
    else this.#frames.schedule()
  }

  disconnectedCallback(): void {
    this.#keepCameras()
    this.#language.stop()
    this.#frames.stop()
    this.#analyzer.stop()
    this.#views.end()
    this.#sharing.leave()
    this.#input.close()
    this.#keys.leave()
    this.#readiness.end()
  }

  attributeChangedCallback(name: AttributeName): void {
    this.#language.during(() => this.#attributes.take(name))
  }

  /**
   * A copy of the 24 coordinates. Takes 24 finite numbers in an array or the like, eight times three
   * of them, or a text as in the attribute. Once the element is drawn, an assignment is one step to
   * undo; one in a gesture of the reader is part of its step. The numbers that are there already
   * change nothing. While a gesture runs, neither do those that events have brought of late, unless
   * they are set in the listener itself: a page that gives back what it was told may do so late.
   */
  get vertices(): number[] {
    return this.#store.state.vertices.slice()
  }

  set vertices(given: GivenVertices) {
    taking(this, 'vertices', () => this.#setVertices(checkedVertices(given)))
  }

  /**
   * Everything that a reader expects to come back, as plain data to keep as JSON:
   * `docs/state.schema.json`. Version 1 can always be read. A later one, or anything else outside the
   * schema, changes nothing and is told by `hex-error`. A change of the vertices is one step to undo.
   */
  get state(): StateDocument & SceneState {
    const state = { ...this.#store.state, cameras: this.#camerasNow }
    return stateDocument(state, knownPanels(HexLens.composition.panels)) as StateDocument & SceneState
  }

  set state(given: StateDocument) {
    taking(this, 'state', () => {
      const result = readState(given, knownPanels(HexLens.composition.panels))
      if (!result.ok) throw new HexLensError(result.error.code, result.error.message)
      this.#dispatch({ type: 'restore', state: result.value })
    })
  }

  /**
   * The elements that undo and redo lead to, as plain data to keep as JSON, every bit of it:
   * `docs/history.schema.json`. Of a gesture that still runs it has where that began. An assignment
   * takes the place of all steps and shows their present element; what is set after it is a step.
   * Version 1 can always be read. A later one, or anything else outside the schema, changes nothing
   * and is told by `hex-error`.
   */
  get history(): HistoryDocument {
    return historyDocument(this.#store.history)
  }

  set history(given: HistoryDocument) {
    taking(this, 'history', () => {
      const result = readHistory(given)
      if (!result.ok) throw new HexLensError(result.error.code, result.error.message)
      this.#dispatch({ type: 'take-history', history: result.value })
    })
  }

  /**
   * The camera as it is now: the `direction` to the eye, how many times nearer it is than where the
   * element just fits in (`zoom`), and how far the view is shifted (`pan`), as in `state`. An
   * assignment looks that way at once; a text is the attribute, null the default view. What is not
   * understood is told by `hex-error`.
   */
  get camera(): CameraView {
    return this.#camerasNow?.camera ?? DEFAULT_VIEW
  }

  set camera(given: CameraGoal | string | null | undefined) {
    if (typeof given === 'string') this.setAttribute('camera', given)
    else
      taking(this, 'camera', () => this.#lookFrom(given === undefined || given === null ? null : readCameraView(given)))
  }

  /** Faces that are not drawn, 0 to 5. Reflects the attribute `hidden-faces`. */
  get hiddenFaces(): readonly number[] {
    return sliceOf(scriptSlice, this.#store.state).hiddenFaces
  }

  set hiddenFaces(given: readonly number[] | string | null | undefined) {
    const text = listOf(given)?.map(textOf).join(' ') ?? textOf(given)
    if (text === null) this.removeAttribute('hidden-faces')
    else this.setAttribute('hidden-faces', text)
  }

  /** The id of the preset that the element started from. Null, if set, changes nothing. */
  get preset(): string | null {
    return this.#store.state.preset
  }

  set preset(id: string | null) {
    taking(this, 'preset', () => {
      const preset = readAttribute('preset', textOf(id), viewNames(HexLens.composition))
      if (preset) this.#dispatch({ type: 'set-vertices', vertices: presetVertices(preset), preset: preset.id })
    })
  }

  /**
   * The core’s report on exactly these vertices. Null while the core is loading, or if it could not
   * start.
   */
  get report(): Report | null {
    return this.#analyzer.report(this.#store.state.vertices)
  }

  /** The address that opens these vertices again, bit for bit, in the page `app`; null without one. */
  get permalink(): string | null {
    if (this.#app === null) return null
    const address = new URL(this.#app)
    address.hash = encodePermalink(this.#store.state.vertices)
    return address.href
  }

  /**
   * How far each of its scrolling boxes is scrolled, in CSS pixels. Takes what it gave, to scroll
   * them back; an empty list scrolls to the top.
   */
  get scrollPositions(): readonly number[] {
    return this.#views.scrollers.map(({ scrollTop }) => scrollTop)
  }

  set scrollPositions(given: readonly number[]) {
    taking(this, 'scroll-positions', () => {
      const positions = listOf(given)
      if (!positions?.every(Number.isFinite))
        throw new HexLensError('not-finite', 'The scroll positions are not a list of numbers.')
      for (const [i, scroller] of this.#views.scrollers.entries()) scroller.scrollTop = Number(positions[i] ?? 0)
    })
  }

  /**
   * True when everything in sight is drawn. Views are made when the element is first seen, panels
   * when they are opened.
   */
  get complete(): boolean {
    return this.#frames.isSeen && this.#store.state.phase === 'begun' && this.#frames.isIdle && this.#views.isComplete
  }

  /** Resolved when everything in sight is drawn for the first time; the event is `hex-ready`. */
  get ready(): Promise<void> {
    return this.#readiness.first
  }

  /**
   * Focuses the scene, or without a scene the first control. Before the element is drawn it does so
   * once it is, unless the focus has gone elsewhere since.
   *
   * @param {FocusOptions} [options]
   */
  override focus(options?: FocusOptions): void {
    this.#readiness.focus(options)
  }

  /** Undoes one step of the element. */
  undo(): void {
    this.#dispatch({ type: 'undo' }, 'history')
  }

  /** Redoes one step of the element. */
  redo(): void {
    this.#dispatch({ type: 'redo' }, 'history')
  }

  /** Goes back to where the element started, as the reader’s Reset does: one step to undo. */
  reset(): void {
    this.#dispatch({ type: 'reset' }, 'history')
  }

  /** Shows the whole element, along the same line of sight. Before the scene is drawn it does nothing. */
  fit(): void {
    if (this.#looking.camera) this.#lookFrom({ ...DEFAULT_VIEW, direction: this.camera.direction })
  }

  /**
   * Moves the camera there, in 0.4 seconds or in others, or at once where the reader wants no
   * motion. Ends where it is if the reader takes the element in hand, if something else turns it, or
   * by `signal`. Resolves to whether it has arrived; rejects with HexLensError.
   *
   * @param {{ direction: number[], zoom?: number, pan?: number[] }} camera
   * @param {number} seconds
   * @param {{ signal?: AbortSignal }} options
   */
  async moveCamera(camera: CameraGoal, seconds = 0.4, options: MotionOptions = {}): Promise<boolean> {
    const to = readCameraView(camera)
    const length = readSeconds(seconds)
    const from = this.camera
    let asked = this.#store.state.cameras
    return this.#turning.play(length, options, share => {
      if (!this.isConnected || this.#store.state.cameras !== asked) return false
      this.#lookFrom(cameraBetween(from, to, share))
      asked = this.#store.state.cameras
      return true
    })
  }

  /**
   * Moves the vertices straight to others, given as for `vertices`, in 2 seconds or in others, or at
   * once where the reader wants no motion: one step to undo. Ends where it is as `moveCamera` does.
   * Resolves to whether it has arrived; rejects with HexLensError.
   *
   * @param {GivenVertices} to
   * @param {number} seconds
   * @param {{ signal?: AbortSignal }} options
   */
  async playMorph(to: GivenVertices, seconds = 2, options: MotionOptions = {}): Promise<boolean> {
    const end = checkedVertices(to)
    const length = readSeconds(seconds)
    const from = this.#store.state.vertices
    this.#dispatch({ type: 'begin-gesture' })
    let placed = this.#store.state.vertices
    return this.#morphing.play(
      length,
      options,
      share => {
        const { vertices, gestureStart } = this.#store.state
        if (!this.isConnected || vertices !== placed || gestureStart === null) return false
        this.#dispatch({ type: 'move-all', vertices: elementAt(from, end, share) })
        placed = this.#store.state.vertices
        return true
      },
      () => this.#dispatch({ type: 'commit-gesture' }),
    )
  }

  /**
   * Marks parts of the element, in the scene and in the face maps: `vertices`, `edges` and `faces`
   * by their numbers, `point` in reference coordinates. They stay marked until the next call; without
   * an argument nothing is. No part of the history, and not read out: the page says what they are.
   * What is not understood is told by `hex-error`.
   *
   * @param {{ vertices?: number[], edges?: number[], faces?: number[], point?: number[] }} parts
   */
  highlight(parts: HighlightedParts | null = null): void {
    taking(this, 'highlight', () => this.#dispatch(sliceChange(scriptSlice, { highlights: readHighlights(parts) })))
  }

  /**
   * Draws other hexahedra around the element as thin lines, such as its neighbours in a mesh, those
   * with `isInvalid` in the colour of negative jacdet; and marks vertices as `fixed`, by their
   * numbers. Fixed are they by the page: it sets `vertices` back in the listener of `hex-input`. All
   * stay until the next call; without an argument there is nothing. No part of the history. What is
   * not understood is told by `hex-error`.
   *
   * @param {{ hexahedra?: { vertices: number[], isInvalid?: boolean }[], fixed?: number[] }} parts
   */
  surround(parts: SurroundingParts | null = null): void {
    taking(this, 'surround', () => this.#dispatch(sliceChange(surroundingsSlice, readSurroundings(parts))))
  }

  /**
   * Marks a place of a vertex, such as a better one: a dashed handle there, with a line to it, and
   * points with their labels, the larger the more they weigh. `null` takes them away, and so does a
   * change of the vertices. No part of the history. What is not understood is told by `hex-error`.
   *
   * @param {{ vertex: number, position?: [number, number, number] | null, points?: { position: [number, number, number], point?: [number, number, number] | null, label: string, weight?: number | null }[] } | null} parts
   */
  markPlace(parts: PlaceParts | null): void {
    taking(this, 'place', () => this.#dispatch(sliceChange(placeSlice, { place: readPlace(parts) })))
  }

  /** The core’s report on any 24 numbers, or on the element’s own. Rejects with HexLensError. */
  async analyze(given: GivenVertices = this.#store.state.vertices): Promise<Report> {
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

  /**
   * The scene as it is, at the size that it has on the page, in view or not. The file contains the
   * vertices: dropped on the page, it opens them again. Rejects with HexLensError; its code is
   * `no-picture` if the element is not on the page, has no scene, or is not displayed.
   */
  async toPNG(): Promise<Blob> {
    const [{ figurePng }, figure] = await Promise.all([import('../views/figure-files'), this.#figure('scene')])
    return figurePng(figure, this.#store.state.vertices)
  }

  /**
   * The scene, or the face maps while their panel is open, as a document of its own. Rejects as
   * `toPNG()` does.
   *
   * @param {'scene' | 'face-maps'} name
   */
  async toSVG(name: FigureName = 'scene'): Promise<string> {
    const [{ figureSvg }, figure] = await Promise.all([import('../views/figure-files'), this.#figure(name)])
    return figureSvg(figure, this.#store.state.vertices, this.label ?? this.preset ?? say('Hexahedron'))
  }

  /**
   * Turns the scene to where the minimum is seen from outside, in less than a second or, where the
   * reader wants no motion, at once. Faces that hide it from everywhere become see-through. If jacdet
   * is lower inside than on the boundary, the inside is shown, cut at its minimum. Before the scene
   * is drawn it does nothing.
   */
  showMinimum(): void {
    this.#views.showMinimum()
  }

  /**
   * Reads a text, a file, or files that belong together, as if dropped here. One element becomes
   * the element, as one step to undo. Of several the reader chooses one, where `paste` is among the
   * views; `isQuiet` leaves the focus where it is. What cannot be read is told by `hex-error`.
   */
  offer(given: string | File | readonly File[], isQuiet = false): void {
    const input = typeof given === 'string' ? { text: given } : { files: given instanceof File ? [given] : given }
    this.#input.read(input, isQuiet)
  }

  /**
   * Shows a sentence of the page’s own above the element, and tells `hex-error`. A problem of the
   * same code takes its place.
   *
   * @param {{ code: string, message: string }} problem
   */
  raise(problem: Problem): void {
    if (this.#problems.get(problem.code)?.message === problem.message) return
    this.#problems.set(problem.code, problem)
    this.#frames.schedule()
    this.#tell('hex-error', problem)
  }

  /**
   * Takes the problem of that code back.
   *
   * @param {string} code
   */
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

  get #shownPanels(): readonly Panel[] {
    const { isReadonly } = this.#store.state
    return HexLens.composition.panels.filter(
      panel =>
        panel.always ||
        (this.#viewNames.includes(panel.with ?? panel.name) &&
          !(isReadonly && panel.changes) &&
          !(panel.links && this.#app === null)),
    )
  }

  #showPanels(names: readonly string[]): void {
    this.#viewNames = names
    if (!this.isConnected) return
    this.#keepCameras()
    this.#views.begin(this.#shownPanels)
    this.#frames.schedule()
  }

  /** The page's own: while the reader drags a part of the drag, and nothing if it only comes back. */
  #setVertices(vertices: Vertices): void {
    const { phase, vertices: present, gestureStart } = this.#store.state
    const isGesture = gestureStart !== null
    const comesBack = sameBits(vertices, present) || (isGesture && this.#changes.isEcho(vertices))
    if (phase === 'begun' && comesBack) return
    // What moves by itself, as a morph does, ends.
    const isHeld = isGesture && this.#changes.gesture !== 'panel'
    this.#dispatch(
      isHeld ? { type: 'move-all', vertices } : { type: 'set-vertices', vertices, preset: presetOf(vertices) },
    )
  }

  /** In another language: the views are made anew, and attributes that were refused are read again. */
  #sayAnew(): void {
    this.#showPanels(this.#viewNames)
    for (const name of attributeNames) if (this.#problems.has(`bad-${name}`)) this.attributeChangedCallback(name)
  }

  /** The cameras as the reader has turned them, or as they were asked for. */
  get #camerasNow(): Cameras | null {
    return this.#views.cameras() ?? this.#store.state.cameras
  }

  #lookFrom(camera: CameraView | null): void {
    const referenceCamera = this.#camerasNow?.referenceCamera ?? null
    this.#dispatch({ type: 'look', cameras: { camera, referenceCamera } })
  }

  /** Views that are made anew look the same way. */
  #keepCameras(): void {
    this.#dispatch({ type: 'look', cameras: this.#camerasNow })
  }

  /** The first frame waits for the core. The action is the reader's if `source` is null. */
  #dispatch(action: Action, source: ChangeSource | null = 'program'): void {
    const before = this.#store.state
    this.#store.dispatch(action)
    const after = this.#store.state
    if (after === before) return
    this.#changes.note(before, after, action, source)
    if (before.phase === 'begun') this.#frames.schedule()
  }

  #dispatchOfReader(action: Action): void {
    if (!(this.#store.state.isReadonly && CHANGES.has(action.type))) this.#dispatch(action, null)
  }

  /** The core comes before the first frame, unless it is slow to come. */
  async #start(): Promise<void> {
    const slow = setTimeout(() => this.#frames.schedule(), PATIENCE_MS)
    try {
      this.#analyzer.core = await fetchCore(HexLens.composition.core)
      this.clear('core-failed')
      if (this.isConnected) this.#tellChanges()
      this.#frames.schedule()
    } catch (reason) {
      const why = reason instanceof Error ? reason.message : String(reason)
      this.#language.speak()
      this.raise({
        code: 'core-failed',
        message: say(
          'The WebAssembly core did not start, so there is no verdict ({why}). The vertices and the link still work; reload the page to try again.',
          { why },
        ),
      })
    } finally {
      clearTimeout(slow)
    }
  }

  #onFrame({ time, isNews, isSeen, isForPaper }: DueFrame) {
    this.#tellChanges()
    const { state } = this.#store
    if (!isSeen) {
      this.#sharing.tell(time)
      return { isWaiting: false, isUnmade: false }
    }
    this.#language.speak()
    const frame: Frame = {
      state,
      ...this.#analyzer.analyze(state),
      reading: this.#input.reading,
      problems: [...this.#problems.values()],
      isForPaper,
    }
    this.#views.draw(frame, isNews, time)
    this.#looking.tell(() => this.#views.cameras() && this.camera, frame.probe)
    this.#sharing.tell(time)
    if (this.complete && !this.#views.isWaiting) this.#readiness.drawn()
    return this.#views
  }

  #tellChanges(): void {
    this.#store.dispatch({ type: 'begin' })
    const { report } = this
    this.#readiness.judged(report?.valid ?? null)
    this.#changes.tell(this.#store.state, report)
  }

  #figure(name: FigureName): Promise<Figure> {
    return this.#frames.whileDrawn(async () => {
      await fetchCore(HexLens.composition.core).catch(() => {}) // without it there are lines, and they are drawn
      const isDisplayed = () => {
        const { width, height } = this.getBoundingClientRect()
        return width > 0 && height > 0
      }
      while (isDisplayed() && !this.complete) await new Promise(requestAnimationFrame)
      if (!isDisplayed()) throw new HexLensError('no-picture', 'The element is not displayed, so there is no picture.')
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
