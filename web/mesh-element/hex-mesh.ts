/**
 * `<hex-mesh>`: a mesh in a page of documentation, with its sentence, its picture and its cells, worst first. The mesh is in a worker
 * from when the element is first seen until it is removed. `npm run reference` writes docs/mesh-element.md from the comments of the
 * class and of its public members.
 */
import { sentenceOf } from '../core/workers'
import { taking } from '../element/attributes'
import type { TellingElement } from '../element/events'
import { OwnLanguage } from '../element/own-language'
import { Readiness } from '../element/readiness'
import { reflectAttributes } from '../element/reflecting-element'
import type { ReadingWorker } from '../input/input-reader'
import type { PastedInput } from '../input/pasted-input'
import type { LookingJobs } from '../survey/looking-jobs'
import { OpenSurvey } from '../survey/open-survey'
import type { Arrangement, CellDetail, Overview, Place } from '../survey/survey-jobs'
import type { Problem } from '../views/view'
import { say } from '../words/say'
import type { HexMeshEventMap, MeshSummary, PickedCell } from './events'
import { fetchedFile } from './fetched-file'
import { inputOf, MESH_ATTRIBUTES, type MeshAttribute, readMode, readTheme } from './mesh-attributes'
import { MeshView, type ShownMesh } from './mesh-view'
import { MeshProblem } from './problem'

/** A server has no elements; it only has to be able to import this. */
const Base = (globalThis.HTMLElement ?? class {}) as unknown as {
  new (): TellingElement<HexMeshEventMap>
  prototype: TellingElement<HexMeshEventMap>
}

/** What is to be opened, and who waits for it. */
interface Source {
  readonly given: PastedInput | { readonly src: string }
  readonly resolve: (summary: MeshSummary | null) => void
}

/** A worker from beside the script knows these jobs. */
type LookedAt = Pick<OpenSurvey, Exclude<keyof LookingJobs, 'accept'> | 'close'>

type MeshProblemCode = MeshProblem['code'] | 'no-webgl' | `bad-${string}`

const FIRST_ORDER: Arrangement = { column: 'worst', isDescending: false }
const NOTHING: ShownMesh = {
  overview: null,
  progress: null,
  problems: [],
  mode: 'surface',
  row: null,
  pointed: null,
  left: '',
  isDrawn: true,
  label: null,
}

/** Browsers end a page's oldest contexts when there are more than sixteen, and others on the page want some, too. */
const MOST_PICTURES = 8
const pictured = new Set<HexMesh>()

/**
 * @summary A mesh of hexahedra: how many are invalid, where, and which, worst first.
 * @tag hex-mesh
 *
 * @attr {an address} [src=none] - The file of the mesh, from the page’s own address: whatever
 *   `hexlens check` reads. It is fetched when the element is first seen.
 * @attr {`surface`, `invalid` or `neighbours`} [mode=surface] - The cells in the picture: all, seen
 *   from outside, with invalid ones shining through; the invalid ones alone; or these with the cells
 *   that share a point with them. The reader’s choice is written back.
 * @attr {`auto`, `light` or `dark`} [theme=auto] - `auto` is the `color-scheme` of the page where the
 *   element stands.
 * @attr {a text} [label=none] - The name of the whole for screen readers.
 *
 * @slot - Shown until a mesh is open, and where none ever is: without JavaScript, for one.
 *
 * @cssState ready - Everything has been drawn.
 * @cssState valid - All cells are; neither this nor the next while there is no mesh.
 * @cssState invalid - A cell is.
 *
 * @csspart mesh - The whole element.
 * @csspart overview - The sentence, and what the reader of the file says.
 * @csspart picture - The picture.
 * @csspart list - The cells.
 * @csspart fallback - The box of the content between the tags.
 *
 * @cssprop [--hl-rem=16px] - The unit for the sizes of text, whatever the page’s own text size is.
 * @cssprop [--hl-paper=#fcfcfb, dark #17181a] - The background.
 * @cssprop [--hl-ink=#1c1e21, dark #e9e9e6] - Text and lines.
 * @cssprop [--hl-muted=#6a6f76, dark #9a9fa6] - Text of less weight.
 * @cssprop [--hl-line=#e4e5e3, dark #303336] - Hairlines.
 * @cssprop [--hl-negative=#b2182b, dark #f4787a] - The hue of invalid cells.
 * @cssprop [--hl-positive=#2166ac, dark #74b3f0] - The hue of relative minimum 1.
 * @cssprop [--hl-neutral=#eeeeeb, dark #373a3f] - The colour of zero.
 */
export class HexMesh extends Base {
  static readonly observedAttributes: readonly MeshAttribute[] = MESH_ATTRIBUTES
  /** `defineMesh` sets it once, before an element is made. */
  static worker: ReadingWorker

  /** Reflects the attribute, as do the next three. */
  declare src: string | null
  declare mode: string | null
  declare theme: string | null
  declare label: string | null

  readonly #view: MeshView
  readonly #language: OwnLanguage
  readonly #readiness = new Readiness(this, () => this.#tell('hex-ready', null))
  readonly #problems = new Map<MeshProblemCode, string>()
  #shown = NOTHING
  #survey: LookedAt | null = null
  /** What is to be opened once the element is seen, or anew when it comes back. */
  #source: Source | null = null
  #isDue = false
  #loading: AbortController | null = null
  #visibility: IntersectionObserver | null = null
  #isSeen = false
  #rank: number | null = null
  #chosen: CellDetail | null = null
  #asked = 0

  constructor() {
    super()
    const shadow = this.attachShadow({ mode: 'open' })
    this.#view = new MeshView(shadow, {
      speak: () => this.#language.speak(),
      rows: (from, to) => this.#asking(survey => survey.rows(from, to), []),
      arrange: order => void this.#arrange(order),
      choose: (cell: number, rank?: number) => void this.#choose(cell, rank),
      faces: shown => this.#survey?.faces(shown) ?? Promise.reject(new Error(CLOSED)),
      goToNext: step => void this.#goToNext(step),
      point: cell => void this.#point(cell),
      setMode: mode => {
        this.mode = mode
      },
    })
    this.#language = new OwnLanguage(this, this.#view.lens, () => this.#set({}))
  }

  connectedCallback(): void {
    this.#language.start()
    for (const name of MESH_ATTRIBUTES) this.#adopt(name)
    this.#view.begin()
    this.#isDue = this.#source !== null
    this.#visibility = new IntersectionObserver(entries => this.#see(entries.at(-1)?.isIntersecting ?? false))
    this.#visibility.observe(this)
    this.#set({})
  }

  disconnectedCallback(): void {
    this.#language.stop()
    this.#visibility?.disconnect()
    this.#isSeen = false
    this.#loading?.abort()
    this.#source?.resolve(null)
    this.#survey?.close()
    this.#survey = null
    pictured.delete(this)
    this.#view.end()
    this.#forget()
    this.#readiness.end()
    this.#set({ ...NOTHING, mode: this.#shown.mode, label: this.#shown.label })
  }

  attributeChangedCallback(name: MeshAttribute): void {
    this.#language.during(() => {
      if (name === 'src') this.#setSource()
      else if (name === 'label') this.#set({ label: this.label })
      else if (name === 'theme') taking(this.#taker, name, () => void readTheme(this.theme))
      else
        taking(this.#taker, name, () => {
          const mode = readMode(this.mode)
          if (mode === this.#shown.mode) return
          this.#set({ mode })
          void this.#draw()
        })
    })
  }

  /** The open mesh in numbers; null while none is open. */
  get summary(): MeshSummary | null {
    const { overview } = this.#shown
    return overview && summaryOf(overview)
  }

  /** The chosen cell; null while none is chosen. */
  get picked(): PickedCell | null {
    return this.#chosen && pickedOf(this.#chosen)
  }

  /** Resolved when a mesh is open and drawn for the first time; the event is `hex-ready`. */
  get ready(): Promise<void> {
    return this.#readiness.first
  }

  /**
   * Opens a text, a file, or files that belong together, instead of `src`, as soon as the element is
   * seen. Resolves to what `summary` is then; to null if it cannot be read, of which `hex-error`
   * tells, if something else is opened meanwhile, or if the element is removed. A mesh that was open
   * stays if the next cannot be read.
   *
   * @param {string | File | File[]} given
   */
  open(given: string | File | readonly File[]): Promise<MeshSummary | null> {
    const input = inputOf(given)
    if (input) {
      this.#clear('bad-open')
      return this.#take(input)
    }
    this.#raise('bad-open', () => say('Neither a text nor files were given to be opened.'))
    return Promise.resolve(null)
  }

  /**
   * Chooses a cell by its index, from 0 in the order of the file, and looks at it; null chooses none.
   * Resolves to the cell; to null if there is none of that index, of which `hex-error` tells.
   *
   * @param {number | null} cell
   */
  async pick(cell: number | null): Promise<PickedCell | null> {
    const { overview } = this.#shown
    if (cell === null) {
      this.#forget()
      this.#view.choose(null, null)
      this.#set({ row: null })
      return null
    }
    if (!Number.isInteger(cell) || cell < 0 || cell >= (overview?.hexahedra ?? 0)) {
      this.#raise('bad-pick', () => say('There is no cell {cell}.', { cell: String(cell) }))
      return null
    }
    this.#clear('bad-pick')
    const detail = await this.#show(cell)
    if (detail?.vertices) this.#view.stage.flyTo(detail.vertices)
    return detail && pickedOf(detail)
  }

  /** Shows the whole mesh, along the same line of sight. */
  fit(): void {
    this.#view.stage.fit()
  }

  /**
   * Focuses the picture, or without WebGL the first control. Before the mesh is drawn it does so once
   * it is, unless the focus has gone elsewhere since.
   *
   * @param {FocusOptions} [options]
   */
  override focus(options?: FocusOptions): void {
    this.#readiness.focus(options)
  }

  get #taker() {
    return {
      raise: ({ code, message }: Problem) => this.#raise(code as MeshProblemCode, () => message),
      clear: (code: Problem['code']) => this.#clear(code as MeshProblemCode),
    }
  }

  /** A property set before the class was there hides the class's own. */
  #adopt(name: MeshAttribute): void {
    const early = Object.getOwnPropertyDescriptor(this, name)
    if (early === undefined) return
    Reflect.deleteProperty(this, name)
    Reflect.set(this, name, early.value)
  }

  #setSource(): void {
    const { src } = this
    if (src !== null) void this.#take({ src })
    else if (this.#source && 'src' in this.#source.given && this.#isDue) this.#source = null
  }

  #take(given: Source['given']): Promise<MeshSummary | null> {
    this.#loading?.abort()
    this.#source?.resolve(null)
    return new Promise(resolve => {
      this.#source = { given, resolve }
      this.#isDue = true
      this.#begin()
    })
  }

  #see(isSeen: boolean): void {
    this.#isSeen = isSeen
    if (!isSeen) return
    this.#begin()
    if (this.#shown.overview && !this.#view.stage.hasPicture) this.#beginPicture()
  }

  #begin(): void {
    if (!this.#isDue || !this.#isSeen || !this.#source) return
    this.#isDue = false
    void this.#load(this.#source)
  }

  async #load({ given, resolve }: Source): Promise<void> {
    const loading = new AbortController()
    const { signal } = loading
    this.#loading = loading
    for (const code of ['not-fetched', 'too-large', 'not-read'] as const) this.#problems.delete(code)
    const name = 'src' in given ? given.src : 'text' in given ? 'the text' : (given.files[0]?.name ?? '')
    const onProgress = (step: NonNullable<ShownMesh['progress']>['step'], fraction: number) =>
      signal.aborted || this.#set({ progress: { step, name, fraction } })
    onProgress('src' in given ? 'fetching' : 'reading', 0)
    try {
      const { survey, overview } = await this.#opened(given, signal, onProgress)
      this.#survey?.close()
      this.#survey = survey
      this.#open(overview)
      resolve(summaryOf(overview))
      await this.#picture()
    } catch (reason) {
      if (signal.aborted) return
      this.#set({ progress: null })
      if (reason instanceof MeshProblem) this.#raise(reason.code, reason.sentence)
      else this.#raise('not-read', () => sentenceOf(reason))
      resolve(null)
    }
  }

  /** Rejects if the signal aborts, which ends the worker. */
  async #opened(
    given: Source['given'],
    signal: AbortSignal,
    onProgress: (step: NonNullable<ShownMesh['progress']>['step'], fraction: number) => void,
  ): Promise<{ readonly survey: LookedAt; readonly overview: Overview }> {
    const fetching = { signal, onProgress: (fraction: number) => onProgress('fetching', fraction) }
    const input = 'src' in given ? { files: [await fetchedFile(given.src, fetching)] } : given
    const spawn = await HexMesh.worker().catch(reason => () => {
      throw reason
    })
    signal.throwIfAborted()
    const survey: LookedAt = new OpenSurvey(spawn)
    const end = () => survey.close()
    signal.addEventListener('abort', end)
    const opening = await survey.open(input, ({ step, fraction }) => onProgress(step, fraction))
    signal.removeEventListener('abort', end)
    signal.throwIfAborted()
    if ('opened' in opening) return { survey, overview: opening.opened }
    survey.close()
    const { refused } = opening
    throw new MeshProblem('not-read', () => refused)
  }

  /** The sentence and the list are there before the picture. */
  #open(overview: Overview): void {
    this.#forget()
    this.#view.stage.open(overview)
    this.#set({ overview, progress: null, row: null, pointed: null, left: '' })
    this.#view.list(overview, FIRST_ORDER)
    this.#view.choose(null, 0)
    const { invalid, unanswered } = overview.counts
    this.#readiness.judged(invalid > 0 ? false : unanswered > 0 ? null : true)
    this.#tell('hex-open', summaryOf(overview))
  }

  async #picture(): Promise<void> {
    const survey = this.#survey
    if (this.#beginPicture()) {
      await survey?.join(() => {})
      await this.#draw()
    }
    if (survey !== null && survey === this.#survey)
      requestAnimationFrame(() => this.isConnected && this.#readiness.drawn())
  }

  /** Makes the picture, and has others that are out of sight give up theirs. Returns whether there is WebGL. */
  #beginPicture(): boolean {
    for (const other of pictured) {
      if (pictured.size < MOST_PICTURES) break
      if (!other.#isSeen && other !== this) other.#rest()
    }
    const isDrawn = this.#view.stage.begin()
    if (isDrawn) pictured.add(this)
    this.#set({ isDrawn })
    if (!isDrawn)
      this.#raise('no-webgl', () =>
        say('This browser gives no WebGL2, so there is no picture. The list has every cell.'),
      )
    return isDrawn
  }

  #rest(): void {
    this.#view.stage.rest()
    pictured.delete(this)
  }

  async #draw(): Promise<void> {
    const { overview, mode } = this.#shown
    if (!overview || !this.#survey || !this.#shown.isDrawn) return
    const left = await this.#view.stage.show(mode, overview).catch(this.#failed)
    if (typeof left === 'string') this.#set({ left })
  }

  async #arrange(order: Arrangement): Promise<void> {
    const isArranged = await this.#asking(survey => survey.arrange(order), false)
    if (isArranged && this.#shown.overview) this.#view.list(this.#shown.overview, order)
  }

  async #choose(cell: number, rank?: number): Promise<void> {
    const detail = await this.#show(cell, rank)
    if (detail) this.#tell('hex-pick', pickedOf(detail))
  }

  /** Chooses a cell; resolves to null if another one has been chosen meanwhile. */
  async #show(cell: number, rank?: number): Promise<CellDetail | null> {
    const asked = ++this.#asked
    const none: Place = { cell, rank: null }
    const place = rank === undefined ? await this.#asking(survey => survey.placeOf(cell), none) : { cell, rank }
    const detail = await this.#asking(survey => survey.detail(cell), null)
    if (detail === null || asked !== this.#asked) return null
    this.#rank = place.rank
    this.#chosen = detail
    this.#view.choose(cell, place.rank)
    this.#view.stage.choose(detail)
    this.#set({ row: detail.row })
    return detail
  }

  #forget(): void {
    this.#asked++
    this.#rank = null
    this.#chosen = null
    this.#view.stage.choose(null)
  }

  async #goToNext(step: 1 | -1): Promise<void> {
    const from = this.#rank ?? (step > 0 ? -1 : 0)
    const place = await this.#asking(survey => survey.nextInvalid(from, step), null)
    if (!place) return
    await this.#choose(place.cell, place.rank ?? undefined)
    if (this.#chosen?.row.cell === place.cell && this.#chosen.vertices) this.#view.stage.flyTo(this.#chosen.vertices)
  }

  async #point(cell: number | null): Promise<void> {
    if (cell === null) {
      if (this.#shown.pointed) this.#set({ pointed: null })
    } else if (cell !== this.#shown.pointed?.cell) {
      const detail = await this.#asking(survey => survey.detail(cell), null)
      this.#set({ pointed: detail?.row ?? null })
    }
  }

  /** Asks the worker; if it has ended, a sentence says so and the answer is `otherwise`. */
  #asking<T>(ask: (survey: LookedAt) => Promise<T>, otherwise: T): Promise<T> {
    const survey = this.#survey
    if (!survey) return Promise.resolve(otherwise)
    return ask(survey).catch(reason => {
      if (survey === this.#survey) this.#failed(reason)
      return otherwise
    })
  }

  /** What a mesh that was closed has not answered is no news. */
  readonly #failed = (reason: unknown): null => {
    if (this.#survey) this.#raise('not-read', () => sentenceOf(reason))
    return null
  }

  #raise(code: MeshProblemCode, words: () => string): void {
    let message = ''
    this.#language.during(() => {
      message = words()
    })
    if (this.#problems.get(code) === message) return
    this.#problems.set(code, message)
    this.#set({})
    this.#tell('hex-error', { code, message })
  }

  #clear(code: MeshProblemCode): void {
    if (this.#problems.delete(code)) this.#set({})
  }

  #set(change: Partial<ShownMesh>): void {
    const problems = [...this.#problems].map(([code, message]): Problem => ({ code: code as Problem['code'], message }))
    this.#shown = { ...this.#shown, ...change, problems }
    this.#language.during(() => this.#view.show(this.#shown))
  }

  #tell<Name extends keyof HexMeshEventMap>(name: Name, detail: HexMeshEventMap[Name]['detail']): void {
    this.dispatchEvent(new CustomEvent(name, { bubbles: true, composed: true, detail }))
  }
}

const CLOSED = 'The mesh was closed.'

function summaryOf({ name, format, hexahedra, counts: { valid, invalid, unanswered } }: Overview): MeshSummary {
  return { name, format, hexahedra, valid, invalid, unanswered }
}

function pickedOf({ row: { cell, id, standing, relativeMinimum }, vertices }: CellDetail): PickedCell {
  return {
    cell,
    id,
    vertices: vertices && [...vertices],
    valid: standing === 'unanswered' ? null : standing !== 'invalid',
    relativeMinimum: Number.isNaN(relativeMinimum) ? null : relativeMinimum,
  }
}

reflectAttributes(HexMesh.prototype, MESH_ATTRIBUTES)

declare global {
  interface HTMLElementTagNameMap {
    'hex-mesh': HexMesh
  }
}
