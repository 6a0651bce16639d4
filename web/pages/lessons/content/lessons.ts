/**
 * The lessons, one file each in web/pages/lessons/content/, in the order of the files' names. tests/unit/lessons.test.ts checks every
 * claim at its step's own state.
 */
import type { Vec3 } from '../../../model/hexahedron'
import type { ElementDocument } from '../../../model/state-document'

/** A sentence that can be computed: it is shown with its numbers, and whether it holds for the element on the screen. */
export interface LessonClaim {
  readonly says: string
  /** A condition of web/model/condition.ts. */
  readonly holds: string
}

/** A drawing in the column, made from the report of the element on the screen. */
export type LessonFigure =
  /** jacdet along an edge: its parabola, with the three Bernstein coefficients. */
  | { readonly kind: 'edge'; readonly edge: number }
  /** The curve jacdet = 0 on the section zeta = value, with the slopes of jacdet at its ends. */
  | { readonly kind: 'section'; readonly value: number }

export interface LessonStep {
  readonly title: string
  /** HTML: paragraphs, formulas as MathML (mathml.ts). */
  readonly text: string
  /** One thing to do or to notice; HTML. */
  readonly task: string
  readonly claims: readonly LessonClaim[]
  readonly figure?: LessonFigure
  /** A preset's id, or eight points. */
  readonly element: string | readonly Vec3[]
  /** The attribute `views` of the lens. */
  readonly views: string
  /** State that is not as in a new element. */
  readonly state?: Partial<Omit<ElementDocument, 'version' | 'vertices' | 'start' | 'preset'>> &
    Readonly<Record<string, unknown>>
}

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
