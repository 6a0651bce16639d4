/** Other node orders that make a valid element of the same eight points, to preview and to use. */
import { html, render, svg, type TemplateResult } from 'lit-html'
import type { Vertices } from '../../model/hexahedron'
import { type NodeOrder, nodeOrders } from '../../model/node-orders'
import { type State, sliceChange, sliceOf } from '../../model/state'
import { copyableJacdet } from '../../views/copyable'
import { isNew } from '../../views/is-new'
import { previewSlice } from '../../views/scene-slices'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { type PlainWord, say } from '../../words/say'
import { answerTo } from '../panel'
import css from './node-order.css?inline'
import { type HelpfulOrder, type TriedOrders, triedOrdersQuestion } from './tried-orders'
import { wireframe } from './wireframe'

export const styles = css

class NodeOrderView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  #used: { readonly vertices: Vertices; readonly name: PlainWord } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'node-order'
  }

  update(frame: Frame): void {
    const { state, report } = frame
    const triedOrders = answerTo(triedOrdersQuestion, frame)
    const { preview } = sliceOf(previewSlice, state)
    if (preview?.order && !state.openPanels.includes('node-order')) this.#preview(null)
    const isStale = triedOrders?.vertices !== state.vertices
    const isValid = report?.valid ?? null
    if (isNew(this.root, isValid, triedOrders, isStale, state.referenceCube, preview, this.#used, state.start))
      render(this.#template(isValid, isStale ? null : triedOrders, state), this.root)
  }

  dispose(): void {
    this.#preview(null)
  }

  #template(isValid: boolean | null, tried: TriedOrders | null, state: State): TemplateResult {
    return html`<p tabindex="-1" class="answer">${this.#answer(isValid, tried)}</p>
      ${isValid === false && tried ? [this.#list(tried, state), triedList(tried)] : ''}`
  }

  #answer(isValid: boolean | null, tried: TriedOrders | null): string {
    if (isValid === null) return say('There is no verdict, so there is nothing to compare.')
    if (isValid) {
      const { vertices } = this.#context.state()
      const used =
        this.#used?.vertices === vertices
          ? `${say('The points were taken in the order “{order}”. Undo takes this back.', { order: say(this.#used.name) })} `
          : ''
      return `${used}${say('The element is valid as its points are ordered, so no other order is tried.')}`
    }
    if (tried === null) return say('The orders are tried when this change is done.')
    const { count, helpful } = tried
    if (helpful.length === 0) return say('None of the {count} orders tried makes it valid.', { count })
    return helpful.length === 1
      ? say('Of {count} other orders of the same eight points, one makes it valid:', { count })
      : say('Of {count} other orders of the same eight points, {helpful} make it valid:', {
          count,
          helpful: helpful.length,
        })
  }

  #list({ vertices, helpful }: TriedOrders, state: State): TemplateResult {
    return html`<ul>
      ${helpful.map(order => this.#order(order, vertices, state))}
    </ul>`
  }

  #order(helpful: HelpfulOrder, given: Vertices, state: State): TemplateResult {
    const { orders, vertices, boundaryMinimum, exponent } = helpful
    const { name: word, permutation } = orders[0] as NodeOrder
    const name = say(word)
    const isOpen = sliceOf(previewSlice, state).preview?.order === permutation
    return html`<li>
      <p class="names">${orders.map(order => html`<span><strong>${say(order.name)}</strong>${usedBy(order)}</span>`)}</p>
      <p class="says">${orders.map(order => say(order.says)).join(' ')}</p>
      <p class="go">
        <button
          type="button"
          aria-label=${say('Preview {order}', { order: name })}
          aria-expanded=${isOpen}
          @click=${() => this.#preview(isOpen ? null : permutation)}
        >
          ${say('Preview')}
        </button>
        <button type="button" aria-label=${say('Use this order: {order}', { order: name })} @click=${() => this.#use(helpful)}>${say('Use this order')}</button>
        <span>min J = ${copyableJacdet(boundaryMinimum, exponent, state.referenceCube)}</span>
      </p>
      ${isOpen ? html`<div class="pictures">${picture(given, null, false)}${picture(vertices, name, true)}</div>` : ''}
    </li>`
  }

  #preview(order: readonly number[] | null): void {
    this.#context.dispatch(sliceChange(previewSlice, { preview: order && { order } }))
  }

  /** One step to undo. The button goes, so the focus moves to the sentence about it. */
  #use({ orders, vertices }: HelpfulOrder): void {
    this.#context.dispatch({ type: 'set-vertices', vertices, preset: null })
    this.#used = { vertices: this.#context.state().vertices, name: (orders[0] as NodeOrder).name }
    this.root.querySelector<HTMLElement>('.answer')?.focus({ preventScroll: true })
  }
}

function usedBy(order: NodeOrder): TemplateResult | string {
  return order.usedBy ? html` <span class="by">${say(order.usedBy)}</span>` : ''
}

function triedList({ count }: TriedOrders): TemplateResult {
  return html`<details>
    <summary>${say('The {count} orders tried', { count })}</summary>
    <dl>
      ${nodeOrders.map(order => html`<div><dt>${say(order.name)}${usedBy(order)}</dt><dd>${say(order.says)}</dd></div>`)}
    </dl>
    <p>${say('Turning the numbers by one of the cube’s 24 rotations changes nothing, so orders that differ by one are tried once.')}</p>
  </details>`
}

/** The picture of an element, numbered in its own order. */
function picture(vertices: Vertices, order: string | null, isValid: boolean): TemplateResult {
  const { points, path } = wireframe(vertices)
  const verdict = isValid ? say('valid') : say('invalid')
  const label =
    order === null
      ? say('The element as it is: {verdict}', { verdict })
      : say('The element in the order {order}: {verdict}', { order, verdict })
  return html`<figure>
    <svg viewBox="-126 -122 252 244" role="img" aria-label=${label}>
      <path d=${path} />
      ${points.map(({ x, y }, v) => svg`<text x=${112 * x} y=${112 * y}>${v}</text>`)}
    </svg>
    <figcaption>${order === null ? say('as it is: {verdict}', { verdict }) : say('{order}: {verdict}', { order, verdict })}</figcaption>
  </figure>`
}

export const create: CreateView = context => new NodeOrderView(context)
