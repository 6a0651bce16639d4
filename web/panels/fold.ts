/**
 * A panel that is closed at first: its heading is the button that opens it, and only then is its code loaded. While it is
 * closed its view is not updated, but for the frame that closes it, in which the view can stop what it has going.
 */
import type { CreateView, Figure, FigureName, Frame, Turn, View, ViewHost } from '../views/view'
import type { Panel } from './panel'
import { adoptStyles } from './style-sheets'

export interface FoldContent {
  readonly create: CreateView
  readonly styles: string
}

export interface FoldOptions {
  readonly name: string
  readonly title: string
  readonly load: () => Promise<FoldContent>
}

export function fold({ name, title, load }: FoldOptions) {
  const create: CreateView = host => new Fold(host, { name, title, load })
  return { name, place: 'folds', opens: true, create, styles: '' } as const satisfies Panel
}

class Fold implements View {
  readonly root = document.createElement('section')
  isLoading = false
  readonly #host: ViewHost
  readonly #name: string
  readonly #load: () => Promise<FoldContent>
  readonly #button = document.createElement('button')
  readonly #body = document.createElement('div')
  #turns: readonly Turn[] = [frame => this.#updateView(frame)]
  #isOpen = false
  #isAsked = false
  #isDisposed = false
  #view: View | null = null

  constructor(host: ViewHost, { name, title, load }: FoldOptions) {
    this.#host = host
    this.#name = name
    this.#load = load
    this.root.className = 'fold'
    this.root.setAttribute('aria-label', title)
    this.#button.type = 'button'
    this.#button.className = 'on-paper'
    this.#button.textContent = title
    this.#button.setAttribute('aria-expanded', 'false')
    this.#button.setAttribute('aria-controls', `panel-${name}`)
    this.#button.addEventListener('click', () =>
      host.dispatch({ type: 'open-panel', panel: name, isOpen: !this.#isOpen }),
    )
    this.#body.id = `panel-${name}`
    this.#body.hidden = true
    const heading = document.createElement('h2')
    heading.append(this.#button)
    this.root.append(heading, this.#body)
  }

  get turns(): readonly Turn[] {
    return this.#isOpen ? this.#turns : []
  }

  update(frame: Frame): void {
    const wasOpen = this.#isOpen
    this.#isOpen = frame.state.openPanels.includes(this.#name)
    this.#button.setAttribute('aria-expanded', String(this.#isOpen))
    this.#body.hidden = !this.#isOpen
    if (wasOpen && !this.#isOpen) this.#view?.update(frame)
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
      const { create, styles } = await this.#load()
      if (this.#isDisposed) return
      adoptStyles(this.root.getRootNode() as ShadowRoot, [styles])
      this.#view = create(this.#host)
      this.#turns = [...this.#turns, ...(this.#view.turns ?? [])]
      this.#body.replaceChildren(this.#view.root)
    } catch (reason) {
      this.#body.textContent = `This panel could not be loaded (${reason instanceof Error ? reason.message : reason}). Reload the page to try again.`
    }
    this.isLoading = false
    this.#host.requestFrame()
  }
}
