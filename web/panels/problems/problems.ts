/** What keeps the page from its full work, said in sentences that stay until they are no longer true or are dismissed. */
import { html, render } from 'lit-html'
import type { CreateView, Frame, Problem, View, ViewHost } from '../../views/view'
import css from './problems.css?inline'

export const problemsStyles = css

/** Those that concern something that happened, not something that still is. */
const dismissible: ReadonlySet<Problem['code']> = new Set(['link-broken', 'input-refused'])

class ProblemsView implements View {
  readonly root = document.createElement('div')
  readonly #host: ViewHost

  constructor(host: ViewHost) {
    this.#host = host
    this.root.className = 'problems'
    this.root.setAttribute('role', 'alert')
  }

  update({ problems }: Frame): void {
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
  }

  dispose(): void {}
}

export const createProblems: CreateView = host => new ProblemsView(host)
