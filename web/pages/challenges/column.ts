/** The column beside the lens: all challenges, one challenge, or the form for writing one. */
import { html, type TemplateResult } from 'lit-html'
import { claims, numbers } from '../../core/quantities'
import type { Report } from '../../core/report'
import { isNumberName } from '../../model/condition/names'
import { formatNumber } from '../../model/decimal'
import type { Forget } from '../forget'
import type { Challenge, Contest, Judgement } from './challenge'
import { challengeFragment } from './challenge-link'
import { challenges } from './challenges'
import type { Progress } from './progress'
import { conditionInWords, numberInWords, numbersInWords } from './words'

/** A challenge that is open, and how it stands. */
export interface Opened {
  /** Null of a teacher's. */
  readonly id: string | null
  readonly challenge: Challenge
  readonly report: Report | null
  readonly judgement: Judgement | null
  /** `solved`: by the reader's last move. `shown`: the element is the stored solution. */
  readonly outcome: 'open' | 'solved' | 'shown'
  readonly isHintShown: boolean
  /** The stored solution's number in the contest, once it is known. */
  readonly toBeat: number | null
  /** The outcome of copying the link; the link itself if it could not be copied. */
  readonly copying: { readonly text: string; readonly link: string | null } | null
}

export interface Actions {
  undo(): void
  restart(): void
  toggleHint(): void
  showSolution(): void
  copyLink(): void
  forget(): void
}

export function listColumn(
  progress: Progress,
  complaint: string | null,
  actions: Actions,
  forgetting: Forget,
): TemplateResult {
  return html`${complaint === null ? '' : html`<p class="complaint" role="alert">${complaint}</p>`}
    <p>
      Things to make with a hexahedron. Drag its vertices, choose one and use the arrow keys, or type its numbers. Every condition is
      judged at once, exactly.
    </p>
    <ol class="challenges">
      ${challenges.map(
        ({ id, title }) => html`<li>
          <a href=${`#${challengeFragment({ kind: 'challenge', id, vertices: null })}`}>${title}</a>
          ${progress.of(id) ? html`<span class="quiet">solved</span>` : ''}
        </li>`,
      )}
    </ol>
    <p class="quiet">${progressInWords(progress)}</p>
    ${progress.count > 0 ? html`<p><button type="button" @click=${actions.forget}>Forget what I have solved</button></p>` : ''}
    <h2>Your own</h2>
    <p>
      A challenge for others has a start, a goal in numbers and a few words. All of it is in a link:
      <a href=${`#${challengeFragment({ kind: 'write' })}`}>write one</a>.
    </p>
    ${forgetting.template()}`
}

function progressInWords(progress: Progress): string {
  const where = progress.isKept
    ? 'It is kept in this browser alone.'
    : 'This browser keeps nothing: it is forgotten when the page is left.'
  return `${progress.count} of ${challenges.length} solved. ${where}`
}

export function challengeColumn(opened: Opened, progress: Progress, actions: Actions): TemplateResult {
  const { id, challenge, isHintShown, copying } = opened
  return html`<p class="quiet"><a href="#">All challenges</a>${positionInWords(id)}</p>
    <h2 tabindex="-1" class="title">${challenge.title}</h2>
    <p class="as-written">${challenge.text}</p>
    <h3>Goal</h3>
    <ul class="goal">
      ${challenge.goal.map((_, i) => goalRow(opened, i))}
    </ul>
    ${challenge.record ? contestLine(opened, challenge.record, progress) : ''}
    <p role="status" class="outcome">${outcomeInWords(opened)}</p>
    ${opened.outcome === 'solved' ? nextLink(id) : ''}
    <p class="actions">
      <button type="button" @click=${actions.undo}>Undo</button>
      <button type="button" @click=${actions.restart}>Start again</button>
      ${
        challenge.hint === null
          ? ''
          : html`<button type="button" aria-expanded=${isHintShown} aria-controls="hint" @click=${actions.toggleHint}>Hint</button>`
      }
      ${challenge.solution === null ? '' : html`<button type="button" @click=${actions.showSolution}>Show a solution</button>`}
      <button type="button" @click=${actions.copyLink}>Copy link to this element</button>
    </p>
    <p id="hint" class="as-written" ?hidden=${!isHintShown}>${challenge.hint}</p>
    <p role="status" class="quiet">${copying?.text ?? ''}</p>
    ${copying?.link ? html`<p><input class="link" readonly aria-label="Link to this element" .value=${copying.link} /></p>` : ''}
    <details class="quiet">
      <summary>What these numbers are</summary>
      ${meanings(challenge)}
    </details>`
}

function positionInWords(id: string | null): string {
  const position = challenges.findIndex(challenge => challenge.id === id)
  return position < 0 ? ' · one that somebody has written' : ` · ${position + 1} of ${challenges.length}`
}

const MARKS = new Map([
  [true, { sign: '✓', word: 'Met' }],
  [false, { sign: '✗', word: 'Not met' }],
  [null, { sign: '?', word: 'Undecided' }],
])

function goalRow({ challenge, report, judgement }: Opened, i: number): TemplateResult {
  const condition = challenge.goal[i] as Challenge['goal'][number]
  const truth = judgement?.truths[i]
  const mark = truth === undefined ? { sign: '–', word: 'Not judged' } : MARKS.get(truth)
  return html`<li class=${truth === true ? 'is-met' : ''}>
    <span class="mark" aria-hidden="true">${mark?.sign}</span><span class="said">${mark?.word}: </span>
    <span>${conditionInWords(condition)}</span>
    <span class="now"><span class="said">, now </span>${report ? numbersInWords(condition, report, challenge) : ''}</span>
  </li>`
}

function contestLine(
  { id, challenge, report, toBeat }: Opened,
  { quantity, best }: Contest,
  progress: Progress,
): TemplateResult {
  const { name } = numbers[quantity]
  const own = id === null ? null : (progress.of(id)?.best ?? null)
  return html`<p class="contest">
    ${name}, the ${best} wins: now ${report ? numberInWords(quantity, report, challenge.start) : '–'}${
      own === null ? '' : `; your best ${formatNumber(own)}`
    }${toBeat === null ? '' : `; to beat ${formatNumber(toBeat)}`}.
  </p>`
}

function outcomeInWords({ outcome }: Opened): string {
  if (outcome === 'solved') return 'Solved: every condition holds.'
  return outcome === 'shown' ? 'This is the stored solution.' : ''
}

function nextLink(id: string | null): TemplateResult | string {
  const next = challenges[challenges.findIndex(challenge => challenge.id === id) + 1]
  if (id === null || next === undefined) return ''
  const fragment = challengeFragment({ kind: 'challenge', id: next.id, vertices: null })
  return html`<p><a href=${`#${fragment}`}>Next: ${next.title}</a></p>`
}

function meanings({ goal, record }: Challenge): TemplateResult {
  const names = new Set([...goal.flatMap(condition => condition.names), ...(record ? [record.quantity] : [])])
  return html`<dl class="meanings">
    ${[...names].map(name => {
      const { name: title, sentence } = isNumberName(name) ? numbers[name] : claims.valid
      return html`<dt>${title}</dt>
        <dd>${sentence}</dd>`
    })}
  </dl>`
}
