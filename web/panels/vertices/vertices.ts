/** The 24 coordinates as fields. Typing is like dragging: live, one undo step, ended by Escape. */
import { html, render } from 'lit-html'
import { COORDINATE_COUNT, VERTEX_COUNT } from '../../model/hexahedron'
import type { CreateView, Frame, Update, View, ViewContext } from '../../views/view'
import { coordinateText, fieldText, readCoordinate } from './coordinate-text'
import css from './vertices.css?inline'

export const verticesStyles = css

/** Characters that surely fit a field; a longer text may hide its exponent. */
const WIDTH = 11

const axisNames = ['x', 'y', 'z'] as const

/** "Vertex 6 z" for coordinate 20. */
function coordinateLabel(index: number): string {
  return `Vertex ${Math.floor(index / 3)} ${axisNames[index % 3]}`
}

const template = html`
  <h2 id="vertices-title">Vertices</h2>
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
          ${axisNames.map(
            (_, axis) => html`<td>
              <input
                class="on-paper"
                type="number"
                step="any"
                autocomplete="off"
                aria-label=${coordinateLabel(3 * vertex + axis)}
                data-index=${3 * vertex + axis}
              />
            </td>`,
          )}
        </tr>`,
      )}
    </tbody>
  </table>
  <p class="refusal" id="vertices-refusal" aria-live="polite"></p>
`

interface LeftOut {
  readonly index: number
  readonly text: string
}

class VerticesView implements View {
  readonly root = document.createElement('section')
  readonly updates: readonly Update[] = [frame => this.#draw(frame)]
  readonly #context: ViewContext
  readonly #inputs: readonly HTMLInputElement[]
  readonly #rows: readonly HTMLTableRowElement[]
  readonly #refusal: HTMLElement
  readonly #refused = new Set<number>()
  /** The input that the focused field last could not take. */
  #leftOut: LeftOut | null = null
  /** The numbers of the last frame, or as typed since. */
  readonly #values: number[] = new Array(COORDINATE_COUNT).fill(Number.NaN)
  #selected = -1
  #edit: { readonly index: number; readonly before: number } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'vertices'
    this.root.setAttribute('role', 'group')
    this.root.setAttribute('aria-labelledby', 'vertices-title')
    render(template, this.root)
    this.#inputs = [...this.root.querySelectorAll('input')]
    this.#rows = [...this.root.querySelectorAll<HTMLTableRowElement>('tr[data-vertex]')]
    this.#refusal = this.root.querySelector('.refusal') as HTMLElement
    this.root.addEventListener('beforeinput', this.#onBeforeInput)
    this.root.addEventListener('input', this.#onInput)
    this.root.addEventListener('change', this.#commit)
    this.root.addEventListener('keydown', this.#onKeyDown)
    this.root.addEventListener('focusin', this.#onFocusIn)
    this.root.addEventListener('focusout', this.#onFocusOut)
    this.root.addEventListener('pointerover', this.#onPointerOver)
    this.root.addEventListener('wheel', this.#onWheel, { passive: false })
  }

  update(): void {}

  #draw({ state }: Frame): void {
    if (state.isReadonly !== this.#inputs[0]?.readOnly)
      for (const input of this.#inputs) input.readOnly = state.isReadonly
    state.vertices.forEach((value, index) => {
      if (Object.is(value, this.#values[index])) return
      this.#values[index] = value
      this.#show(index)
    })
    const selected = state.isVertexChosen ? state.selectedVertex : -1
    if (selected === this.#selected) return
    this.#selected = selected
    this.#rows.forEach((row, vertex) => {
      row.classList.toggle('selected', vertex === this.#selected)
    })
  }

  dispose(): void {
    this.#commit()
  }

  /** The field's text from the value; a text being typed stays while it is the same number. */
  #show(index: number): void {
    const input = this.#inputs[index] as HTMLInputElement
    const value = this.#values[index] as number
    const says = readCoordinate(input.value)
    if (this.#focused() !== input || says === null || !Object.is(says, value)) input.value = coordinateText(value)
    input.title = input.value.length > WIDTH ? input.value : ''
    this.#accept(index)
  }

  /** A text that is not one number is refused: the browser would make another number of it. */
  readonly #onBeforeInput = (event: InputEvent): void => {
    const text = event.data ?? event.dataTransfer?.getData('text/plain') ?? ''
    const taken = fieldText(text)
    if (text === '' || taken === text) return
    event.preventDefault()
    // The only way to insert that keeps the caret and the browser's own undo.
    if (taken !== null) document.execCommand('insertText', false, taken)
    else this.#leaveOut({ index: Number((event.target as HTMLInputElement).dataset.index), text })
  }

  readonly #onInput = (event: Event): void => {
    const input = event.target as HTMLInputElement
    const index = Number(input.dataset.index)
    const value = readCoordinate(input.value)
    if (value === null) {
      this.#cancel()
      this.#refuse(index)
      return
    }
    this.#accept(index)
    if (this.#edit?.index !== index) {
      this.#commit()
      this.#edit = { index, before: this.#values[index] as number }
      this.#context.dispatch({ type: 'begin-gesture' })
    }
    this.#values[index] = value
    this.#context.dispatch({ type: 'move-coordinate', index, to: value })
  }

  readonly #commit = (): void => {
    if (this.#edit === null) return
    this.#edit = null
    this.#context.dispatch({ type: 'commit-gesture' })
  }

  #cancel(): void {
    if (this.#edit === null) return
    this.#values[this.#edit.index] = this.#edit.before
    this.#edit = null
    this.#context.dispatch({ type: 'cancel-gesture' })
  }

  #refuse(index: number): void {
    this.#refused.add(index)
    this.#inputs[index]?.setAttribute('aria-invalid', 'true')
    this.#inputs[index]?.setAttribute('aria-errormessage', 'vertices-refusal')
    this.#sayRefused()
  }

  #accept(index: number): void {
    if (!this.#refused.delete(index)) return
    this.#inputs[index]?.removeAttribute('aria-invalid')
    this.#inputs[index]?.removeAttribute('aria-errormessage')
    this.#sayRefused()
  }

  #leaveOut(leftOut: LeftOut | null): void {
    if (this.#leftOut === leftOut) return
    this.#leftOut = leftOut
    this.#sayRefused()
  }

  #sayRefused(): void {
    const refused = [...this.#refused].map(
      index =>
        `${coordinateLabel(index)} needs a finite number; ${coordinateText(this.#values[index] as number)} is kept.`,
    )
    if (this.#leftOut !== null) refused.push(leftOutSentence(this.#leftOut))
    this.#refusal.textContent = refused.join(' ')
  }

  readonly #onKeyDown = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !(event.target instanceof HTMLInputElement)) return
    const index = Number(event.target.dataset.index)
    if (this.#edit === null && this.#leftOut === null && !this.#refused.has(index)) return
    event.stopPropagation()
    this.#leaveOut(null)
    this.#cancel()
    event.target.value = coordinateText(this.#values[index] as number)
    this.#accept(index)
  }

  readonly #onFocusIn = (event: FocusEvent): void => this.#select(event.target as Element)

  readonly #onFocusOut = (event: FocusEvent): void => {
    this.#commit()
    this.#leaveOut(null)
    const input = event.target as HTMLInputElement
    const index = Number(input.dataset.index)
    if (!this.#refused.has(index)) input.value = coordinateText(this.#values[index] as number)
  }

  readonly #onPointerOver = (event: PointerEvent): void => {
    if (event.pointerType === 'mouse' && event.buttons === 0 && this.#focused() === null)
      this.#select(event.target as Element)
  }

  /** A focused number field would step with the wheel: nobody means that while scrolling. */
  readonly #onWheel = (event: WheelEvent): void => {
    if (event.target === this.#focused()) event.preventDefault()
  }

  #select(target: Element): void {
    const row = target.closest<HTMLElement>('tr[data-vertex]')
    if (row === null) return
    const vertex = Number(row.dataset.vertex)
    if (vertex !== this.#selected) this.#context.dispatch({ type: 'select-vertex', vertex })
  }

  #focused(): Element | null {
    return this.root.querySelector('input:focus')
  }
}

function leftOutSentence({ index, text }: LeftOut): string {
  const shown = text.length > 24 ? `${text.slice(0, 24)}…` : text
  return `${coordinateLabel(index)} takes one number, like −1.5 or 2e-3; “${shown}” was left out.`
}

export const createVertices: CreateView = context => new VerticesView(context)
