/**
 * A panel that is closed at first: its heading is the button that opens it, and only then is its
 * code loaded. A closed panel's view is not updated, but for the frame that closes it, in which the
 * view can stop its timers.
 */
import { html, render } from 'lit-html'
import type { Action, State } from '../model/state'
import type { CreateView, Figure, FigureName, Frame, Update, View, ViewContext } from '../views/view'
import { type PlainWord, say } from '../words/say'
import type { Panel } from './panel'
import { adoptStyles } from './style-sheets'

export interface FoldContent {
  readonly create: CreateView
  readonly styles: string
}

export interface FoldOptions {
  readonly name: string
  /** In English; one that is in the list of words is said in the language of the page. */
  readonly title: string
  readonly load: () => Promise<FoldContent>
  /** What the reader's opening or closing changes besides. */
  readonly toggled?: (state: State, isOpen: boolean) => Action
}

export function fold(options: FoldOptions) {
  const create: CreateView = context => new Fold(context, options)
  return { name: options.name, region: 'folds', opens: true, create, styles: '' } as const satisfies Panel
}

class Fold implements View {
  readonly root = document.createElement('section')
  isLoading = false
  readonly #context: ViewContext
  readonly #options: FoldOptions
  #updates: readonly Update[] = [frame => this.#updateView(frame)]
  #isOpen = false
  #isAsked = false
  #failure = ''
  #isDisposed = false
  #view: View | null = null

  constructor(context: ViewContext, options: FoldOptions) {
    this.#context = context
    this.#options = options
    this.root.className = 'fold'
    this.root.setAttribute('aria-label', say(options.title as PlainWord))
    this.#render()
  }

  get updates(): readonly Update[] {
    return this.#isOpen ? this.#updates : []
  }

  update(frame: Frame): void {
    const wasOpen = this.#isOpen
    this.#isOpen = frame.state.openPanels.includes(this.#options.name)
    if (this.#isOpen === wasOpen) return
    this.#render()
    if (wasOpen) this.#view?.update(frame)
  }

  #render(): void {
    const { name, title } = this.#options
    const id = `panel-${name}`
    render(
      html`<h2><button type="button" class="on-paper" aria-expanded=${this.#isOpen} aria-controls=${id} @click=${() => this.#toggle()}>${say(title as PlainWord)}</button></h2>
        <div id=${id} ?hidden=${!this.#isOpen}>${this.#view?.root ?? this.#failure}</div>`,
      this.root,
    )
  }

  #toggle(): void {
    const { name, toggled } = this.#options
    const isOpen = !this.#isOpen
    this.#context.dispatch({ type: 'open-panel', panel: name, isOpen })
    if (toggled) this.#context.dispatch(toggled(this.#context.state(), isOpen))
  }

  #updateView(frame: Frame): void {
    if (this.#view) this.#view.update(frame)
    else if (!this.#isAsked) void this.#fill()
  }

  figure(name: FigureName): Figure | null {
    return (this.#isOpen && this.#view?.figure?.(name)) || null
  }

  dispose(): void {
    this.#isDisposed = true
    this.#view?.dispose()
  }

  async #fill(): Promise<void> {
    this.#isAsked = true
    this.isLoading = true
    try {
      const { create, styles } = await this.#options.load()
      if (this.#isDisposed) return
      adoptStyles(this.root.getRootNode() as ShadowRoot, [styles])
      this.#view = create(this.#context)
      this.#updates = [...this.#updates, ...(this.#view.updates ?? [])]
    } catch (reason) {
      const why = reason instanceof Error ? reason.message : String(reason)
      this.#failure = say('This panel could not be loaded ({why}). Reload the page to try again.', { why })
    }
    this.isLoading = false
    this.#render()
    this.#context.requestFrame()
  }
}
