/**
 * What is seen of an element: the tree in its shadow root and the views in it. The views are made when the element is first seen, the
 * slow ones in later frames and piece by piece, and no two elements of a page make theirs in the same frame.
 */
import type { Cameras } from '../model/state'
import type { Panel } from '../panels/panel'
import { adoptStyles } from '../panels/style-sheets'
import marks from '../scene/overlay/marks.css?inline'
import said from '../views/said.css?inline'
import type { Figure, FigureName, Frame, View, ViewHost } from '../views/view'
import css from './hex-lens.css?inline'
import printing from './printing.css?inline'
import { Turns } from './turns'

/** When an element last made views: all frames at one time are one frame of the page. */
let madeAt = -1

export class Show {
  /** Around all that is the element's own. */
  readonly lens = place('lens')
  readonly #host: ViewHost
  readonly #places = { head: place('head'), stage: place('stage'), panel: inner('panel'), folds: inner('folds') }
  /** The poster, and what stands between the tags, until there is something better. */
  readonly #before = place('before', 'fallback')
  readonly #poster = document.createElement('img')
  #views: readonly View[] = []
  /** Slow ones, which join the others in the next frame: to make and to draw them are a frame's work each. */
  #made: readonly { readonly panel: Panel; readonly view: View }[] = []
  /** Panels to be made in the next frame, in the one after it, … */
  #unmade: readonly (readonly Panel[])[] = []
  /** Of the panels that are next: whether what they need has been asked for. */
  #isPrepared = false
  /** Whether the last frame had a number, or none will come: the slow ones wait for that. */
  #isAnswered = false
  #turns = new Turns()

  constructor(shadow: ShadowRoot, host: ViewHost, panels: readonly Panel[]) {
    this.#host = host
    adoptStyles(shadow, [css, said, marks, ...panels.map(panel => panel.styles), printing])
    const { head, stage, panel, folds } = this.#places
    const frame = inner('frame')
    const side = place('side', 'panels')
    const caption = place('caption')
    this.#poster.alt = ''
    this.#poster.hidden = true
    this.#poster.part.add('poster')
    this.#before.append(this.#poster, document.createElement('slot'))
    caption.append(Object.assign(document.createElement('slot'), { name: 'caption' }))
    side.append(panel, folds)
    this.lens.append(head, stage, side)
    frame.append(this.lens, this.#before, caption)
    shadow.append(frame)
  }

  /** Whether everything is made and up to date. */
  get isComplete(): boolean {
    return !this.isUnmade && !this.#turns.isWaiting && !this.#views.some(view => view.isLoading)
  }

  get isUnmade(): boolean {
    return this.#unmade.length > 0 || this.#made.length > 0
  }

  /** Whether a frame is due although nothing is new. */
  get isWaiting(): boolean {
    const isHeld = this.#views.length > 0 && !this.#isAnswered
    return (this.isUnmade && !isHeld) || this.#turns.isWaiting
  }

  begin(shown: readonly Panel[]): void {
    this.end()
    this.#unmade = [shown.filter(panel => !panel.prepare), shown.filter(panel => panel.prepare)]
    const panels = shown.filter(panel => panel.place === 'panel' || panel.place === 'folds')
    this.lens.classList.toggle('has-panel', panels.length > 0)
    this.lens.classList.toggle(
      'has-folds',
      panels.some(panel => panel.place === 'folds'),
    )
    this.lens.classList.toggle('has-line', panels.length === 1 && panels[0]?.name === 'verdict')
    this.lens.classList.toggle(
      'has-stage',
      shown.some(panel => panel.place === 'stage'),
    )
  }

  end(): void {
    for (const view of [...this.#views, ...this.#made.map(({ view }) => view)]) {
      view.dispose()
      view.root.remove()
    }
    this.#views = []
    this.#made = []
    this.#unmade = []
    this.#isPrepared = false
    this.#turns = new Turns()
  }

  setPoster(address: string | null): void {
    this.#poster.hidden = address === null
    if (address === null) this.#poster.removeAttribute('src')
    else this.#poster.src = address
  }

  setLabel(label: string | null): void {
    if (label === null) for (const name of ['role', 'aria-label']) this.lens.removeAttribute(name)
    else {
      this.lens.setAttribute('role', 'group')
      this.lens.setAttribute('aria-label', label)
    }
  }

  /** `isNews` says whether there is anything new since the last frame, `time` is the frame's. */
  draw(frame: Frame, isNews: boolean, time: number): void {
    const isMade = this.#make(frame, time)
    for (const turn of this.#turns.due(this.#views, isNews || isMade, frame.state.gestureStart !== null)) {
      try {
        turn(frame)
      } catch (bug) {
        reportError(bug) // one view's bug must not take the others' numbers away
      }
    }
    this.#before.hidden = !this.isUnmade
  }

  cameras(): Cameras | null {
    return this.#views.reduce<Cameras | null>((found, view) => found ?? view.cameras?.() ?? null, null)
  }

  figure(name: FigureName): Figure | null {
    return this.#views.reduce<Figure | null>((found, view) => found ?? view.figure?.(name) ?? null, null)
  }

  /** Makes what is due in this frame, unless another element has made its own in it. What is slow comes after the first number. */
  #make({ report, problems }: Frame, time: number): boolean {
    const joins = this.#made.length > 0
    this.#join()
    const isHeld = this.#views.length > 0 && !this.#isAnswered
    this.#isAnswered = report !== null || problems.some(({ code }) => code === 'core-failed')
    if (this.#unmade.length === 0 || isHeld || madeAt === time) return joins
    madeAt = time
    const [due = [], ...later] = this.#unmade
    const isSlow = due.some(panel => panel.prepare)
    if (isSlow && !this.#isPrepared) {
      for (const panel of due) panel.prepare?.()
      this.#isPrepared = true
      return joins
    }
    this.#made = due.map(panel => ({ panel, view: panel.create(this.#host) }))
    this.#unmade = later
    if (!isSlow) this.#join()
    return joins || !isSlow
  }

  #join(): void {
    for (const { panel, view } of this.#made) {
      view.root.part.add(panel.name)
      this.#places[panel.place].append(view.root)
    }
    this.#views = [...this.#views, ...this.#made.map(({ view }) => view)]
    this.#made = []
  }
}

/** A box that pages may style as a part. */
function place(name: string, part = name): HTMLElement {
  const element = inner(name)
  element.part.add(part)
  return element
}

function inner(name: string): HTMLElement {
  const element = document.createElement('div')
  element.className = name
  return element
}
