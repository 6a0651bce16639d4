/**
 * The lessons, one file each in web/pages/lessons/content/, in the order of the files' names: a lesson's number is its place, counted
 * from 0. tests/unit/lessons.test.ts checks every claim at its step's own state.
 */
import type { Vec3 } from '../../../model/hexahedron'
import type { ElementDocument } from '../../../model/state-document'
import type { Quadrilateral, Vec2 } from '../plane/quadrilateral'

/** A sentence that can be computed: it is shown with its numbers, and whether it holds for the element on the screen. */
export interface LessonClaim {
  readonly says: string
  /** A condition of web/model/condition.ts. */
  readonly holds: string
}

/** A drawing in the column, made from the report of the element on the screen. */
export type LessonFigure =
  /** jacdet along an edge: its parabola with the control polygon, whose three coefficients may be named. */
  | { readonly kind: 'edge'; readonly edge: number; readonly hasCoefficients?: boolean }
  /** The curve jacdet = 0 on the section zeta = value, with the slopes of jacdet at its ends. */
  | { readonly kind: 'section'; readonly value: number }
  /** The least jacdet of the whole element, computed without the theorem, beside that of the boundary. */
  | { readonly kind: 'boxes' }

/**
 * Asked before the step is shown: text, task, claims and figure come with the answer, or when the reader gives up. What is right is never
 * written here: the core says it.
 */
export interface LessonQuestion {
  /** HTML: what there is to know before, and the question. */
  readonly asks: string
  readonly answer: LessonAnswer
  /** HTML: why it is so, said with the answer. */
  readonly because: string
  /** What the lens shows until then, where it differs from the step: an element that does not give the answer away. */
  readonly before?: Partial<Pick<HexahedronStep, 'element' | 'views' | 'state'>>
}

export type LessonAnswer =
  /** One of some sentences: `holds` is a condition on the step's own element. Exactly one holds. */
  | { readonly kind: 'choice'; readonly choices: readonly LessonClaim[] }
  /** The vertex of these where jacdet is least in the step's own element; no two have the least. */
  | { readonly kind: 'vertex'; readonly vertices: readonly number[] }
  /** The element as the reader has dragged it, when it is handed in: a condition on it. */
  | { readonly kind: 'drag'; readonly holds: string }

interface StepWords {
  readonly title: string
  /** HTML: paragraphs, formulas as MathML (mathml.ts). */
  readonly text: string
  /** One thing to do or to notice; HTML. */
  readonly task: string
  readonly claims: readonly LessonClaim[]
  readonly figure?: LessonFigure
  readonly question?: LessonQuestion
}

export interface HexahedronStep extends StepWords {
  /** A preset's id, or eight points. */
  readonly element: string | readonly Vec3[]
  /** The attribute `views` of the lens. */
  readonly views: string
  /** State that is not as in a new element. */
  readonly state?: Partial<Omit<ElementDocument, 'version' | 'vertices' | 'start' | 'preset'>> &
    Readonly<Record<string, unknown>>
}

/** A step in the plane. Its claims are about the quadrilateral drawn out to a hexahedron of height 1. */
export interface QuadrilateralStep extends StepWords {
  readonly quadrilateral: Quadrilateral
  /** The point of the square that is marked at first. */
  readonly probe?: Vec2
}

export type LessonStep = HexahedronStep | QuadrilateralStep

export interface Lesson {
  /** Part of links: it lasts. */
  readonly id: string
  readonly title: string
  /** One plain sentence. */
  readonly summary: string
  readonly steps: readonly LessonStep[]
}

const files = import.meta.glob<Lesson>('./[0-9]*.ts', { eager: true, import: 'lesson' })

export const lessons: readonly Lesson[] = Object.keys(files)
  .sort()
  .map(name => files[name] as Lesson)

export function isInPlane(step: LessonStep): step is QuadrilateralStep {
  return 'quadrilateral' in step
}
