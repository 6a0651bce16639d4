/**
 * The tree in an element's shadow root, and the views in it. The views are made when the element is
 * first seen, the slow ones step by step in later frames, and no two elements of a page make theirs
 * in the same frame.
 */
import { html, render } from 'lit-html'
import type { Cameras } from '../model/state'
import type { Panel } from '../panels/panel'
import { adoptStyles } from '../panels/style-sheets'
import marks from '../scene/overlay/marks.css?inline'
import said from '../views/said.css?inline'
import type { Figure, FigureName, Frame, View, ViewContext } from '../views/view'
import { BelowPicture } from './below-picture'
import css from './hex-lens.css?inline'
import printing from './printing.css?inline'
import { UpdateQueue } from './update-queue'

/** The time of the last frame that made views, of all elements on the page. */
let madeAt = -1

/** Pages may style its parts. */
const tree = html`<div class="element">
  <div class="lens" part="lens">
    <div class="head" part="head"></div>
    <div class="stage" part="stage"></div>
    <div class="side" part="panels">
      <div class="panel"></div>
      <div class="fold details"></div>
      <div class="folds"></div>
    </div>
  </div>
  <div class="before" part="fallback"><img alt="" part="poster" hidden /><slot></slot></div>
  <div class="caption" part="caption"><slot name="caption"></slot></div>
</div>`

export class ViewHost {
  /** The box around all that is the element's own. */
  readonly lens: HTMLElement
  /** The boxes that scroll. */
  readonly scrollers: readonly HTMLElement[]
  readonly #context: ViewContext
  readonly #regions: Readonly<Record<Panel['region'], HTMLElement>>
  /** The poster, and the content between the tags, until the views are made. */
  readonly #before: HTMLElement
  readonly #poster: HTMLImageElement
  readonly #below: BelowPicture
  #views: readonly View[] = []
  /** Slow views join the others in the next frame: making and drawing them take one each. */
  #made: readonly { readonly panel: Panel; readonly view: View }[] = []
  /** Panels to be made in the next frame, in the one after it, … */
  #unmade: readonly (readonly Panel[])[] = []
  /** True if `prepare` of the panels that are next has been called. */
  #isPrepared = false
  /** True if the last frame had a number, or none will come: slow views wait for that. */
  #isAnswered = false
  #queue = new UpdateQueue()

  constructor(shadow: ShadowRoot, context: ViewContext, panels: readonly Panel[]) {
    this.#context = context
    adoptStyles(shadow, [css, said, marks, ...panels.map(panel => panel.styles), printing])
    render(tree, shadow)
    const box = (name: string) => shadow.querySelector(`.${name}`) as HTMLElement
    this.lens = box('lens')
    this.#regions = { head: box('head'), stage: box('stage'), panel: box('panel'), folds: box('folds') }
    this.scrollers = [box('side'), box('panel'), box('folds'), this.lens]
    this.#before = box('before')
    this.#below = new BelowPicture(this.lens, box('stage'), box('details'))
    this.#poster = shadow.querySelector('img') as HTMLImageElement
  }

  /** True if everything is made and up to date. */
  get isComplete(): boolean {
    return !this.isUnmade && !this.#queue.isWaiting && !this.#views.some(view => view.isLoading)
  }

  get isUnmade(): boolean {
    return this.#unmade.length > 0 || this.#made.length > 0
  }

  /** True if a frame is due although nothing is new. */
  get isWaiting(): boolean {
    const isHeld = this.#views.length > 0 && !this.#isAnswered
    return (this.isUnmade && !isHeld) || this.#queue.isWaiting
  }

  begin(shown: readonly Panel[]): void {
    this.end()
    this.#unmade = [shown.filter(panel => !panel.prepare), shown.filter(panel => panel.prepare)]
    const panels = shown.filter(panel => panel.region === 'panel' || panel.region === 'folds')
    const has = (region: Panel['region']) => shown.some(panel => panel.region === region)
    this.lens.classList.toggle('has-panel', panels.length > 0)
    this.lens.classList.toggle('has-folds', has('folds'))
    const isVerdicts = (panel: Panel) => panel.name === 'verdict' || panel.with === 'verdict'
    this.lens.classList.toggle('has-stage', has('stage'))
    this.#below.begin(has('stage'), panels.length > 0, panels.length > 0 && panels.every(isVerdicts))
  }

  end(): void {
    this.#below.end()
    for (const view of [...this.#views, ...this.#made.map(({ view }) => view)]) {
      view.dispose()
      view.root.remove()
    }
    this.#views = []
    this.#made = []
    this.#unmade = []
    this.#isPrepared = false
    this.#queue = new UpdateQueue()
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

  /** `isNews`: something is new since the last frame; `time` is the frame's. */
  draw(frame: Frame, isNews: boolean, time: number): void {
    this.#below.draw()
    const isMade = this.#make(frame, time)
    for (const update of this.#queue.due(this.#views, isNews || isMade, frame.state.gestureStart !== null)) {
      try {
        update(frame)
      } catch (bug) {
        reportError(bug) // one view's bug must not take the others' numbers away
      }
    }
    // Once it has gone it stays away: views that are made anew take no longer than a frame or two.
    this.#before.hidden ||= !this.isUnmade
  }

  cameras(): Cameras | null {
    return this.#views.reduce<Cameras | null>((found, view) => found ?? view.cameras?.() ?? null, null)
  }

  showMinimum(): void {
    for (const view of this.#views) view.showMinimum?.()
  }

  figure(name: FigureName): Figure | null {
    return this.#views.reduce<Figure | null>((found, view) => found ?? view.figure?.(name) ?? null, null)
  }

  /** Makes the views that are due, one element a frame; slow ones come after the first number. */
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
    this.#made = due.map(panel => ({ panel, view: panel.create(this.#context) }))
    this.#unmade = later
    if (!isSlow) this.#join()
    return joins || !isSlow
  }

  #join(): void {
    for (const { panel, view } of this.#made) {
      view.root.part.add(panel.name)
      this.#regions[panel.region].append(view.root)
    }
    this.#views = [...this.#views, ...this.#made.map(({ view }) => view)]
    this.#made = []
  }
}
