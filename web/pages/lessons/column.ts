/** The column of a lesson: its steps one under another, their claims, and the way on. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { guard } from 'lit-html/directives/guard.js'
import type { Report } from '../../core/report'
import type { Vertices } from '../../model/hexahedron'
import { encodePermalink } from '../../model/permalink'
import { hashOf, neighbour, type StepAddress, stepAt } from './address'
import { boxesFigure } from './boxes-figure'
import { claimList } from './claims'
import { isInPlane, type LessonFigure, type LessonQuestion, type LessonStep, lessons } from './content/lessons'
import { edgeFigure } from './edge-figure'
import { prose } from './prose'
import { type Given, type QuestionActions, questionPart } from './question'
import { sectionFigure } from './section-figure'
import { verticesOf } from './step-state'

export interface ColumnState {
  readonly address: StepAddress
  /** The report of the element on the screen. */
  readonly live: Report | null
  /** The vertices on the screen. */
  readonly vertices: Vertices
  /** Reports of the steps' own elements, as far as they are there. */
  readonly own: readonly (Report | undefined)[]
  /** True if the element is not the step's own any more. */
  readonly isChanged: boolean
  /** The mistake in the address, if any. */
  readonly complaint: string | null
  /** The answers to the lesson's questions, by their steps. */
  readonly answers: readonly (Given | undefined)[]
}

export interface ColumnActions {
  readonly go: (to: StepAddress) => void
  readonly restore: () => void
  /** To the question of a step of this lesson. */
  readonly question: (step: number) => QuestionActions
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
    <summary>Lesson ${lessons.indexOf(lesson)} of ${lessons.length - 1}</summary>
    <ol start="0">
      ${lessons.map(
        other =>
          html`<li>
            <a href=${hashOf({ lesson: other, step: 0 })} aria-current=${other === lesson ? 'true' : nothing}>${other.title}</a>
          </li>`,
      )}
    </ol>
    <p><a href="#">All lessons</a></p>
  </details>`
}

function stepArticle(step: LessonStep, index: number, state: ColumnState, actions: ColumnActions): TemplateResult {
  const { address, live, own, isChanged, answers } = state
  const isActive = index === address.step
  const report = (isActive ? live : own[index]) ?? null
  const isAsked = step.question !== undefined && answers[index] === undefined
  return html`<article class="step" data-step=${index} ?data-active=${isActive}>
    <h2>
      <a href=${hashOf({ ...address, step: index })} aria-current=${isActive ? 'step' : nothing}>
        <span class="number">${index + 1}</span> ${step.title}
      </a>
    </h2>
    ${step.question ? asked(step, step.question, index, state, actions) : nothing}
    ${
      isAsked
        ? nothing
        : html`${prose(step.text)}
            ${guard([step, report], () => computed(step, report))}
            <p class="task">${prose(step.task)}</p>`
    }
    ${
      isActive
        ? html`<p class="tools">
            <button type="button" @click=${actions.restore}>Restore this step</button>
            <a class="quiet" href=${`./#${encodePermalink(state.vertices)}`}>Open in the lens</a>
            <span class="quiet">${isChanged ? changeText(step) : nothing}</span>
          </p>`
        : nothing
    }
  </article>`
}

function asked(
  step: LessonStep,
  question: LessonQuestion,
  index: number,
  { address, live, own, answers }: ColumnState,
  actions: ColumnActions,
): TemplateResult {
  return questionPart(
    {
      question,
      given: answers[index],
      own: own[index] ?? null,
      start: verticesOf(step),
      isActive: index === address.step,
      isJudged: live !== null,
      vertexName: isInPlane(step) ? 'Corner' : 'Vertex',
    },
    actions.question(index),
  )
}

function changeText(step: LessonStep): string {
  return `You have changed the ${isInPlane(step) ? 'quadrilateral' : 'element'}.`
}

/** Made anew only for another report: while a reader drags, only the step that is read has one. */
function computed(step: LessonStep, report: Report | null): TemplateResult {
  return html`
    ${step.figure && report ? drawing(step.figure, report) : nothing}
    ${step.claims.length > 0 ? claimList(step.claims, report, verticesOf(step)) : nothing}`
}

function drawing(figure: LessonFigure, report: Report): TemplateResult {
  if (figure.kind === 'edge') return edgeFigure(report, figure.edge, figure.hasCoefficients ?? false)
  return figure.kind === 'section' ? sectionFigure(report, figure.value) : boxesFigure(report)
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
