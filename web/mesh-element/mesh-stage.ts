/** The place of the picture: what is drawn in each mode, keys and pointers. The picture's context can be given up and made anew. */
import { CellPointer } from '../mesh-scene/cell-pointer'
import { MOST_WHOLE, NO_CONTENT, TRANSLUCENT } from '../mesh-scene/loaded-faces'
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

interface Shown {
  readonly surface: FaceList
  readonly invalid: FaceList | null
}

export class MeshStage {
  readonly root = document.createElement('div')
  readonly #host: StageHost
  readonly #pointer: CellPointer
  #picture: MeshPicture | null = null
  #bounds: Bounds | null = null
  #view: CameraView | null = null
  #shown: Shown | null = null
  #chosen: CellDetail | null = null
  #wanted = 0

  constructor(host: StageHost) {
    this.#host = host
    this.root.className = 'stage'
    this.root.tabIndex = 0
    this.root.setAttribute('role', 'application')
    this.root.part.add('picture')
    this.#pointer = this.#listen()
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
    this.#pointer.end()
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

  #listen(): CellPointer {
    this.root.addEventListener('keydown', event => this.#onKey(event))
    const cellAt = (event: PointerEvent) => this.#picture?.cellAt(event) ?? null
    return new CellPointer(this.root, {
      click: event => {
        const cell = cellAt(event)
        if (cell !== null) this.#host.choose(cell)
      },
      point: event => this.#host.point(event && cellAt(event)),
    })
  }

  #onKey(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return
    const actions: Record<string, () => void> = {
      ...this.#picture?.keys,
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
