/** What keeps the page from its full work, said in sentences that stay until they are no longer true or are dismissed. */
import { html, render } from 'lit-html'
import type { CreateView, Frame, Problem, View, ViewHost } from '../../views/view'
import css from './problems.css?inline'

export const problemsStyles = css

/** Those that concern something that happened, not something that still is. */
const dismissible: ReadonlySet<Problem['code']> = new Set(['link-broken', 'input-refused', 'not-read'])

class ProblemsView implements View {
  readonly root = document.createElement('div')
  readonly #host: ViewHost
  #refusal: Problem | null = null

  constructor(host: ViewHost) {
    this.#host = host
    this.root.className = 'problems'
    this.root.setAttribute('role', 'alert')
  }

  update({ problems }: Frame): void {
    const refusal = problems.find(({ code }) => code === 'not-read') ?? null
    const isNew = refusal !== null && refusal !== this.#refusal
    this.#refusal = refusal
    render(
      problems.map(
        problem => html`<p>
          <span>${problem.message}</span>
          ${
            dismissible.has(problem.code)
              ? html`<button type="button" @click=${() => this.#host.clear(problem.code)}>Dismiss</button>`
              : null
          }
        </p>`,
      ),
      this.root,
    )
    if (isNew && !this.#isReadWhereAsked()) this.root.scrollIntoView({ block: 'nearest' })
  }

  /** The panel from which something was to be read says the same. */
  #isReadWhereAsked(): boolean {
    const { activeElement } = this.root.getRootNode() as ShadowRoot
    return activeElement?.closest('.paste') != null
  }

  dispose(): void {}
}

export const createProblems: CreateView = host => new ProblemsView(host)
