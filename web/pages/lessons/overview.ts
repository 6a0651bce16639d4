/** The page without a lesson: all of them, how long each takes, and how far the reader has come. */
import { html, nothing, type TemplateResult } from 'lit-html'
import { hashOf, type StepAddress, stepAt } from './address'
import { type Lesson, lessons } from './content/lessons'
import { MINUTES_A_TASK, minutesOf, WORDS_A_MINUTE } from './minutes'
import type { Progress } from './progress'

export interface OverviewState {
  readonly progress: Progress
  /** The mistake in the address, if any. */
  readonly complaint: string | null
}

export function overview({ progress, complaint }: OverviewState, forget: () => void): TemplateResult {
  const { last } = progress
  const total = lessons.reduce((sum, lesson) => sum + minutesOf(lesson), 0)
  return html`
    <p class="complaint" role="status">${complaint}</p>
    <h1>Lessons</h1>
    <p>
      When is a hexahedron a valid finite element, and how can one be sure? Short steps, each beside an element to drag. Every claim is
      computed while you read.
    </p>
    ${last ? goOn(last) : html`<p><a class="button" href=${hashOf({ lesson: lessons[0] as Lesson, step: 0 })}>Begin</a></p>`}
    <ol class="overview" start="0">
      ${lessons.map((lesson, i) => row(lesson, i, progress))}
    </ol>
    <p class="quiet">
      About ${total} minutes in all. The times are estimates: ${WORDS_A_MINUTE} words a minute, and ${MINUTES_A_TASK * 60} seconds for each
      formula and each thing to do.
    </p>
    ${progress.isEmpty ? nothing : kept(progress, forget)}`
}

function row(lesson: Lesson, number: number, progress: Progress): TemplateResult {
  const [seen, steps, minutes] = [progress.countIn(lesson), lesson.steps.length, minutesOf(lesson)]
  return html`<li>
    <span class="number" aria-hidden="true">${number}</span>
    <p class="title"><a href=${hashOf({ lesson, step: 0 })}>${lesson.title}</a></p>
    <p class="quiet">${lesson.summary}</p>
    <p class="time">${minutes} min</p>
    <p class="seen">
      ${seen === 0 ? `${steps} steps` : `${seen} of ${steps} steps seen`}
      <svg class="share" aria-hidden="true" viewBox="0 0 ${steps} 1" preserveAspectRatio="none">
        <rect width=${seen} height="1" />
      </svg>
    </p>
  </li>`
}

function goOn(last: StepAddress): TemplateResult {
  const { lesson, step } = last
  return html`<p>
    <a class="button" href=${hashOf(last)}>Continue</a>
    <span class="quiet">Lesson ${lessons.indexOf(lesson)}, step ${step + 1}: ${stepAt(last).title}</span>
  </p>`
}

function kept({ isKept }: Progress, forget: () => void): TemplateResult {
  return html`<p class="quiet">
    ${isKept ? 'Your progress is kept in this browser alone.' : 'This browser keeps nothing: your progress lasts until you leave the page.'}
    <button type="button" class="plain" @click=${forget}>Forget it</button>
  </p>`
}
