/** Companions of the lessons' texts: questions, the glossary, the times, and the characters of the formulas' font. */
import { readFileSync, statSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import { isInPlane, type LessonStep, lessons } from '../../web/pages/lessons/content/lessons'
import { glossary, meaningId, withTerms } from '../../web/pages/lessons/glossary'
import { MINUTES_A_TASK, minutesOf, WORDS_A_MINUTE } from '../../web/pages/lessons/minutes'
import { drawnOut } from '../../web/pages/lessons/plane/quadrilateral'
import { isAnswerTo, isSolvedBy, rightChoice } from '../../web/pages/lessons/question'
import { shownStep, verticesOf } from '../../web/pages/lessons/step-state'
import { core, entry } from './core-fixtures'

const steps = lessons.flatMap(lesson => lesson.steps.map((step, i) => ({ name: `${lesson.id}/${i + 1}`, step })))
const asking = steps.flatMap(({ name, step }) => (step.question ? [{ name, step, question: step.question }] : []))

function reportOf(vertices: readonly number[]) {
  const result = core.analyze(vertices)
  if (!result.ok) throw new Error(result.error.message)
  return result.value
}

const htmlOf = ({ text, task, question }: LessonStep) =>
  [text, task, question?.asks ?? '', question?.because ?? ''].join('\n')

describe('questions', () => {
  it('every lesson has one, and by dragging they are answered in the plane and in the lens', () => {
    expect(asking.filter(({ step }) => isInPlane(step)).length).toBeGreaterThan(1)
    for (const { id } of lessons)
      expect(asking.filter(({ name }) => name.startsWith(`${id}/`)).length, id).toBeGreaterThan(0)
    expect(asking.some(({ step, question }) => !isInPlane(step) && question.answer.kind === 'drag')).toBe(true)
  })

  it.each(asking)('$name: one choice is right, and the core says which', ({ step, question }) => {
    const { answer } = question
    const start = verticesOf(step)
    const report = reportOf(start)
    if (answer.kind === 'drag') {
      expect(rightChoice(question, report, start)).toBe(-1)
      expect(isSolvedBy(question, report, start), 'it is not answered from the beginning').toBe(false)
      return
    }
    const right = rightChoice(question, report, start)
    expect(right).toBeGreaterThanOrEqual(0)
    const choices = answer.kind === 'choice' ? answer.choices : answer.vertices
    for (let i = 0; i < choices.length; i++) {
      // Without the others each is still what it was.
      const alone =
        answer.kind === 'choice'
          ? { ...question, answer: { ...answer, choices: [entry(answer.choices, i)] } }
          : question
      if (answer.kind === 'choice') expect(rightChoice(alone, report, start)).toBe(i === right ? 0 : -1)
      expect(isAnswerTo(question, i)).toBe(true)
    }
    expect(isAnswerTo(question, choices.length)).toBe(false)
    expect(isSolvedBy(question, report, start)).toBeNull()
  })

  it('the corner with the least jacdet is found, and where corner 2 of the square is in line with its neighbours', () => {
    const [drag, corner] = ['quadrilaterals-first/3', 'quadrilaterals-first/4'].map(
      name => asking.find(given => given.name === name) as (typeof asking)[number],
    ) as [(typeof asking)[number], (typeof asking)[number]]
    const start = verticesOf(corner.step)
    expect(rightChoice(corner.question, reportOf(start), start)).toBe(2)
    const answers = [0.3, 0.5, 0.55, 0.7].map(x => {
      const dragged = drawnOut([
        [0, 0],
        [1, 0],
        [x, x],
        [0, 1],
      ])
      return isSolvedBy(drag.question, reportOf(dragged), verticesOf(drag.step))
    })
    expect(answers).toEqual([false, true, true, false])
  })

  it('where a Gauss point turns is found in the lens', () => {
    const { step, question } = asking.find(({ name }) => name === 'corners-are-not-enough/5') as (typeof asking)[number]
    const start = verticesOf(step)
    const answers = [0.75, 2 / 3, 0.55, 0.48, 0.464, 0.42, 0.36].map(t =>
      isSolvedBy(question, reportOf(start.map((x, i) => (Math.floor(i / 3) === 6 ? t : x))), start),
    )
    expect(answers).toEqual([false, false, false, true, true, true, false])
  })

  it('what is shown before is another element, and after the answer the step’s own', () => {
    const shown = asking.filter(({ question }) => question.before?.element)
    expect(shown.length).toBeGreaterThan(0)
    for (const { step } of shown) {
      expect(verticesOf(shownStep(step, true))).not.toEqual(verticesOf(step))
      expect(shownStep(step, false)).toBe(step)
    }
  })
})

describe('the texts', () => {
  const LONGEST = 22
  const sentencesOf = (html: string) =>
    html
      .replace(/<math display[\s\S]*?<\/math>|<\/(p|summary)>/g, ' . ')
      .replace(/<math[\s\S]*?<\/math>/g, ' formula ')
      .replace(/<[^>]*>/g, ' ')
      .split(/[.?:](?=\s)/)
      .map(sentence => sentence.split(/\s+/).filter(word => /[\p{L}\d]/u.test(word)))
      .filter(words => words.length > 1)

  it.each(steps)('$name: no sentence is long; a formula counts as a word', ({ step }) => {
    for (const words of sentencesOf(htmlOf(step))) expect(words.length, words.join(' ')).toBeLessThanOrEqual(LONGEST)
  })

  it('derivations are in foldouts, whose summary has no word to press in it', () => {
    const foldouts = steps.flatMap(({ step }) => withTerms(htmlOf(step)).match(/<details[\s\S]*?<\/details>/g) ?? [])
    expect(foldouts.length).toBeGreaterThan(6)
    for (const foldout of foldouts) {
      expect(foldout).toMatch(/^<details class="foldout"><summary>[^<>]+<\/summary><p>/)
      expect(foldout).toContain('<math display="block">')
    }
  })
})

describe('the glossary', () => {
  it('is in its order, in whole sentences, and every word of it is in a lesson', () => {
    const names = glossary.map(({ name }) => name.toLowerCase())
    expect(names).toEqual(names.toSorted())
    const texts = steps.map(({ step }) => withTerms(htmlOf(step))).join('\n')
    for (const term of glossary) {
      expect(term.means).toMatch(/^\S.*\.$/)
      expect(texts.includes(`aria-describedby="${meaningId(term)}"`), term.name).toBe(true)
    }
  })

  it('marks the first of a word alone, not in formulas, links or other words', () => {
    expect(withTerms('<p>jacdet, and jacdet</p>')).toBe(
      '<p><span class="kept"><button type="button" class="term" data-term="jacdet" aria-describedby="meaning-jacdet">jacdet</button>,</span> and jacdet</p>',
    )
    expect(withTerms('<p>The <em>Jacobian\n  determinant</em></p>')).toMatch(
      /<em><button [^>]*>Jacobian\n {2}determinant</,
    )
    for (const left of [
      '<math><mi>jacdet</mi></math>',
      '<a href="#">jacdet</a>',
      '<p title="jacdet">a</p>',
      '<p>jacdets</p>',
    ])
      expect(withTerms(left)).toBe(left)
  })

  it('changes nothing in the words of a step', () => {
    for (const { step } of steps) {
      const bare = (html: string) => html.replace(/<[^>]*>/g, '')
      expect(bare(withTerms(htmlOf(step)))).toBe(bare(htmlOf(step)))
    }
  })
})

describe('the times', () => {
  it('grow with words, tasks and formulas', () => {
    const step = { ...entry(entry(lessons, 0).steps, 0), text: '<p>word</p>', task: '', claims: [] }
    const lesson = (text: string, count: number) => ({
      ...entry(lessons, 0),
      steps: Array.from({ length: count }, () => ({ ...step, text })),
    })
    expect(minutesOf(lesson('', 4))).toBe(4 * MINUTES_A_TASK)
    expect(minutesOf(lesson(`<p>${'word '.repeat(WORDS_A_MINUTE)}</p>`, 4))).toBe(4 * (1 + MINUTES_A_TASK))
    expect(minutesOf(lesson('<math display="block"></math>', 4))).toBe(
      Math.ceil(4 * 2 * MINUTES_A_TASK + 4 / WORDS_A_MINUTE),
    )
  })

  it('are between a few minutes and a quarter of an hour', () => {
    for (const lesson of lessons) {
      expect(minutesOf(lesson)).toBeGreaterThan(3)
      expect(minutesOf(lesson)).toBeLessThan(16)
    }
  })
})

describe('the formulas’ font', () => {
  const file = (name: string) => fileURLToPath(new URL(`../../web/pages/lessons/math-font/${name}`, import.meta.url))

  it('has every character of the formulas, and is small', () => {
    const has = new Set(readFileSync(file('characters.txt'), 'utf8'))
    const formulas = steps.flatMap(({ step }) => htmlOf(step).match(/<math[\s\S]*?<\/math>/g) ?? [])
    expect(formulas.length).toBeGreaterThan(100)
    const text = formulas
      .join('')
      .replace(/<[^>]*>/g, '')
      .replaceAll('&lt;', '<')
      .replaceAll('&gt;', '>')
    expect([...new Set(text)].filter(character => !has.has(character))).toEqual([])
    // A letter by itself is drawn as its italic.
    for (const [, letter = ''] of formulas.join('').matchAll(/<mi>(\p{L})<\/mi>/gu)) {
      const italic = letter === 'h' ? 'ℎ' : italicOf(letter)
      expect(has.has(italic), letter).toBe(true)
    }
    expect(statSync(file('stix-two-math.woff2')).size).toBeLessThanOrEqual(40_000)
    expect(readFileSync(file('stix-two-math.woff2')).subarray(0, 4).toString()).toBe('wOF2')
    expect(readFileSync(file('OFL.txt'), 'utf8')).toMatch(/STIX Fonts Project Authors[\s\S]*SIL OPEN FONT LICENSE/)
  })
})

function italicOf(letter: string): string {
  const code = letter.codePointAt(0) as number
  const blocks = [
    ['A', 'Z', 0x1d434],
    ['a', 'z', 0x1d44e],
    ['α', 'ω', 0x1d6fc],
  ] as const
  const block = blocks.find(([from, to]) => letter >= from && letter <= to)
  return block ? String.fromCodePoint(block[2] + code - (block[0].codePointAt(0) as number)) : letter
}
