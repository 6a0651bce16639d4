/** Addresses of the steps of lessons: #corners-are-not-enough/2. Without a step the page shows the overview. */
import { type Lesson, type LessonStep, lessons } from './content/lessons'

export interface StepAddress {
  readonly lesson: Lesson
  /** Counted from 0. */
  readonly step: number
}

export function hashOf({ lesson, step }: StepAddress): string {
  return `#${lesson.id}/${step + 1}`
}

/** The step that a link names; else the first of the lesson that it names; null is the overview. */
export function addressOf(hash: string): StepAddress | null {
  const [id, number] = hash.replace(/^#/, '').split('/')
  const lesson = lessons.find(given => given.id === id)
  if (!lesson) return null
  const step = Number(number) - 1
  return { lesson, step: step in lesson.steps ? step : 0 }
}

/** The mistake in a link, in a sentence; null if it names a step, or nothing. */
export function complaintAbout(hash: string): string | null {
  const [id = '', number] = hash.replace(/^#/, '').split('/')
  const address = addressOf(hash)
  if (id === '') return null
  if (!address) return `There is no lesson “${id.slice(0, 40)}”. These are the lessons that there are.`
  if (number === undefined || number === `${address.step + 1}`) return null
  return `This lesson has no step “${number.slice(0, 40)}”. This is its first.`
}

/** The step before or after, across lessons; null at the ends. */
export function neighbour({ lesson, step }: StepAddress, by: -1 | 1): StepAddress | null {
  if (step + by in lesson.steps) return { lesson, step: step + by }
  const other = lessons[lessons.indexOf(lesson) + by]
  return other ? { lesson: other, step: by > 0 ? 0 : other.steps.length - 1 } : null
}

export function stepAt({ lesson, step }: StepAddress): LessonStep {
  return lesson.steps[step] as LessonStep
}
