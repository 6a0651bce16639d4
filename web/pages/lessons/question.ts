/**
 * Questions that are asked before a step is shown ("predict, then see"). What is right is computed from the core's report on the step's
 * own element; of an element that the reader dragged, from the report on it.
 */
import { html, nothing, type TemplateResult } from 'lit-html'
import { quantitiesOf } from '../../core/quantities'
import type { Report } from '../../core/report'
import { valueInside } from '../../core/section'
import { parseCondition, truthOf } from '../../model/condition'
import { formatJacdet } from '../../model/decimal'
import { type Vertices, vertexReference } from '../../model/hexahedron'
import type { LessonAnswer, LessonQuestion } from './content/lessons'
import { prose } from './prose'

/** The choice, by its place in the list; of a dragged element, whether it was right; null if the reader had it shown. */
export type Given = number | boolean | null

export interface Asked {
  readonly question: LessonQuestion
  /** Undefined until there is an answer. */
  readonly given: Given | undefined
  /** On the step's own element; null while it is on its way. */
  readonly own: Report | null
  readonly start: Vertices
  /** True if the picture is this step's. */
  readonly isActive: boolean
  /** True if the core has said what there is to say of the element on the screen. */
  readonly isJudged: boolean
  /** Words for a vertex: "Vertex" or "Corner". */
  readonly vertexName: string
}

export interface QuestionActions {
  /** Hands in a choice by its place in the list. */
  readonly choose: (choice: number) => void
  /** Hands in the element on the screen. */
  readonly handIn: () => void
  /** Gives up. */
  readonly show: () => void
  readonly askAgain: () => void
}

interface Choice {
  readonly says: string
  readonly isRight: boolean | null
  /** Shown with the answer. */
  readonly number: string
}

/** True if it can be an answer to the question: another version of the page may have asked another one. */
export function isAnswerTo({ answer }: LessonQuestion, given: unknown): given is Given {
  if (given === null || answer.kind === 'drag') return given === null || typeof given === 'boolean'
  return Number.isInteger(given) && (given as number) in (answer.kind === 'choice' ? answer.choices : answer.vertices)
}

/** The element does what was asked, certainly; null if that cannot be told. */
export function isSolvedBy({ answer }: LessonQuestion, report: Report, start: Vertices): boolean | null {
  return answer.kind === 'drag' ? truth(answer.holds, report, start) : null
}

/** The place of the right one in the list of choices; -1 if it is not known, or there is no list. */
export function rightChoice({ answer }: LessonQuestion, own: Report, start: Vertices): number {
  return choicesOf(answer, own, start, '').findIndex(({ isRight }) => isRight)
}

export function questionPart(asked: Asked, actions: QuestionActions): TemplateResult {
  const { question, given, own, start, isActive, isJudged, vertexName } = asked
  const choices = choicesOf(question.answer, own, start, vertexName)
  const isDrag = question.answer.kind === 'drag'
  return html`<div class="question" role="group" aria-label="Question">
    ${prose(question.asks)}
    ${
      given === undefined
        ? html`<div class="choices" role="group" aria-label="Your answer">
            ${choices.map(({ says }, i) => html`<button type="button" @click=${() => actions.choose(i)}>${says}</button>`)}
            ${isDrag && isActive ? html`<button type="button" ?disabled=${!isJudged} @click=${actions.handIn}>I expect it here</button>` : nothing}
            <button type="button" class="plain" @click=${actions.show}>Show it</button>
          </div>`
        : html`${choices.length > 0 ? choiceList(choices, given) : nothing}
            <div class="judged" tabindex="-1">${judgement(choices, given)}${prose(question.because)}</div>
            <p><button type="button" class="plain" @click=${actions.askAgain}>Ask me again</button></p>`
    }
  </div>`
}

function choiceList(choices: readonly Choice[], given: Given): TemplateResult {
  return html`<ul class="claims answers" aria-label="Answers">
    ${choices.map(
      ({ says, isRight, number }, i) => html`<li data-truth=${String(isRight)}>
        <span class="sign" aria-hidden="true">${isRight === null ? '·' : isRight ? '✓' : '✗'}</span>
        <span class="says">${says}${given === i ? html` <em>(your answer)</em>` : nothing}<span class="said">: ${isRight === null ? 'not known' : isRight ? 'right' : 'wrong'}</span></span>
        <span class="numbers">${number}</span>
      </li>`,
    )}
  </ul>`
}

function judgement(choices: readonly Choice[], given: Given): TemplateResult | typeof nothing {
  const right = choices.find(({ isRight }) => isRight)
  const isRight = typeof given === 'number' ? choices[given]?.isRight : given
  if (isRight) return html`<p><strong>Right.</strong></p>`
  if (given === null) return right ? html`<p>It is: ${right.says}.</p>` : nothing
  return html`<p><strong>Not quite.</strong>${right ? ` It is: ${right.says}.` : nothing}</p>`
}

function choicesOf(answer: LessonAnswer, own: Report | null, start: Vertices, name: string): Choice[] {
  if (answer.kind === 'drag') return []
  if (answer.kind === 'choice')
    return answer.choices.map(({ says, holds }) => ({ says, isRight: own && truth(holds, own, start), number: '' }))
  const jacdets = answer.vertices.map(vertex => own && jacdetAtVertex(own, vertex))
  const least = Math.min(...jacdets.map(jacdet => jacdet ?? Number.NaN))
  return answer.vertices.map((vertex, i) => {
    const jacdet = jacdets[i] ?? null
    return {
      says: `${name} ${vertex}`,
      isRight: jacdet === null ? null : jacdet === least,
      number: jacdet === null ? '' : formatJacdet(jacdet, own?.exponent ?? 0, 'unit'),
    }
  })
}

function jacdetAtVertex({ bernstein }: Report, vertex: number): number {
  return valueInside(bernstein, vertexReference[vertex] as (typeof vertexReference)[number])
}

function truth(holds: string, report: Report, start: Vertices): boolean | null {
  const condition = parseCondition(holds)
  if (!condition.ok) throw new Error(`${holds}: ${condition.error.message}`)
  return truthOf(condition.value, quantitiesOf(report, start))
}
