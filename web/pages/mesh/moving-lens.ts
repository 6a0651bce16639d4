/**
 * The lens of the page Mesh: a vertex that is moved in it moves in the mesh. All cells around are answered in the frame of the move; the mesh's
 * worker has the move when it is done. Vertices on the boundary stay, unless they are freed.
 */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import { coreFiles } from '../../core/core-files'
import { fetchCore } from '../../core/fetch-core'
import type { Core } from '../../core/report'
import { historyStep } from '../../element/shortcuts'
import { written } from '../../model/document-readers'
import { type Vec3, type Vertices, vertexOf } from '../../model/hexahedron'
import type { Around, MovementCounts, Moves, Row } from '../../survey/survey-jobs'
import { LiveCells } from './live-cells'
import { isTyping } from './typing'

export interface MovingHost {
  /** Rows of the list as they are while a vertex moves. */
  rows(rows: readonly Row[]): void
  /** A move is done. */
  move(moves: Moves): void
  step(which: 'undo' | 'redo'): void
  /** Points where they were read, or all. */
  restore(points: readonly number[] | null): void
  /** The boundary may move, or no longer. */
  freed(): void
}

interface Chosen {
  readonly cell: number
  readonly around: Around | null
  /** Why no vertex can be moved; empty if some can. */
  readonly whyNot: string
}

const VERTICES = [0, 1, 2, 3, 4, 5, 6, 7] as const
const UNKNOWN = 'Vertices can be moved once the surface of the mesh has been found.'
export const NOTHING_MOVED: MovementCounts = { movedCount: 0, canUndo: false, canRedo: false, whyNotInPlace: null }

export class MovingLens {
  readonly #lens: HTMLElementTagNameMap['hex-lens']
  readonly #root: HTMLElement
  readonly #host: MovingHost
  #core: Core | null = null
  #chosen: Chosen | null = null
  #live: LiveCells | null = null
  /** As the mesh has them, and as they are in the hand. */
  #committed: Vertices = []
  #now: Vertices = []
  #isBoundaryFree = false
  #movement = NOTHING_MOVED
  #said = ''

  constructor(lens: HTMLElementTagNameMap['hex-lens'], root: HTMLElement, host: MovingHost) {
    this.#lens = lens
    this.#root = root
    this.#host = host
    lens.addEventListener('hex-input', ({ detail: { vertices, source } }) => {
      if (source !== 'program') this.#onInput(vertices)
    })
    lens.addEventListener('hex-change', () => this.#onChange())
    lens.addEventListener('keydown', event => this.#onKey(event), { capture: true })
    document.addEventListener('keydown', event => {
      if (!isTyping(event) && !event.defaultPrevented) this.#onKey(event)
    })
    // Without it the worker answers alone, when a move is done.
    fetchCore(coreFiles).then(
      core => {
        this.#core = core
        this.#relive()
      },
      () => {},
    )
  }

  /** True while a hand has a vertex: the lens and what is around it are ahead of the mesh then. */
  get #isHeld(): boolean {
    return this.#lens.isConnected && !same(this.#now, this.#committed)
  }

  set movement(movement: MovementCounts) {
    this.#movement = movement
    this.#render()
  }

  /** A cell of the mesh; `steps` is true for a mesh of several time steps, which is only looked at. */
  show(cell: number, vertices: Vertices, around: Around | null, { hasSteps }: { readonly hasSteps: boolean }): void {
    if (this.#chosen?.cell === cell && this.#isHeld) return
    const isAnother = this.#chosen?.cell !== cell
    if (isAnother) this.#said = ''
    const whyNot = hasSteps ? ONLY_SHOWN : around === null ? UNKNOWN : ''
    this.#chosen = { cell, around, whyNot }
    this.#put(vertices)
    // For the lens an element that a program sets is a step of an animation: its camera would stay.
    if (isAnother) this.#lens.fit()
    this.#relive()
    this.#render()
  }

  showNone(): void {
    this.#chosen = null
    this.#live = null
    this.#said = ''
    this.#render()
  }

  #say(sentence: string): void {
    this.#said = sentence
    this.#render()
  }

  /** The lens has no history of its own: its steps would lead to other cells. */
  #put(vertices: Vertices): void {
    this.#committed = vertices
    this.#now = vertices
    const element = { vertices: written(vertices), preset: null, start: written(vertices) }
    this.#lens.history = { version: 1, elements: [element], present: 0 }
  }

  #relive(): void {
    const around = this.#chosen?.around
    this.#live = around && this.#core ? new LiveCells(this.#core, around) : null
    this.#surround()
  }

  #surround(): void {
    const { cell, around, whyNot } = this.#chosen ?? {}
    const ofBoundary = this.#isBoundaryFree ? [] : (around?.onBoundary ?? [])
    this.#lens.surround({
      hexahedra: cell === undefined ? [] : (this.#live?.drawnAround(cell) ?? []),
      fixed: whyNot === ONLY_SHOWN ? VERTICES : ofBoundary,
    })
  }

  #onInput(given: Vertices): void {
    const places = new Map<number, Vec3>()
    const next = [...this.#now]
    for (const v of VERTICES) {
      const place = vertexOf(given, v)
      if (samePlace(place, vertexOf(this.#now, v)) || this.#stays(v)) continue
      // A cell may have a point several times.
      for (const w of this.#samePoints(v)) {
        places.set(w, place)
        next.splice(3 * w, 3, ...place)
      }
    }
    if (!same(next, given)) this.#lens.vertices = next
    if (places.size === 0) return
    this.#now = next
    if (this.#live) this.#host.rows(this.#live.move(places))
    this.#surround()
  }

  #onChange(): void {
    const { cell, around } = this.#chosen ?? {}
    const moved = VERTICES.filter(v => !samePlace(vertexOf(this.#now, v), vertexOf(this.#committed, v)))
    if (!around || cell === undefined || moved.length === 0) return
    const points = moved.map(v => around.points[v] as number)
    const to = Float64Array.from(moved.flatMap(v => [...vertexOf(this.#now, v)]))
    this.#put(this.#now)
    this.#host.move({ points: Uint32Array.from(points), to })
  }

  /** A sentence about a vertex that may not move; null for one that may. */
  whyFixed(vertex: number): string | null {
    const { around, whyNot } = this.#chosen ?? { around: null, whyNot: UNKNOWN }
    if (whyNot !== '') return whyNot
    const isFixed = !this.#isBoundaryFree && around?.onBoundary.includes(vertex)
    return isFixed ? `Vertex ${vertex} stays: it is on the boundary of the hexahedra.` : null
  }

  /** True, and says why, for a vertex that may not move. */
  #stays(vertex: number): boolean {
    const why = this.whyFixed(vertex)
    if (why !== null) this.#say(why)
    return why !== null
  }

  #samePoints(vertex: number): number[] {
    const points = this.#chosen?.around?.points ?? []
    return VERTICES.filter(v => v === vertex || points[v] === points[vertex])
  }

  #onKey(event: KeyboardEvent): void {
    const step = historyStep(event)
    if (step === null || !this.#movement[step === 'undo' ? 'canUndo' : 'canRedo'] || this.#isHeld) return
    event.preventDefault()
    this.#host.step(step)
  }

  #free(isFree: boolean): void {
    this.#isBoundaryFree = isFree
    this.#said = isFree
      ? 'The boundary may be moved now. The shape of the mesh and cells of other types are not looked after.'
      : ''
    this.#surround()
    this.#render()
    this.#host.freed()
  }

  /** The vertex that keys move. */
  #restoreVertex(): void {
    const { around } = this.#chosen ?? {}
    const { selectedVertex } = this.#lens.state
    const point = around?.points[selectedVertex]
    if (point === undefined) return
    if (around?.moved.includes(selectedVertex)) this.#host.restore([point])
    else this.#say(`Vertex ${selectedVertex} is where it was read.`)
  }

  #render(): void {
    const isOnlyShown = this.#chosen?.whyNot === ONLY_SHOWN
    const template = isOnlyShown ? html`<p class="moved">${ONLY_SHOWN}</p>` : this.#chosen ? this.#template() : nothing
    render(template, this.#root)
  }

  #template(): TemplateResult {
    const { movedCount, canUndo, canRedo } = this.#movement
    const count =
      movedCount === 0 ? '' : `${movedCount.toLocaleString('en')} ${movedCount === 1 ? 'vertex' : 'vertices'} moved.`
    return html`<p class="steps-of-moves">
        <button type="button" title="Undo (Ctrl+Z)" ?disabled=${!canUndo} @click=${() => this.#host.step('undo')}>Undo</button>
        <button type="button" title="Redo (Ctrl+Shift+Z)" ?disabled=${!canRedo} @click=${() => this.#host.step('redo')}>Redo</button>
        <button type="button" title="The chosen vertex where it was read" ?disabled=${movedCount === 0} @click=${() => this.#restoreVertex()}>Vertex back</button>
        <button type="button" title="All vertices where they were read: one step to undo" ?disabled=${movedCount === 0} @click=${() => this.#host.restore(null)}>All back</button>
        <label title="Grey handles are on the boundary of the hexahedra, and stay"
          ><input type="checkbox" .checked=${this.#isBoundaryFree} @change=${(event: Event) => this.#free((event.target as HTMLInputElement).checked)} /> Free the boundary</label
        >
      </p>
      <p class="moved" role="status">${count === '' && this.#said === '' ? HINT : `${count} ${this.#said}`.trim()}</p>`
  }
}

const HINT = 'A vertex that is dragged moves in the mesh; grey ones stay.'
const ONLY_SHOWN = 'A mesh of several time steps is only shown: open the file of one step alone to move its vertices.'

function samePlace(a: Vec3, b: Vec3): boolean {
  return a.every((x, axis) => Object.is(x, b[axis]))
}

function same(a: Vertices, b: Vertices): boolean {
  return a.length === b.length && a.every((x, i) => Object.is(x, b[i]))
}
