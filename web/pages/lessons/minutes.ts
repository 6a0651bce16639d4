/** An estimate of the time that a lesson takes, from its words and from what there is to do. */
import type { Lesson, LessonStep } from './content/lessons'

/** Slower than a novel is read: every sentence wants to be compared with the picture. */
export const WORDS_A_MINUTE = 120
/** For a task, a question or a formula on a line of its own. */
export const MINUTES_A_TASK = 0.5

export function minutesOf({ steps }: Lesson): number {
  const words = steps.reduce((sum, step) => sum + wordsIn(step), 0)
  const tasks = steps.reduce((sum, step) => sum + tasksIn(step), 0)
  return Math.ceil(words / WORDS_A_MINUTE + tasks * MINUTES_A_TASK)
}

/** Without foldouts: they are for those who want them. */
function htmlOf({ text, task, claims, question }: LessonStep): string {
  const html = [text, task, ...claims.map(({ says }) => says), question?.asks ?? '', question?.because ?? ''].join(' ')
  return html.replace(/<details[\s\S]*?<\/details>/g, ' ')
}

/** A formula in a line counts as a word. */
function wordsIn(step: LessonStep): number {
  const text = htmlOf(step)
    .replace(/<math[\s\S]*?<\/math>/g, ' formula ')
    .replace(/<[^>]*>/g, ' ')
  return text.split(/\s+/).filter(word => /[\p{L}\d]/u.test(word)).length
}

function tasksIn(step: LessonStep): number {
  return 1 + (step.question ? 1 : 0) + (htmlOf(step).match(/<math display="block">/g) ?? []).length
}
