/** The column of a lesson: its steps one under another, their claims, and the way on. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { guard } from 'lit-html/directives/guard.js'
import { unsafeHTML } from 'lit-html/directives/unsafe-html.js'
import type { Report } from '../../core/report'
import { encodePermalink } from '../../model/permalink'
import { hashOf, neighbour, type StepAddress, stepAt } from './address'
import { claimList } from './claims'
import { type LessonFigure, type LessonStep, lessons } from './content/lessons'
import { edgeFigure } from './edge-figure'
import { sectionFigure } from './section-figure'
import { verticesOf } from './step-state'

export interface ColumnState {
  readonly address: StepAddress
  /** The report of the element on the screen. */
  readonly live: Report | null
  /** Reports of the steps' own elements, as far as they are there. */
  readonly own: readonly (Report | undefined)[]
  /** True if the element is not the step's own any more. */
  readonly isChanged: boolean
  /** The mistake in the address, if any. */
  readonly complaint: string | null
}

export interface ColumnActions {
  readonly go: (to: StepAddress) => void
  readonly restore: () => void
}

export function column(state: ColumnState, actions: ColumnActions): TemplateResult {
  const { lesson } = state.address
  return html`
    <p class="complaint" role="status">${state.complaint}</p>
    <header class="lesson">
      ${contents(state.address)}
      <h1>${lesson.title}</h1>
      <p class="quiet">${lesson.summary}</p>
    </header>
    ${lesson.steps.map((step, i) => stepArticle(step, i, state, actions))}
    ${end(state.address)}
    ${bar(state.address, actions)}`
}

function contents({ lesson }: StepAddress): TemplateResult {
  return html`<details class="contents">
    <summary>Lesson ${lessons.indexOf(lesson) + 1} of ${lessons.length}</summary>
    <ol>
      ${lessons.map(
        other =>
          html`<li>
            <a href=${hashOf({ lesson: other, step: 0 })} aria-current=${other === lesson ? 'true' : nothing}>${other.title}</a>
          </li>`,
      )}
    </ol>
  </details>`
}

function stepArticle(step: LessonStep, index: number, state: ColumnState, { restore }: ColumnActions): TemplateResult {
  const { address, live, own, isChanged } = state
  const isActive = index === address.step
  const report = (isActive ? live : own[index]) ?? null
  return html`<article class="step" data-step=${index} ?data-active=${isActive}>
    <h2>
      <a href=${hashOf({ ...address, step: index })} aria-current=${isActive ? 'step' : nothing}>
        <span class="number">${index + 1}</span> ${step.title}
      </a>
    </h2>
    ${prose(step.text)}
    ${guard([step, report], () => computed(step, report))}
    <p class="task">${prose(step.task)}</p>
    ${
      isActive
        ? html`<p class="tools">
            <button type="button" @click=${restore}>Restore this step</button>
            <a class="quiet" href=${`./#${encodePermalink(live?.vertices ?? verticesOf(step))}`}>Open in the lens</a>
            <span class="quiet">${isChanged ? 'You have changed the element.' : nothing}</span>
          </p>`
        : nothing
    }
  </article>`
}

/** No line begins with the punctuation after a formula. */
function prose(text: string): ReturnType<typeof unsafeHTML> {
  return unsafeHTML(text.replace(/<math>(?:(?!<\/math>).)*<\/math>[.,;:)]+/gs, '<span class="together">$&</span>'))
}

/** Made anew only for another report: while a reader drags, only the step that is read has one. */
function computed(step: LessonStep, report: Report | null): TemplateResult {
  return html`
    ${step.figure && report ? drawing(step.figure, report) : nothing}
    ${step.claims.length > 0 ? claimList(step.claims, report, verticesOf(step)) : nothing}`
}

function drawing(figure: LessonFigure, report: Report): TemplateResult {
  return figure.kind === 'edge' ? edgeFigure(report, figure.edge) : sectionFigure(report, figure.value)
}

function end({ lesson }: StepAddress): TemplateResult {
  const next = lessons[lessons.indexOf(lesson) + 1]
  return html`<p class="end">
    ${
      next
        ? html`Next lesson: <a href=${hashOf({ lesson: next, step: 0 })}>${next.title}</a>. <span class="quiet">${next.summary}</span>`
        : html`That was the last lesson. Go on with the <a href="./challenges.html">challenges</a>.`
    }
  </p>`
}

function bar(address: StepAddress, { go }: ColumnActions): TemplateResult {
  const [before, after] = [neighbour(address, -1), neighbour(address, 1)]
  const isLast = address.step === address.lesson.steps.length - 1
  return html`<div class="bar" role="group" aria-label="Steps of the lesson">
    <button type="button" ?disabled=${!before} @click=${() => before && go(before)}>Previous</button>
    <p role="status">
      Step ${address.step + 1} of ${address.lesson.steps.length}<span class="said">: ${stepAt(address).title}</span>
    </p>
    <button type="button" ?disabled=${!after} @click=${() => after && go(after)}>${isLast && after ? 'Next lesson' : 'Next'}</button>
  </div>`
}
