/** The picture and what chooses the cells in it: a set of cells, the slice, the threshold, and what is peeled and dug away. */
import { nothing, render } from 'lit-html'
import { wordsOf } from '../../core/workers'
import { CellPointer } from '../../mesh-scene/cell-pointer'
import { drawGhostLines } from '../../mesh-scene/ghost-lines'
import { TRANSLUCENT } from '../../mesh-scene/loaded-faces'
import { MeshPicture, type PictureSpace } from '../../mesh-scene/mesh-picture'
import { drawMarks, MARKS_HEIGHT } from '../../mesh-scene/picture-marks'
import { type Plane, PlaneHandle } from '../../mesh-scene/plane-handle'
import type { Vec3, Vertices } from '../../model/hexahedron'
import type { CameraView } from '../../model/state'
import { azimuthOf, directionAt, elevationOf } from '../../scene/space/camera'
import type { CutCells, CutFaces, FaceList, Neighbour, Overview, Row } from '../../survey/survey-jobs'
import { type BarHost, type BarState, barTemplate } from './picture-bar'
import {
  cutOf,
  FIRST_SETTINGS,
  invalidCutOf,
  type PictureSettings,
  planeOf,
  roundedNormal,
  type Slice,
  sliceAt,
  unitOf,
} from './picture-settings'
import { isTyping } from './typing'

export interface PictureHost {
  /** The boundary of the mesh. */
  boundary(): Promise<FaceList>
  cut(cells: CutCells): Promise<CutFaces>
  choose(cell: number): void
  /** The cell as the list has it; null if no mesh is open. */
  name(cell: number): Promise<Row | null>
  /** The settings or the camera may have changed. */
  changed(): void
  /** All settings as a text. */
  settingsText(): string
  copySettings(): void
  takeSettings(text: string): void
}

const SHRUNK = 0.8
/** A key's part of the way through the mesh, and its turn of the slice. */
const SLIDE_STEP = 0.02
const TURN_STEP = Math.PI / 36
const FIRST_SLICE: Slice = { normal: [1, 0, 0], place: 0.5 }
const LEAST_THRESHOLD = 0.2

export class PictureControls implements BarHost {
  readonly #host: PictureHost
  readonly #picture: MeshPicture
  readonly #plane: PlaneHandle
  readonly #marks = document.createElement('canvas')
  readonly #bar = document.createElement('div')
  readonly #tip = document.createElement('p')
  /** The size, view and colours of the marks as they are drawn. */
  #marked: readonly unknown[] = []
  #ghostLines: Float64Array | null = null
  #overview: Overview | null = null
  #settings = FIRST_SETTINGS
  #before: BarState['before'] = { slice: FIRST_SLICE, relative: [-Infinity, LEAST_THRESHOLD] }
  #isDigging = false
  #isTravelOpen = false
  #complaint: BarState['complaint'] = null
  #notice = ''
  #joining = ''
  #chosen: { readonly cell: number; readonly vertices: Vertices | null } | null = null
  #faces: CutFaces | null = null
  #invalid: { readonly key: string; readonly faces: CutFaces } | null = null
  #boundary: FaceList | null = null
  /** Counts meshes and their steps, and what is asked of them. */
  #mesh = 0
  #wanted = 0
  #asking: Promise<void> | null = null
  /** Counts what was pointed at. */
  #pointed = 0

  constructor(root: HTMLElement, host: PictureHost) {
    this.#host = host
    const canvas = document.createElement('div')
    canvas.className = 'canvas'
    canvas.tabIndex = 0
    canvas.setAttribute('role', 'application')
    canvas.setAttribute('aria-label', KEYS)
    this.#bar.className = 'bar'
    this.#tip.className = 'tip'
    root.append(canvas, this.#tip, this.#bar)
    this.#picture = new MeshPicture(canvas)
    this.#plane = new PlaneHandle({ move: plane => this.#movePlane(plane), rayOf: event => this.#picture.rayOf(event) })
    this.#picture.top = MARKS_HEIGHT
    this.#picture.onDraw = space => this.#drawOver(space)
    canvas.append(this.#marks, this.#plane.root)
    this.#listen(canvas)
    if (!this.#picture.isDrawn) root.classList.add('is-not-drawn')
  }

  get settings(): PictureSettings {
    return this.#settings
  }

  /** Null is the default view. */
  get camera(): CameraView | null {
    return this.#picture.view
  }

  /** Another mesh. */
  open(overview: Overview, settings = FIRST_SETTINGS, camera: CameraView | null = null): void {
    this.#overview = overview
    this.#settings = settings
    const [, upper] = settings.relative ?? firstThreshold(overview)
    this.#before = { slice: settings.slice ?? FIRST_SLICE, relative: settings.relative ?? [-Infinity, upper] }
    this.#isDigging = false
    this.#complaint = null
    this.#notice = ''
    this.#joining = ''
    this.#chosen = null
    this.#faces = null
    this.#invalid = null
    this.#ghostLines = null
    this.#boundary = null
    this.#mesh++
    this.#wanted++
    this.#picture.open(overview.bounds, camera)
    this.#picture.colouring = settings.colours
    this.#put()
  }

  /** Another step of the mesh, seen as the one before was. */
  step(overview: Overview): void {
    this.#overview = overview
    this.#invalid = null
    this.#boundary = null
    this.#mesh++
    this.#picture.step(overview.bounds)
    this.#put()
  }

  /** Other settings of the same mesh. */
  use(settings: PictureSettings, camera: CameraView | null): void {
    this.#picture.look(camera)
    this.set(settings)
  }

  say(notice: string): void {
    this.#notice = notice
    this.#render()
  }

  /** How much of the mesh's surface has been found, from 0 to 1. */
  joining(part: number): void {
    this.#joining = part < 1 ? `Finding the surface: ${Math.floor(100 * part)} %` : ''
    this.#render()
  }

  /** Draws the cells of the present settings. While they are asked for others may be wanted: these come next. */
  show(): Promise<void> {
    this.#wanted++
    this.#asking ??= this.#ask().finally(() => {
      this.#asking = null
    })
    return this.#asking
  }

  /** After another selection. */
  async refresh(): Promise<void> {
    this.#invalid = null
    if (this.#settings.set === 'listed' && this.#faces) await this.show()
  }

  choose(cell: number | null, vertices: Vertices | null, neighbours: readonly Neighbour[]): void {
    const isOther = this.#chosen?.cell !== cell
    this.#chosen = cell === null ? null : { cell, vertices }
    this.#picture.choose(vertices, neighbours)
    this.#render()
    if (isOther && this.#settings.set === 'around' && this.#faces) void this.show()
  }

  /** Two points a line, six numbers: edges as they would be. Null for none. */
  set ghostLines(ends: Float64Array | null) {
    this.#ghostLines = ends
    this.#picture.draw()
  }

  /** Null where there is no WebGL. */
  toPNG(): Promise<Blob> | null {
    const { colours } = this.#settings
    return this.#picture.isDrawn ? this.#picture.toPNG((context, space) => drawMarks(context, space, colours)) : null
  }

  readonly flyToChosen = (): void => {
    if (this.#chosen?.vertices) this.#picture.flyTo(this.#chosen.vertices)
  }

  readonly fit = (): void => this.#picture.fit()

  set(settings: Partial<PictureSettings>): void {
    this.#notice = ''
    this.#settings = { ...this.#settings, ...settings }
    const { slice, relative, colours } = this.#settings
    this.#before = { slice: slice ?? this.#before.slice, relative: relative ?? this.#before.relative }
    this.#picture.colouring = colours
    this.#put()
    void this.show()
  }

  readonly digging = (isDigging: boolean): void => {
    this.#isDigging = isDigging
    this.#put()
  }

  readonly digChosen = (): void => {
    if (this.#chosen) this.#dig(this.#chosen.cell)
  }

  readonly undoDig = (): void => this.set({ away: this.#settings.away.slice(0, -1) })

  readonly travelling = (isOpen: boolean): void => {
    this.#isTravelOpen = isOpen
    this.#render()
  }

  readonly copySettings = (): void => this.#host.copySettings()

  takeSettings(text: string): void {
    this.#host.takeSettings(text)
  }

  complain(complaint: BarState['complaint']): void {
    this.#complaint = complaint
    this.#render()
  }

  direction(): Vec3 {
    return this.#picture.direction
  }

  /** The address has the settings as they are. */
  travelled(): void {
    if (this.#isTravelOpen) this.#render()
  }

  async #ask(): Promise<void> {
    for (let asked = 0; asked !== this.#wanted; ) {
      asked = this.#wanted
      const mesh = this.#mesh
      try {
        await this.#askFor(mesh)
      } catch (reason) {
        if (mesh === this.#mesh && this.#overview) this.say(`The picture could not be drawn: ${wordsOf(reason)}`)
      }
    }
  }

  async #askFor(mesh: number): Promise<void> {
    const overview = this.#overview
    if (!overview) return
    const settings = this.#settings
    const plane = this.#planeOf(settings.slice)
    const chosen = this.#chosen?.cell ?? null
    this.#boundary ??= await this.#host.boundary()
    if (mesh !== this.#mesh) return
    const faces = await this.#host.cut(cutOf(settings, plane, chosen))
    if (mesh !== this.#mesh) return
    const invalidCut = overview.counts.invalid > 0 ? invalidCutOf(settings, chosen) : null
    const key = JSON.stringify(invalidCut)
    if (!invalidCut) this.#invalid = null
    else if (this.#invalid?.key !== key) {
      const invalid = await this.#host.cut(invalidCut)
      if (mesh !== this.#mesh) return
      this.#invalid = { key, faces: invalid }
    }
    this.#faces = faces
    const invalid = this.#invalid?.faces ?? null
    this.#picture.show({
      boundary: this.#boundary,
      hidden: faces.hidden,
      surface: faces,
      invalid,
      opacity: invalid !== null && invalid.cells.length > 0 ? TRANSLUCENT : 1,
      size: settings.isApart ? SHRUNK : 1,
      hasGhost: isCut(settings),
    })
    this.#render()
  }

  #planeOf(slice: Slice | null): Plane | null {
    const bounds = this.#overview?.bounds ?? null
    return slice && planeOf(slice, this.#picture.middleOf(bounds), bounds)
  }

  #movePlane({ normal, offset }: Plane): void {
    const bounds = this.#overview?.bounds ?? null
    const turned = roundedNormal(normal)
    this.set({ slice: sliceAt({ normal: turned, offset }, this.#picture.middleOf(bounds), bounds) })
  }

  #dig(cell: number): void {
    const { away } = this.#settings
    if (!away.includes(cell)) this.set({ away: [...away, cell] })
  }

  #put(): void {
    this.#plane.plane = this.#planeOf(this.#settings.slice)
    this.#render()
    this.#host.changed()
  }

  #drawOver(space: PictureSpace): void {
    this.#drawMarks(space)
    this.#plane.draw(space)
    this.#host.changed()
  }

  /** While a slice slides, the marks stay as they are. */
  #drawMarks(space: PictureSpace): void {
    const { camera, theme, ramp, share } = space
    const { width, height } = camera
    const ratio = Math.min(devicePixelRatio, 2)
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)]
    const colours = this.#overview && this.#settings.colours
    const marked = [wide, high, ...camera.axes().flat(), theme, ramp, share, colours, this.#ghostLines]
    const isSame = marked.every((value, i) => value === this.#marked[i])
    if (isSame && !this.#ghostLines) return
    this.#marked = marked
    // A size that is set makes the memory anew, also if it is the same.
    if (this.#marks.width !== wide) this.#marks.width = wide
    if (this.#marks.height !== high) this.#marks.height = high
    const context = this.#marks.getContext('2d')
    context?.setTransform(ratio, 0, 0, ratio, 0, 0)
    context?.clearRect(0, 0, width, height)
    if (context && colours && this.#picture.isDrawn) drawMarks(context, space, colours)
    if (context && this.#ghostLines) drawGhostLines(context, space, this.#ghostLines)
  }

  #cellAt(event: PointerEvent): number | null {
    return this.#picture.cellAt(event, { isThrough: !this.#isDigging })
  }

  #listen(canvas: HTMLElement): void {
    new CellPointer(canvas, { click: event => this.#click(event), point: event => void this.#point(event) })
    canvas.addEventListener('keydown', event => this.#onKey(event))
    document.addEventListener('keydown', event => {
      const isUndo = (event.ctrlKey || event.metaKey) && !event.shiftKey && !event.altKey && event.key === 'z'
      if (isTyping(event) || !isUndo || this.#settings.away.length === 0) return
      event.preventDefault()
      this.undoDig()
    })
  }

  #click(event: PointerEvent): void {
    const cell = this.#cellAt(event)
    if (cell === null) return
    if (this.#isDigging) this.#dig(cell)
    else this.#host.choose(cell)
  }

  async #point(event: PointerEvent | null): Promise<void> {
    const pointed = ++this.#pointed
    const cell = event && this.#cellAt(event)
    const row = cell === null ? null : await this.#host.name(cell).catch(() => null)
    if (pointed !== this.#pointed) return
    this.#tip.textContent = row ? `Cell ${row.id}${row.block === null ? '' : `, ${row.block}`}: ${row.standing}` : ''
  }

  #onKey(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return
    const { slice } = this.#settings
    const action = (event.shiftKey && slice ? this.#turns(slice) : this.#keys(slice))[event.key]
    if (!action) return
    event.preventDefault()
    action()
  }

  #keys(slice: Slice | null): Readonly<Record<string, () => void>> {
    const slide = (by: number) => () =>
      slice && this.set({ slice: { ...slice, place: Math.max(0, Math.min(1, slice.place + by)) } })
    return {
      ...this.#picture.keys,
      ...(slice ? { PageUp: slide(SLIDE_STEP), PageDown: slide(-SLIDE_STEP) } : {}),
      ...(this.#isDigging ? { Delete: this.digChosen } : {}),
    }
  }

  #turns(slice: Slice): Readonly<Record<string, () => void>> {
    const turn = (right: number, up: number) => () => {
      const unit = unitOf(slice.normal)
      const elevation = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, elevationOf(unit) + up * TURN_STEP))
      const normal = roundedNormal(directionAt(azimuthOf(unit) + right * TURN_STEP, elevation))
      this.set({ slice: { ...slice, normal } })
    }
    return { ArrowLeft: turn(-1, 0), ArrowRight: turn(1, 0), ArrowUp: turn(0, 1), ArrowDown: turn(0, -1) }
  }

  #render(): void {
    const overview = this.#overview
    render(overview ? barTemplate(this.#stateOf(overview), this) : nothing, this.#bar)
  }

  #stateOf(overview: Overview): BarState {
    return {
      overview,
      settings: this.#settings,
      isDigging: this.#isDigging,
      isTravelOpen: this.#isTravelOpen,
      travelText: this.#isTravelOpen ? this.#host.settingsText() : '',
      before: this.#before,
      faces: this.#faces,
      invalidLeftOut: this.#invalid ? leftOut(this.#invalid.faces) : '',
      hasChosen: this.#chosen?.vertices != null,
      complaint: this.#complaint,
      notice: this.#joining || this.#notice,
    }
  }
}

/** Whether so much is away that the shape of the mesh is not seen any more. A slice leaves it, and what is dug. */
function isCut({ set, relative, layers }: PictureSettings): boolean {
  return set !== 'all' || relative !== null || layers > 0
}

const KEYS = [
  'Mesh: arrow keys turn it, plus and minus zoom, F shows it whole, N and P go through the invalid cells',
  'with a slice, Page Up and Page Down slide it, Shift and arrow keys turn it',
  'when digging, Delete takes the chosen cell away',
].join('; ')

/** At which the ten worst cells are seen, at least. */
function firstThreshold({ worst }: Overview): readonly [number, number] {
  const tenth = worst.slice(0, 10).at(-1)?.relativeMinimum ?? Number.NaN
  return [-Infinity, tenth > LEAST_THRESHOLD ? Math.min(1, Math.ceil(10 * tenth) / 10) : LEAST_THRESHOLD]
}

function leftOut({ shown, wanted }: CutFaces): string {
  return shown === wanted
    ? ''
    : `Of the invalid ones inside the worst ${shown.toLocaleString('en')} of ${wanted.toLocaleString('en')} are drawn.`
}
