/** The 24 coordinates as fields. Typing is like dragging: live, one undo step, ended by Escape. */
import { html, render } from 'lit-html'
import { COORDINATE_COUNT, VERTEX_COUNT } from '../../model/hexahedron'
import { NumberField } from '../../views/number-field'
import type { CreateView, Frame, Update, View, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import css from './vertices.css?inline'

export const verticesStyles = css

const REFUSAL = 'vertices-refusal'

const axisNames = ['x', 'y', 'z'] as const

const template = (fields: readonly NumberField[]) => html`
  <h2 id="vertices-title">${say('Vertices')}</h2>
  <table>
    <thead>
      <tr>
        <td></td>
        ${axisNames.map(axis => html`<th scope="col">${axis}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${Array.from(
        { length: VERTEX_COUNT },
        (_, vertex) => html`<tr data-vertex=${vertex}>
          <th scope="row">${vertex}</th>
          ${axisNames.map((_, axis) => html`<td>${fields[3 * vertex + axis]?.input}</td>`)}
        </tr>`,
      )}
    </tbody>
  </table>
  <p class="refusal" id=${REFUSAL} aria-live="polite"></p>
`

class VerticesView implements View {
  readonly root = document.createElement('section')
  readonly updates: readonly Update[] = [frame => this.#draw(frame)]
  readonly #context: ViewContext
  readonly #fields: readonly NumberField[]
  readonly #rows: readonly HTMLTableRowElement[]
  readonly #refusal: HTMLElement
  #selected = -1

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'vertices'
    this.root.setAttribute('role', 'group')
    this.root.setAttribute('aria-labelledby', 'vertices-title')
    this.#fields = Array.from({ length: COORDINATE_COUNT }, (_, index) => this.#field(index))
    render(template(this.#fields), this.root)
    this.#rows = [...this.root.querySelectorAll<HTMLTableRowElement>('tr[data-vertex]')]
    this.#refusal = this.root.querySelector('.refusal') as HTMLElement
    this.root.addEventListener('focusin', this.#onFocusIn)
    this.root.addEventListener('pointerover', this.#onPointerOver)
  }

  update(): void {}

  #field(index: number): NumberField {
    const { dispatch } = this.#context
    const field = new NumberField({
      name: say('Vertex {name} {axis}', { name: Math.floor(index / 3), axis: axisNames[index % 3] as string }),
      refusalId: REFUSAL,
      onRefusal: () => {
        const refusals = this.#fields.map(({ refusal }) => refusal).filter(refusal => refusal !== '')
        this.#refusal.textContent = refusals.join(' ')
      },
      live: {
        begin: () => dispatch({ type: 'begin-gesture', by: 'field' }),
        type: to => dispatch({ type: 'move-coordinate', index, to }),
        cancel: () => dispatch({ type: 'cancel-gesture' }),
      },
      commit: () => dispatch({ type: 'commit-gesture' }),
    })
    field.input.className = 'on-paper'
    return field
  }

  #draw({ state }: Frame): void {
    if (state.isReadonly !== this.#fields[0]?.input.readOnly)
      for (const { input } of this.#fields) input.readOnly = state.isReadonly
    state.vertices.forEach((value, index) => {
      this.#fields[index]?.show(value)
    })
    const selected = state.isVertexChosen ? state.selectedVertex : -1
    if (selected === this.#selected) return
    this.#selected = selected
    this.#rows.forEach((row, vertex) => {
      row.classList.toggle('selected', vertex === this.#selected)
    })
  }

  dispose(): void {
    for (const field of this.#fields) field.commit()
  }

  readonly #onFocusIn = (event: FocusEvent): void => this.#select(event.target as Element)

  readonly #onPointerOver = (event: PointerEvent): void => {
    if (event.pointerType === 'mouse' && event.buttons === 0 && this.root.querySelector('input:focus') === null)
      this.#select(event.target as Element)
  }

  #select(target: Element): void {
    const row = target.closest<HTMLElement>('tr[data-vertex]')
    if (row === null) return
    const vertex = Number(row.dataset.vertex)
    if (vertex !== this.#selected) this.#context.dispatch({ type: 'select-vertex', vertex })
  }
}

export const createVertices: CreateView = context => new VerticesView(context)
