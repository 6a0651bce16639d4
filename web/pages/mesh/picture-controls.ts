/** The picture and what chooses the cells in it: modes, the slice, rings, shrinking, blocks. */
import { html, nothing, render, type TemplateResult } from 'lit-html'
import { MeshPicture } from '../../mesh-scene/mesh-picture'
import type { Vec3, Vertices } from '../../model/hexahedron'
import type { FaceList, Neighbour, Overview, Row, ShownCells } from '../../survey/survey-jobs'

export interface PictureHost {
  faces(cells: ShownCells): Promise<FaceList>
  choose(cell: number): void
  /** The cell as the list has it; null if no mesh is open. */
  name(cell: number): Promise<Row | null>
}

type Mode = 'surface' | 'slice' | 'invalid' | 'listed' | `block-${number}`
type Along = 'x' | 'y' | 'z' | 'view'

interface Settings {
  readonly mode: Mode
  readonly along: Along
  /** From 0 to 1 of the way through the mesh. */
  readonly offset: number
  readonly rings: number
  readonly shrink: boolean
}

const FIRST: Settings = { mode: 'surface', along: 'x', offset: 0.5, rings: 0, shrink: false }

/** More would be a second of drawing on a slow machine; what is left out is said. */
const MOST_WHOLE = 20_000
const SHRUNK = 0.8
const TRANSLUCENT = 0.28

export class PictureControls {
  readonly #host: PictureHost
  readonly #picture: MeshPicture
  readonly #bar = document.createElement('div')
  readonly #tip = document.createElement('p')
  #overview: Overview | null = null
  #settings = FIRST
  #vertices: Vertices | null = null
  #wanted = 0
  #left = ''
  #pointed = 0

  constructor(root: HTMLElement, host: PictureHost) {
    this.#host = host
    const canvas = document.createElement('div')
    canvas.className = 'canvas'
    canvas.tabIndex = 0
    canvas.setAttribute('role', 'application')
    canvas.setAttribute('aria-label', 'Mesh: arrow keys turn it, plus and minus zoom, F shows it whole')
    this.#bar.className = 'bar'
    this.#tip.className = 'tip'
    root.append(canvas, this.#tip, this.#bar)
    this.#picture = new MeshPicture(canvas)
    let down: { readonly x: number; readonly y: number } | null = null
    canvas.addEventListener('pointerdown', ({ clientX: x, clientY: y }) => {
      down = { x, y }
    })
    canvas.addEventListener('pointerup', event => {
      const isClick = down !== null && Math.hypot(event.clientX - down.x, event.clientY - down.y) < 4
      down = null
      const cell = isClick ? this.#cellAt(event) : null
      if (cell !== null) host.choose(cell)
    })
    canvas.addEventListener(
      'pointermove',
      event => event.pointerType === 'mouse' && event.buttons === 0 && this.#point(event),
    )
    canvas.addEventListener('pointerleave', () => this.#say(''))
    canvas.addEventListener('keydown', event => this.#onKey(event))
    if (!this.#picture.isDrawn) root.classList.add('is-not-drawn')
  }

  /** Another mesh, or none. */
  open(overview: Overview | null): void {
    this.#overview = overview
    this.#settings = FIRST
    this.#vertices = null
    this.#left = ''
    this.#wanted++
    this.#picture.open(overview?.bounds ?? null)
    this.#render()
  }

  /** Another step of the mesh, seen as the one before was. */
  step(overview: Overview): void {
    this.#overview = overview
    this.#picture.step(overview.bounds)
    this.#render()
  }

  say(notice: string): void {
    this.#left = notice
    this.#render()
  }

  /** Asks for the faces of the present settings, and draws them. */
  async show(): Promise<void> {
    const wanted = ++this.#wanted
    const isOld = () => wanted !== this.#wanted
    const { mode, rings, shrink } = this.#settings
    const hasInvalid = (this.#overview?.counts.invalid ?? 0) > 0
    const cells = this.#cellsOf()
    const most = shrink || mode === 'invalid' || mode === 'listed' ? MOST_WHOLE : Infinity
    const surface = await this.#host.faces({ cells, isWhole: shrink, most }).catch(() => null)
    if (surface === null || isOld()) return
    const showsInvalid =
      hasInvalid && !shrink && (mode === 'surface' || mode === 'slice' || (mode === 'invalid' && rings > 0))
    const invalid = showsInvalid
      ? await this.#host
          .faces({ cells: { which: 'invalid', rings: 0 }, isWhole: false, most: MOST_WHOLE })
          .catch(() => null)
      : null
    if (isOld()) return
    this.#picture.opacity = invalid ? TRANSLUCENT : 1
    this.#picture.size = shrink ? SHRUNK : 1
    this.#picture.show('invalid', invalid)
    this.#picture.show('surface', surface)
    this.#left = leftOut(surface) || (invalid ? leftOut(invalid) : '')
    this.#render()
  }

  /** After another selection. */
  async refresh(): Promise<void> {
    if (this.#settings.mode === 'listed') await this.show()
  }

  choose(vertices: Vertices | null, neighbours: readonly Neighbour[]): void {
    this.#vertices = vertices
    this.#picture.choose(vertices, neighbours)
  }

  /** Null where there is no WebGL. */
  toPNG(): Promise<Blob> | null {
    return this.#picture.isDrawn ? this.#picture.toPNG() : null
  }

  flyToChosen(): void {
    if (this.#vertices) this.#picture.flyTo(this.#vertices)
  }

  #set(settings: Partial<Settings>): void {
    this.#settings = { ...this.#settings, ...settings }
    this.#render()
    void this.show()
  }

  #cellsOf(): ShownCells['cells'] {
    const { mode, rings } = this.#settings
    if (mode === 'surface') return { which: 'all' }
    if (mode === 'invalid') return { which: 'invalid', rings }
    if (mode === 'listed') return { which: 'listed' }
    if (mode === 'slice') return this.#plane()
    return { which: 'block', block: Number(mode.slice('block-'.length)) }
  }

  /** The plane at its part of the way between the two corners of the bounds that lie farthest along its normal. */
  #plane(): ShownCells['cells'] {
    const { along, offset } = this.#settings
    const normal: Vec3 = along === 'view' ? this.#picture.direction : AXES[along]
    const { least, greatest } = this.#overview?.bounds ?? { least: [0, 0, 0], greatest: [0, 0, 0] }
    const reach = [0, 1, 2].reduce(
      (sum, axis) => sum + (Math.abs(normal[axis as 0]) * (greatest[axis as 0] - least[axis as 0])) / 2,
      0,
    )
    const middle = this.#picture.middleOf(this.#overview?.bounds ?? null)
    const across = [0, 1, 2].reduce((sum, axis) => sum + normal[axis as 0] * middle[axis as 0], 0)
    return { which: 'behind-plane', normal, offset: across + (2 * offset - 1) * reach }
  }

  #cellAt(event: PointerEvent): number | null {
    return this.#picture.cellAt(event)
  }

  #point(event: PointerEvent): void {
    cancelAnimationFrame(this.#pointed)
    this.#pointed = requestAnimationFrame(async () => {
      const cell = this.#cellAt(event)
      if (cell === null) return this.#say('')
      const row = await this.#host.name(cell)
      if (row) this.#say(`Cell ${row.id}${row.block === null ? '' : `, ${row.block}`}: ${row.standing}`)
    })
  }

  #say(text: string): void {
    this.#tip.textContent = text
  }

  #onKey(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.#picture.turn(-1, 0),
      ArrowRight: () => this.#picture.turn(1, 0),
      ArrowUp: () => this.#picture.turn(0, 1),
      ArrowDown: () => this.#picture.turn(0, -1),
      '+': () => this.#picture.zoom(1.25),
      '-': () => this.#picture.zoom(0.8),
      f: () => this.#picture.fit(),
    }
    const action = actions[event.key]
    if (!action) return
    event.preventDefault()
    action()
  }

  #render(): void {
    render(this.#overview ? this.#template(this.#overview, this.#settings) : nothing, this.#bar)
  }

  #template({ blocks, counts }: Overview, { mode, along, offset, rings, shrink }: Settings): TemplateResult {
    const option = (value: Mode, name: string) =>
      html`<option value=${value} ?selected=${value === mode}>${name}</option>`
    return html`<label
        ><span class="said">Cells in the picture</span
        ><select @change=${(event: Event) => this.#set({ mode: (event.target as HTMLSelectElement).value as Mode })}>
          ${option('surface', 'Surface')} ${option('slice', 'Slice')}
          ${counts.invalid > 0 ? option('invalid', 'Invalid cells') : nothing} ${option('listed', 'Listed cells')}
          ${blocks.map((block, i) => option(`block-${i}`, `Block ${block.name}`))}
        </select></label
      >
      ${
        mode === 'slice'
          ? html`<label
                ><span class="said">Across</span
                ><select @change=${(event: Event) => this.#set({ along: (event.target as HTMLSelectElement).value as Along })}>
                  ${(['x', 'y', 'z', 'view'] as const).map(
                    axis =>
                      html`<option value=${axis} ?selected=${axis === along}>${axis === 'view' ? 'across the view' : `across ${axis}`}</option>`,
                  )}
                </select></label
              ><label
                ><span class="said">Place of the slice</span
                ><input
                  type="range"
                  min="0"
                  max="1"
                  step="0.005"
                  .value=${String(offset)}
                  @input=${(event: Event) => this.#set({ offset: Number((event.target as HTMLInputElement).value) })}
              /></label>`
          : nothing
      }
      ${
        mode === 'invalid'
          ? html`<label
              >Rings around
              <select @change=${(event: Event) => this.#set({ rings: Number((event.target as HTMLSelectElement).value) })}>
                ${[0, 1, 2, 3].map(count => html`<option ?selected=${count === rings}>${count}</option>`)}
              </select></label
            >`
          : nothing
      }
      <label><input type="checkbox" .checked=${shrink} @change=${(event: Event) => this.#set({ shrink: (event.target as HTMLInputElement).checked })} /> Apart</label>
      <button type="button" @click=${() => this.flyToChosen()}>Chosen cell</button>
      <button type="button" @click=${() => this.#picture.fit()}>Fit</button>
      <span class="left">${this.#left}</span>`
  }
}

const AXES: Readonly<Record<'x' | 'y' | 'z', Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] }

function leftOut({ shown, wanted }: FaceList): string {
  return shown === wanted ? '' : `The worst ${shown.toLocaleString('en')} of ${wanted.toLocaleString('en')} are drawn.`
}
