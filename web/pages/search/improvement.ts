/** An element that is polished, or climbed from, in a worker. Stopping keeps the best so far. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { formatNumber } from '../../model/decimal'
import type { Vertices } from '../../model/hexahedron'
import type { Query } from './engine/query'
import { climbed, polished, type SearchWorkers } from './engine/search'
import { thousands } from './found'
import { isSame } from './kept'

export interface ImprovementRequest {
  readonly kind: 'polish' | 'climb'
  readonly query: Query
  readonly vertices: Vertices
  readonly name: string
}

const NOUNS = { polish: 'polishing', climb: 'climbing' } as const
const DONE = { polish: 'Polished', climb: 'Climbed' } as const
const BETTER = { polish: 'simpler', climb: 'more extreme' } as const

export class Improvement {
  readonly request: ImprovementRequest
  readonly #controller = new AbortController()
  #best: Vertices
  #extremeness: number | null = null
  #steps = 0
  #tried = 0

  constructor(request: ImprovementRequest) {
    this.request = request
    this.#best = request.vertices
  }

  /** Steps to something better, each from the one before. */
  get steps(): number {
    return this.#steps
  }

  /** Elements that were tried for them; 0 where nobody counts. */
  get tried(): number {
    return this.#tried
  }

  get best(): Vertices {
    return this.#best
  }

  /** The measure of the best in a climb. */
  get extremeness(): number | null {
    return this.#extremeness
  }

  stop(): void {
    this.#controller.abort()
  }

  /** Resolves at the end or when it is stopped; rejects if the worker fails. */
  async run(workers: SearchWorkers, onProgress: () => void): Promise<void> {
    const { kind, query, vertices } = this.request
    const { signal } = this.#controller
    try {
      if (kind === 'polish') {
        const onStep = (better: { readonly vertices: Vertices }) => {
          this.#best = better.vertices
          this.#steps += 1
          onProgress()
        }
        await polished(query, vertices, workers, { signal, onStep })
      } else {
        const onStep = (progress: Awaited<ReturnType<typeof climbed>>) => {
          this.#best = progress.vertices
          this.#extremeness = progress.extremeness
          this.#steps = progress.steps
          this.#tried = progress.tried
          onProgress()
        }
        onStep(await climbed(query, vertices, workers, { signal, onStep }))
      }
    } catch (reason) {
      if (!signal.aborted) throw reason
    }
  }
}

export interface ImprovementButton {
  readonly request: ImprovementRequest
  readonly label: string
  /** A longer name, where the label does not say of which element. */
  readonly name?: string
  readonly isPossible: boolean
  /** The one that is under way, and the last one that ended. */
  readonly improvement: Improvement | null
  readonly ended: Improvement | null
  onStart(request: ImprovementRequest): void
}

/** One button, which keeps the focus: it begins, and it stops what it began. */
export function improvementButton(props: ImprovementButton): TemplateResult {
  const { request, label, name, isPossible, improvement, ended, onStart } = props
  const { kind, vertices } = request
  const isOwn = (other: Improvement | null) =>
    other?.request.kind === kind && isSame(other.request.vertices, vertices) ? other : null
  const [own, done] = [isOwn(improvement), isOwn(ended)]
  return html`<button
      type="button"
      class="improve"
      aria-label=${own ? `Stop ${NOUNS[kind]}` : (name ?? nothing)}
      ?disabled=${own ? false : improvement !== null || !isPossible}
      @click=${own ? () => own.stop() : () => onStart(request)}
    >${own ? 'Stop' : label}</button>
    ${own ? progressTemplate(progressText(own)) : nothing}
    ${done && !own ? progressTemplate(done.steps > 0 ? `${progressText(done)}, kept` : `Nothing ${BETTER[kind]} near`) : nothing}`
}

function progressTemplate(text: string): TemplateResult {
  return html`<span class="quiet progress">${text}</span>`
}

function progressText({ extremeness, steps, tried, request }: Improvement): string {
  if (request.kind === 'polish') return stepsText(steps)
  const height = extremeness === null ? '' : `${formatNumber(extremeness)}, `
  return `${height}${stepsText(steps)}, ${thousands(tried)} tried`
}

/** The name that the better element is kept by. */
export function improvedName({ request: { kind, name } }: Improvement): string {
  return `${name}-${DONE[kind].toLowerCase()}`
}

/** What came of it, as one sentence. */
export function outcomeText(improvement: Improvement): string {
  const { request, steps, extremeness } = improvement
  const { kind } = request
  if (steps === 0) return `Nothing ${BETTER[kind]} was found near this element.`
  const height = extremeness === null ? '' : ` to ${formatNumber(extremeness)}`
  return `${DONE[kind]}${height} in ${stepsText(steps)}, and kept as ${improvedName(improvement)}.`
}

function stepsText(steps: number): string {
  return `${thousands(steps)} ${steps === 1 ? 'step' : 'steps'}`
}
