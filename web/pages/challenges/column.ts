/** The column beside the lens: all challenges, one challenge, or the form for writing one. */
import { html, type TemplateResult } from 'lit-html'
import { claims, numbers } from '../../core/quantities'
import type { Report } from '../../core/report'
import type { Condition } from '../../model/condition'
import { isNumberName } from '../../model/condition/names'
import { formatNumber } from '../../model/decimal'
import type { Forget } from '../forget'
import { type Challenge, type Contest, type Judgement, LIMITS } from './challenge'
import { challengeFragment } from './challenge-link'
import { challenges } from './challenges'
import type { Progress } from './progress'
import type { Member } from './series'
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
  readonly copying: Copying | null
  readonly handingIn: Copying | null
  /** What came of printing. */
  readonly printing: string
  /** Null if it stands alone. */
  readonly place: Place | null
}

/** The outcome of copying a link; the link itself if it could not be copied. */
export interface Copying {
  readonly text: string
  readonly link: string | null
}

/** A challenge's place in a series. */
export interface Place {
  readonly code: string
  readonly at: number
  readonly members: readonly Member[]
  /** By the index of the challenge. */
  readonly solved: readonly boolean[]
}

export interface Actions {
  undo(): void
  restart(): void
  toggleHint(): void
  showSolution(): void
  copyLink(): void
  setName(name: string): void
  handIn(): void
  print(): void
  forget(): void
}

export interface ListProps {
  readonly progress: Progress
  /** True if something was made in a series. */
  readonly hasMade: boolean
  readonly complaint: string | null
  readonly actions: Pick<Actions, 'forget'>
  readonly forgetting: Forget
}

export function listColumn({ progress, hasMade, complaint, actions, forgetting }: ListProps): TemplateResult {
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
    ${progress.count > 0 || hasMade ? html`<p><button type="button" @click=${actions.forget}>Forget what I have solved</button></p>` : ''}
    <h2>Your own</h2>
    <p>
      A challenge for others has a start, a goal in numbers and a few words. All of it is in a link, and so is a series of several:
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

export function challengeColumn(
  opened: Opened,
  progress: Progress,
  studentName: string,
  actions: Actions,
): TemplateResult {
  const { id, challenge, report, judgement, isHintShown, copying, place } = opened
  return html`<p class="quiet"><a href="#">All challenges</a>${positionInWords(id, place)}</p>
    ${place && place.members.length > 1 ? seriesNavigation(place) : ''}
    <h2 tabindex="-1" class="title">${challenge.title}</h2>
    <p class="as-written">${challenge.text}</p>
    <h3>Goal</h3>
    <ul class="goal">
      ${challenge.goal.map((condition, i) => goalRow(condition, judgement?.truths[i], report, challenge.start))}
    </ul>
    ${challenge.record ? contestLine(opened, challenge.record, progress) : ''}
    <p role="status" class="outcome">${outcomeInWords(opened)}</p>
    ${nextLink(opened)}
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
    ${copyingTemplate(copying, 'Link to this element')}
    <details class="quiet">
      <summary>What these numbers are</summary>
      ${meanings(challenge)}
    </details>
    <details ?open=${id === null || place !== null}>
      <summary>Hand in, print</summary>
      <p class="quiet">
        The link to hand in holds ${place && place.members.length > 1 ? 'these challenges and your elements' : 'this challenge and your element'},
        bit for bit. Whoever opens it sees each judged anew.
      </p>
      <label class="field"
        ><span>Your name, if you like</span>
        <input
          maxlength=${LIMITS.title}
          autocomplete="name"
          .value=${studentName}
          @input=${(event: Event) => actions.setName((event.target as HTMLInputElement).value)}
      /></label>
      <p class="actions">
        <button type="button" @click=${actions.handIn}>Copy link to hand in</button>
        <button type="button" @click=${actions.print}>Print on one side</button>
      </p>
      ${copyingTemplate(opened.handingIn, 'Link to hand in')}
      <p role="status" class="quiet">${opened.printing}</p>
    </details>`
}

export function copyingTemplate(copying: Copying | null, label: string): TemplateResult {
  return html`<p role="status" class="quiet">${copying?.text ?? ''}</p>
    ${copying?.link ? html`<p><input class="link" readonly aria-label=${label} .value=${copying.link} /></p>` : ''}`
}

function positionInWords(id: string | null, place: Place | null): string {
  if (place && place.members.length > 1) return ` · ${place.at + 1} of ${place.members.length} in this series`
  const position = challenges.findIndex(challenge => challenge.id === id)
  return position < 0 ? ' · one that somebody has written' : ` · ${position + 1} of ${challenges.length}`
}

/** The numbers of the series' challenges, each a link. */
function seriesNavigation(place: Place): TemplateResult {
  return html`<nav aria-label="The series">
    <ol class="series-places">
      ${place.members.map(({ challenge }, i) => {
        const isSolved = place.solved[i] ?? false
        return html`<li>
          <a
            class="button"
            href=${`#${fragmentAt(place, i)}`}
            aria-current=${i === place.at ? 'step' : 'false'}
            title=${challenge.title}
            >${i + 1}<span class="said"> ${challenge.title}${isSolved ? ', solved' : ''}</span>${
              isSolved ? html`<span aria-hidden="true">✓</span>` : ''
            }</a
          >
        </li>`
      })}
    </ol>
  </nav>`
}

function fragmentAt({ code }: Place, at: number): string {
  return challengeFragment({ kind: 'series', code, at, vertices: null })
}

const MARKS = new Map([
  [true, { sign: '✓', word: 'Met' }],
  [false, { sign: '✗', word: 'Not met' }],
  [null, { sign: '?', word: 'Undecided' }],
])

/** A condition, whether it holds, and the element's numbers in it. Undefined is not judged yet. */
export function goalRow(
  condition: Condition,
  truth: boolean | null | undefined,
  report: Report | null,
  start: Challenge['start'],
  inNumbers = numbersInWords,
): TemplateResult {
  const mark = truth === undefined ? { sign: '–', word: 'Not judged' } : MARKS.get(truth)
  return html`<li class=${truth === true ? 'is-met' : ''}>
    <span class="mark" aria-hidden="true">${mark?.sign}</span><span class="said">${mark?.word}: </span>
    <span>${conditionInWords(condition)}</span>
    <span class="now"><span class="said">, now </span>${report ? inNumbers(condition, report, start) : ''}</span>
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

/** Within a series one may go on unsolved. */
function nextLink({ id, outcome, place }: Opened): TemplateResult | string {
  if (place && place.members.length > 1) {
    const next = place.members[place.at + 1]
    if (next !== undefined) {
      const word = outcome === 'open' ? 'Skip to' : 'Next'
      return html`<p><a href=${`#${fragmentAt(place, place.at + 1)}`}>${word}: ${next.challenge.title}</a></p>`
    }
    const left = place.solved.findIndex(isSolved => !isSolved)
    if (left < 0) return html`<p>All ${place.members.length} are solved: the link to hand in is below.</p>`
    return left === place.at
      ? ''
      : html`<p><a href=${`#${fragmentAt(place, left)}`}>Not solved yet: ${place.members[left]?.challenge.title}</a></p>`
  }
  const next = challenges[challenges.findIndex(challenge => challenge.id === id) + 1]
  if (outcome !== 'solved' || id === null || next === undefined) return ''
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
