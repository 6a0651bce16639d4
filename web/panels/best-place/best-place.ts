/** Where a vertex alone makes the element best, and the points that forbid a better place, with their weights. */
import { html, render, type TemplateResult } from 'lit-html'
import type { BestPlace } from '../../core/repair/best-place'
import { placeCertificateJson } from '../../core/repair/place-certificate'
import type { JacobianReport } from '../../core/report'
import { formatNumber } from '../../model/decimal'
import { type Vec3, type Vertices, vertexOf } from '../../model/hexahedron'
import { nearestDouble } from '../../model/rational'
import type { ReferenceCube } from '../../model/state'
import { copyText } from '../../views/copy-text'
import { copyable, copyableJacdet, copyablePoint } from '../../views/copyable'
import { isNew } from '../../views/is-new'
import { saveFile } from '../../views/save-file'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { say, sayParts } from '../../words/say'
import { answerTo } from '../panel'
import css from './best-place.css?inline'
import { bestPlaceQuestion, type ShownHold, type VertexPlace } from './best-place-question'

export const styles = css

class BestPlaceView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  /** The vertices after the last move there. */
  #moved: Vertices | null = null
  /** The last copy, said as long as that answer is shown. */
  #copied: { readonly of: VertexPlace; readonly isCopied: boolean } | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'best-place'
  }

  update(frame: Frame): void {
    const { vertices, referenceCube } = frame.state
    const answer = answerTo(bestPlaceQuestion, frame)
    if (isNew(this.root, answer, referenceCube, this.#moved === vertices, this.#copied))
      render(this.#template(answer, referenceCube), this.root)
  }

  dispose(): void {}

  #template(answer: VertexPlace | null, cube: ReferenceCube): TemplateResult {
    if (answer === null) return html`<p class="answer">${say('There is no verdict, so there is no best place.')}</p>`
    return html`${this.#chooser(answer)}
      <p tabindex="-1" class="answer">${this.#answer(answer)}</p>
      ${this.#move(answer)}${this.#why(answer, cube)}${explanation(answer.place)}`
  }

  #chooser({ places, vertex }: VertexPlace): TemplateResult {
    return html`<p class="says" id="best-place-reach">
        ${say('The greatest relative minimum that each vertex can bring, moved alone:')}
      </p>
      <div class="reach" role="group" aria-labelledby="best-place-reach">
        ${places.map(
          (place, name) => html`<button
            type="button"
            aria-pressed=${name === vertex}
            aria-label=${reachWords(name, place)}
            @click=${() => this.#context.dispatch({ type: 'select-vertex', vertex: name })}
          >
            <b>${name}</b> <span>${reachText(place) ?? '–'}</span>
          </button>`,
        )}
      </div>`
  }

  #answer(answer: VertexPlace): unknown {
    const { place, proof, vertex: name, vertices } = answer
    const moved = this.#moved === vertices ? `${say('The vertex has been moved. Undo takes it back.')} ` : ''
    return [moved, place.measure === 'volume' ? bestWords(answer) : forbiddenWords(name, proof, place)]
  }

  #move({ place, vertex, vertices }: VertexPlace): TemplateResult | '' {
    if (!place.isMoved) return ''
    const { position, measure } = place
    const at = {
      point: copyablePoint(position),
      distance: copyable(formatNumber(distanceBetween(vertexOf(vertices, vertex), position)), String(position)),
    }
    return html`<p class="go">
      <button type="button" @click=${() => this.#moveThere(vertex, position)}>${say('Move there')}</button>
      <span class="says">${
        measure === 'volume'
          ? sayParts('to {point}, {distance} away', at)
          : sayParts('to {point}, {distance} away, where min J is greatest, though not positive', at)
      }</span>
    </p>`
  }

  #why(answer: VertexPlace, cube: ReferenceCube): TemplateResult | '' {
    const { place, proof, holds, vertex: name } = answer
    if (proof === null) return html`<p class="says">${say('The proof follows when this change is done.')}</p>`
    return html`<p>${whyWords(answer)}</p>
      ${holds.length === 0 ? '' : holdsTable(holds, cube, name, place)}
      ${this.#certificate(answer)}`
  }

  #certificate(answer: VertexPlace): TemplateResult | '' {
    const text = certificateOf(answer)
    if (text === null) return ''
    const copied = this.#copied?.of === answer ? this.#copied.isCopied : null
    return html`<p class="go">
        <button type="button" @click=${() => this.#copy(answer, text)}>${copied ? say('Copied') : say('Copy JSON')}</button>
        <button type="button" @click=${() => saveFile('place-certificate.json', text, 'application/json')}>${say('Download')}</button>
        <span aria-live="polite">${copied === false ? say('Copying is not allowed here. Download gives the same.') : ''}</span>
      </p>
      <p class="says">
        ${say('To check the proof without this page:')}
        <code>python3 tests/certificates/check_certificates.py FILE.json</code>
      </p>`
  }

  async #copy(of: VertexPlace, text: string): Promise<void> {
    this.#copied = { of, isCopied: await copyText(text) }
    this.#context.requestFrame()
  }

  /** One step to undo. What is said is new, so the focus moves there. */
  #moveThere(vertex: number, to: Vec3): void {
    this.#context.dispatch({ type: 'select-vertex', vertex })
    this.#context.dispatch({ type: 'move-vertex', vertex, to })
    this.#moved = this.#context.state().vertices
    this.root.querySelector<HTMLElement>('.answer')?.focus({ preventScroll: true })
  }
}

function bestWords({ place, vertex: name }: VertexPlace): unknown {
  const { isMoved, relativeMinimum, presentRelativeMinimum: present } = place
  const number = (value: number | null) =>
    value === null
      ? '–'
      : html`<b class=${value < 0 ? 'negative' : ''}>${copyable(formatNumber(value), String(value))}</b>`
  const after = number(relativeMinimum)
  if (!isMoved) return sayParts('Vertex {name} is at its best place: relative minimum {after}.', { name, after })
  return present === null
    ? sayParts('Vertex {name} alone can bring the relative minimum to {after}.', { name, after })
    : sayParts('Vertex {name} alone can bring the relative minimum from {before} to {after}.', {
        name,
        before: number(present),
        after,
      })
}

function forbiddenWords(name: number, proof: VertexPlace['proof'], { holds }: BestPlace): unknown {
  const count = proof?.isProved ? proof.holds.length : holds.length
  const isProved = proof === null || (proof.isProved && proof.isImpossible)
  if (!isProved) return say('No valid place of vertex {name} was found, and none is ruled out.', { name })
  return count === 1
    ? html`<b>${say('No place of vertex {name} makes this element valid: this point forbids it.', { name })}</b>`
    : html`<b>${say('No place of vertex {name} makes this element valid: these {count} points forbid it.', { name, count })}</b>`
}

/** What the weights mean, and what is proved. */
function whyWords({ place, proof, vertex: name }: VertexPlace): unknown {
  const { measure, holds } = place
  if (!proof?.isProved)
    return say(
      'Not proved: the weights do not cancel exactly. All that is certain is that no relative minimum is above 1.',
    )
  if (holds.length === 0)
    return say('No place is better, proved: the least jacdet is never above its mean, the volume.')
  if (measure === 'volume') {
    const bound = nearestDouble(proof.bound)
    return sayParts(
      'No place is better, proved exactly: with these weights J\u00a0−\u00a0r·volume adds up to the same number at every place, and it is not positive. So no place has more than r = {bound}.',
      { bound: copyable(formatNumber(bound), String(bound)) },
    )
  }
  if (!proof.isImpossible) return say('The weights cancel exactly, but their sum is positive: it forbids nothing.')
  return proof.holds.length === 1
    ? say('Proved exactly: J at this point is the same wherever vertex {name} is, and it is not positive.', { name })
    : say(
        'Proved exactly: with these weights J adds up to the same number at every place, and it is not positive. So J is never positive at all of them.',
      )
}

function holdsTable(
  holds: readonly ShownHold[],
  cube: ReferenceCube,
  name: number,
  { isMoved }: BestPlace,
): TemplateResult {
  return html`<table aria-label=${say('Points that forbid a better place of vertex {name}', { name })}>
    <thead>
      <tr>
        <th scope="col"><span class="said">${say('Point')}</span></th>
        <th scope="col">${say('weight')}</th>
        <th scope="col">(ξ, η, ζ)</th>
        <th scope="col">${isMoved ? say('J now') : 'J'}</th>
        ${isMoved ? html`<th scope="col">${say('J there')}</th>` : ''}
      </tr>
    </thead>
    <tbody>
      ${holds.map(({ letter, weight, now, there }) =>
        now === null
          ? html`<tr><th scope="row">${letter}</th><td>${weightText(weight)}</td><td colspan="3">${say('a side of the box')}</td></tr>`
          : html`<tr>
              <th scope="row">${letter}</th>
              <td>${weightText(weight)}</td>
              <td>${copyablePoint(now.point)}</td>
              <td>${jacdetOf(now, cube)}</td>
              ${isMoved ? html`<td>${there && jacdetOf(there, cube)}</td>` : ''}
            </tr>`,
      )}
    </tbody>
  </table>`
}

function jacdetOf({ jacdet, exponent }: JacobianReport, cube: ReferenceCube): TemplateResult {
  return copyableJacdet(jacdet, exponent, cube)
}

function weightText(weight: number | null): TemplateResult | '' {
  return weight === null ? '' : copyable(shortWeight(weight), String(weight))
}

function shortWeight(weight: number): string {
  return weight < 0.0005 ? '<0.001' : weight.toFixed(3)
}

function explanation({ unitExponent }: BestPlace): TemplateResult {
  const half = 2 ** (BOX_BITS + unitExponent)
  return html`<details>
    <summary>${say('What is certain, and why')}</summary>
    <p>
      ${say('The relative minimum is the least jacdet over the volume: 1 of a box, 0 or less of an invalid element. The best place has the greatest one, to one part in a million. Of several it is the nearest.')}
    </p>
    <p>
      ${say('While the other seven vertices stay, J at a point of the element is an affine function of the place, and so is the volume. So the places with at least r > 0 form a convex set, and at most four points forbid a greater r.')}
    </p>
    <p>
      ${sayParts('Places are sought up to {half} away on each axis. Derivation and limits: {document}.', {
        half: copyable(formatNumber(half), String(half)),
        document: html`<code>docs/repair.md</code>`,
      })}
    </p>
  </details>`
}

/** Half side of the box of places, in units of 2^unitExponent: docs/repair.md (R14). */
const BOX_BITS = 20

function reachText(place: BestPlace | null): string | null {
  if (place?.measure !== 'volume' || place.relativeMinimum === null) return null
  return place.relativeMinimum < 0.01 ? '<0.01' : place.relativeMinimum.toFixed(2)
}

function reachWords(name: number, place: BestPlace | null): string {
  const value = reachText(place)
  return value === null
    ? say('Vertex {name}, no valid place', { name })
    : say('Vertex {name}, at best {value}', { name, value })
}

function certificateOf({ vertex, star, place, proof }: VertexPlace): string | null {
  const json = proof && placeCertificateJson(`vertex ${vertex}`, ['hexahedron'], star, place, proof)
  return json && `[\n${JSON.stringify(json)}\n]\n`
}

function distanceBetween(a: Vec3, b: Vec3): number {
  return Math.hypot(...a.map((x, axis) => x - (b[axis] as number)))
}

export const create: CreateView = context => new BestPlaceView(context)
