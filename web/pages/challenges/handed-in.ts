/**
 * What a student has handed in: each element is judged anew by the core, and nothing that the link
 * might claim is believed.
 */
import { html, type TemplateResult } from 'lit-html'
import { quantitiesOf } from '../../core/quantities'
import type { Report } from '../../core/report'
import { VERTEX_COUNT, type Vertices } from '../../model/hexahedron'
import { type Judgement, judged } from './challenge'
import { goalRow } from './column'
import { exactInWords, exactNumbersInWords } from './exact-words'
import type { HandedIn, Member } from './series'
import { contestInWords } from './words'

export interface JudgedMember {
  readonly member: Member
  readonly vertices: Vertices | null
  /** Null where nothing was made, and until it is judged. */
  readonly answer: { readonly report: Report; readonly judgement: Judgement } | null
}

export interface HandedInView {
  readonly name: string | null
  readonly members: readonly JudgedMember[]
  /** The index of the element in the lens. */
  readonly shown: number
}

export function handedInView(members: readonly Member[], { name, elements }: HandedIn): HandedInView {
  const shown = elements.findIndex(vertices => vertices !== null)
  return {
    name,
    members: members.map((member, i) => ({ member, vertices: elements[i] ?? null, answer: null })),
    shown: Math.max(shown, 0),
  }
}

export async function judgedAnew(
  view: HandedInView,
  analyze: (vertices: Vertices) => Promise<Report>,
): Promise<HandedInView> {
  const members = await Promise.all(
    view.members.map(async each => {
      if (each.vertices === null) return each
      const report = await analyze(each.vertices)
      const { challenge } = each.member
      return { ...each, answer: { report, judgement: judged(challenge, quantitiesOf(report, challenge.start)) } }
    }),
  )
  return { ...view, members }
}

export function handedInColumn(view: HandedInView, show: (at: number) => void): TemplateResult {
  const { name, members } = view
  const solved = members.filter(({ answer }) => answer?.judgement.isSolved).length
  const isJudged = members.every(({ vertices, answer }) => vertices === null || answer !== null)
  return html`<p class="quiet"><a href="#">All challenges</a> · handed in</p>
    <h2 tabindex="-1" class="title">${name === null ? 'Handed in' : `Handed in by ${name}`}</h2>
    <p role="status" class="outcome">${isJudged ? `${solved} of ${members.length} solved.` : 'Judging …'}</p>
    <p class="quiet">
      Each element comes from the link bit for bit and was judged here, exactly. The name is what the student wrote. A change in the lens
      does not change what was handed in.
    </p>
    ${members.map((each, i) => memberTemplate(each, i, i === view.shown, () => show(i)))}`
}

function memberTemplate(
  { member: { challenge }, vertices, answer }: JudgedMember,
  i: number,
  isShown: boolean,
  show: () => void,
): TemplateResult {
  const { title, text, goal, start, solution, record } = challenge
  return html`<section class="handed-in">
    <h3>${i + 1}. ${title}: ${outcomeInWords(vertices, answer)}</h3>
    <p class="as-written quiet">${text}</p>
    ${
      vertices === null
        ? ''
        : html`<ul class="goal">
            ${goal.map((condition, k) =>
              goalRow(condition, answer?.judgement.truths[k], answer?.report ?? null, start, exactNumbersInWords),
            )}
          </ul>
          ${
            record === null || answer === null
              ? ''
              : html`<p>${contestInWords(record)} ${exactInWords(record.quantity, answer.report, start)}.</p>`
          }
          <p>${differencesInWords(vertices, start, solution)}</p>
          <p class="actions">
            <button type="button" aria-pressed=${isShown} @click=${show}>Show element ${i + 1} in the lens</button>
          </p>`
    }
  </section>`
}

function outcomeInWords(vertices: Vertices | null, answer: JudgedMember['answer']): string {
  if (vertices === null) return 'nothing was handed in'
  if (answer === null) return 'not judged'
  return answer.judgement.isSolved ? 'solved' : 'not solved'
}

/** "2 vertices were moved from the start. It is not the stored solution: 3 vertices differ." */
export function differencesInWords(vertices: Vertices, start: Vertices, solution: Vertices | null): string {
  const moved = verticesThatDiffer(vertices, start)
  const sentences = [moved === 1 ? '1 vertex is moved from the start.' : `${moved} vertices are moved from the start.`]
  if (solution === null) sentences.push('No solution is stored.')
  else {
    const others = verticesThatDiffer(vertices, solution)
    sentences.push(
      others === 0
        ? 'It is the stored solution.'
        : `It is not the stored solution: ${others === 1 ? '1 vertex differs' : `${others} vertices differ`}.`,
    )
  }
  return sentences.join(' ')
}

/** By their numbers, as `moved` counts them: the sign of a zero moves nothing. */
function verticesThatDiffer(one: Vertices, other: Vertices): number {
  const differs = (v: number) => [0, 1, 2].some(axis => one[3 * v + axis] !== other[3 * v + axis])
  return Array.from({ length: VERTEX_COUNT }, (_, v) => v).filter(differs).length
}
