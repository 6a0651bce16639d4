/** Problems, as sentences that stay until they are no longer true or are dismissed. */
import { html, nothing, render } from 'lit-html'
import type { CreateView, Frame, Problem, View, ViewContext } from '../../views/view'
import { say } from '../../words/say'
import css from './problems.css?inline'

export const problemsStyles = css

/** Problems that happened once, and are dismissed; others last as long as their cause. */
const dismissible: ReadonlySet<Problem['code']> = new Set(['link-broken', 'input-refused', 'not-read'])

class ProblemsView implements View {
  readonly root = document.createElement('div')
  readonly #context: ViewContext
  #refusal: Problem | null = null

  constructor(context: ViewContext) {
    this.#context = context
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
          <span lang=${problem.code === 'not-read' ? 'en' : nothing}>${problem.message}</span>
          ${
            dismissible.has(problem.code)
              ? html`<button type="button" @click=${() => this.#context.clear(problem.code)}>${say('Dismiss')}</button>`
              : null
          }
        </p>`,
      ),
      this.root,
    )
    if (isNew && !this.#isReadWhereAsked()) this.root.scrollIntoView({ block: 'nearest' })
  }

  /** The panel `paste` says the same. */
  #isReadWhereAsked(): boolean {
    const { activeElement } = this.root.getRootNode() as ShadowRoot
    return activeElement?.closest('.paste') != null
  }

  dispose(): void {}
}

export const createProblems: CreateView = context => new ProblemsView(context)
