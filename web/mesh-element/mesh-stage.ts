/** The place of the picture: what is drawn in each mode, keys and pointers. The picture's context can be given up and made anew. */
import { NO_CONTENT } from '../mesh-scene/loaded-faces'
import { MeshPicture } from '../mesh-scene/mesh-picture'
import type { Vertices } from '../model/hexahedron'
import type { CameraView } from '../model/state'
import type { Bounds, CellDetail, FaceList, Overview, ShownCells } from '../survey/survey-jobs'
import { say } from '../words/say'
import type { Mode } from './mesh-attributes'

export interface StageHost {
  speak(): void
  faces(shown: ShownCells): Promise<FaceList>
  choose(cell: number): void
  goToNext(step: 1 | -1): void
  /** The pointer is on a cell, or on none. */
  point(cell: number | null): void
}

/** More would be a second of drawing on a slow machine; what is left out is said. */
const MOST_WHOLE = 20_000
const TRANSLUCENT = 0.28
/** CSS pixels: a pointer that has moved less has clicked. */
const CLICK = 4

interface Shown {
  readonly surface: FaceList
  readonly invalid: FaceList | null
}

export class MeshStage {
  readonly root = document.createElement('div')
  readonly #host: StageHost
  #picture: MeshPicture | null = null
  #bounds: Bounds | null = null
  #view: CameraView | null = null
  #shown: Shown | null = null
  #chosen: CellDetail | null = null
  #wanted = 0
  #pointed = 0

  constructor(host: StageHost) {
    this.#host = host
    this.root.className = 'stage'
    this.root.tabIndex = 0
    this.root.setAttribute('role', 'application')
    this.root.part.add('picture')
    this.#listen()
  }

  get hasPicture(): boolean {
    return this.#picture !== null
  }

  /** Makes the picture where it is not yet; returns whether there is WebGL. */
  begin(): boolean {
    if (this.#picture) return this.#picture.isDrawn
    const isOurs = (event: WheelEvent) => event.ctrlKey || event.metaKey || this.root.matches(':focus')
    this.#picture = new MeshPicture(this.root, isOurs)
    this.#picture.open(this.#bounds, this.#view)
    this.#put()
    return this.#picture.isDrawn
  }

  /** Gives up the picture and its context; `begin` makes it as it was. */
  rest(): void {
    this.#view = this.#picture?.view ?? this.#view
    this.#picture?.dispose()
    this.#picture = null
  }

  dispose(): void {
    this.#wanted++
    cancelAnimationFrame(this.#pointed)
    this.#picture?.dispose()
    this.#picture = null
  }

  /** Another mesh, or none. */
  open(overview: Overview | null): void {
    this.#wanted++
    this.#bounds = overview?.bounds ?? null
    this.#view = null
    this.#shown = null
    this.#chosen = null
    this.#picture?.open(this.#bounds)
  }

  sayAnew(): void {
    this.root.setAttribute(
      'aria-label',
      say('Mesh: arrow keys turn it, plus and minus zoom, F shows it whole, N and P go through the invalid cells'),
    )
  }

  /** Resolves to what is left out, in words, when the faces are there; null if something else was asked for meanwhile. */
  async show(mode: Mode, { counts }: Overview): Promise<string | null> {
    const wanted = ++this.#wanted
    const invalidOnly: ShownCells = { cells: { which: 'invalid', rings: 0 }, isWhole: false, most: MOST_WHOLE }
    const whole: ShownCells = { cells: { which: 'all' }, isWhole: false, most: Infinity }
    const around: ShownCells = { cells: { which: 'invalid', rings: 1 }, isWhole: false, most: MOST_WHOLE }
    const hasInvalid = counts.invalid > 0
    const surface = await this.#host.faces({ surface: whole, invalid: invalidOnly, neighbours: around }[mode])
    const invalid = mode !== 'invalid' && hasInvalid ? await this.#host.faces(invalidOnly) : null
    if (wanted !== this.#wanted) return null
    this.#shown = { surface, invalid }
    this.#put()
    this.#host.speak()
    if (mode !== 'surface' && !hasInvalid) return say('No cell is invalid: nothing is drawn.')
    return leftOut(surface) || (invalid ? leftOut(invalid) : '')
  }

  choose(detail: CellDetail | null): void {
    this.#chosen = detail
    this.#picture?.choose(detail?.vertices ?? null, detail?.neighbours)
  }

  flyTo(vertices: Vertices): void {
    this.#picture?.flyTo(vertices)
  }

  fit(): void {
    this.#picture?.fit()
  }

  #put(): void {
    if (!this.#picture || !this.#shown) return
    const { surface, invalid } = this.#shown
    this.#picture.show({ ...NO_CONTENT, surface, invalid, opacity: invalid ? TRANSLUCENT : 1 })
    this.choose(this.#chosen)
  }

  #listen(): void {
    const { root } = this
    let down: { readonly x: number; readonly y: number } | null = null
    root.addEventListener('pointerdown', ({ clientX: x, clientY: y }) => {
      down = { x, y }
    })
    root.addEventListener('pointercancel', () => {
      down = null
    })
    root.addEventListener('pointerup', event => {
      const isClick = down !== null && Math.hypot(event.clientX - down.x, event.clientY - down.y) < CLICK
      down = null
      const cell = isClick ? (this.#picture?.cellAt(event) ?? null) : null
      if (cell !== null) this.#host.choose(cell)
    })
    root.addEventListener(
      'pointermove',
      event => event.pointerType === 'mouse' && event.buttons === 0 && this.#point(event),
    )
    root.addEventListener('pointerleave', () => {
      cancelAnimationFrame(this.#pointed)
      this.#host.point(null)
    })
    root.addEventListener('keydown', event => this.#onKey(event))
  }

  #point(event: PointerEvent): void {
    cancelAnimationFrame(this.#pointed)
    this.#pointed = requestAnimationFrame(() => this.#host.point(this.#picture?.cellAt(event) ?? null))
  }

  #onKey(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.#picture?.turn(-1, 0),
      ArrowRight: () => this.#picture?.turn(1, 0),
      ArrowUp: () => this.#picture?.turn(0, 1),
      ArrowDown: () => this.#picture?.turn(0, -1),
      '+': () => this.#picture?.zoom(1.25),
      '-': () => this.#picture?.zoom(0.8),
      f: () => this.fit(),
      n: () => this.#host.goToNext(1),
      p: () => this.#host.goToNext(-1),
    }
    const action = actions[event.key]
    if (!action) return
    event.preventDefault()
    event.stopPropagation()
    action()
  }
}

function leftOut({ shown, wanted }: FaceList): string {
  if (shown === wanted) return ''
  const [few, all] = [shown, wanted].map(count => count.toLocaleString('en')) as [string, string]
  return say('The worst {shown} of {wanted} cells are drawn.', { shown: few, wanted: all })
}
