/** The way between two elements: the boundary minimum, and doubles where the verdict changes. */
import { html, render, type TemplateResult } from 'lit-html'
import type { Report } from '../../core/report'
import { formatJacdet } from '../../model/decimal'
import type { Vertices } from '../../model/hexahedron'
import { type ReferenceCube, sliceChange, sliceOf } from '../../model/state'
import { elementAt, tauOf } from '../../model/way'
import { copyable, copyableJacdet } from '../../views/copyable'
import { isNew } from '../../views/is-new'
import type { CreateView, Frame, View, ViewContext } from '../../views/view'
import { type PlainWord, say } from '../../words/say'
import { answerTo } from '../panel'
import css from './morph.css?inline'
import type { Morph } from './morph-answer'
import { MorphGraph } from './morph-graph'
import { type Ends, endsSlice, type Follows, morphQuestion, type Way } from './morph-question'

export const styles = css

type End = keyof Ends

const STEP = 0.001
/** Milliseconds from A to B. */
const PLAYING_TIME = 5000
/** Milliseconds that one frame counts at most: a page that was hidden goes on where it was. */
const LONGEST_FRAME = 100
/** Places that readers see who want little motion. */
const STILL_PLACES = 8
const ENDS: readonly { readonly end: End; readonly name: string }[] = [
  { end: 'morphA', name: 'A' },
  { end: 'morphB', name: 'B' },
]
const FOLLOWS: Readonly<Record<Follows, PlainWord>> = {
  start: 'the element that Reset goes back to',
  box: 'the box around the element',
  element: 'the element as it is',
  dented: 'the element with vertex 6 pushed in',
}

class MorphView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  readonly #graph = new MorphGraph()
  #morph: Way | null = null
  #tau = 1
  #isSliding = false
  /** The animation frame that is asked for, while the element plays. */
  #playing: number | null = null

  constructor(context: ViewContext) {
    this.#context = context
    this.root.className = 'morph'
  }

  update(frame: Frame): void {
    const { state, report } = frame
    const morph = answerTo(morphQuestion, frame)
    if (!state.openPanels.includes('morph')) {
      this.#commit()
      return
    }
    this.#morph = morph
    this.root.hidden = morph === null
    if (morph === null || report === null) return
    const here = tauOf(morph.a, morph.b, state.vertices, this.#tau)
    if (here !== null) this.#tau = here
    this.#graph.update(morph, here, state.referenceCube)
    const ends = sliceOf(endsSlice, state)
    if (
      !isNew(
        this.root,
        morph,
        here,
        report,
        ends,
        state.referenceCube,
        state.gestureStart === null,
        this.#playing === null,
      )
    )
      return
    render(
      html`<div>${this.#endsOf(ends, morph)}</div>
        ${this.#graph.root}
        <div>${this.#slider(here, report, state.referenceCube)}</div>
        <div>${this.#crossings(morph, here)}</div>`,
      this.root,
    )
  }

  dispose(): void {
    this.#commit()
  }

  #endsOf(ends: Ends, { follows }: Way): TemplateResult {
    return html`<dl>
        ${ENDS.map(
          ({ end, name }, i) => html`<div>
            <dt>${name}</dt>
            <dd>${say(ends[end] === null ? FOLLOWS[follows[i] as Follows] : 'kept')}</dd>
            <dd><button type="button" @click=${() => this.#keep(end, this.#context.state().vertices)}>${say('Keep as {name}', { name })}</button></dd>
          </div>`,
        )}
      </dl>
      ${
        ends.morphA === null && ends.morphB === null
          ? ''
          : html`<p><button type="button" @click=${() => this.#forget()}>${say('Forget both')}</button></p>`
      }`
  }

  #slider(here: number | null, report: Report, cube: ReferenceCube): TemplateResult {
    const { valid: isValid, boundaryMinimum, exponent } = report
    const minimum = formatJacdet(boundaryMinimum, exponent, cube)
    const verdict = isValid ? say('valid') : say('invalid')
    const text =
      here === null
        ? say('not on the way')
        : say('{place}, {verdict}, minimum {minimum}', { place: here, verdict, minimum })
    return html`<label class="slide">
        <input
          type="range"
          min="0"
          max="1"
          step=${STEP}
          .value=${String(this.#tau)}
          aria-label=${say('Place between A and B')}
          aria-valuetext=${text}
          @input=${(event: Event) => this.#slideTo((event.target as HTMLInputElement).valueAsNumber)}
          @change=${() => this.#commit()}
          @blur=${() => this.#commit()}
          @keydown=${(event: KeyboardEvent) => this.#onKey(event)}
        />
      </label>
      <p class="place">
        <button type="button" @click=${() => this.#playOrPause(here)} @keydown=${(event: KeyboardEvent) => this.#onKey(event)}>
          ${this.#playing === null ? say('Play') : say('Pause')}
        </button>
        ${
          here === null
            ? say('The element is not on the way from A to B. Move the slider to put it there.')
            : html`τ = <b>${copyable(String(here), String(here))}</b>
              <span class="says">${verdict}, min J = ${copyableJacdet(boundaryMinimum, exponent, cube)}</span>`
        }
      </p>`
  }

  #crossings({ a, b, samples, crossings }: Morph, here: number | null): TemplateResult {
    if (a === b || a.every((value, i) => Object.is(value, b[i])))
      return html`<p class="note">${say('A and B are the same element. Move a vertex, or keep this one as A and choose another preset.')}</p>`
    if (crossings.length === 0)
      return html`<p class="note">
        ${samples[0]?.valid ? say('Valid at every place tried from A to B: no change of the verdict was found.') : say('Invalid at every place tried from A to B: no change of the verdict was found.')}
      </p>`
    return html`<table aria-label=${say('Where the verdict changes')}>
        <tbody>
          ${crossings.map(
            ({ validTau, invalidTau }, i) =>
              html`${this.#crossing(say('Last valid'), validTau, crossings.length > 1 ? i + 1 : 0, here)}
              ${this.#crossing(say('First invalid'), invalidTau, crossings.length > 1 ? i + 1 : 0, here)}`,
          )}
        </tbody>
      </table>
      <p class="note">
        ${say('No double lies between the last valid and the first invalid τ, and each verdict is exact. The element at τ is A + τ (B − A), with every coordinate in doubles.')}
      </p>`
  }

  #crossing(name: string, tau: number, number: number, here: number | null): TemplateResult {
    return html`<tr>
      <th scope="row">
        <button
          type="button"
          class="on-paper"
          aria-label=${number > 0 ? say('{name}, change {number}', { name, number }) : name}
          aria-pressed=${tau === here}
          @click=${() => this.#jump(tau)}
        >
          ${name}
        </button>
      </th>
      <td>τ = ${copyable(String(tau), String(tau))}</td>
    </tr>`
  }

  #keep(end: End, vertices: Vertices | null): void {
    this.#context.dispatch(sliceChange(endsSlice, { [end]: vertices }))
  }

  #forget(): void {
    for (const { end } of ENDS) this.#keep(end, null)
    this.root.querySelector('button')?.focus()
  }

  /** The ends no longer follow the element, or the way would change under the slider. */
  #hold({ a, b }: Morph): void {
    const { morphA, morphB } = sliceOf(endsSlice, this.#context.state())
    if (morphA === null) this.#keep('morphA', a)
    if (morphB === null) this.#keep('morphB', b)
  }

  #slideTo(tau: number): void {
    this.#halt()
    const morph = this.#morph
    if (morph === null) return
    this.#begin(morph)
    this.#moveTo(morph, tau)
  }

  #begin(morph: Morph): void {
    if (this.#isSliding) return
    this.#hold(morph)
    this.#context.dispatch({ type: 'begin-gesture' })
    this.#isSliding = true
  }

  /** From where the element is to B, or all the way again; one step to undo. */
  #playOrPause(here: number | null): void {
    const morph = this.#morph
    if (this.#playing !== null || morph === null) {
      this.#commit()
      this.#context.requestFrame()
      return
    }
    this.#begin(morph)
    const places = matchMedia('(prefers-reduced-motion: reduce)').matches ? STILL_PLACES : 1 / STEP
    let played = here === null || here === 1 ? 0 : here
    let before: number | null = null
    let placed: Vertices | null = null
    const play = (time: number) => {
      if (placed !== null && this.#context.state().vertices !== placed) {
        this.#halt()
        this.#isSliding = false // something else has moved the element, and ended the gesture
        this.#context.requestFrame()
        return
      }
      played += before === null ? 0 : Math.min(time - before, LONGEST_FRAME) / PLAYING_TIME
      before = time
      const tau = Math.min(1, Math.floor(played * places) / places)
      if (placed === null || tau !== this.#tau) this.#moveTo(morph, tau)
      placed = this.#context.state().vertices
      if (tau < 1) this.#playing = requestAnimationFrame(play)
      else this.#commit()
    }
    this.#playing = requestAnimationFrame(play)
    this.#context.requestFrame()
  }

  #halt(): void {
    if (this.#playing !== null) cancelAnimationFrame(this.#playing)
    this.#playing = null
  }

  #jump(tau: number): void {
    const morph = this.#morph
    if (morph === null) return
    this.#commit()
    this.#hold(morph)
    this.#moveTo(morph, tau)
  }

  #moveTo({ a, b }: Morph, tau: number): void {
    this.#tau = tau
    this.#context.dispatch({ type: 'move-all', vertices: elementAt(a, b, tau) })
  }

  #commit(): void {
    this.#halt()
    if (!this.#isSliding) return
    this.#isSliding = false
    this.#context.dispatch({ type: 'commit-gesture' })
  }

  #onKey(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || !this.#isSliding) return
    this.#halt()
    this.#isSliding = false
    this.#context.dispatch({ type: 'cancel-gesture' })
    event.preventDefault()
  }
}

export const create: CreateView = context => new MorphView(context)
